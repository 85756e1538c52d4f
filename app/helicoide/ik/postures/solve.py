"""The entry to inverse kinematics: the closed form of an arm if it has one, else searches; or a solver by name."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.confinement import Obstacles, planes_of
from helicoide.ik import Limits, Problem, closed, methods
from helicoide.ik.clik import TaskFunction, task_from, to_pose
from helicoide.ik.converge import StoppingCriterion, Tolerance, converged, solver_of
from helicoide.ik.method import ConfiguredMethod, Method, Task
from helicoide.ik.postures import listing, numeric, subspace
from helicoide.ik.postures.answer import Answer, Form, Found, Words, answer_as_found, answer_in_order
from helicoide.ik.postures.branch import check_pose, pose_of, sentences
from helicoide.ik.postures.choice import Ranked, ranked, touching
from helicoide.ik.postures.measure import left
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

NUMERIC = "numeric"
EXACT = Tolerance(listing.REACHED, listing.REACHED)  # the largest errors of a goal that counts as reached
FACTOR, PERIOD, STEPS = 0.5, 0.1, 1000  # of an iteration: step factor, duration of a step, s, number of steps

REACHED = Text(en="reached", pt_BR="alcançado")
OUT = Text(
    en="out of reach by {mm:.3f} mm and {degrees:.3f}°", pt_BR="fora do alcance por {mm:.3f} mm e {degrees:.3f}°"
)
LEFT = Text(
    en="not reached: remaining error {mm:.3f} mm and {degrees:.3f}°",
    pt_BR="não alcançado: erro restante de {mm:.3f} mm e {degrees:.3f}°",
)
LIMITED = Text(en="reached only outside the joint limits", pt_BR="alcançado só fora dos limites das juntas")
PROJECTED = Text(
    en="projected by {degrees:.3f}° and {mm:.3f} mm onto the poses of the arm: {status}",
    pt_BR="projetado por {degrees:.3f}° e {mm:.3f} mm nas poses do braço: {status}",
)


def solve(
    robot: Robot, T_world_tool: ArrayLike, q: ArrayLike, every: bool = False, with_orientation: bool = True
) -> Answer:
    """Every posture for a tool pose, or the one within the limits with the smallest motion from q.

    Args: T_world_tool (4, 4), m; q (n,), rad or m; every: whether all are asked for; with_orientation: False for the
    position alone. For an arm with fewer than six joints, a goal that it cannot take is projected to the nearest that
    it can. If one is asked for and none within the limits reaches the goal, it is the nearest that was found.
    Raises HelicoideError for an invalid pose or q.
    """
    T, q = pose_of(T_world_tool), robot.joint_array(q)
    for form in closed.of(robot).values():
        if with_orientation or form.OF_POINTS:
            return _by_form(robot, form, T, q, every, with_orientation)
    return _searched(robot, T, q, every, with_orientation)


def solve_by(
    name: str, robot: Robot, T_world_tool: ArrayLike, q: ArrayLike, every: bool = False, with_orientation: bool = True
) -> Answer:
    """`solve` with the solver of that name: a closed form, `numeric`, or a method that iterates from q.

    Raises HelicoideError, also where the solver does not apply; the message lists the names that are valid here.
    """
    T, q = check_pose(T_world_tool), robot.check_joints(q)
    if name == NUMERIC:
        return _searched(robot, T, q, every, with_orientation)
    if name in methods.names():
        return _iterated(robot, methods.named(name), T, q, with_orientation)
    if name not in closed.closed_forms():
        why = Text(en=f"There is no way {name!r}.", pt_BR=f"Não existe o modo {name!r}.")
        raise _refused(robot, why, with_orientation)
    form = closed.closed_forms()[name]
    reason = form.applies(robot) if with_orientation or form.OF_POINTS else _WHOLE
    if reason is not None:
        why = sentences(Text(en=f"{name} does not apply.", pt_BR=f"{name} não se aplica."), reason)
        raise _refused(robot, why, with_orientation)
    return _by_form(robot, form, T, q, every, with_orientation)


_WHOLE = Text(en="A closed form needs an orientation.", pt_BR="Uma forma fechada precisa de orientação.")


def ways(robot: Robot, with_orientation: bool = True) -> tuple[str, ...]:
    """The names that `solve_by` accepts for a robot, for a pose or for a position alone."""
    _, aiming = _aiming(robot, robot.T_world_tool_0, with_orientation)
    task = _task(aiming, robot.poses["ready"])
    iterating = (name for name in methods.names() if methods.named(name).applies(task) is None)
    return (*_forms(robot, with_orientation), NUMERIC, *iterating)


def _forms(robot: Robot, with_orientation: bool) -> dict[str, Form]:
    """The closed forms of an arm by name, for a pose or for a position alone."""
    return {name: form for name, form in closed.of(robot).items() if with_orientation or form.OF_POINTS}


def _refused(robot: Robot, why: Text, with_orientation: bool) -> HelicoideError:
    valid = Text(en="Forms for {robot}: {ways}.", pt_BR="Formas para {robot}: {ways}.")
    known = ", ".join(ways(robot, with_orientation))
    return HelicoideError(sentences(why, valid.format(robot=robot.name, ways=known)))


def _by_form(robot: Robot, form: Form, T: Array, q: Array, every: bool, with_orientation: bool) -> Answer:
    """The answer of a closed form; where one posture is asked for and none is within the limits, the nearest that is.

    For a position alone the pose has the orientation of the arm there, so that the projection does not rotate it.
    """
    if not with_orientation:
        T = T.copy()
        T[:3, :3] = subspace.project_point(robot, T, q).T_world_goal[:3, :3]
    found = form.find(robot, T, q)
    answer = answer_in_order(robot, found, T, q, with_orientation)
    if every:
        return answer
    if answer.is_solved:
        return answer.nearest
    one = numeric.one(robot, found.T_world_goal, q, with_orientation)
    told = Words(
        one.explanation.names, sentences(found.explanation.words, one.explanation.words), free=found.explanation.free
    )
    one = one._replace(explanation=told, moved=found.moved, turned=found.turned, short=max(found.short, one.short))
    return answer_in_order(robot, one, T, q, with_orientation)


def _searched(robot: Robot, T: Array, q: Array, every: bool, with_orientation: bool) -> Answer:
    """The answer of the searches; if an arm with fewer than six joints does not reach the goal, it is projected."""
    find = numeric.every if every else numeric.one
    answer = answer_in_order(robot, find(robot, T, q, with_orientation), T, q, with_orientation)
    if _is_met(answer) or len(robot.variables) >= 6:
        return answer
    goal = (subspace.project_to_subspace if with_orientation else subspace.project_point)(robot, T, q)
    if goal.words is None:
        return answer
    found = find(robot, goal.T_world_goal, q, with_orientation)
    told = Words(found.explanation.names, sentences(goal.words, found.explanation.words))
    found = found._replace(explanation=told, moved=goal.moved, turned=goal.turned)
    return answer_in_order(robot, found, T, q, with_orientation)


def _iterated(robot: Robot, method: Method, T: Array, q: Array, with_orientation: bool) -> Answer:
    """The result of a method that iterates from q, with its default settings, without limits and planes."""
    goal = subspace.project_to_subspace(robot, T, q) if with_orientation else subspace.Projection(T, 0.0, 0.0)
    problem, aiming = _aiming(robot, goal.T_world_goal, with_orientation)
    why = method.applies(_task(aiming, q))
    if why is not None:
        raise _refused(robot, why, with_orientation)
    inverse, until = ConfiguredMethod(method, method.Options()), StoppingCriterion(EXACT, STEPS)
    report = converged(solver_of(problem, inverse, FACTOR, until, dt=PERIOD), aiming, q)
    told = Words((method.TITLE,), sentences(goal.words, report.words))
    found = Found(report.q[None], goal.T_world_goal, told, goal.moved, goal.turned)
    return answer_as_found(robot, found, T, with_orientation)


def ranked_postures(
    robot: Robot, answer: Answer, q: Array, weights: ArrayLike, obstacles: Obstacles, with_orientation: bool
) -> tuple[Ranked, ...]:
    """The postures of an answer by increasing weighted motion from q, those that miss the goal or are ruled out last.

    Arguments and errors as in `choice.ranked`. Source: Campos 1998, s.17.
    """
    rows = ranked(robot, answer.branches, q, weights, touching(robot, obstacles))

    def misses(row: Ranked) -> bool:
        return not EXACT.holds(*left(robot, row.branch.q, answer.T_world_goal, with_orientation))

    return tuple(sorted(rows, key=lambda row: (row.dropped is not None, misses(row))))


def _aiming(robot: Robot, T_world_goal: Array, with_orientation: bool) -> tuple[Problem, TaskFunction]:
    """The problem and the task of a method for a pose (4, 4), m."""
    problem = Problem(robot, Limits(robot.lower, robot.upper, robot.speed), planes_of(()))
    return problem, to_pose(problem, T_world_goal, with_orientation)


def _task(aiming: TaskFunction, q: Array) -> Task:
    """The first task of a method, at q (n,)."""
    return task_from(aiming(q, 0.0), FACTOR / PERIOD, q, PERIOD)


def _is_met(answer: Answer) -> bool:
    """Whether the first posture reaches the pose that was solved for."""
    return answer.left is not None and EXACT.holds(*answer.left)


def reached(answer: Answer) -> bool:
    """Whether a posture within the joint limits reaches the pose that was asked for."""
    return any(branch.within and EXACT.holds(branch.missed, branch.turned) for branch in answer.branches)


def answer_status(answer: Answer) -> Text:
    """In few words: reached, or the remaining errors, and whether the goal was projected."""
    if reached(answer):
        return REACHED
    if any(EXACT.holds(branch.missed, branch.turned) for branch in answer.branches):
        return LIMITED
    if EXACT.holds(answer.moved, answer.turned):
        return _short_by(answer)
    if not _is_met(answer):
        said, missed, turned = _short_by(answer), answer.moved, answer.turned
    else:
        best = answer.branches[0]
        said, missed, turned = REACHED if best.within else LIMITED, best.missed, best.turned
    return PROJECTED.format(mm=1000 * missed, degrees=np.degrees(turned), status=said)


def _short_by(answer: Answer) -> Text:
    """The errors of the best posture against the pose that was solved for, in words."""
    missed, turned = (answer.short, 0.0) if answer.left is None else answer.left
    words = OUT if answer.short > EXACT.position or not answer.branches else LEFT
    return words.format(mm=1000 * missed, degrees=np.degrees(turned))
