"""Frames: one point with two triples of numbers, matrices of poses, their order, their inverse, and both readings."""

from __future__ import annotations

from math import cos, radians, sin

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import GetReady
from helicoide.geometry import rotation
from helicoide.kinematics.forward import tool_by_screws
from helicoide.lesson import Choice, Diagnosis, Estimate, Mark, Shown, Step, StepGoal, Value, fixed
from helicoide.lines import GivenName, LineExercise
from helicoide.seat import Seat
from helicoide.state import State, Update
from helicoide.text import Text

TITLE = Text(en="Frames", pt_BR="Referenciais")
ABOUT = Text(
    en="Where a thing is depends on who measures: frames, the matrix of a pose, the side of a factor, the inverse.",
    pt_BR="O lugar de uma coisa depende de quem mede: referenciais, a matriz de uma pose, o lado do fator, a inversa.",
)
ROBOT = "orca"
NEEDS = ("drive_the_arm",)
SOURCES = (
    "Cerbaro 2022: eqs. 48–51 (homogeneous matrices), tab. 7",
    "Campos 1998: s. 13–14 (tool and wrist frames), s. 29 (planar arm)",
    "Craig, Introduction to Robotics (station and goal frames)",
)
OWN_ARM = True

SHOULDER, ELBOW, WRIST = range(3)
UPPER_ARM = 1  # among the frames of the base and the links
STATION, STATION_TURN = np.array([0.500, 0.0, 0.0]), radians(60.0)
IN_STATION = np.array([0.120, 0.060, 0.0])
AHEAD, NEAR, NEAR_ANGLE = 0.008, 0.015, radians(2.0)
RIGHT_ANGLE, D_TURN = radians(90.0), radians(30.0)
SEEN_BASE = np.array([-0.200, 0.400, 0.0])
AT_REST = radians(3.0)
Z_AXIS = np.array([0.0, 0.0, 1.0])


def start(state: State) -> State:
    """Ask for the arm at `ready`, with a held orientation."""
    return gate.get_ready()(gate.keep_orientation(True)(state))


def place_alone(state: State) -> State:
    """Ask for the arm at `ready`; of a target only the place counts."""
    return gate.keep_orientation(False)(start(state))


def rests(state: State) -> bool:
    """Whether the arm rests, and is not asked for `ready`."""
    return not state.arm.moving and not isinstance(state.request.command, GetReady)


def about_z(angle: float) -> Array:
    """The matrix of a turn about z by an angle, rad, (4, 4)."""
    T = np.eye(4)
    T[:2, :2] = [[cos(angle), -sin(angle)], [sin(angle), cos(angle)]]
    return T


def station() -> Array:
    """The pose of the station in the base frame, (4, 4), m."""
    T = about_z(STATION_TURN)
    T[:3, 3] = STATION
    return T


def ready_pose(state: State) -> Array:
    """The pose of the tool at `ready`, (4, 4), m."""
    return tool_by_screws(state.robot, np.array(state.robot.poses["ready"]))


def seen_from(T_world_frame: Array, point: Array) -> Array:
    """A point, (3,), m, world frame, in the coordinates of another frame."""
    return np.asarray(T_world_frame[:3, :3].T @ (point - T_world_frame[:3, 3]))


def moved(T: Array, point: Array) -> Array:
    """A point, (3,), m, moved by a matrix (4, 4)."""
    return np.asarray(T[:3, :3] @ point + T[:3, 3])


def heading(state: State) -> float:
    """The direction of the tool in the plane of the arm, from −π to π, rad."""
    return float(np.arctan2(state.T_world_tool[1, 0], state.T_world_tool[0, 0]))


def place(state: State) -> Array:
    """The place of the tool, (3,), m."""
    return np.asarray(state.T_world_tool[:3, 3])


def station_from_tool(state: State, seat: Seat) -> Array:
    """The x and y of the station as the tool sees them, (2,), m."""
    return seen_from(state.T_world_tool, STATION)[:2]


def station_ahead(state: State, seat: Seat) -> bool:
    """The station is straight ahead of the gripper."""
    x, y = station_from_tool(state, seat)
    return bool(x > 0 and abs(y) <= AHEAD) and rests(state)


def turned_left(state: State, seat: Seat) -> bool:
    """The wrist has turned to the left, away from the station."""
    return bool(state.arm.q[WRIST] - state.robot.poses["ready"][WRIST] > AT_REST) and rests(state)


def heads(angle: float) -> StepGoal:
    """Whether the gripper rests and points in a direction, rad."""
    return lambda state, seat: abs(heading(state) - angle) <= NEAR_ANGLE and rests(state)


