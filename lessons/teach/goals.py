"""Taught waypoints, the ways between them and the ball in a state; what the steps request, goals and mistakes."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from math import cos, radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array, frozen
from helicoide.command import HoldPosition, MoveToJoints
from helicoide.confinement import Obstacles, segment_distances
from helicoide.kinematics.forward import link_poses, tool_by_screws
from helicoide.kinematics.robot import Robot
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.trajectory.waypoint_file import encode_waypoints
from helicoide.trajectory.waypoints import WaypointList, waypoint

WAIST, SHOULDER, ELBOW = 0, 1, 2
SIDE, FAR_SIDE = radians(35.0), radians(85.0)
HIGH, LOW = (60.0, -75.0, -15.0, 0.0), (30.0, -75.0, -15.0, 0.0)  # ° of the other joints at the taught points
FIRST, LAST = "P1", "P2"
DIFFERENT, THERE = radians(20.0), radians(0.3)
BALL_VIA, BALL = ((0.65, 0.40, 0.20), (0.65, 0.40, 0.44)), (0.6547, 0.0, 0.4397)
CLEAR, TOUCHING, BETWEEN = 0.020, 0.012, 25
ON_STAND = 2e-3
NOT_THERE = 1.0  # m, instead of a distance from a sphere or a ball that is not there


def start(state: State) -> State:
    """Ask for the arm at `ready`, without planes, spheres, waypoints or a ball, with its gripper closed."""
    for index in reversed(range(len(state.problem.obstacles.radii))):
        state = gate.remove_obstacle(index)(state)
    for name in state.taught.names:
        state = gate.delete_waypoint(name)(state)
    for change in (
        gate.clear_planes(),
        gate.keep_orientation(True),
        gate.take_ball_away(),
        gate.set_gripper(0.0),
        gate.get_ready(),
    ):
        state = change(state)
    return state


def taught(state: State, side: float, others: tuple[float, ...], move_type: str) -> State:
    """The state with two waypoints, to the left and to the right: side, rad, of the waist; others, °."""
    robot, rest = state.robot, np.radians(others)
    points = (
        waypoint(robot, FIRST, [side, *rest]),
        waypoint(robot, LAST, [-side, *rest], move_type),
    )
    return gate.take_waypoints(encode_waypoints(WaypointList(robot, points)))(state)


def start_with_two(state: State) -> State:
    """The same as `start`, with two waypoints and a joint move between them."""
    return taught(start(state), SIDE, HIGH, "joints")


def start_with_line(state: State) -> State:
    """The same with two waypoints far to the sides, and a linear move between them."""
    return taught(start(state), FAR_SIDE, LOW, "line")


def start_with_sphere(state: State) -> State:
    """The same as `start_with_two`, with a sphere in the middle of the way."""
    state = gate.add_obstacle()(start_with_two(state))
    for place in (*BALL_VIA, BALL):
        state = gate.set_obstacle(0, place)(state)
    return state


def run(state: State) -> State:
    """Run the waypoints, as the button does."""
    return gate.replay_through(state)(state)


def place(robot: Robot, q: Array) -> Array:
    """The place of the tool at joint values, (3,), m."""
    return tool_by_screws(robot, q)[:3, 3]


def radius(state: State) -> float:
    """The distance of the tool from the axis of the waist at the high waypoints, m."""
    return float(np.hypot(*place(state.robot, np.array([0.0, *np.radians(HIGH)]))[:2]))


def height_there(state: State) -> float:
    """The height of the tool at the high waypoints, m."""
    return float(place(state.robot, np.array([0.0, *np.radians(HIGH)]))[2])


def passing(state: State) -> float:
    """How far the straight line between the waypoints far to the sides passes from the axis of the waist, m."""
    return float(np.hypot(*place(state.robot, np.array([0.0, *np.radians(LOW)]))[:2])) * cos(FAR_SIDE)


def bulge(state: State, seat: Seat) -> float:
    """How far the joint move between the high waypoints leaves the straight line, m."""
    return radius(state) * (1 - cos(SIDE))


def aside(state: State) -> float:
    """The distance of the tool from the straight line between the high waypoints, m."""
    a, b = (place(state.robot, np.array([side, *np.radians(HIGH)])) for side in (SIDE, -SIDE))
    along = (b - a) / np.linalg.norm(b - a)
    return float(np.linalg.norm(np.cross(state.T_world_tool[:3, 3] - a, along)))


def clearance_at(robot: Robot, balls: Obstacles, q: Array) -> float:
    """The distance of the surface of the arm from the nearest sphere at joint values, m."""
    poses = link_poses(robot.chain, frozen(q))
    bodies = [body for body in robot.bodies if max(body.links) > 0]
    axes = np.array([body.axis_at(poses) for body in bodies])
    radii = np.array([body.radius for body in bodies])
    return float((segment_distances(balls.ends[:, 0], axes) - radii - balls.radii[:, None]).min())


@lru_cache(maxsize=8)
def taught_clearance(points: WaypointList, balls: Obstacles) -> float:
    """The least distance from the spheres on the joint moves from waypoint to waypoint, m."""
    if not len(balls.radii) or len(points.waypoints) < 2:
        return NOT_THERE
    shares = np.linspace(0.0, 1.0, BETWEEN)
    ways = ((1 - s) * a.q + s * b.q for a, b in pairwise(points.waypoints) for s in shares)
    return min(clearance_at(points.robot, balls, q) for q in ways)


def way_clearance(state: State) -> float:
    """The least distance from the sphere on the taught way, m."""
    return taught_clearance(state.taught, state.problem.obstacles)


def ball_to_goal(state: State) -> float:
    """The distance of the ball from where it should lie on the second stand, m."""
    ball = state.ball
    if ball is None or len(ball.supports) < 2:
        return NOT_THERE
    first, second = ball.supports[:2]
    return float(np.linalg.norm((ball.centre - second)[:2])) if ball.centre[2] > first[2] else NOT_THERE


# Goals and mistakes.


def at_last(state: State, seat: Seat) -> bool:
    """The arm has run the waypoints, and rests at the last one."""
    points = state.taught.waypoints
    is_over = isinstance(state.request.command, MoveToJoints) and not state.arm.moving
    return bool(points) and is_over and bool(np.abs(state.arm.q - points[-1].q).max() < THERE)


def two_different(state: State, seat: Seat) -> bool:
    """Two recorded postures differ."""
    points = state.taught.waypoints
    return any(bool(np.abs(a.q - b.q).max() >= DIFFERENT) for a, b in pairwise(points))


def two_alike(state: State, seat: Seat) -> bool:
    """Two waypoints were recorded, both of the same posture."""
    points = state.taught.waypoints
    return len(points) >= 2 and not two_different(state, seat)


def run_along(move_type: str, state: State) -> bool:
    """Whether the arm has run to its last waypoint by a move of this type."""
    return state.taught.waypoints[-1:] != () and state.taught.waypoints[-1].move_type == move_type


def ran_in_line(state: State, seat: Seat) -> bool:
    """The arm has reached the last waypoint by a linear move."""
    return run_along("line", state) and at_last(state, seat)


def ran_by_joints(state: State, seat: Seat) -> bool:
    """The arm has reached the last waypoint by a joint move."""
    return run_along("joints", state) and at_last(state, seat)


def crossed(state: State, seat: Seat) -> bool:
    """The arm has run to the waypoint on the other side."""
    return state.taught.names[-1:] == (LAST,) and at_last(state, seat)


def line_refused(state: State, seat: Seat) -> bool:
    """The run was refused, and the last move is still linear."""
    is_refused = state.notice is not None and isinstance(state.request.command, HoldPosition)
    return is_refused and run_along("line", state)


def went_round(state: State, seat: Seat) -> bool:
    """The arm has run to the other side, by a way that keeps clear of the sphere."""
    return crossed(state, seat) and way_clearance(state) >= CLEAR


def pushed_aside(state: State, seat: Seat) -> bool:
    """The arm has run to the other side, and the taught way leads through the sphere."""
    return crossed(state, seat) and way_clearance(state) < TOUCHING


def out_of_order(state: State, seat: Seat) -> bool:
    """A waypoint was added, and comes after those of the way."""
    return len(state.taught.waypoints) > 2 and state.taught.names[-1] != LAST


def carried(state: State, seat: Seat) -> bool:
    """The ball lies on the second stand, and the fingers are open."""
    released = state.ball is not None and state.ball.grasp_offset is None
    return released and ball_to_goal(state) < ON_STAND and at_last(state, seat)


def left_behind(state: State, seat: Seat) -> bool:
    """The run is over, and the ball is still on its first stand."""
    ball = state.ball
    return ball is not None and ball.grasp_offset is None and ball_to_goal(state) > ON_STAND and at_last(state, seat)


def still_held(state: State, seat: Seat) -> bool:
    """The run is over, and the fingers still hold the ball."""
    return state.ball is not None and state.ball.grasp_offset is not None and at_last(state, seat)
