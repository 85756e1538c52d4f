"""One posture for a pose, to 10⁻⁶ m and rad and within the limits, beside the Robotics Toolbox's search in C++."""

from __future__ import annotations

import numpy as np
from tests.benchmarks.children.turns import Numbers, timed
from tests.benchmarks.ik_turns import (
    Run,
    Turn,
    faster,
    faster_on_average,
    in_turn,
    judged,
    line,
    or_left_out,
    taking_part,
    turn_of,
)
from tests.benchmarks.kinematics import urdf_of
from tests.benchmarks.peers import Child, Peer

from helicoide.arrays import Array
from helicoide.ik.postures.branch import between
from helicoide.ik.postures.numeric import first_posture
from helicoide.ik.postures.solve import solve
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.tool_kernels import arm_array, tool_pose

PEERS = (Peer("roboticstoolbox-python", "with_toolbox_ik.py"),)
ROBOTS = ("puma560", "ur5", "panda", "movemaster")
POSES, LENGTH, ROUNDS = 1000, 50, 5
TOLERANCE, FASTER, SOLVED = 1e-6, 8.0, 3.0
ROUNDING = 1e-12
HOW = (
    "1,000 poses of postures drawn within the limits; from `ready`, then from drawn postures, up to 100 searches of",
    "30 steps; each answer is judged by our forward kinematics and by the limits. Theirs ends at ½ e² ≤ ½ 10⁻¹².",
)


def _solved(robot: Robot, poses: list[Array], run: Run) -> Array:
    """Whether each answer (q, searches) reaches its pose within the limits, (rounds · poses,)."""
    arm = arm_array(robot)
    return np.array([_reaches(robot, arm, *asked) for asked in zip(poses * ROUNDS, run.answers, strict=True)])


def _reaches(robot: Robot, arm: Array, pose: Array, answer: tuple[Numbers, int]) -> bool:
    q = np.array(answer[0])
    missed, turned = between(pose, tool_pose(arm, q))
    within = np.all((q >= robot.lower - ROUNDING) & (q <= robot.upper + ROUNDING))
    return bool(within) and missed <= TOLERANCE and turned <= TOLERANCE


def _said(run: Run, solved: Array) -> str:
    searches = np.array([searches for _, searches in run.answers])
    return (
        f"{100 * solved.mean():.2f} % solved, {searches.mean():.2f} searches on average, {int(searches.max())} at most"
    )


def _searched(robot: Robot, poses: list[Array], start: Array) -> Turn:
    """The turns of our search."""

    def turn(first: int, beyond: int) -> tuple[list[float], Numbers]:
        seconds, found = timed(lambda k: first_posture(robot, poses[k], start), range(first, beyond))
        return seconds, [(q[:-4], q[-1]) for q in found]

    return turn


def _answered(robot: Robot, poses: list[Array], start: Array) -> Turn:
    """The turns of our front door."""

    def turn(first: int, beyond: int) -> tuple[list[float], Numbers]:
        seconds, found = timed(lambda k: solve(robot, poses[k], start), range(first, beyond))
        return seconds, [(answer.q[0], 1) for answer in found]

    return turn


def _measure(name: str, child: Child) -> None:
    robot = load_robot(name)
    rng, arm, start = np.random.default_rng(0), arm_array(robot), robot.poses["ready"]
    qs = rng.uniform(robot.lower, robot.upper, (POSES, len(robot.variables)))
    poses = [tool_pose(arm, q) for q in qs]
    limits = {"lower": robot.lower.tolist(), "upper": robot.upper.tolist()}
    goals = {"poses": [pose.tolist() for pose in poses], "start": start.tolist(), "tolerance": TOLERANCE}
    child.ask({"given": {"urdf": urdf_of(robot), **limits, **goals}})
    for statement, turns, goal in (
        ("posture(robot, T, q)", _searched(robot, poses, start), FASTER),
        ("solve(robot, T, q)", _answered(robot, poses, start), SOLVED),
    ):
        ours, theirs = in_turn(turns, turn_of(child), POSES, LENGTH, ROUNDS)
        solved = _solved(robot, poses, ours)
        line("ours", ours, f"{_said(ours, solved)}  {statement}")
        line(child.name, theirs, f"{_said(theirs, _solved(robot, poses, theirs))}  ets.ik_LM(T, q0, …)")
        judged(f"{name}, {statement}, every pose solved", bool(solved.all()))
        faster(f"{name}, {statement} beside {child.name}", ours, theirs, goal)
        faster_on_average(f"{name}, {statement} beside {child.name}", ours, theirs, goal)


def run() -> None:
    print("\n".join(f"  {said}" for said in HOW))
    with taking_part(PEERS) as children:
        for child in children:
            for name in ROBOTS:
                print(f"  {name}, one posture")
                with or_left_out(child, name):
                    _measure(name, child)