def rests_at(point: Array) -> StepGoal:
    """Whether the tool rests at a point, (3,), m."""
    return lambda state, seat: bool(np.linalg.norm(place(state) - point) <= NEAR) and rests(state)


def point_of_station(state: State, seat: Seat) -> Array:
    """The point that is given in the station, in the base frame, (3,), m."""
    return moved(station(), IN_STATION)


def rests_in_pose(T_world_tool: Array, state: State) -> bool:
    """Whether the tool rests in a pose (4, 4), m."""
    turn = rotation.logarithm(T_world_tool[:3, :3].T @ state.T_world_tool[:3, :3])
    near = np.linalg.norm(place(state) - T_world_tool[:3, 3]) <= NEAR
    return bool(near and np.linalg.norm(turn) <= NEAR_ANGLE) and rests(state)


def turned_in_place(state: State, seat: Seat) -> bool:
    """The tool rests in the pose T D: turned about its own origin."""
    return rests_in_pose(ready_pose(state) @ about_z(D_TURN), state)


def turned_about_base(state: State, seat: Seat) -> bool:
    """The tool rests in the pose D T: turned about the origin of the base."""
    return rests_in_pose(about_z(D_TURN) @ ready_pose(state), state)


def turned_about_wrist(state: State, seat: Seat) -> bool:
    """The wrist alone has turned by the angle of D."""
    away = state.arm.q - state.robot.poses["ready"]
    return bool(np.abs(away - [0.0, 0.0, D_TURN]).max() <= NEAR_ANGLE) and rests(state)


def base_from_tool(state: State, seat: Seat) -> Array:
    """The x and y of the origin of the base as the tool sees them, (2,), m."""
    return seen_from(state.T_world_tool, np.zeros(3))[:2]


def base_seen(state: State, seat: Seat) -> bool:
    """The tool sees the origin of the base where it was asked to."""
    away = base_from_tool(state, seat) - SEEN_BASE[:2]
    return bool(np.linalg.norm(away) <= NEAR) and rests(state)


def station_from_upper_arm(state: State, seat: Seat) -> Array:
    """The x and y of the station in the frame of the upper arm, (2,), m."""
    return seen_from(state.arm.poses[UPPER_ARM], STATION)[:2]


def shoulder_at(angle: float) -> StepGoal:
    """Whether the arm rests with the shoulder at an angle, rad."""
    return lambda state, seat: abs(float(state.arm.q[SHOULDER]) - angle) <= NEAR_ANGLE and rests(state)


def station_on_the_left(state: State, seat: Seat) -> bool:
    """The arm rests where the station has the y that is asked for in the frame of the upper arm."""
    return abs(station_from_upper_arm(state, seat)[1] - STATION[0] * sin(D_TURN)) <= NEAR and rests(state)


def target_at(point: Array, angle: float = 0.0) -> Update:
    """Ask for a place, (3,), m, and a direction of the gripper, rad."""
    return gate.set_target(point, rotation.from_axis_angle(Z_AXIS, angle))


def turned_where_it_is(state: State) -> State:
    """Ask for the tool turned about its own origin."""
    return target_at(place(state), heading(state) + D_TURN)(state)


VALUES = {
    "joints": Value(lambda state, _: state.arm.q, "°"),
    "in_base": fixed(STATION[:2], "mm"),
    "in_tool": Value(station_from_tool, "mm"),
    "ahead": fixed(AHEAD, "mm"),
    "pose": Value(lambda state, _: state.T_world_tool, "", 3),
    "heading": Value(lambda state, _: heading(state), "°"),
    "within": fixed(NEAR_ANGLE, "°"),
    "station_turn": fixed(STATION_TURN, "°"),
    "in_station": fixed(IN_STATION[:2], "mm"),
    "station_point": Value(lambda state, seat: point_of_station(state, seat)[:2], "mm"),
    "added": fixed((STATION + IN_STATION)[:2], "mm"),
    "turned_part": fixed(lambda: moved(about_z(STATION_TURN), IN_STATION)[:2], "mm"),
    "near": fixed(NEAR, "mm"),
    "d_turn": fixed(D_TURN, "°"),
    "start_x": Value(lambda state, _: float(ready_pose(state)[0, 3]), "mm"),
    "start_y": Value(lambda state, _: float(ready_pose(state)[1, 3]), "mm"),
    "away": Value(lambda state, _: float(np.linalg.norm(place(state) - ready_pose(state)[:3, 3])), "mm"),
    "example_place": fixed(np.array([0.400, 0.200]), "mm"),
    "right_angle": fixed(RIGHT_ANGLE, "°"),
    "seen_base": Value(base_from_tool, "mm"),
    "asked_base": fixed(SEEN_BASE[:2], "mm"),
    "opposite": fixed(-SEEN_BASE[:2], "mm"),
    "in_upper_arm": Value(station_from_upper_arm, "mm"),
    "asked_y": fixed(lambda: STATION[0] * sin(D_TURN), "mm"),
    "minus_y": fixed(lambda: -STATION[0] * sin(D_TURN), "mm"),
    "shoulder": Value(lambda state, _: state.arm.q[SHOULDER], "°"),
}

