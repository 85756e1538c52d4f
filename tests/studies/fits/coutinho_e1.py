"""From where E1 comes through its singularity as it is printed: `python -m tests.studies.fits.coutinho_e1 [seconds]`.

What happens at the wrist does not depend on the arm: shaft, tool and entry point alone are moved, by the Jacobian of
eq. 3.28, which is a run of its own kind beside `ik.rcm`. l_a(0), θ₇(0) and θ₈(0) are drawn at random for so many
seconds (two of the first 1551 hold), then how far those that were chosen beside the first may change is shown, and how
far those may whose θ₇ begins at the end of its printed range.
"""

from __future__ import annotations

import sys
import time
from math import cos, pi, sin, sqrt

import numpy as np
from numba import njit

from helicoide.ik.rcm import wrists
from helicoide.studies._coutinho_runs import E1_DEPTH, E1_START

Kp, Ko, DT, STEPS = 270.0, 1500.0, 0.002, 22501
LENGTH, L_8, RATE = 0.33, 0.21, 2 * pi / 7000 / 0.009
PLAIN, DAMPED, FILTERED = 0, 1, 2
FROM_THE_END = (0.12, pi / 4, -pi / 2)
zy_trocar = njit(wrists.zy_trocar)


@njit
def turn(w: np.ndarray) -> np.ndarray:
    """Rodrigues' formula: w (3,), rad."""
    angle = sqrt((w**2).sum())
    K = np.array([[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]])
    if angle < 1e-12:
        return np.eye(3) + K
    return np.eye(3) + sin(angle) / angle * K + (1 - cos(angle)) / angle**2 * (K @ K)


@njit
def inverted(kind: int, J: np.ndarray, Theta: np.ndarray, asked: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """u, and Θ after the step: plain, damped by κ = 0.01, or filtered with Γ = 5."""
    if kind == PLAIN:
        return np.linalg.solve(J, asked), Theta
    if kind == DAMPED:
        return J.T @ np.linalg.solve(J @ J.T + 1e-4 * np.eye(6), asked), Theta
    u = Theta @ (Theta.T @ (J.T @ asked))
    steps = int(np.ceil(2 * 5.0 * DT * (J**2).sum()))
    for _ in range(steps):
        Theta = Theta - 5.0 * DT / steps * (J.T @ (J @ Theta - np.eye(6)) + (Theta @ J - np.eye(6)) @ J.T)
    return u, Theta


@njit
def bent(kind: int, l_a: float, q7: float, q8: float) -> tuple[np.ndarray, float]:
    """θ₇ of every step, rad, and the largest rate of shaft and wrist, rad/s."""
    x, y = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
    p, R, entry = np.zeros(3), np.eye(3), l_a * y
    R_e = turn(np.array([0.0, 0.0, q7])) @ turn(q8 * y)
    p_e = LENGTH * y + R_e @ (L_8 * y)
    R_0, p_0 = R_e.copy(), p_e.copy()
    Theta = np.linalg.pinv(zy_trocar(l_a, LENGTH - l_a, L_8, q7, q8))
    way, fastest = np.zeros(STEPS), 0.0
    for k in range(STEPS):
        wt = RATE * DT * k
        phi, v = pi / 18 * (cos(wt) - 1), 0.01 * sin(8 * wt)
        l_a = (R.T @ (entry - p))[1]
        error = R_e.T @ (p_0 + R_0 @ (0.03 * sin(wt) * x) - p_e)
        M = R_e.T @ R_0 @ turn(phi * x)
        eta = 0.5 * sqrt(max(1 + np.trace(M), 1e-12))
        epsilon = np.array([M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]]) / (4 * eta)
        omega = R_e.T @ (R_0[:, 0].copy() * (-pi / 18 * RATE * sin(wt))) + Ko * epsilon
        move = R_e.T @ (R_0 @ (0.03 * RATE * cos(wt) * x)) + Kp * error - np.cross(omega, error)
        push, spin = v / (1 + l_a**2) * x, np.array([0.0, 0.0, -l_a * v / (1 + l_a**2)])
        R_ie, p_ie = R.T @ R_e, R.T @ (p_e - p)
        asked = np.concatenate((move - R_ie.T @ (push + np.cross(spin, p_ie)), omega - R_ie.T @ spin))
        J = zy_trocar(l_a, LENGTH - l_a, L_8, q7, q8)
        u, Theta = inverted(kind, J, Theta, asked)
        omega_i = np.array([-u[2] / l_a, u[3], u[0] / l_a]) + spin
        way[k], fastest = q7, max(fastest, abs(u[4]), abs(u[5]), sqrt((omega_i**2).sum()))
        p, entry = p + R @ (u[:3] + push) * DT, entry + R @ (v * x) * DT
        R = R @ turn(omega_i * DT)
        q7, q8 = q7 + u[4] * DT, q8 + u[5] * DT
        bend = turn(np.array([0.0, 0.0, q7]))
        R_e = R @ bend @ turn(q8 * y)
        p_e = p + R @ (LENGTH * y + bend @ (L_8 * y))
    return way, fastest


def crossed(kind: int, l_a: float, q7: float, q8: float) -> tuple[int, float, float, float]:
    """How often θ₇ changes its sign, its least and its largest value, rad, and the largest rate, rad/s."""
    way, fastest = bent(kind, l_a, q7, q8)
    return int(np.count_nonzero(np.diff(np.sign(way)))), float(way.min()), float(way.max()), float(fastest)


def as_printed(l_a: float, q7: float, q8: float) -> bool:
    """Two crossings by the bounded inverses within −π/36 … π/4, and a plain one that races."""
    for kind in (DAMPED, FILTERED):
        times, least, most, fastest = crossed(kind, l_a, q7, q8)
        if times != 2 or least < -pi / 36 or most > pi / 4 + 1e-3 or fastest > 3.0:
            return False
    return crossed(PLAIN, l_a, q7, q8)[3] > 10.0


def with_one(start: tuple[float, ...], index: int, factor: float) -> tuple[float, ...]:
    """The start with one of its values changed."""
    return (*start[:index], factor * start[index], *start[index + 1 :])


if __name__ == "__main__":
    random, tried, until = np.random.default_rng(1), 0, time.monotonic() + float((*sys.argv, "300")[1])
    while time.monotonic() < until:
        start = (random.uniform(0.08, 0.24), random.uniform(0.1, pi / 4), random.uniform(-pi, pi))
        tried += 1
        if as_printed(*start):
            near = [as_printed(*with_one(start, index, factor)) for index in range(3) for factor in (0.95, 1.05)]
            print(f"start {tried}: {start}, at ±5 %: {near}", flush=True)
    print(f"{tried} random starts", flush=True)
    chosen = (E1_DEPTH, *(float(angle) for angle in E1_START[6:]))
    for begun in (chosen, FROM_THE_END):
        for index, name in enumerate(("l_a(0)", "θ₇(0)", "θ₈(0)")):
            for factor in (0.85, 0.9, 0.95, 1.0, 1.05, 1.1, 1.15):
                changed = with_one(begun, index, factor)
                print(name, round(changed[index], 6), as_printed(*changed), flush=True)
