"""The poses that an arm with fewer than six joints can take: a goal is projected to the nearest one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.ik.families import elbow
from helicoide.ik.families.planar import Planar, planar
from helicoide.ik.families.polar_arm import polar_arm
from helicoide.ik.families.turret import turret
from helicoide.ik.postures.branch import between, check_pose, tool_at
from helicoide.ik.postures.nearest import nearest_posture
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

# Below this length, m, and angle, rad, a change is not reported; below this sine axes are parallel; below this value of
# 1 + cos(tilt) an orientation is upside down.
NOTHING, PARALLEL, FLIPPED = 1e-9, 1e-9, 1e-14


@dataclass(frozen=True, eq=False)
class Projection:
    """A goal projected to the subspace: the pose (4, 4), m, and its distance from the asked one, m and rad."""

    T_world_goal: Array
    moved: float
    turned: float

    @property
    def words(self) -> Text | None:
        """The change of the goal in words; None where the goal was in the subspace."""
        if self.moved < NOTHING and self.turned < NOTHING:
            return None
        return _TAKEN.format(moved=1000 * self.moved, turned=np.degrees(self.turned))


_TAKEN = Text(
    en="The arm cannot take this pose: the goal was moved by {moved:.3g} mm and rotated by {turned:.3g}°.",
    pt_BR="O braço não assume esta pose: o alvo foi deslocado {moved:.3g} mm e girado {turned:.3g}°.",
)


def project_to_subspace(robot: Robot, T_world_tool: Array, q: Array) -> Projection:
    """The nearest pose of the arm's subspace to a pose (4, 4), m; it may still lie outside the workspace.

    All axes parallel: the tilt is removed, and without a prismatic joint also the height; with two joints the
    orientation is that of the nearer posture. Polar arms keep (x, y). Arms of `families.turret` keep the position, and
    the pointing axis is rotated into their plane. Others with fewer than six joints: `nearest_posture`. Six joints and
    more: the pose itself.
    Args: q (n,), rad or m: decides where the geometry leaves a choice. Raises HelicoideError for an invalid pose.
    Source: Campos 1998, s.29, s.31–36, s.55.
    """
    T, q = check_pose(T_world_tool), robot.check_joints(q)
    goal = frozen(_projected(robot, T, q))
    return Projection(goal, *between(T, goal))


def project_point(robot: Robot, T_world_tool: Array, q: Array) -> Projection:
    """The projection of the position of a pose (4, 4), m, alone, with the orientation that the arm has there.

    For arms whose axes are all parallel and for polar arms; for others the pose itself. Args, errors as in
    `project_to_subspace`.
    """
    T, q = check_pose(T_world_tool), robot.check_joints(q)
    if not (isinstance(planar(robot, 2), Planar) or _keeps_upright(robot) or polar_arm(robot)):
        return Projection(T, 0.0, 0.0)
    goal = frozen(_projected(robot, T, q))
    return Projection(goal, between(T, goal)[0], 0.0)


def distance_beyond(robot: Robot, T_world_goal: Array, q: Array) -> float:
    """How far a pose of the subspace (4, 4), m, lies beyond the edge of the workspace, m; 0 inside.

    Planar arms with two or three joints: the distance from the annulus of the first two links, for the orientation of
    the goal. Others: the distance to the nearest point that the tool reaches in any orientation, found by
    `nearest_posture` and so an upper bound; prismatic joints keep their limits, angles are free.
    Args: q (n,), rad or m: the start of the search. Source: Campos 1998, s.6–10, s.44, s.53.
    """
    T, q = check_pose(T_world_goal), robot.check_joints(q)
    for count in (2, 3):
        if isinstance(arm := planar(robot, count), Planar):
            x, y, _ = arm.end(T)
            return arm.links.beyond(float(np.hypot(x, y)))
    missing, _ = between(T, tool_at(robot, nearest_posture(robot, T, q, with_orientation=False)))
    return missing if missing > NOTHING else 0.0


def _projected(robot: Robot, T: Array, q: Array) -> Array:
    if isinstance(two := planar(robot, 2), Planar):
        return _of_two_links(two, _without_tilt(robot, T, q), q)
    if _keeps_upright(robot):
        return _without_tilt(robot, T, q)
    if (polar := polar_arm(robot)) is not None:
        x, y = polar.place(T)
        rho = float(np.hypot(x, y))
        return polar.tool(float(q[0]) if rho < NOTHING else float(np.arctan2(-x, y)), rho)
    if (arm := turret(robot)) is not None:
        return arm.pointed(T, float(q[0]))[1]
    return T if len(robot.variables) >= 6 else tool_at(robot, nearest_posture(robot, T, q, with_orientation=True))


def _of_two_links(arm: Planar, upright: Array, q: Array) -> Array:
    """The pose in the plane with the orientation of the nearer of the two postures for its point."""
    x, y, _ = arm.end(upright)
    kept = float(arm.angles(q)[0])
    signs = arm.links.elbows(float(np.hypot(x, y)))
    postures = [elbow.algebraic(x, y, arm.links, sign, kept) for sign in signs]
    poses = [arm.tool(x, y, posture.theta1 + posture.theta2) for posture in postures]
    return min(poses, key=lambda pose: between(upright, pose)[1], default=upright)


def _keeps_upright(robot: Robot) -> bool:
    """Whether all axes are parallel and at least three joints are revolute, so that every heading is possible."""
    turning = sum(not joint.is_prismatic for joint in robot.joints)
    apart = np.linalg.norm(np.cross(robot.directions[0], robot.directions), axis=1).max()
    return turning >= 3 and bool(apart < PARALLEL) and not any(joint.mimic for joint in robot.joints)


def _without_tilt(robot: Robot, T: Array, q: Array) -> Array:
    """The nearest pose with a rotation about the axes alone: φ = Atan2(r₂₁ − r₁₂, r₁₁ + r₂₂), z along them.

    If the asked orientation is upside down, every φ is equally near, and that of q is used. Source: Campos 1998, s.29.
    """
    z, home = robot.directions[0], robot.T_world_tool_0
    turn = T[:3, :3] @ home[:3, :3].T
    sine, cosine = _about(turn, z)
    if np.hypot(sine, cosine) < FLIPPED:
        sine, cosine = _about(tool_at(robot, q)[:3, :3] @ home[:3, :3].T, z)
    goal = T.copy()
    goal[:3, :3] = rotation.exponential(np.arctan2(sine, cosine) * z) @ home[:3, :3]
    if not any(joint.is_prismatic for joint in robot.joints):
        goal[:3, 3] -= ((T[:3, 3] - home[:3, 3]) @ z) * z
    return goal


def _about(turn: Array, z: Array) -> tuple[float, float]:
    """r₂₁ − r₁₂ and r₁₁ + r₂₂ of a rotation (3, 3), expressed in a frame with this z axis, (3,)."""
    sine = z @ [turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]
    return float(sine), float(np.trace(turn) - z @ turn @ z)
