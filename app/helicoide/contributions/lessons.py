"""Faults of a lesson: its texts in both languages, the names it uses, and its steps, played on its own robot."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import chain

import numpy as np

from helicoide import content, gate, kernels, lesson
from helicoide.contributions.lesson_names import name_faults
from helicoide.contributions.lesson_playing import LONGEST, done, played, settled
from helicoide.contributions.lesson_values import value_faults
from helicoide.contributions.lesson_words import word_faults
from helicoide.contributions.loading import collected_faults
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.lesson import Diagnosis, Lesson, Solution, Step, StepGoal
from helicoide.lesson.watching import MISTAKEN_FOR
from helicoide.seat import Seat
from helicoide.state import State, Update, initial_state
from helicoide.text import HelicoideError, Text
from helicoide.view.window import new_seat

BETWEEN = 0.2  # s between two looks at a goal that has to hold
AT_LOAD = Text(
    en="it computes while the file is loaded, when the kernels may not be there; use a function, as fixed(lambda: …)",
    pt_BR="faz contas enquanto o arquivo é carregado, quando os kernels podem faltar; use uma função, como "
    "fixed(lambda: …)",
)
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
NOT_LONG = Text(
    en="its goal does not hold for {seconds} s after its solution",
    pt_BR="o objetivo não se mantém por {seconds} s depois da solução",
)
NEEDLESS = Text(
    en="its goal is met after {n} of the {count} parts of its solution: leave the others out",
    pt_BR="o objetivo é cumprido com {n} das {count} partes da solução: tire as outras",
)
NO_FALSE = Text(en="its goal answers {kind}, not True or False", pt_BR="o objetivo responde {kind}, não True ou False")
OF_DIAGNOSIS = Text(en="diagnosis {name}: {what}", pt_BR="diagnóstico {name}: {what}")
NO_WRONG = Text(en="it has no wrong path", pt_BR="falta o caminho errado")
NOT_FOUND = Text(
    en="its wrong path does not lead to it: {found} applies {seconds} s after it",
    pt_BR="o caminho errado não leva a ele: {seconds} s depois dele, vale {found}",
)
NONE = Text(en="no diagnosis", pt_BR="nenhum diagnóstico")
SOLVES = Text(en="its wrong path reaches the goal", pt_BR="o caminho errado chega ao objetivo")
AT_ONCE = Text(en="it applies before anything is done", pt_BR="ele já vale antes de se fazer algo")
BEFORE = Text(en="the end of the step before", pt_BR="onde termina o passo anterior")
NOT_RESET = Text(
    en="its goal is still met after its solution and a reset",
    pt_BR="o objetivo continua cumprido depois da solução e de reiniciar o passo",
)
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
        with kernels.run_none(HelicoideError(AT_LOAD)):
            found = lesson.read_lesson(name)
        robot = load_robot(found.robot)
    except HelicoideError as error:
        return (error.text,)
    said = chain(
        word_faults(found, robot), name_faults(found, robot), _whole(found, robot), _from_anywhere(found, robot)
    )
    return collected_faults(content.content_folder("lessons", name) / "lesson.py", said)


def _whole(found: Lesson, robot: Robot) -> Iterator[Text]:
    """The faults of the steps, each started where the one before has ended, with its wrong paths and its reset."""
    state, seat = initial_state(robot), lesson.entered(new_seat("", "en", None), found.id)
    for number, step in enumerate(found.steps):
        seat = lesson.with_step_shown(lesson.turned_to(found, seat, number), step)
        try:
            begun = _begun(step, state, seat, BEFORE)
            yield from (OF_STEP.format(step=step.id, what=fault) for fault in _begun_faults(found, step, begun, seat))
            state, seat = _solved(step, begun, seat)
            yield from (OF_STEP.format(step=step.id, what=fault) for fault in value_faults(found, step, state, seat))
            _check_reset(step, state, lesson.with_step_shown(seat, step))
        except _Wrong as wrong:
            yield OF_STEP.format(step=step.id, what=wrong.text)
        seat = lesson.without_step_shown(lesson.progressed(step, seat), step)


def _begun_faults(found: Lesson, step: Step, begun: State, seat: Seat) -> Iterator[Text]:
    yield from value_faults(found, step, begun, seat)
    for diagnosis in step.diagnoses:
        for fault in _diagnosis_faults(step, diagnosis, begun, seat):
            yield OF_DIAGNOSIS.format(name=diagnosis.id, what=fault)


def _diagnosis_faults(step: Step, diagnosis: Diagnosis, begun: State, seat: Seat) -> Iterator[Text]:
    """The faults of a diagnosis: its wrong path must lead to it, and not to the goal."""
    if _answer(diagnosis.when, begun, seat):
        yield AT_ONCE
    if not diagnosis.wrong:
        yield NO_WRONG
        return
    state = begun
    for part in diagnosis.wrong:
        state, seat = done(state, seat, part)
    state = played(state, MISTAKEN_FOR)
    if _met(step, state, seat):
        yield SOLVES
    if (made := lesson.mistake_made(step, state, seat)) != diagnosis.id:
        yield NOT_FOUND.format(found=made or NONE, seconds=MISTAKEN_FOR)


def _from_anywhere(found: Lesson, robot: Robot) -> Iterator[Text]:
    """The faults of the setups from other starts: each named pose, and the parked arm if there are planes."""
    ways: list[tuple[Text, Callable[[], State | None]]] = [
        (POSE.format(title=robot.pose_titles[pose]), partial(_arrived, robot, gate.go_to(pose))) for pose in robot.poses
    ]
    if robot.panes:
        ways.append((PARKED, partial(_arrived, robot, gate.park())))
    entered = lesson.entered(new_seat("", "en", None), found.id)
    for start, way in ways:
        if (state := way()) is None:
            continue
        for number, step in enumerate(found.steps):
            seat = lesson.with_step_shown(lesson.turned_to(found, entered, number), step)
            try:
                _begun(step, state, seat, start)
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


def _check_reset(step: Step, state: State, seat: Seat) -> None:
    """A step that is set up again after its solution begins anew."""
    begun = settled(step.setup(state))
    if begun is None or _met(step, begun, seat):
        raise _Wrong(NOT_RESET)


def _solved(step: Step, state: State, seat: Seat) -> tuple[State, Seat]:
    """The state and the seat after the solution. Every part of the solution has to be necessary."""
    if step.goal is None:
        return _after(step.solution, state, seat)
    if not step.solution:
        raise _Wrong(NO_SOLUTION)
    for n, part in enumerate(step.solution):
        if n and _met(step, state, seat):
            raise _Wrong(NEEDLESS.format(n=n, count=len(step.solution)))
        state, seat = done(state, seat, part)
    if not _met(step, state, seat):
        raise _Wrong(UNSOLVED)
    for _ in range(round(step.held_for / BETWEEN)):
        state = played(state, BETWEEN)
        if not _met(step, state, seat):
            raise _Wrong(NOT_LONG.format(seconds=step.held_for))
    return state, seat


def _after(solution: Solution, state: State, seat: Seat) -> tuple[State, Seat]:
    for part in solution:
        state, seat = done(state, seat, part)
    return state, seat


def _met(step: Step, state: State, seat: Seat) -> bool:
    return step.goal is not None and _answer(step.goal, state, seat)


def _answer(goal: StepGoal, state: State, seat: Seat) -> bool:
    answer = goal(state, seat)
    if not isinstance(answer, bool | np.bool_):
        raise _Wrong(NO_FALSE.format(kind=type(answer).__name__))
    return bool(answer)
