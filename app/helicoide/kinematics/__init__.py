"""Robots and their kinematics: poses by three roads, Jacobians."""
