"""Redundancy: one point in many postures, the null space, secondary objectives, and weights that grow at a limit."""

from __future__ import annotations

from dataclasses import replace
from math import radians

from helicoide import gate
from helicoide.command import PathChoice
from helicoide.geometry import rotation
from helicoide.ik.controller import Controller
from helicoide.lesson import Choice, Diagnosis, Estimate, Shown, Step
from helicoide.lines import GivenName, LineExercise
from helicoide.seat import Seat
from helicoide.state import State, Update
from helicoide.text import Text, untranslated

from .values import (
    ELBOW,
    EXACT,
    FREE_OF_LIMIT,
    GOOD,
    HEAVY,
    JOINTS_OF_FIVE,
    LEVEL,
    LITTLE,
    LOST,
    MOVED_AWAY,
    OVERGROWN,
    ROWS_OF_POSITION,
    SAME_POINT,
    SHOULDER,
    TARGET,
    TURNED,
    WRIST,
    away,
    has_target,
    manipulability,
    ready_pose,
    to_limit,
    to_target,
    turned,
    weights,
)
from .values import VALUES as VALUES

TITLE = Text(en="Redundancy", pt_BR="Redundância")
ABOUT = Text(
    en="What joints can do that a task does not need: self-motion, secondary objectives, and where they end.",
    pt_BR="O que fazem as juntas que sobram em uma tarefa: automovimento, objetivos secundários e onde eles acabam.",
)
ROBOT = "orca"
NEEDS = ("differential",)
SOURCES = (
    "Cerbaro 2022: §4.4.1, eqs. 9–12, 14, fig. 27; §4.5, algorithm 1; §6.1",
    "Vargas 2013: eq. 2.51",
)

COORDINATES = tuple(
    GivenName(
        f"{axis}{n}",
        "number",
        Text(en="{axis} in column {n} of J", pt_BR="{axis} na coluna {n} de J").format(axis=untranslated(axis), n=n),
    )
    for axis in "xy"
    for n in (1, 2, 3)
)
NULL_SPACE = LineExercise(
    "jacobian",
    COORDINATES,
    "x1*y2 - x2*y1",
    steps=(("w2", "x3*y1 - x1*y3"),),
    title=Text(en="a vector of the null space", pt_BR="um vetor do espaço nulo"),
)


