"""A hand on a haptic device: its motion, the samples that the controller reads, and the run of the arm."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, pi, sin
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik.method import ConfiguredMethod, OneOf, Quantity
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm.follow import RcmReference, rcm_loop
from helicoide.ik.rcm.passage import through
from helicoide.studies._coutinho_rows import FEEDBACK
from helicoide.studies._coutinho_runs import (
    DEPTH,
    INVERSES,
    LINK,
    START,
    Run,
    dia10,
    entry_on,
    initial_rcm_state,
    problem_without_planes,
    run_columns,
    source_control,
)
from helicoide.studies.study import Interpretation, Progress
from helicoide.text import Text

INVERSE = Text(en="inverse of J^r", pt_BR="inversa de J^r")

# Of the device, and of the controller, s: it tells its pose a thousand times a second, and is asked every 2 ms.
SAMPLE, STEP = 0.001, 0.002
# What the hand does: how long, s, and its tremor, m and Hz.
PERIOD = 60.0
TREMOR = ((5e-5, 9.0), (5e-5, 11.0))
# Where the entry point moves it does as in E1: 10 mm/s at 8 · 2π/7000 for each sample of 9 ms.
ENTRY_SPEED, ENTRY_RATE = 0.01, 8 * 2 * pi / 7000 / 0.009
# Kp and Ko, 1/s: of table 4.2 and of table 4.3.
GAINS = {"simulations": (5.0, 10.0), "experiments": (270.0, 1500.0)}
# By which the experiments run; the simulations, which start without an error, come out by either.
BODY_FRAME_ERROR = Interpretation(
    Text(en="the error of orientation as the body sees it", pt_BR="o erro de orientação como o corpo o vê"),
    Text(
        en="by the printed Q_d ⊗ Q⁻¹ with Ko = 1500 the loop is unstable",
        pt_BR="com o impresso Q_d ⊗ Q⁻¹ e Ko = 1500 a malha é instável",
    ),
)

Hand = Callable[[float], tuple[Array, float]]


def steering_hand(size: float, aside: float, turn: float, period: float = PERIOD) -> Hand:
    """Where a hand holds the tool by time: d (3,), m, in its axes at the start, and its turn about its x, rad.

    It leads in and back, sideways and round, with a tremor. Args: size: half the way in, m; aside, m; turn, rad;
    period, s.
    """
    w = 2 * pi / period

    def at(t: float) -> tuple[Array, float]:
        tremor = sum(amplitude * sin(2 * pi * rate * t) for amplitude, rate in TREMOR)
        way = np.array([aside * sin(w * t), size * (1 - cos(w * t)), aside * sin(2 * w * t)])
        return way + np.array([tremor, 0.0, tremor]), -turn / 2 * (1 - cos(w * t))

    return at


def dragging_hand(velocity: Array) -> Hand:
    """A hand that moves with a constant velocity (3,), m/s."""
    return lambda t: (velocity * t, 0.0)


@dataclass(frozen=True, eq=False)
class HapticDevice:
    """What the controller is told of a hand that starts at the pose T_0 (4, 4), m: the newest sample, and differences.

    ẋ_d = (p_k − p_{k−1}) / T_s, and ω_d = log(R_k R_{k−1}ᵀ) / T_s. entry_speed: how fast the entry point swings along x
    of the shaft, m/s. Source: Coutinho 2015, §4.2.
    """

    hand: Hand
    T_world_start: Array
    entry_speed: float = 0.0

    def pose(self, number: int) -> Array:
        """The pose (4, 4), m, of a sample; before the first the hand is at its start."""
        d, turn = self.hand(max(number, 0) * SAMPLE)
        R, T = self.T_world_start[:3, :3], np.eye(4)
        T[:3, :3] = R @ rotation.exponential([turn, 0.0, 0.0])
        T[:3, 3] = self.T_world_start[:3, 3] + R @ d
        return T

    def reference(self, t: float) -> RcmReference:
        """The reference at time t, s."""
        number = int(np.floor(t / SAMPLE + 1e-6))
        now, before = self.pose(number), self.pose(number - 1)
        turn = rotation.logarithm(now[:3, :3] @ before[:3, :3].T)
        ahead = np.concatenate([now[:3, 3] - before[:3, 3], turn]) / SAMPLE
        return RcmReference(now, ahead, np.array([self.entry_speed * sin(ENTRY_RATE * t), 0.0]))


def run_led(
    hand: Hand, entry_speed: float, of_tool: ConfiguredMethod, feedback: float, seconds: float, progress: Progress
) -> Run:
    """What the steps of so many seconds measured, by the gains of the experiments; w: w_r at each, by its formula."""
    robot = dia10()
    problem, passage = problem_without_planes(robot), through(robot, LINK)
    entry, device = entry_on(robot, START, DEPTH), HapticDevice(hand, tool_at(robot, START), entry_speed)
    position, orientation = GAINS["experiments"]
    gained = source_control(feedback, of_tool, position=position, orientation=orientation)
    start = initial_rcm_state(problem, passage, gained, START, entry)
    steps = rcm_loop(problem, passage, gained, device.reference, start, STEP)
    got = run_columns(steps, round(seconds / STEP) + 1, STEP, progress)
    return {**got, "w": (got["inside"] / got["outside"]) ** 2 * np.abs(np.sin(got["q7"]))}


@dataclass(frozen=True)
class Options:
    """How J^r is inverted, and the gain Kr, 1/s."""

    inverse: Annotated[str, OneOf(INVERSE, {name: title for name, (title, _) in INVERSES.items()})] = "filtered"
    feedback: Annotated[float, Quantity(FEEDBACK, 0.0, 20.0, "1/s")] = 0.0
