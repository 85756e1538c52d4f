"""The method that drives the tool: which one, its settings, its gains, and another one to compare it with."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from helicoide.gate.check import checked, finite
from helicoide.ik import objectives
from helicoide.ik.controller import Controller, Gains, SecondaryObjective
from helicoide.ik.method import changed
from helicoide.ik.methods import named
from helicoide.state import ComparedArm, State, Update
from helicoide.text import HelicoideError, Text

LEAST_GAIN, LARGEST_GAIN, HEAVIEST = 0.5, 50.0, 1000.0
NOT_A_ROW = Text(
    en="“{title}” does not come to rest at zero and cannot be a row of the task.",
    pt_BR="“{title}” não repousa em zero e não pode ser uma linha da tarefa.",
)


def choose_method(name: str) -> Update:
    """Drive by another method from here on: the arm goes on from where it is."""

    def wish(state: State) -> State:
        named(name)
        drive = state.request.controller.with_method(name)
        return replace(state, request=replace(state.request.renewed(), controller=drive))

    return checked(wish)


def compare_with(name: str | None) -> Update:
    """Put a second arm where the first one is, to follow the same target by another method; None takes it away."""

    def wish(state: State) -> State:
        if name is None:
            return replace(state, compared=None)
        named(name)
        drive = state.request.controller.with_method(name)
        arm = state.arm if state.compared is None else state.compared.arm
        return replace(state, compared=ComparedArm(replace(arm, active_set=None), drive))

    return checked(wish)


def set_option(method: str, name: str, value: object) -> Update:
    """One setting of a method, for whichever arm it drives."""

    def wish(state: State) -> State:
        options = changed(state.request.controller.options(method), name, value)
        return for_both_arms(state, lambda drive: drive.with_options(method, options))

    return checked(wish)


def set_gain(index: int, value: float) -> Update:
    """A gain of the closed loop, 1/s: of the tool's x, y, z (0 to 2) or of its orientation (3)."""

    def wish(state: State) -> State:
        (gain,) = finite([value], (1,))
        if index not in range(4) or not LEAST_GAIN <= gain <= LARGEST_GAIN:
            raise HelicoideError(
                Text(
                    en="Gains 1 to 4 take {least:g} to {largest:g} 1/s.",
                    pt_BR="Os ganhos de 1 a 4 aceitam de {least:g} a {largest:g} 1/s.",
                ).format(least=LEAST_GAIN, largest=LARGEST_GAIN)
            )
        return for_both_arms(state, lambda drive: replace(drive, gains=_with(drive.gains, index, float(gain))))

    return checked(wish)


def choose_objective(name: str | None) -> Update:
    """What the joints do with the freedom that the task leaves; None for nothing."""

    def wish(state: State) -> State:
        if name is None:
            return for_both_arms(state, lambda drive: replace(drive, secondary=None))
        objective = objectives.named(name)
        if (why := objective.applies(state.robot)) is not None:
            raise HelicoideError(why)
        return for_both_arms(
            state, lambda drive: replace(drive, secondary=SecondaryObjective(name, objective.Options()))
        )

    return checked(wish)


def set_objective(name: str, value: object) -> Update:
    """One setting of the objective that is chosen."""
    return _objective_changed(lambda second: replace(second, options=changed(second.options, name, value)))


def weigh_objective(weight: float) -> Update:
    """The weight k₀ of the objective, 1/s; gains that have grown begin with it anew."""

    def heavier(second: SecondaryObjective) -> SecondaryObjective:
        (value,) = finite([weight], (1,))
        if not 0.0 <= value <= HEAVIEST:
            raise HelicoideError(
                Text(en="The weight takes 0 to {most:g} 1/s.", pt_BR="O peso aceita de 0 a {most:g} 1/s.").format(
                    most=HEAVIEST
                )
            )
        return replace(second, weight=float(value), weights=None)

    return _objective_changed(heavier)


def objective_as_row(on: bool) -> Update:
    """Whether the objective is one more row of the task, or moves the joints in its null space."""

    def change(second: SecondaryObjective) -> SecondaryObjective:
        objective = objectives.named(second.objective)
        if on and not objective.AUGMENTS:
            raise HelicoideError(NOT_A_ROW.format(title=objective.TITLE))
        return replace(second, as_row=bool(on))

    return _objective_changed(change)


def grow_weights(on: bool) -> Update:
    """Algorithm 1: the weight of a joint grows each time it is stopped at its limit."""
    return _objective_changed(lambda second: replace(second, adapts=bool(on), weights=None))


def _objective_changed(change: Callable[[SecondaryObjective], SecondaryObjective]) -> Update:
    def wish(state: State) -> State:
        if state.request.controller.secondary is None:
            raise HelicoideError(Text(en="Choose an objective first.", pt_BR="Escolha um objetivo primeiro."))
        second = change(state.request.controller.secondary)
        return for_both_arms(state, lambda drive: replace(drive, secondary=second))

    return checked(wish)


def _with(gains: Gains, index: int, value: float) -> Gains:
    x, y, z, turn = (value if i == index else gain for i, gain in enumerate(gains))
    return x, y, z, turn


def for_both_arms(state: State, change: Callable[[Controller], Controller]) -> State:
    """The same change of the drive of the arm and of the one beside it."""
    beside = state.compared and replace(state.compared, controller=change(state.compared.controller))
    return replace(state, request=replace(state.request, controller=change(state.request.controller)), compared=beside)
