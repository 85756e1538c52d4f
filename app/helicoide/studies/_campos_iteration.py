"""Where iterations from many random starts lead: to which posture of a goal, how often, and in how many iterations."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem, methods
from helicoide.ik.clik import to_pose
from helicoide.ik.converge import Report, StoppingCriterion, converged, solver_of
from helicoide.ik.methods import configured_method
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.ik.postures.solve import EXACT
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_rows import posture_motion
from helicoide.studies.study import Chart, ChartLine, Motion, Row
from helicoide.text import Text, untranslated

NAMES = {"puma560": untranslated("PUMA"), "movemaster": untranslated("Movemaster")}
# The joint values, rad, whose pose is the goal.
EXAMPLE = {"puma560": (0.3, -0.5, 0.7, 0.4, 0.9, -1.1), "movemaster": (0.3, 1.8, -2.0, -1.0, 0.9)}
CAP, PERIOD = 300, 0.1

Start = tuple[Array, Report]


def converged_from_starts(robot: Robot, count: int) -> list[Start]:
    """The random starts (n,), rad, and what damped least squares reach from each, for the goal of `EXAMPLE`."""
    problem = Problem(robot, Limits(robot.lower, robot.upper, robot.speed), planes_of(()))
    aiming = to_pose(problem, tool_at(robot, np.array(EXAMPLE[robot.name])), True)
    solver = solver_of(problem, configured_method("damped"), 0.5, StoppingCriterion(EXACT, CAP), dt=PERIOD)
    starts = np.random.default_rng(24).uniform(-2.5, 2.5, (count, len(robot.variables)))
    return [(q, converged(solver, aiming, q)) for q in starts]


def iteration_rows(robot: Robot, starts: list[Start], answer: Answer) -> Iterator[Row]:
    """The share of starts that reach the goal, how many different postures they reach, and the mean iterations."""
    ends = [_nearest(answer, report) for _, report in starts if report.reached]
    passes = [report.iterations for _, report in starts if report.reached]
    yield Row(LED.format(arm=NAMES[robot.name]), len(ends) / len(starts))
    yield Row(DIFFERENT.format(arm=NAMES[robot.name]), len(set(ends)))
    yield Row(PASSES.format(arm=NAMES[robot.name]), float(np.mean(passes)))


def _nearest(answer: Answer, report: Report) -> int:
    """The number, from 1, of the posture that is nearest to where an iteration ended."""
    ways = [float(np.abs(wrap(branch.q - report.q)).max()) for branch in answer.branches]
    return int(np.argmin(ways)) + 1


def iteration_charts(robot: Robot, starts: list[Start], answer: Answer) -> Iterator[Chart]:
    """The position error of the first iterations that reach the goal, and the share of starts for each posture."""
    met = [report for _, report in starts if report.reached][:4]
    yield Chart(
        ERRORS.format(arm=NAMES[robot.name]),
        Text(en="iterations", pt_BR="iterações"),
        untranslated("m"),
        tuple(
            ChartLine(START.format(n=n), np.arange(0.0, len(report.errors)), report.errors[:, 0] + 1e-17)
            for n, report in enumerate(met, start=1)
        ),
        log=True,
    )
    numbers = np.arange(1.0, len(answer.branches) + 1)
    ends = np.array([_nearest(answer, report) for _, report in starts if report.reached])
    shares = np.array([np.sum(ends == n) / len(starts) for n in numbers])
    yield Chart(
        WHICH.format(arm=NAMES[robot.name]),
        Text(en="posture", pt_BR="postura"),
        Text(en="share of starts", pt_BR="fração das partidas"),
        (ChartLine(methods.named("damped").TITLE, numbers, shares),),
    )


def iteration_motion(robot: Robot, starts: list[Start]) -> Motion:
    """The first starts that reach the goal, each followed by the posture it reaches."""
    postures = [frozen(q) for start, report in starts[:8] if report.reached for q in (start, report.q)]
    return posture_motion(robot.name, postures, title=ENDS.format(arm=NAMES[robot.name]))


LED = Text(en="{arm}, iteration: share of starts that lead there", pt_BR="{arm}, iteração: fração que chega ao alvo")
DIFFERENT = Text(
    en="{arm}, iteration: different postures that the starts lead to",
    pt_BR="{arm}, iteração: posturas diferentes a que as partidas levam",
)
PASSES = Text(en="{arm}, iteration: passes for one posture", pt_BR="{arm}, iteração: passos para uma postura")
ERRORS = Text(en="{arm}: error of position while iterating", pt_BR="{arm}: erro de posição ao iterar")
START = Text(en="start {n}", pt_BR="partida {n}")
WHICH = Text(en="{arm}: which posture a start leads to", pt_BR="{arm}: a que postura cada partida leva")
ENDS = Text(en="{arm}: starts of the iteration, and where they lead", pt_BR="{arm}: partidas da iteração e aonde levam")
