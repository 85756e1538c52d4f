"""The demonstrations of Cerbaro 2022, §4.4.3 and §4.4.4: rows in mm, λ = 0.1 mm, Λ Δt the same for every step."""

from __future__ import annotations

import numpy as np
from tests.ik.secondary_runs import DAMPED, PINV, PLAIN, Path, Run, along, chosen, position, problem, ran, start_at

from helicoide.ik import Problem
from helicoide.ik.clik import Aim, Aiming, followed
from helicoide.ik.secondary import push
from helicoide.kinematics.chain import Array
from helicoide.trajectory import Ellipse

CIRCLE = Ellipse(centre=(0.36, 0.18, 0), radii=(0.1, 0.1, 0), pitch=0, roll=0, period=60)

ELLIPSE = Ellipse(centre=(0.52, 0, 0.2), radii=(0.08, 0.08, 0.05), pitch=-np.pi / 3, roll=0, period=60)


def orca() -> Problem:
    return problem("orca", scale=1e-3)


def movemaster() -> Problem:
    """The limits of table 3."""
    return problem("movemaster", scale=1e-3, J1=(-np.radians(100), np.radians(100)))


def with_heading(problem: Problem, path: Path, phi: float = 0.0) -> Aiming:
    """The position of an arm in a plane and its φ = q1 + q2 + q3; the third row is zero."""
    plain = position(problem, path)

    def aim(q: Array, t: float) -> Aim:
        three = plain(q, t)
        return Aim(np.vstack([three.J, [1, 1, 1]]), np.append(three.error, phi - q.sum()), np.append(three.ahead, 0))

    return aim


def with_pitch_and_roll(problem: Problem, path: Path, pitch: float = -np.pi / 3) -> Aiming:
    """Position, pitch q2 + q3 + q4 and roll q5 of the Movemaster (Cerbaro 2022, §4.4.4; digest §1.2)."""
    plain = position(problem, path)

    def aim(q: Array, t: float) -> Aim:
        three = plain(q, t)
        J = np.vstack([three.J, [0, 1, 1, 1, 0], [0, 0, 0, 0, 1]])
        return Aim(J, np.append(three.error, [pitch - q[1:4].sum(), -q[4]]), np.append(three.ahead, [0, 0]))

    return aim


def home(problem: Problem) -> Array:
    return problem.robot.poses["home"]


def circle(dt: float, gain: float = 0.8, turn: float = 0.5, seconds: float = 60.0) -> Run:
    """gain, turn: Λ Δt of position and orientation."""
    here = orca()
    aiming = with_heading(here, along(CIRCLE))
    q = start_at(here, aiming, home(here))
    gains = np.array([gain, gain, gain, turn]) / dt
    return ran(followed(here, PINV, PLAIN, aiming, gains, q, dt), seconds)


def ellipse(dt: float, seconds: float = 60.0) -> Run:
    here = movemaster()
    aiming = with_pitch_and_roll(here, along(ELLIPSE))
    q = start_at(here, aiming, home(here))
    gains = np.array([1.8, 1.8, 1.8, 1.2, 1.2]) / dt
    return ran(followed(here, DAMPED, DAMPED.Options(0.1), aiming, gains, q, dt), seconds)


CIRCLE_RANGES = [(-40.76, 11.59), (83.55, 141.06), (-130.22, -76.69)]

ELLIPSE_RANGES = [(-8.85, 8.85), (33.2, 62.4), (-129.97, -76.2), (-22.0, 18.0)]


def within(run: Run, ranges: list[tuple[float, float]], atol: float) -> None:
    """The joints take just these ranges, degrees."""
    found = np.degrees([run.q.min(axis=0), run.q.max(axis=0)]).T
    np.testing.assert_allclose(found[: len(ranges)], ranges, rtol=0, atol=atol)


def demonstration_3(name: str, k0: float, dt: float, seconds: float = 60.0) -> Run:
    if name == "orca":
        here, method, options, ellipse, gain = orca(), PINV, PLAIN, CIRCLE, 0.8
        start = with_heading(here, along(ellipse))
    else:
        here, method, options, ellipse, gain = movemaster(), DAMPED, DAMPED.Options(0.1), ELLIPSE, 1.8
        start = with_pitch_and_roll(here, along(ellipse))
    aiming = position(here, along(ellipse))
    q = start_at(here, start, here.robot.poses["home"])
    pushed = push(here, chosen("limit_distance"), k0)
    return ran(followed(here, method, options, aiming, gain / dt, q, dt, pushed), seconds)


def degrees(run: Run, joint: int) -> tuple[float, float]:
    return float(np.degrees(run.q[:, joint - 1].min())), float(np.degrees(run.q[:, joint - 1].max()))
