"""Faults of a lesson: its texts in both languages, and its steps, which are played on its own robot."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from itertools import chain

import numpy as np

from helicoide import content, gate, lesson
from helicoide.command import HoldPosition
from helicoide.contributions.lesson_words import word_faults
from helicoide.contributions.loading import collected_faults
from helicoide.foresight import advance_with_search
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.lesson import AtSeat, Lesson, Step
from helicoide.seat import Seat
from helicoide.state import State, Update, initial_state
from helicoide.text import HelicoideError, Text

TICK = 0.01
LONGEST = 30.0  # s, for a setup to come to rest
OF_STEP = Text(en="step {step}: {what}", pt_BR="passo {step}: {what}")
MOVES = Text(
    en="its setup moves the arm by itself; it may only ask, by functions of gate",
    pt_BR="o setup move o braço por conta própria; ele só pode pedir, por funções de gate",
)
RESTLESS = Text(
    en="{seconds:.0f} s after its setup, from {start}, the arm still does not rest",
    pt_BR="{seconds:.0f} s depois do setup, a partir de {start}, o braço ainda não repousa",
)
TOO_SOON = Text(
    en="its goal is met before anything is done, from {start}",
    pt_BR="o objetivo já está cumprido antes de se fazer algo, a partir de {start}",
)
NO_SOLUTION = Text(en="it has no solution", pt_BR="falta a solução")
UNSOLVED = Text(en="its solution does not reach its goal", pt_BR="a solução não chega ao objetivo")
NEEDLESS = Text(
    en="its goal is met after {n} of the {count} parts of its solution: leave the others out",
    pt_BR="o objetivo é cumprido com {n} das {count} partes da solução: tire as outras",
)
NO_FALSE = Text(en="its goal answers {kind}, not True or False", pt_BR="o objetivo responde {kind}, não True ou False")
BEFORE = Text(en="the end of the step before", pt_BR="onde termina o passo anterior")
PARKED = Text(en="the parked arm", pt_BR="o braço estacionado")
POSE = Text(en="the pose “{title}”", pt_BR="a postura “{title}”")


class _Wrong(Exception):
    """A fault of a step, after which the rest of the step cannot be checked."""

    def __init__(self, text: Text) -> None:
        super().__init__(text.en)
        self.text = text


def faults(name: str) -> tuple[Text, ...]:
    """The faults of a lesson, by the name of its folder. Its steps are played."""
    try:
        found = lesson.load_lesson(name)
        robot = load_robot(found.robot)
    except HelicoideError as error:
        return (error.text,)
    found_faults = chain(word_faults(found, robot), _whole(found, robot), _from_anywhere(found, robot))
    return collected_faults(content.content_folder("lessons", name) / "lesson.py", found_faults)


def played(state: State, seconds: float) -> State:
    """The state after a number of seconds without requests."""
    for _ in range(round(seconds / TICK)):
        state = advance_with_search(state, TICK)
    return state


def settled(state: State) -> State | None:
    """The state once the arm is at rest without a command; None if that takes longer than `LONGEST`."""
    for _ in range(round(LONGEST)):
        state = played(state, 1.0)
        if isinstance(state.request.command, HoldPosition) and not state.arm.moving:
            return state
    return None


def done(state: State, seat: Seat, part: tuple[Update | AtSeat, float]) -> tuple[State, Seat]:
    """The state and the seat after one part of a solution."""
    act, seconds = part
    if isinstance(act, AtSeat):
        return played(state, seconds), act.update(seat)
    return played(act(state), seconds), seat


def _whole(found: Lesson, robot: Robot) -> Iterator[Text]:
    """The faults of the steps, each started where the one before has ended."""
    state, seat = initial_state(robot), Seat(token="", language="en", lesson=found.id)
    for number, step in enumerate(found.steps):
        try:
            begun = _begun(step, state, seat, BEFORE)
            state, seat = _solved(step, begun, replace(seat, step=number))
        except _Wrong as wrong:
            yield OF_STEP.format(step=step.id, what=wrong.text)


def _from_anywhere(found: Lesson, robot: Robot) -> Iterator[Text]:
    """The faults of the setups from other starts: each named pose, and the parked arm if there are planes."""
    ways: list[tuple[Text, Callable[[], State | None]]] = [
        (POSE.format(title=robot.pose_titles[pose]), partial(_arrived, robot, gate.go_to(pose))) for pose in robot.poses
    ]
    if robot.panes:
        ways.append((PARKED, partial(_arrived, robot, gate.park())))
    for start, way in ways:
        if (state := way()) is None:
            continue
        for step in found.steps:
            try:
                _begun(step, state, Seat(token="", language="en", lesson=found.id), start)
            except _Wrong as wrong:
                yield OF_STEP.format(step=step.id, what=wrong.text)


def _arrived(robot: Robot, ask: Update) -> State | None:
    return settled(ask(initial_state(robot)))


def _begun(step: Step, state: State, seat: Seat, start: Text) -> State:
    """The state at rest after the setup of a step."""
    asked = step.setup(state)
    if asked.arm.q is not state.arm.q:
        raise _Wrong(MOVES)
    if _met(step, asked, seat):
        raise _Wrong(TOO_SOON.format(start=start))
    if (begun := settled(asked)) is None:
        raise _Wrong(RESTLESS.format(seconds=LONGEST, start=start))
    if _met(step, begun, seat) or _met(step, played(begun, 5.0), seat):
        raise _Wrong(TOO_SOON.format(start=start))
    return begun


def _solved(step: Step, state: State, seat: Seat) -> tuple[State, Seat]:
    """The state and the seat after the solution. Every part of the solution has to be necessary."""
    if not step.solution:
        raise _Wrong(NO_SOLUTION)
    for n, part in enumerate(step.solution):
        if n and _met(step, state, seat):
            raise _Wrong(NEEDLESS.format(n=n, count=len(step.solution)))
        state, seat = done(state, seat, part)
    if not _met(step, state, seat):
        raise _Wrong(UNSOLVED)
    return state, replace(seat, done=seat.done | {step.id})


def _met(step: Step, state: State, seat: Seat) -> bool:
    answer = step.goal(state, seat)
    if not isinstance(answer, bool | np.bool_):
        raise _Wrong(NO_FALSE.format(kind=type(answer).__name__))
    return bool(answer)
