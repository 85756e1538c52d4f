"""Chapter 6 of Cerbaro 2022: three paths in a foam enclosure, each in three cases.

Case 1 keeps the orientation (five tasks, no freedom left); case 2 leaves it free and keeps the joints off their limits
with one gain; case 3 does so with the gains of Algorithm 1, which grow. Runs follow the source's rules, or take the
constrained QP step.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from helicoide.arrays import Array
from helicoide.command import FollowPath
from helicoide.confinement import planes_of
from helicoide.foresight import advance_with_search
from helicoide.ik import Limits, Problem, limit_gains, objectives
from helicoide.ik.adaptation import Rule, TargetPoints, Track, adapted, moving_point_distances, trimmed
from helicoide.ik.clik import ControlLaw, LoopStep, TaskFunction
from helicoide.ik.controller import Controller, SecondaryObjective
from helicoide.ik.converge import INNER, IterativeSolver, StoppingCriterion, Tolerance, converged, solver_of
from helicoide.ik.limit_gains import GROWTH, GrowingObjective, LimitGainMemory
from helicoide.ik.secondary import push
from helicoide.kinematics.library import load_robot
from helicoide.state import State, initial_state, with_command
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.study import Progress
from helicoide.trajectory import EQ_33, Ellipse

ELLIPSE = EQ_33
# Eq. 34 prints 500 mm for the last radius, which its own end points contradict.
LINE = Ellipse(centre=(0.55, 0.0, 0.23), radii=(0.0, 0.25, 0.05), pitch=0.0, roll=np.pi / 2)
CIRCLE = Ellipse(centre=(0.48, 0.1, 0.2), radii=(0.22, 0.22, 0.0), pitch=-1.2217, roll=0.5236)

CEILING, WALLS_AND_BENCH = 0, (1, 2, 3)
SAMPLES, SAMPLES_SHORT = 301, 121
CONTROL_PERIOD, LONGEST = 0.01, 90.0
DT = 1e-3


@dataclass(frozen=True)
class Gains:
    """Values that the source omits: k₀, 1/s; step factor κ; tolerance, m; λ, mm/rad; growth of gains in Algorithm 1."""

    k0: float
    factor: float
    tolerance: float
    damping: float = 0.1
    growth: float = GROWTH


@dataclass(frozen=True, eq=False)
class ConfinedRun:
    """A run along a path: desired and trimmed points (k, 3), m, and the outcome; q, tool, near as in `Track`."""

    desired: Array
    trimmed: Array
    q: Array
    tool: Array
    distances: Array
    errors: Array
    target_moves: Array
    gains: Array

    @property
    def least_distances(self) -> Array:
        """Least distance to each plane, mm."""
        return np.asarray(1000 * self.distances.min(axis=0))

    @property
    def deviations(self) -> Array:
        """Distance of the tool from the desired point, (k,), mm."""
        return np.asarray(1000 * np.linalg.norm(self.tool - self.desired, axis=1))

    @property
    def deviation(self) -> float:
        """The mean deviation, mm."""
        return float(self.deviations.mean())


def confined_problem() -> Problem:
    """The Movemaster in the measured enclosure, ±90° at the waist, rows in mm."""
    robot = load_robot("movemaster")
    return Problem(robot, Limits(robot.lower, robot.upper, robot.speed), planes_of(robot.panes), scale=setups.MM)


def source_rule() -> Rule:
    """The source's rule with eq. 36 corrected: only the ceiling is monitored; in its warning zone nothing may rise."""
    return Rule((CEILING,), level=True)


def limit_margins(problem: Problem, q: Array) -> Array:
    """The least margin of each joint to its limits, degrees, (n,); negative outside."""
    lower, upper = problem.limits.lower, problem.limits.upper
    return np.asarray(np.degrees(np.minimum(q - lower, upper - q).min(axis=0)))


