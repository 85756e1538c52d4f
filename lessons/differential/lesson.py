"""Differential kinematics: columns of the Jacobian, the velocity ellipse, one large step, drift and feedback."""

from __future__ import annotations

from dataclasses import replace
from math import exp, radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import FollowPath, MoveToJoints, MoveToPose, PathChoice
from helicoide.ik.controller import Controller
from helicoide.lesson import Choice, Diagnosis, Estimate, Mark, Shown, Step, StepGoal
from helicoide.lines import GivenName, LineExercise
from helicoide.readout import position_analysis, target_pose
from helicoide.seat import Seat
from helicoide.state import State, Update
from helicoide.text import Text

from .values import (
    AFTER,
    ARRIVED,
    ELBOW,
    FIRST_WITHIN,
    LAP,
    MANY_STEPS,
    MOVED,
    ON_CIRCLE,
    PULLED,
    SETTLED,
    SHIFT,
    SHOULDER,
    SLOW_GAIN,
    THIN,
    WRIST,
    axis_point,
    column_length,
    drift,
    first_step,
    missing,
    ready_length,
    second_step,
    target_shift,
    to_target,
    turned_by,
)
from .values import VALUES as VALUES

TITLE = Text(en="The Jacobian", pt_BR="A jacobiana")
ABOUT = Text(
    en="From joint velocities to the velocity of the end effector and back: columns, ellipse, drift and feedback.",
    pt_BR="Das velocidades das juntas à do efetuador, e de volta: colunas, elipse, deriva e realimentação.",
)
ROBOT = "orca"
NEEDS = ("screws",)
SOURCES = (
    "Vargas 2013: eqs. 2.16–2.21 (Jacobian), 2.33 (closed loop), 3.1, 3.4 (ellipsoid)",
    "Cerbaro 2022: eqs. 65, 67, 69, 72; §4.4.2 (CLIK); §4.4.3 (circle)",
)

AT_REST = radians(3.0)
LONGER = 0.030  # m/s
ENOUGH_OF_LAP = 0.75
TOO_FAR, LATE = 0.005, 8.0  # m and s

COLUMN = LineExercise(
    "jacobian",
    (
        GivenName("x", "length", Text(en="x of the axis of the joint", pt_BR="x do eixo da junta")),
        GivenName("y", "length", Text(en="y of the axis of the joint", pt_BR="y do eixo da junta")),
        GivenName("px", "number", Text(en="x of the end effector", pt_BR="x do efetuador")),
        GivenName("py", "number", Text(en="y of the end effector", pt_BR="y do efetuador")),
    ),
    "px - x",
    steps=(("vx", "y - py"),),
    title=Text(en="the velocity in a column of the Jacobian", pt_BR="a velocidade em uma coluna da jacobiana"),
)


