"""All postures for a pose of the PUMA 560, a UR5 and the Movemaster, by our closed forms and by EAIK's."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from tests.benchmarks.children.turns import Numbers, timed
from tests.benchmarks.ik_turns import Run, Turn, faster, in_turn, judged, line, or_left_out, taking_part, turn_of
from tests.benchmarks.peers import Child, Peer

from helicoide.arrays import Array
from helicoide.ik.families import movemaster_arm, parallel_postures, puma_arm
from helicoide.ik.families.parallel_arm import parallel_arm
from helicoide.ik.postures.branch import between
from helicoide.ik.postures.solve import solve
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.tool_kernels import arm_array, tool_pose

PEERS = (Peer("eaik", "with_eaik_ik.py"),)
POSES, LENGTH, ROUNDS = 1000, 50, 7
BARE, WORDED = 1.0, 0.5  # times as fast as theirs: the kernel, and the answer of which words can be read
ALIKE, MISSED = 1e-6, 1e-9
HOW = (
    "The same 1,000 poses for both, as 4 × 4 arrays; theirs is the bare call, without the making of arrays from its Q.",
    "EAIK takes arms of six joints: the Movemaster stands beside its time for the poses of the PUMA.",
)


def _same(ours: Numbers, theirs: Numbers) -> bool:
    """Whether both are the same set of postures, but for whole turns, each once."""
    apart = np.array(ours)[:, None] - np.array(theirs)[None]
    alike = (np.abs((apart + np.pi) % (2 * np.pi) - np.pi) < ALIKE).all(axis=2)
    return bool((alike.sum(axis=0) == 1).all() and (alike.sum(axis=1) == 1).all())


def _worst(arm: Array, poses: list[Array], run: Run) -> float:
    """What the worst of all postures misses of its pose, m or rad, by our forward kinematics."""
    return max(
        max(between(pose, tool_pose(arm, np.array(q))))
        for pose, found in zip(poses * ROUNDS, run.answers, strict=True)
        for q in found
    )


def _bare(robot: Robot) -> tuple[Callable[[Array], Array], str]:
    """The kernel of a robot's closed form, and what is called."""
    start = robot.poses["ready"].copy()
    if (puma := puma_arm.puma(robot)) is not None:
        return lambda T: puma_arm.puma_joint_values(puma.packed, T, start), "puma_arm.joint_values(arm, T, q)"
    if (parallel := parallel_arm(robot)) is not None:
        return lambda T: parallel_postures.parallel_joint_values(
            parallel, T, start
        ), "parallel_postures.joint_values(arm, T, q)"
    side = movemaster_arm.side_of(robot)
    assert side is not None
    return lambda T: movemaster_arm.movemaster_joint_values(side.packed, T, start)[
        0
    ], "movemaster_arm.joint_values(arm, T, q)"


def _given(robot: Robot, poses: list[Array]) -> dict[str, object]:
    """An arm of six joints and its poses as EAIK takes them."""
    ways = np.diff([np.zeros(3), *robot.points, robot.T_world_tool_0[:3, 3]], axis=0)
    axes = {"directions": robot.directions.tolist(), "ways": ways.tolist()}
    return {**axes, "tool_turn": robot.T_world_tool_0[:3, :3].tolist(), "poses": [pose.tolist() for pose in poses]}


def _poses(robot: Robot) -> list[Array]:
    rng, arm = np.random.default_rng(0), arm_array(robot)
    return [tool_pose(arm, q) for q in rng.uniform(robot.lower, robot.upper, (POSES, len(robot.variables)))]


def _measure(robot: Robot, child: Child, beside: Robot) -> None:
    """Ours for a robot and theirs for the one beside it, which is the same where they take it."""
    arm, poses, n = arm_array(robot), _poses(robot), len(robot.variables)
    start, (bare, called) = robot.poses["ready"], _bare(robot)
    child.ask({"given": _given(beside, _poses(beside))})

    def by_kernel(first: int, beyond: int) -> tuple[list[float], Numbers]:
        seconds, found = timed(lambda k: bare(poses[k]), range(first, beyond))
        return seconds, [rows[:, :n] for rows in found]

    def by_answer(first: int, beyond: int) -> tuple[list[float], Numbers]:
        seconds, found = timed(lambda k: solve(robot, poses[k], start, every=True), range(first, beyond))
        return seconds, [answer.q for answer in found]

    ways: tuple[tuple[str, Turn, float], ...] = (
        (called, by_kernel, BARE),
        ("solve(robot, T, q, every=True)", by_answer, WORDED),
    )
    for statement, turn, goal in ways:
        ours, theirs = in_turn(turn, turn_of(child), POSES, LENGTH, ROUNDS)
        worst, count = _worst(arm, poses, ours), np.mean([len(found) for found in ours.answers])
        line("ours", ours, f"{count:.3f} postures, the worst misses {worst:.1e}  {statement}")
        count = np.mean([len(found) for found in theirs.answers])
        line(child.name, theirs, f"{count:.3f} postures of {beside.name}  robot.calculate_IK(T)")
        judged(f"{robot.name}, {statement}, misses at most {MISSED:.0e}", worst <= MISSED)
        if robot is beside:
            alike = [_same(mine, others) for mine, others in zip(ours.answers, theirs.answers, strict=True)]
            judged(f"{robot.name}, {100 * np.mean(alike):.2f} % of the sets of postures the same", all(alike))
        faster(f"{robot.name}, {statement} beside {child.name}", ours, theirs, goal)


def run() -> None:
    print("\n".join(f"  {said}" for said in HOW))
    with taking_part(PEERS) as children:
        for child in children:
            for name, beside in (("puma560", "puma560"), ("ur5", "ur5"), ("movemaster", "puma560")):
                print(f"  {name}, all postures")
                with or_left_out(child, f"all postures of {name}"):
                    _measure(load_robot(name), child, load_robot(beside))
