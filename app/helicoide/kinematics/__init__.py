"""Robots and their kinematics: forward kinematics in three formulations, Jacobians, singularities, workspaces."""
