"""Every condition between a wish and the arm: what comes from a browser is checked here, and becomes an Update. Pure.

A wish that cannot be granted leaves the state as it was, but for a notice that says why. Values are judged here and
nowhere else: a browser may send anything.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from helicoide.confinement import stopped_at_arm
from helicoide.geometry import rotation
from helicoide.ik.goal import best_goal
from helicoide.kinematics.chain import Array, frozen
from helicoide.state import PATH, Along, GetReady, Grasp, Hold, Park, State, ToJoints, ToPose, Update, commanded
from helicoide.text import HelicoideError, Text

Phase = Literal["start", "update", "end"]

LATCH = 0.5
FARTHEST = 3.7
PARKED = Text(
    en="The arm is parked with its planes off: press Ready first.",
    pt_BR="O braço está estacionado, com os planos desligados: aperte Pronto primeiro.",
)
NO_PARKING = Text(
    en="This arm has no planes to park out of.",
    pt_BR="Este braço não tem planos dos quais sair para estacionar.",
)
_NOT_A_NUMBER = Text(en="That is not a finite number.", pt_BR="Isso não é um número finito.")


def _finite(values: ArrayLike, shape: tuple[int, ...]) -> Array:
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise HelicoideError(_NOT_A_NUMBER) from error
    if array.shape != shape or not np.isfinite(array).all():
        raise HelicoideError(_NOT_A_NUMBER)
    return frozen(array)


def _checked(wish: Update) -> Update:
    """The wish, or the same state with the reason why not."""

    def update(state: State) -> State:
        try:
            return wish(state)
        except HelicoideError as refusal:
            return replace(state, notice=refusal.text)

    return update


def _driven(wish: Update) -> Update:
    """A wish that moves the arm: refused while it is parked."""

    def update(state: State) -> State:
        if state.parked:
            raise HelicoideError(PARKED)
        return wish(state)

    return _checked(update)


def pose(state: State, position: ArrayLike, wxyz: ArrayLike) -> Array:
    """T (4, 4), m, from a position and a quaternion; raises HelicoideError unless both are finite and make a pose."""
    p, q, far = _finite(position, (3,)), _finite(wxyz, (4,)), FARTHEST * state.robot.reach
    if np.abs(p).max() > far or np.abs(q).max() > FARTHEST or np.linalg.norm(q) < 1e-6:
        raise HelicoideError(
            Text(
                en="The target must lie within {far:.1f} m of the base and have an orientation.",
                pt_BR="O alvo deve ficar a até {far:.1f} m da base e ter uma orientação.",
            ).format(far=far)
        )
    T = np.eye(4)
    T[:3, :3] = rotation.to_matrix(q / np.linalg.norm(q))
    T[:3, 3] = p
    return frozen(T)


def drag_target(seat: str, phase: Phase, position: ArrayLike, wxyz: ArrayLike) -> Update:
    """The target gizmo: held from start to end; at the end it comes to rest on the accepted goal."""

    def wish(state: State) -> State:
        T = pose(state, position, wxyz)
        if phase == "start":
            state = replace(state, grasp=Grasp(seat, "target"))
        if state.grasp != Grasp(seat, "target"):
            return state
        state = commanded(state, ToPose(T))
        return _released(state, T) if phase == "end" else state

    return _driven(wish)


def _released(state: State, T_world_target: Array) -> State:
    """The target let go: kept where another posture reaches it, else moved to the nearest that the arm can do."""
    goal, detour = best_goal(state.problem, state.q, T_world_target, state.with_orientation)
    T = goal.T_world_tool if detour is None else T_world_target
    return replace(state, grasp=None, command=ToPose(T), detour=detour, searched=True)


def set_target(position: ArrayLike, wxyz: ArrayLike) -> Update:
    """The target by numbers; it stays where it was put, also out of reach."""
    return _driven(lambda state: commanded(state, ToPose(pose(state, position, wxyz))))


def hold_orientation(on: bool) -> Update:
    """Whether the target's orientation counts, or its position only."""
    return lambda state: replace(state, with_orientation=bool(on), searched=False, rested=0.0)


def drag_plane(seat: str, phase: Phase, index: int, position: ArrayLike, wxyz: ArrayLike) -> Update:
    """A plane's gizmo, z along the inward normal: the plane stops at the critical distance from the arm."""

    def wish(state: State) -> State:
        T = pose(state, position, wxyz)
        panes = state.robot.panes
        if index not in range(len(panes)) or not panes[index].movable:
            raise HelicoideError(Text(en="That plane is fixed.", pt_BR="Esse plano é fixo."))
        handle = f"plane {index}"
        if phase == "start":
            state = replace(state, grasp=Grasp(seat, handle))
        if state.grasp != Grasp(seat, handle):
            return state
        held = replace(state, grasp=None) if phase == "end" else state
        return _plane_moved(held, index, T[:3, 2], T[:3, 3])

    return _driven(wish)


def _plane_moved(state: State, index: int, normal: Array, asked: Array) -> State:
    """The plane where it was asked for, or at the critical distance from the arm, and then the words that say so."""
    problem, critical = state.problem, state.problem.zones.critical
    points = state.guarded_points
    centre = stopped_at_arm(normal, asked, points, critical)
    stopped = None if np.array_equal(centre, asked) else _stopped_plane(state, index, (points - centre) @ normal)
    problem = replace(problem, planes=problem.planes.moved(index, normal, centre))
    return replace(state, problem=problem, searched=False, rested=0.0, notice=stopped)