WRIST_FRAME = LineExercise(
    "chain",
    (
        GivenName("T_bs", "motor", Text(en="the station in the base frame", pt_BR="a estação no referencial da base")),
        GivenName("T_sg", "motor", Text(en="the goal in the station frame", pt_BR="o objetivo no da estação")),
        GivenName("T_wt", "motor", Text(en="the end effector in the wrist frame", pt_BR="o efetuador no do punho")),
    ),
    "T_bg*inverse(T_wt)",
    steps=(("T_bg", "T_bs*T_sg"),),
    sign_counts=False,
    title=Text(en="the pose of the wrist for a goal", pt_BR="a pose do punho para um objetivo"),
)
ON_THE_BENCH = Shown(layers=("frames",), camera="top", sheet="station_frame")
ALL_JOINTS = (SHOULDER, ELBOW, WRIST)

STEPS = (
    Step(
        "two_views",
        start,
        station_ahead,
        ((gate.set_joint(WRIST, radians(-119.5)), 4.0),),
        joints=(WRIST,),
        prediction=Choice(right=1),
        diagnoses=(Diagnosis("left", turned_left, ((gate.set_joint(WRIST, radians(-30.0)), 3.0),)),),
        shown=ON_THE_BENCH,
    ),
    Step(
        "columns",
        start,
        heads(RIGHT_ANGLE),
        ((gate.set_joint(WRIST, radians(20.0)), 4.0),),
        joints=ALL_JOINTS,
        prediction=Choice(right=0),
        diagnoses=(
            Diagnosis("row", heads(-RIGHT_ANGLE), ((gate.set_joints(np.radians([-40.0, 75.0, -125.0])), 4.0),)),
        ),
        shown=Shown(layers=("frames",), camera="top"),
    ),
    Step(
        "station",
        place_alone,
        rests_at(moved(station(), IN_STATION)),
        ((target_at(moved(station(), IN_STATION)), 5.0),),
        prediction=Mark(point_of_station, within=0.03),
        diagnoses=(
            Diagnosis("added", rests_at(STATION + IN_STATION), ((target_at(STATION + IN_STATION), 6.0),)),
            Diagnosis("as_base", rests_at(IN_STATION), ((target_at(IN_STATION), 8.0),)),
        ),
        shown=ON_THE_BENCH,
    ),
    Step(
        "sides",
        start,
        turned_in_place,
        ((turned_where_it_is, 5.0),),
        joints=ALL_JOINTS,
        prediction=Choice(right=0),
        diagnoses=(
            Diagnosis("left_side", turned_about_base, ((gate.set_joint(SHOULDER, radians(25.0)), 4.0),)),
            Diagnosis("at_the_wrist", turned_about_wrist, ((gate.set_joint(WRIST, radians(-40.0)), 4.0),)),
        ),
        shown=Shown(layers=("frames", "trail"), camera="top"),
    ),
    Step(
        "back",
        start,
        base_seen,
        ((target_at(np.array([0.400, 0.200, 0.0]), RIGHT_ANGLE), 6.0),),
        joints=ALL_JOINTS,
        prediction=Estimate(lambda state, seat: float(SEEN_BASE[0]), "mm", within=20.0),
        diagnoses=(
            Diagnosis("minus", rests_at(-SEEN_BASE), ((target_at(-SEEN_BASE, -RIGHT_ANGLE), 6.0),)),
            Diagnosis("exchanged", rests_at(SEEN_BASE), ((target_at(SEEN_BASE, RIGHT_ANGLE), 8.0),)),
        ),
        shown=Shown(layers=("frames",), camera="top"),
    ),
    Step(
        "passive",
        start,
        station_on_the_left,
        ((gate.set_joint(SHOULDER, -D_TURN), 4.0),),
        joints=(SHOULDER,),
        prediction=Estimate(lambda state, seat: float(-STATION[0] * sin(D_TURN)), "mm", within=25.0),
        diagnoses=(Diagnosis("active", shoulder_at(D_TURN), ((gate.set_joint(SHOULDER, D_TURN), 4.0),)),),
        shown=ON_THE_BENCH,
    ),
    Step("write", start, line=WRIST_FRAME),
    Step("explore", start, joints=ALL_JOINTS, shown=ON_THE_BENCH, is_open=True),
)