def solver_of_case(problem: Problem, case: int, gains: Gains) -> IterativeSolver:
    """The solver of a case: damped least squares, with the objective in cases 2 and 3 and Algorithm 1 in case 3."""
    inverse, until = setups.damped_inverse(gains.damping), StoppingCriterion(Tolerance(gains.tolerance))
    if case == 1:
        return solver_of(problem, inverse, gains.factor, until)
    chosen = setups.limit_distance()
    if case == 2:
        return solver_of(problem, inverse, gains.factor, until, push(problem, chosen, gains.k0), DT)
    law, objective = ControlLaw(inverse, gains.factor / DT, DT), GrowingObjective(chosen, gains.growth)
    first = LimitGainMemory(np.full(len(problem.limits.lower), gains.k0))

    def run(aiming: TaskFunction, q: Array, memory: LimitGainMemory | None) -> Iterator[LoopStep]:
        return limit_gains.loop_with_limit_gains(problem, law, objective, aiming, q, memory or first)

    return IterativeSolver(problem, run, until)


def task_of_case(problem: Problem, case: int, path: Ellipse, target: Array) -> TaskFunction:
    """The task of a case for a target (3,), m."""
    point = setups.fixed_point(*target)
    if case == 1:
        return setups.pitch_and_roll_task(problem, point, path.pitch, path.roll)
    return setups.position_task(problem, point)


def path_samples(path: Ellipse, samples: int) -> Array:
    """Points of one turn, including both ends, (k, 3), m."""
    return np.array([path.point(s) for s in np.linspace(0, path.period, samples)])


def run_by_rule(path: Ellipse, case: int, gains: Gains, rule: Rule, samples: int, progress: Progress) -> ConfinedRun:
    """The source's experiment: from home to the first point, then along the path, which is moved away from planes."""
    problem = confined_problem()
    solver, task = solver_of_case(problem, case, gains), partial(task_of_case, problem, case, path)
    points = path_samples(path, samples)
    targets = trimmed(points, problem.planes, WALLS_AND_BENCH, problem.zones.warning)
    begin = converged(solver, task(targets[0]), problem.robot.poses["home"])
    per_point = replace(solver, until=replace(INNER, tolerance=solver.until.tolerance))
    track = adapted(per_point, TargetPoints(targets, task), begin.q, rule, begin.memory, progress)
    return _course(problem, points, targets, track, gains)


def _course(problem: Problem, points: Array, targets: Array, track: Track, gains: Gains) -> ConfinedRun:
    tool = np.array([setups.tool_position(problem, q) for q in track.q])
    grown = track.memory.gains if isinstance(track.memory, LimitGainMemory) else np.full(track.q.shape[1], gains.k0)
    return ConfinedRun(points, targets, track.q, tool, track.near, track.errors, track.moved, grown)


def run_constrained(path: Ellipse, k0: float, seconds: float, progress: Progress) -> ConfinedRun:
    """The same path with the constrained QP step of the page; the objective has a lower priority than the task.

    Joint limits are hard constraints, so Algorithm 1 has nothing to clip and cases 2 and 3 coincide. k0: 1/s; seconds:
    duration along the path, from its start.
    """
    state, turn = _on_the_path(path, k0), round(seconds / CONTROL_PERIOD)
    points, q, near = [], [], []
    for step in range(turn):
        state = advance_with_search(state, CONTROL_PERIOD)
        points.append(path.point(state.request.path_s))
        q.append(state.arm.q)
        near.append(moving_point_distances(state.problem, state.arm.q.copy()))
        progress((step + 1) / turn)
    desired, tool = np.array(points), np.array([setups.tool_position(state.problem, one) for one in q])
    errors = np.linalg.norm(tool - desired, axis=1)
    return ConfinedRun(desired, desired, np.array(q), tool, np.array(near), errors, np.zeros(turn), np.full(5, k0))


def _on_the_path(path: Ellipse, k0: float) -> State:
    """The page's state with the arm at the start of the path, or as near to it as the planes allow."""
    state = initial_state(load_robot("movemaster"))
    drive = Controller(secondary=SecondaryObjective("limit_distance", objectives.named("limit_distance").Options(), k0))
    state = with_command(
        replace(state, request=replace(state.request, controller=drive, with_orientation=False)),
        FollowPath(path, 0.0, playing=True),
    )
    for _ in range(round(LONGEST / CONTROL_PERIOD)):
        if isinstance(state.request.command, FollowPath) and state.request.command.arrived:
            break
        state = advance_with_search(state, CONTROL_PERIOD)
    return state
