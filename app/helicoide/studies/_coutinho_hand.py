"""A hand on the device: where it holds the tool by time, and what the controller sees of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, pi, sin

import numpy as np

from helicoide.geometry import rotation
from helicoide.ik.rcm.follow import Wish
from helicoide.kinematics.chain import Array

# Of the device, s: it tells its pose a thousand times a second.
SAMPLE = 0.001
# What the hand does: period, s, how far, m, how far round, rad, and its tremor, m and Hz.
PERIOD, REACH, TURN = 60.0, (0.015, 0.027, 0.012), pi / 8
TREMOR = ((5e-5, 9.0), (5e-5, 11.0))
# The entry point moves as in E1: 10 mm/s at 8 · 2π/7000 for each sample of 9 ms.
ENTRY_SPEED, ENTRY_RATE = 0.01, 8 * 2 * pi / 7000 / 0.009

Hand = Callable[[float], tuple[Array, float]]


def steering(t: float) -> tuple[Array, float]:
    """Where the hand holds the tool, d (3,), m, in its axes at the start, and its turn about its x, rad.

    As S3, so that the wrist comes through θ₇ = 0, but three times as fast, sideways too, and with a tremor.
    """
    w, (x, y, z) = 2 * pi / PERIOD, REACH
    tremor = sum(size * sin(2 * pi * rate * t) for size, rate in TREMOR)
    return np.array([x * sin(w * t) + tremor, y * (1 - cos(w * t)), z * sin(2 * w * t) + tremor]), -TURN * sin(w * t)


def dragging(velocity: Array) -> Hand:
    """A hand that drags steadily: velocity (3,), m/s."""
    return lambda t: (velocity * t, 0.0)


@dataclass(frozen=True, eq=False)
class Device:
    """What the controller is told of a hand that starts at the pose T_0 (4, 4), m: the newest sample, and differences.

    ẋ_d = (p_k − p_{k−1}) / T_s, and ω_d = log(R_k R_{k−1}ᵀ) / T_s. Source: Coutinho 2015, §4.2.
    """

    hand: Hand
    T_world_start: Array

    def pose(self, number: int) -> Array:
        """The pose (4, 4), m, of a sample; before the first the hand is at its start."""
        d, turn = self.hand(max(number, 0) * SAMPLE)
        R, T = self.T_world_start[:3, :3], np.eye(4)
        T[:3, :3] = R @ rotation.exponential([turn, 0.0, 0.0])
        T[:3, 3] = self.T_world_start[:3, 3] + R @ d
        return T

    def wished(self, t: float) -> Wish:
        """What is asked at the time t, s, the entry point moving along x of the shaft as in E1."""
        number = int(np.floor(t / SAMPLE + 1e-6))
        now, before = self.pose(number), self.pose(number - 1)
        turn = rotation.logarithm(now[:3, :3] @ before[:3, :3].T)
        ahead = np.concatenate([now[:3, 3] - before[:3, 3], turn]) / SAMPLE
        return Wish(now, ahead, np.array([ENTRY_SPEED * sin(ENTRY_RATE * t), 0.0]))