def start(state: State) -> State:
    """Ask for the arm at `ready`, with its usual method, without a second arm, and the path at its beginning."""
    for change in (gate.clear_planes(), gate.compare_with(None), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return replace(state, request=replace(state.request, controller=Controller(), path_choice=PathChoice(), path_s=0.0))


def start_at_circle(state: State) -> State:
    """The same, with the pseudoinverse and the circle of Cerbaro as the path."""
    state = start(state)
    for change in (gate.choose_method("pseudoinverse"), gate.choose_path("demonstration"), gate.set_duration(LAP)):
        state = change(state)
    return state


def start_slowly(state: State) -> State:
    """The same, with the pseudoinverse and a small gain."""
    state = gate.choose_method("pseudoinverse")(start(state))
    for row in range(len(state.request.controller.gains)):
        state = gate.set_gain(row, SLOW_GAIN)(state)
    return state


def target_at(x: float, y: float) -> Update:
    """Ask for a place, m, with the orientation of `ready`."""
    return gate.set_target([x, y, 0.0], [1.0, 0.0, 0.0, 0.0])


def rests(state: State) -> bool:
    """Whether the arm rests where joints were asked for."""
    return not state.arm.moving and isinstance(state.request.command, MoveToJoints)


def only_turned(joint: int) -> StepGoal:
    """Whether the arm rests with one joint turned, and no other."""
    others = [k for k in (SHOULDER, ELBOW, WRIST) if k != joint]
    return lambda state, seat: (
        rests(state)
        and abs(turned_by(state, joint)) >= MOVED
        and all(abs(turned_by(state, k)) <= AT_REST for k in others)
    )


def another_turned(joint: int) -> StepGoal:
    """Whether the arm rests with another joint turned."""
    others = [k for k in (SHOULDER, ELBOW, WRIST) if k != joint]
    return lambda state, seat: rests(state) and any(abs(turned_by(state, k)) > AT_REST for k in others)


def wrist_is_faster(state: State, seat: Seat) -> bool:
    """The wrist alone would move the end effector faster than the shoulder alone."""
    return rests(state) and column_length(state, WRIST) > column_length(state, SHOULDER)


def farther_from_shoulder(state: State, seat: Seat) -> bool:
    """The end effector is farther from the axis of the shoulder than before."""
    return rests(state) and column_length(state, SHOULDER) > ready_length(state.robot, SHOULDER) + LONGER


def wrist_point(state: State, seat: Seat) -> Array:
    """The point of the gripper that stays where it is while the wrist alone turns, (3,), m."""
    return axis_point(state, WRIST)


def ellipse_is_flat(state: State, seat: Seat) -> bool:
    """The shorter semi-axis of the ellipse is nearly zero."""
    return rests(state) and bool(position_analysis(state).sigma[1] <= THIN)


def at_wanted_point(state: State, seat: Seat) -> bool:
    """The end effector rests at the place that is asked for."""
    return rests(state) and missing(state) <= ARRIVED


def step_by(share: float) -> Update:
    """Ask for the joint values at a part of the first step, from `ready`; 1 for the whole step."""

    def change(state: State) -> State:
        before = state.robot.poses["ready"]
        return gate.set_joints(before + share * (first_step(state.robot) - before))(state)

    return change


def step_again(state: State) -> State:
    """Ask for the joint values after the second step."""
    return gate.set_joints(second_step(state.robot))(state)


def stepped_backwards(state: State, seat: Seat) -> bool:
    """The arm rests where a step in the opposite direction leads."""
    before = state.robot.poses["ready"]
    return rests(state) and bool(np.abs(state.arm.q - 2 * before + first_step(state.robot)).max() <= FIRST_WITHIN)


def lap_followed(state: State, seat: Seat) -> bool:
    """The arm follows the circle closely, and most of it is done."""
    off = float(np.linalg.norm(target_pose(state)[:2, 3] - state.T_world_tool[:2, 3]))
    is_following = isinstance(state.request.command, FollowPath)
    return is_following and state.request.path_s >= ENOUGH_OF_LAP * LAP and off <= ON_CIRCLE


def lap_left(state: State, seat: Seat) -> bool:
    """The circle was left, or paused, before most of it was done."""
    is_playing = isinstance(state.request.command, FollowPath) and state.request.command.playing
    return not is_playing and 0.0 < state.request.path_s < ENOUGH_OF_LAP * LAP


def reached_slowly(state: State, seat: Seat) -> bool:
    """The end effector has come to a target that was far enough away."""
    return target_shift(state) >= PULLED and to_target(state) <= SETTLED


def target_is_near(state: State, seat: Seat) -> bool:
    """The target was reached, but it was near."""
    return SETTLED < target_shift(state) < PULLED and to_target(state) <= SETTLED


def out_of_reach(state: State, seat: Seat) -> bool:
    """Long after the target was asked for, the end effector is still away from it."""
    is_late = isinstance(state.request.command, MoveToPose) and state.request.unchanged > LATE
    return is_late and to_target(state) > TOO_FAR


STEPS = (
    Step(
        "one_joint",
        start,
        only_turned(SHOULDER),
        ((gate.set_joint(SHOULDER, radians(30.0)), 3.0),),
        joints=(SHOULDER, ELBOW, WRIST),
        prediction=Estimate(lambda state, _: ready_length(state.robot, SHOULDER), "mm/s", within=30.0),
        diagnoses=(Diagnosis("another", another_turned(SHOULDER), ((gate.set_joint(ELBOW, radians(40.0)), 3.0),)),),
        shown=Shown(layers=("columns", "trail"), camera="top"),
    ),
    Step(
        "lengths",
        start,
        wrist_is_faster,
        ((gate.set_joint(ELBOW, radians(148.0)), 3.0), (gate.set_joint(WRIST, radians(130.0)), 4.0)),
        joints=(SHOULDER, ELBOW, WRIST),
        prediction=Choice(right=0),
        diagnoses=(
            Diagnosis("shoulder_alone", only_turned(SHOULDER), ((gate.set_joint(SHOULDER, radians(40.0)), 3.0),)),
            Diagnosis("farther", farther_from_shoulder, ((gate.set_joint(ELBOW, radians(20.0)), 3.0),)),
        ),
        shown=Shown(layers=("columns",), camera="top"),
    ),
    Step(
        "column",
        start,
        line=COLUMN,
        shown=Shown(layers=("columns",), camera="top"),
    ),
    Step(
        "point",
        start,
        only_turned(WRIST),
        ((gate.set_joint(WRIST, radians(-20.0)), 3.0),),
        joints=(ELBOW, WRIST),
        prediction=Mark(wrist_point, within=0.04),
        diagnoses=(Diagnosis("another", another_turned(WRIST), ((gate.set_joint(ELBOW, radians(40.0)), 3.0),)),),
        shown=Shown(layers=("columns", "trail"), camera="top"),
    ),
    Step(
        "ellipse",
        start,
        ellipse_is_flat,
        ((gate.set_joint(ELBOW, radians(4.0)), 3.0), (gate.set_joint(WRIST, radians(-3.0)), 3.0)),
        joints=(SHOULDER, ELBOW, WRIST),
        prediction=Choice(right=1),
        shown=Shown(layers=("velocity_ellipsoid",), camera="top"),
    ),
    Step(
        "step",
        start,
        at_wanted_point,
        ((step_by(1.0), 3.0), (step_again, 3.0)),
        joints=(SHOULDER, ELBOW, WRIST),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(Diagnosis("backwards", stepped_backwards, ((step_by(-1.0), 3.0),)),),
        shown=Shown(layers=("columns", "trail"), camera="top"),
    ),
    Step(
        "drift",
        start_at_circle,
        lap_followed,
        ((gate.play(), 18.0),),
        prediction=Estimate(lambda state, _: drift(state.robot, MANY_STEPS), "mm", within=0.6),
        diagnoses=(Diagnosis("left_early", lap_left, ((gate.play(), 6.0), (gate.pause(), 0.5))),),
        shown=Shown(layers=("path", "trail", "columns"), camera="top", tab="robot"),
        charts=("position error",),
    ),
    Step(
        "gain",
        start_slowly,
        reached_slowly,
        ((target_at(0.50, 0.10), 6.0),),
        prediction=Estimate(lambda state, _: SHIFT * exp(-SLOW_GAIN * AFTER), "mm", within=3.0),
        diagnoses=(
            Diagnosis("near", target_is_near, ((target_at(0.49, 0.17), 6.0),)),
            Diagnosis("beyond", out_of_reach, ((target_at(0.80, 0.20), 9.0),)),
        ),
        shown=Shown(layers=("trail",), camera="top"),
        charts=("position error",),
    ),
    Step(
        "explore",
        start,
        joints=(SHOULDER, ELBOW, WRIST),
        shown=Shown(layers=("columns", "velocity_ellipsoid", "twist"), camera="top"),
        charts=("position error", "speed"),
        is_open=True,
    ),
)