def start(state: State) -> State:
    """Ask for the arm at `ready`, with its usual method and orientation, without a second arm."""
    for change in (gate.clear_planes(), gate.compare_with(None), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return replace(state, request=replace(state.request, controller=Controller(), path_choice=PathChoice(), path_s=0.0))


def start_free(state: State) -> State:
    """The same, where the position alone counts."""
    return gate.keep_orientation(False)(start(state))


def start_with_objective(state: State) -> State:
    """The same, with manipulability as the objective."""
    return gate.weigh_objective(HEAVY)(gate.choose_objective("manipulability")(start_free(state)))


def start_near_limits(state: State) -> State:
    """The same with the pseudoinverse, and the distance to joint limits as the objective."""
    state = gate.choose_method("pseudoinverse")(start_free(state))
    return gate.weigh_objective(HEAVY)(gate.choose_objective("limit_distance")(state))


def target_turned(by: float, shift: float = 0.0) -> Update:
    """Ask for the pose of `ready`, turned by an angle, rad, and shifted along −y, m."""

    def change(state: State) -> State:
        position = ready_pose(state)[:3, 3] - [0.0, shift, 0.0]
        return gate.set_target(position, rotation.from_axis_angle([0.0, 0.0, 1.0], by))(state)

    return change


def rests_at_target(state: State) -> bool:
    """Whether the arm rests after a target was asked for."""
    return has_target(state) and not state.arm.moving


def turned_in_place(state: State, seat: Seat) -> bool:
    """The gripper has turned, and the end effector is where it was."""
    return rests_at_target(state) and abs(turned(state)) >= TURNED and away(state) <= SAME_POINT


def moved_away(state: State, seat: Seat) -> bool:
    """The end effector has left its place."""
    return rests_at_target(state) and away(state) > MOVED_AWAY


def turned_a_little(state: State, seat: Seat) -> bool:
    """The gripper has turned in place, but only a little."""
    return rests_at_target(state) and LITTLE <= abs(turned(state)) < TURNED and away(state) <= SAME_POINT


def is_free(state: State, seat: Seat) -> bool:
    """The orientation does not count any more."""
    return not state.request.with_orientation


def only_moved_target(state: State, seat: Seat) -> bool:
    """A target was asked for, and the orientation still counts."""
    return has_target(state) and state.request.with_orientation


def chosen(state: State) -> str:
    """The name of the objective; empty without one."""
    second = state.request.controller.secondary
    return "" if second is None else second.objective


def better_in_place(state: State, seat: Seat) -> bool:
    """The objective has made the ellipse larger, and the end effector is at its target."""
    is_there = has_target(state) and to_target(state) <= EXACT
    return is_there and chosen(state) == "manipulability" and manipulability(state) >= GOOD


def another_objective(state: State, seat: Seat) -> bool:
    """An objective was chosen, but another one."""
    return chosen(state) not in ("", "manipulability")


def without_target(state: State, seat: Seat) -> bool:
    """An objective was chosen, but there is no target to keep."""
    return chosen(state) == "manipulability" and not has_target(state)


def objective_is_idle(state: State, seat: Seat) -> bool:
    """Orientation counts too, and the arm rests at its target although an objective is chosen."""
    is_asked = state.request.with_orientation and chosen(state) != ""
    return is_asked and rests_at_target(state) and to_target(state) <= EXACT and abs(turned(state)) <= LEVEL


def objective_removed(state: State, seat: Seat) -> bool:
    """There is no objective any more."""
    return chosen(state) == ""


def adapts(state: State) -> bool:
    """Whether Algorithm 1 is on."""
    second = state.request.controller.secondary
    return second is not None and second.adapts


def off_the_limit(state: State, seat: Seat) -> bool:
    """A weight has grown at a limit, no joint is there any more, and the end effector is at its target."""
    has_grown = adapts(state) and float(weights(state).max()) > HEAVY
    return has_target(state) and has_grown and to_limit(state) >= FREE_OF_LIMIT and to_target(state) <= EXACT


def overgrown(state: State, seat: Seat) -> bool:
    """The weights have grown so much that the end effector does not come to its target."""
    return adapts(state) and float(weights(state).max()) > OVERGROWN and to_target(state) > LOST


ASK_NEAR_LIMIT = gate.set_target([*TARGET, 0.0], [1.0, 0.0, 0.0, 0.0])

STEPS = (
    Step(
        "turn",
        start,
        turned_in_place,
        ((target_turned(radians(40.0)), 4.0),),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("moved", moved_away, ((target_turned(0.0, 0.05), 4.0),)),
            Diagnosis("little", turned_a_little, ((target_turned(radians(12.0)), 4.0),)),
        ),
        shown=Shown(layers=("trail",), camera="top", tab="robot"),
    ),
    Step(
        "count",
        start,
        is_free,
        ((gate.keep_orientation(False), 0.5),),
        prediction=Estimate(lambda state, _: float(JOINTS_OF_FIVE - ROWS_OF_POSITION), "", within=0.4, reveal="done"),
        diagnoses=(Diagnosis("target", only_moved_target, ((target_turned(0.0, 0.05), 3.0),)),),
        shown=Shown(layers=("null",), camera="top", tab="robot"),
    ),
    Step(
        "vector",
        start_free,
        line=NULL_SPACE,
        prediction=Choice(right=1),
        shown=Shown(layers=("null", "columns"), camera="top"),
    ),
    Step(
        "secondary",
        start_free,
        better_in_place,
        (
            (target_turned(0.0, 0.02), 2.0),
            (gate.choose_objective("manipulability"), 0.5),
            (gate.weigh_objective(HEAVY), 5.0),
        ),
        prediction=Estimate(lambda state, _: 0.0, "mm", within=1.0),
        diagnoses=(
            Diagnosis("another", another_objective, ((gate.choose_objective("limit_distance"), 0.5),)),
            Diagnosis("no_target", without_target, ((gate.choose_objective("manipulability"), 0.5),)),
        ),
        shown=Shown(layers=("velocity_ellipsoid", "trail"), camera="top", tab="method"),
        charts=("position error", "manipulability"),
    ),
    Step(
        "empty",
        start_with_objective,
        objective_is_idle,
        ((target_turned(0.0, 0.02), 4.0), (gate.keep_orientation(True), 5.0)),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(Diagnosis("removed", objective_removed, ((gate.choose_objective(None), 0.5),)),),
        shown=Shown(layers=("null",), camera="top", tab="robot"),
    ),
    Step(
        "limit",
        start_near_limits,
        off_the_limit,
        ((ASK_NEAR_LIMIT, 5.0), (gate.grow_weights(True), 5.0)),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(Diagnosis("overgrown", overgrown, ((gate.grow_weights(True), 0.5), (ASK_NEAR_LIMIT, 8.0))),),
        shown=Shown(camera="top", tab="robot"),
        charts=("positions", "position error"),
    ),
    Step(
        "explore",
        start_with_objective,
        joints=(SHOULDER, ELBOW, WRIST),
        shown=Shown(layers=("null", "velocity_ellipsoid", "trail"), camera="top", tab="method"),
        charts=("positions", "manipulability", "position error"),
        is_open=True,
    ),
)
