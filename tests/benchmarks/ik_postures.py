"""All postures of the PUMA 560 for a pose, by our closed form and by EAIK's."""

from __future__ import annotations

import numpy as np
from tests.benchmarks.children.turns import Numbers, timed
from tests.benchmarks.ik_turns import Run, faster, in_turn, judged, line, or_left_out, taking_part, turn_of
from tests.benchmarks.peers import Child, Peer

from helicoide.ik.closed.puma560 import lengths_of, postures
from helicoide.ik.postures.branch import between
from helicoide.kinematics.chain import Array
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.tool import packed, tool_pose

PEERS = (Peer("eaik", "with_eaik_ik.py"),)
POSES, LENGTH, ROUNDS = 1000, 50, 7
FASTER = 1.0
ALIKE, MISSED = 1e-6, 1e-9
HOW = (
    "The same 1,000 poses for both, as 4 × 4 arrays; theirs is the bare call, without the making of arrays from its Q."
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


def _measure(robot: Robot, child: Child) -> None:
    rng, arm = np.random.default_rng(0), packed(robot)
    poses = [tool_pose(arm, q) for q in rng.uniform(robot.lower, robot.upper, (POSES, 6))]
    before, behind = np.linalg.inv(robot.dh.T_world_dh), np.linalg.inv(robot.dh.T_dh_tool)
    wrists = [np.ascontiguousarray(before @ pose @ behind) for pose in poses]
    lengths, shifts = lengths_of(robot).copy(), np.array([row.theta for row in robot.dh.rows])
    start = robot.poses["ready"] + shifts

    def turn(first: int, beyond: int) -> tuple[list[float], Numbers]:
        seconds, found = timed(lambda k: postures(lengths, wrists[k], start), range(first, beyond))
        return seconds, [theta[exists] - shifts for theta, exists in found]

    ways = np.diff([np.zeros(3), *robot.points, robot.T_world_tool_0[:3, 3]], axis=0)
    axes = {"directions": robot.directions.tolist(), "ways": ways.tolist()}
    tool = robot.T_world_tool_0[:3, :3].tolist()
    child.ask({"given": {**axes, "tool_turn": tool, "poses": [pose.tolist() for pose in poses]}})
    ours, theirs = in_turn(turn, turn_of(child), POSES, LENGTH, ROUNDS)
    for who, run, said in (("ours", ours, "postures(lengths, T, q)"), (child.name, theirs, "robot.calculate_IK(T)")):
        count = np.mean([len(found) for found in run.answers])
        line(who, run, f"{count:.3f} postures, the worst misses {_worst(arm, poses, run):.1e}  {said}")
    alike = [_same(mine, others) for mine, others in zip(ours.answers, theirs.answers, strict=True)]
    judged(f"{robot.name}, {100 * np.mean(alike):.2f} % of the sets of postures the same", all(alike))
    judged(f"{robot.name}, ours miss at most {MISSED:.0e}", _worst(arm, poses, ours) <= MISSED)
    faster(f"{robot.name}, all postures beside {child.name}", ours, theirs, FASTER)


def run() -> None:
    print(f"  {HOW}")
    with taking_part(PEERS) as children:
        for child in children:
            print("  puma560, all postures")
            with or_left_out(child, "all postures"):
                _measure(load("puma560"), child)
