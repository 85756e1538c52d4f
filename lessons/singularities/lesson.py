"""Singularities: what a velocity costs near them, and what four inverses of the Jacobian make of it."""

from __future__ import annotations

from dataclasses import replace
from math import cos, radians, sin

from helicoide import gate
from helicoide.command import FollowPath, MoveToJoints, MoveToPose, PathChoice
from helicoide.ik.controller import Controller
from helicoide.lesson import Choice, Diagnosis, Estimate, Order, Shown, Step, StepGoal
from helicoide.lines import GivenName, LineExercise
from helicoide.seat import Seat
from helicoide.state import State, Update
from helicoide.text import Text

from .values import (
    DELTA,
    FLAT,
    GREAT,
    INSIDE,
    INWARDS,
    LAGGING,
    LAP,
    METRES,
    OUTSIDE,
    SECOND_WITHIN,
    SECONDS,
    SMALL_DAMPING,
    WANTED,
    asked,
    damping,
    from_base,
    second_to_target,
    short_axis,
    target_from_base,
    to_target,
)
from .values import VALUES as VALUES

TITLE = Text(en="Singularities", pt_BR="Singularidades")
ABOUT = Text(
    en="Where a direction is lost, what a velocity costs nearby, and what four inverses of the Jacobian do about it.",
    pt_BR="Onde se perde uma direção, quanto custa uma velocidade por perto, e o que quatro inversas fazem disso.",
)
ROBOT = "planar3r"
NEEDS = ("differential",)
SOURCES = (
    "Vargas 2013: eqs. 2.49, 3.1, 3.10–3.14 (DLS), 3.15–3.25 (FIK), 4.2–4.8, 4.60–4.67 (filtered inverse); sims. 6, 12",
    "Cerbaro 2022: eqs. 70, 71",
)

SHOULDER, ELBOW, WRIST = range(3)
HALF_TURN = radians(180.0)
STARTED, LATE = 4.0, 12.0  # s
NEAR_LAMBDA, NEAR_DELTA = 0.010, 0.004  # m/rad
STILL, ON_LINE, REACHED = 0.005, 0.001, 0.010

SHARE = LineExercise(
    "error",
    (
        GivenName("s", "number", Text(en="the semi-axis σ", pt_BR="o semieixo σ")),
        GivenName("lambda", "number", Text(en="the damping λ", pt_BR="o amortecimento λ")),
    ),
    "lambda**2/(s**2 + lambda**2)",
    steps=(("arrives", "s**2/(s**2 + lambda**2)"),),
    title=Text(
        en="the part of the velocity that arrives, and the part that is missing",
        pt_BR="a parte da velocidade que chega e a parte que falta",
    ),
)


def start(state: State) -> State:
    """Ask for the arm at `ready`, where the position alone counts, without a second arm."""
    for change in (gate.clear_planes(), gate.compare_with(None), gate.keep_orientation(False), gate.get_ready()):
        state = change(state)
    return replace(state, request=replace(state.request, controller=Controller(), path_choice=PathChoice(), path_s=0.0))


def start_with(method: str, other: str | None = None) -> Update:
    """The same with a method, and with a second arm that another method moves."""
    return lambda state: gate.compare_with(other)(gate.choose_method(method)(start(state)))


def start_on_path(state: State) -> State:
    """The same with damped least squares and trajectory 1 of Vargas, faster than there."""
    state = start_with("damped")(state)
    for change in (gate.choose_path("vargas1"), gate.set_duration(LAP)):
        state = change(state)
    return state


def target_at(distance: float, direction: float) -> Update:
    """Ask for a place at a distance from the base, m, in a direction, rad."""
    return gate.set_target([distance * cos(direction), distance * sin(direction), 0.0], [1.0, 0.0, 0.0, 0.0])


def damped_by(metres: float) -> Update:
    """Set λ, m/rad."""
    return lambda state: gate.set_option("damped", "damping", metres / state.problem.length)(state)


def rests(state: State) -> bool:
    """Whether the arm rests where joints were asked for."""
    return not state.arm.moving and isinstance(state.request.command, MoveToJoints)


def ellipse_is_flat(state: State, seat: Seat) -> bool:
    """The arm rests where the shorter semi-axis is small."""
    return rests(state) and short_axis(state) <= FLAT


def flat_inside(state: State, seat: Seat) -> bool:
    """The same, with the end effector well inside its disc."""
    return ellipse_is_flat(state, seat) and from_base(state) <= INSIDE


def flat_at_the_edge(state: State, seat: Seat) -> bool:
    """The same, with the arm stretched."""
    return ellipse_is_flat(state, seat) and from_base(state) > INSIDE


def first_asks_much(state: State, seat: Seat) -> bool:
    """The target is out of reach, and the first method has asked for a great joint velocity."""
    return target_from_base(state) >= OUTSIDE and asked(state, 0) >= GREAT


def target_reached(state: State, seat: Seat) -> bool:
    """The target is within reach, and the arm is there."""
    return isinstance(state.request.command, MoveToPose) and not state.arm.moving and to_target(state) <= REACHED


def second_removed(state: State, seat: Seat) -> bool:
    """There is no second arm any more."""
    return state.compared is None


def both_have_tried(state: State, seat: Seat) -> bool:
    """The target is out of reach, and both arms have moved for a while."""
    second = state.compared
    return second is not None and target_from_base(state) >= OUTSIDE and second.trace.seconds >= SECONDS


def follows(state: State) -> bool:
    """Whether the arm follows the path, after it has arrived there."""
    command = state.request.command
    return isinstance(command, FollowPath) and command.playing and command.arrived