def _stopped_plane(state: State, index: int, distances: Array) -> Text:
    pane, point = state.robot.panes[index], state.robot.guarded[int(distances.argmin())]
    return Text(
        en="Plane {name} ({pane}) stops at {mm:.0f} mm from the arm: {point}.",
        pt_BR="O plano {name} ({pane}) para a {mm:.0f} mm do braço: {point}.",
    ).format(name=pane.name, pane=pane.title, mm=1000 * distances.min(), point=point.title)


def restore_planes() -> Update:
    """Every plane back to where the robot's file has it, or as near to that as the arm allows."""

    def wish(state: State) -> State:
        state = replace(state, notice=None)
        for index, pane in enumerate(state.robot.panes):
            moved = _plane_moved(state, index, pane.normal, pane.centre)
            state = replace(moved, notice=moved.notice or state.notice)
        return state

    return _driven(wish)


def set_joint(index: int, angle: float) -> Update:
    """One joint from its slider or number box, rad or m; ignored right after a stop, until the hand has let go."""

    def wish(state: State) -> State:
        if state.t < state.latched:
            return replace(state, latched=state.t + LATCH)
        (value,) = _finite([angle], (1,))
        if index not in range(len(state.q)):
            raise HelicoideError(
                Text(en="There are joints 1 to {n}.", pt_BR="Há juntas de 1 a {n}.").format(n=len(state.q))
            )
        limits = state.problem.limits
        if not limits.lower[index] - 1e-6 <= value <= limits.upper[index] + 1e-6:
            raise HelicoideError(_outside(state, index))
        goal = state.command.q if isinstance(state.command, ToJoints) else state.q
        q = goal.copy()
        q[index] = min(max(value, limits.lower[index]), limits.upper[index])
        return commanded(state, ToJoints(frozen(q), yielding=index))

    return _driven(wish)


def _outside(state: State, index: int) -> Text:
    joint, limits = state.robot.variables[index], state.problem.limits
    scale, unit = (1000.0, " mm") if joint.slides else (180 / np.pi, "°")
    return Text(
        en="Joint {n} ({title}) takes {lower:.0f}{unit} to {upper:.0f}{unit}.",
        pt_BR="A junta {n} ({title}) aceita de {lower:.0f}{unit} a {upper:.0f}{unit}.",
    ).format(
        n=index + 1,
        title=joint.title,
        lower=scale * limits.lower[index],
        upper=scale * limits.upper[index],
        unit=unit,
    )


def go_to(name: str) -> Update:
    """A named posture of the robot; with planes `home` is parking, and `ready` is getting ready."""

    def wish(state: State) -> State:
        poses = state.robot.poses
        if name not in poses:
            raise HelicoideError(
                Text(
                    en="There is no pose {name!r}; there is: {known}.",
                    pt_BR="Não existe a pose {name!r}; existe: {known}.",
                ).format(name=name, known=", ".join(poses))
            )
        return commanded(state, ToJoints(poses[name]))

    def update(state: State) -> State:
        parking = name == "home" and state.robot.panes
        return park()(state) if parking else _driven(wish)(state)

    return get_ready() if name == "ready" else update


def park() -> Update:
    """To `ready` inside the planes, then home with the planes off."""

    def wish(state: State) -> State:
        if not state.robot.panes:
            raise HelicoideError(NO_PARKING)
        return commanded(replace(state, grasp=None), Park())

    return _checked(wish)


def get_ready() -> Update:
    """To `ready`; from home with the planes off."""
    return lambda state: commanded(replace(state, grasp=None), GetReady())


def set_gripper(opening: float) -> Update:
    """The gripper, 0 closed to 1 open."""

    def wish(state: State) -> State:
        if state.t < state.latched:
            return replace(state, latched=state.t + LATCH)
        (value,) = _finite([opening], (1,))
        if not 0.0 <= value <= 1.0:
            raise HelicoideError(Text(en="The gripper takes 0 to 100 %.", pt_BR="A garra aceita de 0 a 100 %."))
        released = Hold() if state.command == Hold(stopped=True) else state.command
        return replace(state, gripper_target=value, command=released)

    return _checked(wish)


def play() -> Update:
    """Follow the path from where its parameter stands."""
    return _driven(lambda state: commanded(state, Along(PATH, state.path_s, playing=True)))


def pause() -> Update:
    """Stay at this place of the path."""

    def wish(state: State) -> State:
        if not isinstance(state.command, Along):
            return state
        return commanded(state, replace(state.command, playing=False))

    return _driven(wish)


def scrub(s: float) -> Update:
    """Another place of the path, in seconds from its start; playing goes on from there."""

    def wish(state: State) -> State:
        if state.t < state.latched:
            return replace(state, latched=state.t + LATCH)
        (value,) = _finite([s], (1,))
        if not 0.0 <= value <= PATH.period:
            raise HelicoideError(
                Text(en="The path takes 0 to {end:g} s.", pt_BR="A trajetória aceita de 0 a {end:g} s.").format(
                    end=PATH.period
                )
            )
        playing = isinstance(state.command, Along) and state.command.playing
        return commanded(replace(state, path_s=value), Along(PATH, value, playing=playing))

    return _driven(wish)


def stop() -> Update:
    """Nothing moves from this tick on; what is held is let go, and sliders stay deaf until the hand has let go."""
    return lambda state: replace(
        commanded(state, Hold(stopped=True)),
        grasp=None,
        gripper_target=state.gripper,
        latched=state.t + LATCH,
    )
