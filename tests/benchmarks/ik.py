"""Inverse kinematics beside other libraries: one posture, and all postures."""

from __future__ import annotations

from tests.benchmarks import ik_postures, ik_solve

TITLE = (
    "Inverse kinematics beside other libraries; ours and theirs in turn, each in its own process, single calls timed"
)


def run() -> None:
    for part in (ik_solve, ik_postures):
        part.run()
