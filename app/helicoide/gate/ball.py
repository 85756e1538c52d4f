"""A ball to grasp: place it, remove it, or load the taught waypoints that carry it from one stand to another."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen
from helicoide.gate.check import FARTHEST, checked, finite
from helicoide.kernels import python_function
from helicoide.kinematics.ball import BALL_RADIUS, GolfBall, holding_opening
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.state import State, Update
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.waypoints import waypoint

# Name, joints, °, way and gripper. Cerbaro 2022, §3.2, fig. 21, describes the test; the postures are assumed.
ABOVE, ON_IT = (34.13, -64.21, -59.92), (23.79, -64.66, -49.13)
POINTS = {
    "movemaster": (
        ("A1", (20.0, *ABOVE, 0.0), "joints", "open"),
        ("A2", (20.0, *ON_IT, 0.0), "line", "closed"),
        ("A3", (20.0, *ABOVE, 0.0), "line", ""),
        ("B1", (-20.0, *ABOVE, 0.0), "joints", ""),
        ("B2", (-20.0, *ON_IT, 0.0), "line", "open"),
        ("B3", (-20.0, *ABOVE, 0.0), "line", ""),
    )
}


def can_grasp(robot: Robot) -> bool:
    """Whether the gripper of an arm opens wide enough for the ball."""
    return robot.gripper is not None and holding_opening(robot.gripper) < 1


def put_ball(centre: ArrayLike) -> Update:
    """Place the ball with its centre at a point (3,), m, not grasped."""

    def change(state: State) -> State:
        at, far = finite(centre, (3,)), FARTHEST * state.robot.maximum_reach
        if not can_grasp(state.robot):
            raise HelicoideError(
                Text(
                    en="This arm has no gripper that opens wide enough for a ball of {mm:.1f} mm.",
                    pt_BR="Este braço não tem garra com abertura para uma bola de {mm:.1f} mm.",
                ).format(mm=2000 * BALL_RADIUS)
            )
        if np.abs(at).max() > far:
            raise HelicoideError(
                Text(
                    en="The ball must be within {far:.1f} m of the base.",
                    pt_BR="A bola deve ficar a até {far:.1f} m da base.",
                ).format(far=far)
            )
        return replace(state, ball=GolfBall(at), notice=None)

    return checked(change)


def take_ball_away() -> Update:
    """Remove the ball."""
    return lambda state: replace(state, ball=None)


def pick_and_place() -> Update:
    """Place the ball on the first of two stands; replace the waypoints by those that carry it to the second."""

    def change(state: State) -> State:
        robot = state.robot
        if robot.name not in POINTS:
            raise HelicoideError(
                Text(
                    en="The points of the golf ball are taught to: {robots}.",
                    pt_BR="Os pontos da bola de golfe foram ensinados a: {robots}.",
                ).format(robots=", ".join(POINTS))
            )
        points = tuple(
            waypoint(robot, name, np.radians(q), way, gripper=gripper) for name, q, way, gripper in POINTS[robot.name]
        )
        first, second = (_tool(robot, points[i].q) for i in (1, 4))
        stands = frozen(np.array([first, second]) - [0, 0, BALL_RADIUS])
        taught = replace(state.taught, waypoints=points)
        return replace(state, taught=taught, ball=GolfBall(first, stands), notice=None)

    return checked(change)


def _tool(robot: Robot, q: Array) -> Array:
    """Position of the tool (3,), m, at a posture q (n,). Uses no compiled kernel."""
    return frozen((python_function(link_poses)(robot.chain, frozen(q))[-1] @ robot.T_link_tool)[:3, 3])
