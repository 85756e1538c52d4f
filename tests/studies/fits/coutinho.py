"""Joints at the start of S1 to S4 that hold all that is printed of them: `python -m tests.studies.fits.coutinho`.

θ₂, θ₄, θ₆, θ₇ and θ₈ are free; θ₁, θ₃ and θ₅ follow from the place of the tool in table 4.2. With θ₈ near π/2 the turn
of S3 goes through the axis of the shaft, and a small θ₇ lets S1 withdraw along it; the others are round numbers at
which the arm is far from its own singularities. Takes a quarter of an hour.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.postures.branch import tool_at
from helicoide.kinematics import differential
from helicoide.studies import coutinho_s1, coutinho_s2, coutinho_s3, coutinho_s4
from helicoide.studies._coutinho_runs import DLS, PSEUDOINVERSE, START, RunStart, dia10, run_path, source_control
from helicoide.studies.study import Row, Statement

PLACE = np.array([0.194, 1.019, 0.958])  # table 4.2, m
FREE, FOLLOWING = {"θ₂": 1, "θ₄": 3, "θ₆": 5, "θ₇": 6, "θ₈": 7}, [0, 2, 4]
ROUND = np.array([0.8, -0.25, -1.3, -1.65, 0.6, 1.1, 0.0, 1.57])
STEPS = {"S1": 0.1, "S2": 0.1, "S3": 0.1, "S4": 0.02}  # s
STATED = {"S1": coutinho_s1.s1_rows, "S2": coutinho_s2.s2_rows, "S4": coutinho_s4.s4_rows}


def standing(q: Array) -> Array:
    """θ₁, θ₃ and θ₅ so that the tool is at its place, by Newton's rule. Args: q (8,), rad."""
    robot, found = dia10(), q.copy()
    for _ in range(20):
        J = differential.frame_jacobian(robot, found)[:3, FOLLOWING]
        found[FOLLOWING] += np.linalg.solve(J, PLACE - tool_at(robot, found)[:3, 3])
    return found


def rows(q: Array) -> list[Row]:
    """All rows of the four simulations from q (8,), rad."""
    found = [
        row
        for name, stated in STATED.items()
        for row in stated(run_path(name, source_control(), STEPS[name], RunStart(q)), STEPS[name])
    ]
    damped = (
        run_path("S3", source_control(of_tool=DLS, of_arm=arm), STEPS["S3"], RunStart(q))
        for arm in (PSEUDOINVERSE, DLS)
    )
    return [*found, *coutinho_s3.s3_rows(*damped)]


def failing(q: Array) -> list[str]:
    """What does not hold from q (8,), rad: of the source, and that the joints stay within their limits."""
    robot = dia10()
    if not ((q > robot.lower) & (q < robot.upper)).all():
        return ["limits"]
    return [
        f"{row.quantity.en} = {row.computed:.4g}"
        for row in rows(q)
        if isinstance(row.source, Statement) and not row.source.holds(row.computed)
    ]


def with_free(q: Array, joint: int, value: float) -> Array:
    """A start with one of its free joints changed."""
    changed = q.copy()
    changed[joint] = value
    return standing(changed)


def holds_to(joint: int, factor: float) -> float:
    """The farthest value of a joint, in steps of 5 % and at most 25 % away, to which all holds."""
    farthest = START[joint]
    for step in range(1, 6):
        value = START[joint] * (1 + factor * step)
        if failing(with_free(START, joint, value)):
            break
        farthest = value
    return float(farthest)


if __name__ == "__main__":
    for q7 in (-0.1, -0.15, -0.2, -0.225, -0.25, -0.3, -0.4):
        print(f"θ₇ = {q7}:", failing(with_free(ROUND, 6, q7)) or "all holds", flush=True)
    print("START", np.round(with_free(ROUND, 6, -0.225), 6), flush=True)
    for name, joint in FREE.items():
        print(name, START[joint], holds_to(joint, -0.05), holds_to(joint, 0.05), flush=True)