def lags_behind(state: State, seat: Seat) -> bool:
    """Damped least squares follows the path with an error that can be seen."""
    is_damped = state.request.controller.method == "damped"
    return is_damped and follows(state) and state.request.path_s >= STARTED and to_target(state) >= LAGGING


def hardly_damped(state: State, seat: Seat) -> bool:
    """Most of a lap is done, with a small λ."""
    return follows(state) and state.request.path_s >= LATE and damping(state) < SMALL_DAMPING


def without_damping(state: State, seat: Seat) -> bool:
    """Another method was chosen."""
    return state.request.controller.method != "damped"


def lambda_is(metres: float, within: float) -> StepGoal:
    """Whether λ is near a value, m/rad."""
    return lambda state, seat: abs(damping(state) - metres) <= within


def is_stuck(state: State, seat: Seat) -> bool:
    """The target is inwards on the line of the stretched arm; the arm stays there, and the second one has come."""
    is_asked = isinstance(state.request.command, MoveToPose) and state.compared is not None
    is_stretched = from_base(state) >= state.robot.reach - STILL
    return bool(is_asked and is_stretched and to_target(state) >= INWARDS and second_to_target(state) <= SECOND_WITHIN)


def beside_the_line(state: State, seat: Seat) -> bool:
    """The target is not on the y axis, and the arm has come to it."""
    return target_reached(state, seat) and abs(float(target_at_x(state))) > ON_LINE


def from_elsewhere(state: State, seat: Seat) -> bool:
    """The target is on the y axis, but the arm has not been stretched before."""
    return target_reached(state, seat) and abs(float(target_at_x(state))) <= ON_LINE


def target_at_x(state: State) -> float:
    """The x of the target, m; 0 without a target."""
    command = state.request.command
    return float(command.T_world_target[0, 3]) if isinstance(command, MoveToPose) else 0.0


BEYOND = target_at(4.4, radians(20.0))
WITHIN = target_at(2.4, radians(20.0))

STEPS = (
    Step(
        "price",
        start,
        ellipse_is_flat,
        ((gate.set_joint(ELBOW, radians(2.0)), 3.0), (gate.set_joint(WRIST, radians(1.0)), 3.0)),
        joints=(SHOULDER, ELBOW, WRIST),
        prediction=Estimate(lambda state, _: WANTED / FLAT, "rad/s", within=0.5),
        shown=Shown(layers=("velocity_ellipsoid", "singular"), camera="top"),
    ),
    Step(
        "folded",
        start,
        flat_inside,
        ((gate.set_joint(ELBOW, HALF_TURN), 4.0), (gate.set_joint(WRIST, 0.0), 3.0)),
        joints=(SHOULDER, ELBOW, WRIST),
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis(
                "edge",
                flat_at_the_edge,
                ((gate.set_joint(ELBOW, 0.0), 3.0), (gate.set_joint(WRIST, 0.0), 3.0)),
            ),
        ),
        shown=Shown(layers=("velocity_ellipsoid", "singular"), camera="top"),
    ),
    Step(
        "beyond",
        start_with("pseudoinverse", "damped"),
        first_asks_much,
        ((BEYOND, 3.0),),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("within", target_reached, ((WITHIN, 4.0),)),
            Diagnosis("no_second", second_removed, ((gate.compare_with(None), 0.5),)),
        ),
        shown=Shown(camera="top", tab="method"),
        charts=("asked speed",),
    ),
    Step(
        "share",
        start,
        line=SHARE,
        prediction=Estimate(lambda state, _: 0.5, "%", within=3.0),
        shown=Shown(layers=("velocity_ellipsoid",), camera="top"),
    ),
    Step(
        "cost",
        start_on_path,
        lags_behind,
        ((gate.play(), 5.0), (damped_by(1.6), 3.0)),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("hardly_damped", hardly_damped, ((gate.play(), 13.0),)),
            Diagnosis("another_method", without_damping, ((gate.choose_method("pseudoinverse"), 0.5),)),
        ),
        shown=Shown(layers=("path",), camera="top", tab="method"),
        charts=("position error", "asked speed"),
    ),
    Step(
        "unit",
        start_with("damped"),
        lambda_is(METRES, NEAR_LAMBDA),
        ((damped_by(METRES), 0.5),),
        prediction=Choice(right=2),
        diagnoses=(Diagnosis("as_delta", lambda_is(DELTA, NEAR_DELTA), ((damped_by(DELTA), 0.5),)),),
        shown=Shown(camera="top", tab="method"),
    ),
    Step(
        "stuck",
        start_with("damped", "feedback"),
        is_stuck,
        ((gate.go_to("simulation_6"), 5.0), (target_at(3.0, radians(90.0)), 4.0)),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("beside", beside_the_line, ((target_at(3.0, radians(86.0)), 5.0),)),
            Diagnosis("elsewhere", from_elsewhere, ((target_at(3.0, radians(90.0)), 5.0),)),
        ),
        shown=Shown(layers=("singular",), camera="top", tab="robot"),
    ),
    Step(
        "filtered",
        start_with("filtered", "damped"),
        both_have_tried,
        ((BEYOND, 5.0),),
        prediction=Order(right=(1, 2, 0)),
        diagnoses=(
            Diagnosis("within", target_reached, ((WITHIN, 4.0),)),
            Diagnosis("no_second", second_removed, ((gate.compare_with(None), 0.5),)),
        ),
        shown=Shown(camera="top", tab="method"),
        charts=("asked speed", "position error"),
    ),
    Step(
        "explore",
        start_with("damped", "filtered_modified"),
        joints=(SHOULDER, ELBOW, WRIST),
        shown=Shown(layers=("velocity_ellipsoid", "path"), camera="top", tab="method"),
        charts=("asked speed", "position error", "singular values"),
        is_open=True,
    ),
)
