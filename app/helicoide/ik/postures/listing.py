"""Postures in the order in which people look at them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from helicoide.ik.postures.branch import Branch
from helicoide.ik.postures.choice import alike, ranked
from helicoide.kinematics.chain import Array
from helicoide.kinematics.robot import Robot


def nearest_first(robot: Robot, branches: Sequence[Branch], q: Array) -> tuple[Branch, ...]:
    """Those within the limits first, and of these the one with the least motion from q (n,), rad or m.

    Joints count alike, a slide in units of the reach. Each turns the shorter way from q where its limits allow it.
    """
    return tuple(replace(row.branch, q=row.q) for row in ranked(robot, branches, q, alike(robot)))
