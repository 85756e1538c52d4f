"""The method that drives the tool: its choice, options, gains and objective, and a second method to compare with."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.comparison import Trace
from helicoide.gate.check import checked, driven, finite
from helicoide.ik import objectives
from helicoide.ik.controller import Controller, Gains, SecondaryObjective
from helicoide.ik.method import changed
from helicoide.ik.methods import named
from helicoide.ik.postures.singular import pose_beyond
from helicoide.state import ComparedArm, State, Update, with_command
from helicoide.text import HelicoideError, Text

LEAST_GAIN, LARGEST_GAIN, HEAVIEST = 0.5, 50.0, 1000.0
NONE_SINGULAR = Text(
    en="No singular posture of this arm was found inside its limits and planes.",
    pt_BR="Não se achou postura singular deste braço dentro dos limites e dos planos.",
)
NOT_A_ROW = Text(
    en="“{title}” is not zero at its minimum, so it cannot be a task row.",
    pt_BR="“{title}” não é zero no mínimo, por isso não pode ser uma linha da tarefa.",
)


def choose_method(name: str) -> Update:
    """Choose the method; the motion continues from the present posture."""

    def update(state: State) -> State:
        named(name)
        drive = state.request.controller.with_method(name)
        fresh = state.compared and replace(state.compared, trace=Trace())
        return replace(state, request=replace(state.request.renewed(), controller=drive), compared=fresh)

    return checked(update)


def compare_with(name: str | None) -> Update:
    """Add a second arm at the posture of the first, which follows the same target by another method; None removes it.

    A second arm that exists already keeps its posture.
    """

    def update(state: State) -> State:
        if name is None:
            return replace(state, compared=None)
        named(name)
        drive = state.request.controller.with_method(name)
        arm = state.arm if state.compared is None else state.compared.arm
        return replace(state, compared=ComparedArm(replace(arm, active_set=None), drive))

    return checked(update)


def go_beyond_singular(q: Array | None) -> Update:
    """Set a target pose beyond a singular posture q (n,), rad or m. A second arm restarts at the posture of the first.

    None, for no such posture, is refused.
    """

    def update(state: State) -> State:
        if q is None:
            raise HelicoideError(NONE_SINGULAR)
        target = pose_beyond(state.robot, q, state.T_world_tool, state.request.with_orientation)
        second = state.compared and ComparedArm(replace(state.arm, active_set=None), state.compared.controller)
        return replace(with_command(state, MoveToPose(target)), compared=second)

    return driven(update)


def set_option(method: str, name: str, value: object) -> Update:
    """Set one option of a method, for both arms."""

    def update(state: State) -> State:
        options = changed(state.request.controller.options(method), name, value)
        return for_both_arms(state, lambda drive: drive.with_options(method, options))

    return checked(update)


def set_gain(index: int, value: float) -> Update:
    """Set a gain of the closed loop, 1/s: that of the tool's x, y, z (index 0 to 2) or of its orientation (3)."""

    def update(state: State) -> State:
        (gain,) = finite([value], (1,))
        if index not in range(4) or not LEAST_GAIN <= gain <= LARGEST_GAIN:
            raise HelicoideError(
                Text(
                    en="Gains 1 to 4 must be {least:g} to {largest:g} 1/s.",
                    pt_BR="Os ganhos de 1 a 4 vão de {least:g} a {largest:g} 1/s.",
                ).format(least=LEAST_GAIN, largest=LARGEST_GAIN)
            )
        return for_both_arms(state, lambda drive: replace(drive, gains=_with(drive.gains, index, float(gain))))

    return checked(update)


def choose_objective(name: str | None) -> Update:
    """Choose the secondary objective; None for none."""

    def update(state: State) -> State:
        if name is None:
            return for_both_arms(state, lambda drive: replace(drive, secondary=None))
        objective = objectives.named(name)
        if (why := objective.applies(state.robot)) is not None:
            raise HelicoideError(why)
        return for_both_arms(
            state, lambda drive: replace(drive, secondary=SecondaryObjective(name, objective.Options()))
        )

    return checked(update)


def set_objective(name: str, value: object) -> Update:
    """Set one option of the chosen objective."""
    return _objective_changed(lambda second: replace(second, options=changed(second.options, name, value)))


def weigh_objective(weight: float) -> Update:
    """Set the weight k₀ of the objective, 1/s. Weights that have grown restart from it."""

    def heavier(second: SecondaryObjective) -> SecondaryObjective:
        (value,) = finite([weight], (1,))
        if not 0.0 <= value <= HEAVIEST:
            raise HelicoideError(
                Text(en="The weight must be 0 to {most:g} 1/s.", pt_BR="O peso vai de 0 a {most:g} 1/s.").format(
                    most=HEAVIEST
                )
            )
        return replace(second, weight=float(value), weights=None)

    return _objective_changed(heavier)


def objective_as_row(on: bool) -> Update:
    """Whether the objective is one more row of the task, or moves the joints in the null space of the task."""

    def change(second: SecondaryObjective) -> SecondaryObjective:
        objective = objectives.named(second.objective)
        if on and not objective.AUGMENTS:
            raise HelicoideError(NOT_A_ROW.format(title=objective.TITLE))
        return replace(second, as_row=bool(on))

    return _objective_changed(change)


def grow_weights(on: bool) -> Update:
    """Whether the weight of a joint grows each time it stops at its limit (algorithm 1)."""
    return _objective_changed(lambda second: replace(second, adapts=bool(on), weights=None))


def _objective_changed(change: Callable[[SecondaryObjective], SecondaryObjective]) -> Update:
    def update(state: State) -> State:
        if state.request.controller.secondary is None:
            raise HelicoideError(Text(en="Choose an objective first.", pt_BR="Escolha um objetivo primeiro."))
        second = change(state.request.controller.secondary)
        return for_both_arms(state, lambda drive: replace(drive, secondary=second))

    return checked(update)


def _with(gains: Gains, index: int, value: float) -> Gains:
    x, y, z, turn = (value if i == index else gain for i, gain in enumerate(gains))
    return x, y, z, turn


def for_both_arms(state: State, change: Callable[[Controller], Controller]) -> State:
    """The state with the same change of the controllers of the arm and of the second arm."""
    beside = state.compared and replace(state.compared, controller=change(state.compared.controller))
    return replace(state, request=replace(state.request, controller=change(state.request.controller)), compared=beside)
