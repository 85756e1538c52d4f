"""What comes of one URDF file: its arms, what they answer, and its picture; nothing that goes wrong stops the rest."""

from __future__ import annotations

import json
import signal
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from time import process_time
from types import FrameType

import numpy as np
from tests.benchmarks.corpus_findings import Findings, words_of
from tests.benchmarks.corpus_tree import Tree, apart

from helicoide.arrays import Array
from helicoide.commands.ik import answer_json
from helicoide.confinement import Obstacles
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.choice import equal_weights
from helicoide.ik.postures.solve import answer_status, ranked_postures, reached, solve
from helicoide.kinematics.forward import FORMULATIONS
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError
from helicoide.view import shapes

PATIENCE = 10.0  # of a file, s of the processor, so that a busy machine makes no file slow
POSTURES, POSES = 5, 20  # of an arm, for forward kinematics and there and back
FARTHEST = 10.0  # from zero that a posture is drawn, rad or m
TOLERANCE = 1e-6  # of a pose and of a limit, m and rad

Solve = Callable[[Robot, Array, Array], Answer]


class TooLong(BaseException):
    """A file's time is over; not an Exception, which what is interrupted might catch."""


def look(path: Path, solving: Solve = solve, patience: float = PATIENCE) -> Findings:
    """What comes of a file, each thing that a person may ask of it in so many seconds of the processor.

    solving: inverse kinematics.
    """
    found, begun = Findings(), process_time()
    doing = "reading"
    try:
        with _limited(patience):
            tree = _tree(path)
            if tree is not None:
                found.is_drawn, found.meshes = tree.is_drawn, tree.meshes
            arms = list(_arms(path, tree, found))
        for robot in arms:
            doing = f"{robot.tool_link}: forward kinematics"
            with _limited(patience), _faults(found, doing):
                _forward(robot, tree, found)
        for robot in _different(arms):
            doing = f"{robot.tool_link}: there and back"
            with _limited(patience), _faults(found, doing):
                _there_and_back(robot, tree, found, solving)
        if arms:
            doing = "the picture"
            with _limited(patience), _faults(found, doing):
                _picture(arms[0], found)
    except TooLong:
        found.late = doing
    finally:
        shapes.load_shapes.cache_clear()
    found.seconds = process_time() - begun
    return found


@contextmanager
def _limited(seconds: float) -> Iterator[None]:
    def over(signum: int, frame: FrameType | None) -> None:
        raise TooLong

    before = signal.signal(signal.SIGPROF, over)
    signal.setitimer(signal.ITIMER_PROF, seconds, 1.0)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)


@contextmanager
def _faults(found: Findings, doing: str) -> Iterator[None]:
    try:
        yield
    except Exception as error:
        last = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{'/'.join(Path(last.filename).parts[-2:])}:{last.lineno}: {last.line}"
        found.faults.append(f"{doing}: {type(error).__name__}: {str(error)[:100]} ({where})")


def _tree(path: Path) -> Tree | None:
    """Our own reading; None for a file that cannot be read."""
    try:
        return Tree.of(path)
    except Exception:
        return None


def _arms(path: Path, tree: Tree | None, found: Findings) -> Iterator[Robot]:
    """The arm that the file has by itself, and one for each end that moves where it branches or has none."""
    tips = tree.tips() if tree is not None else []
    for tip in (None, *tips):
        if tip in found.arms or (len(tips) == 1 and found.arms):
            continue
        with _faults(found, f"loading with tip {tip}"):
            try:
                robot = load_robot(str(path), tip)
            except HelicoideError as error:
                found.refused[tip or ""] = words_of(error)
            else:
                found.arms.append(robot.tool_link)
                yield robot


def _different(arms: list[Robot]) -> list[Robot]:
    """One arm of those that are moved by the same joints."""
    return list({tuple(joint.name for joint in robot.joints): robot for robot in reversed(arms)}.values())[::-1]


def _drawn(robot: Robot, count: int) -> Array:
    lower, upper = np.maximum(robot.lower, -FARTHEST), np.minimum(robot.upper, FARTHEST)
    outside = lower > upper
    lower, upper = np.where(outside, robot.lower, lower), np.where(outside, robot.upper, upper)
    return np.random.default_rng(0).uniform(lower, upper, (count, len(robot.variables)))


def _pose(robot: Robot, tree: Tree | None, q: Array) -> tuple[Array, float]:
    """Where our own reading has the tool, and how far it has the joints beyond their limits."""
    assert tree is not None, "it loads, and we cannot read it"
    values = {joint.name: float(x) for joint, x in zip(robot.variables, q, strict=True)}
    return tree.pose(robot.tool_link, values), tree.beyond(robot.tool_link, values)


def _forward(robot: Robot, tree: Tree | None, found: Findings) -> None:
    for q in _drawn(robot, POSTURES):
        T, _ = _pose(robot, tree, q)
        for name, road in FORMULATIONS.items():
            error = float(np.max(np.abs(road(robot, q) - T)))
            found.worst = max(found.worst, (error, f"{robot.tool_link} by {name}"))


def _picture(robot: Robot, found: Findings) -> None:
    try:
        found.picture = len(shapes.load_shapes(robot))
    except HelicoideError as error:
        found.unseen = words_of(error)


def _there_and_back(robot: Robot, tree: Tree | None, found: Findings, solving: Solve) -> None:
    for q in _drawn(robot, POSES):
        T, _ = _pose(robot, tree, q)
        ready = robot.poses["ready"]
        answer = solving(robot, T, ready)
        shown = ranked_postures(robot, answer, ready, equal_weights(robot), Obstacles(), True)
        json.dumps(answer_json(robot, answer, answer_status(answer), shown, T, True), allow_nan=False)
        found.asked += 1
        said = f"{robot.tool_link}: {answer_status(answer).en}; q = {[round(float(x), 6) for x in q]}"
        if not reached(answer):
            found.missed.append(said)
        elif (short := _falseness(robot, tree, answer, T)) > TOLERANCE:
            found.false.append(f"{said}; the pose or a limit is missed by {short:.2g}")


def _falseness(robot: Robot, tree: Tree | None, answer: Answer, T: Array) -> float:
    """By how much the best posture misses the pose or a limit, m or rad."""
    found = [_pose(robot, tree, branch.q) for branch in answer.branches]
    return min((max(apart(pose, T), beyond) for pose, beyond in found), default=np.inf)
