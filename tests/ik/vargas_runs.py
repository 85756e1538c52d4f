"""The simulations of Vargas 2013, §4.7: planar 3R, ℓ = 1 m, modified law, γ = 5, Λ = 5 I; digest §6.7, §6.8."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from tests.ik.secondary_runs import Run, chosen, position, problem, ran, tool

from helicoide.ik import Problem, methods
from helicoide.ik.arm_points import ArmPoints, along_links, watched
from helicoide.ik.clik import Aiming, followed
from helicoide.ik.secondary import augmented
from helicoide.kinematics.chain import Array
from helicoide.kinematics.forward import link_poses


def wave(t: float) -> tuple[Array, Array]:
    """Trajectory 1."""
    return (
        np.array([2 + 0.5 * np.sin(0.4 * t), 0.5 * np.cos(0.2 * t), 0]),
        np.array([0.2 * np.cos(0.4 * t), -0.1 * np.sin(0.2 * t), 0]),
    )


def level(t: float) -> tuple[Array, Array]:
    """Trajectory 5."""
    return np.array([2 + 0.5 * np.sin(0.4 * t), 1, 0]), np.array([0.2 * np.cos(0.4 * t), 0, 0])


def planar(**limits: tuple[float, float]) -> Problem:
    return problem("planar3r", scale=1.0, **limits)


def filtered(problem: Problem, aiming: Aiming, q: list[float], h: float, seconds: float) -> Run:
    method = methods.named("filtered_modified")
    options = replace(method.Options(), gain=5.0)
    return ran(followed(problem, method, options, aiming, 5.0, np.array(q), h), seconds)


def nearest(problem: Problem, run: Run, points: Callable[[float], Array], per_link: int, every: float = 0.05) -> float:
    """The least distance of points on the links from other points at a time, (k, 3), m; looked at every 50 ms."""
    fine = along_links(problem.robot, per_link)
    return min(
        float(np.linalg.norm(fine.at(link_poses(problem.robot.chain, q))[:, None] - points(t), axis=2).min())
        for q, t in zip(*_thinned(run, every), strict=True)
    )


def _thinned(run: Run, every: float) -> tuple[Array, Array]:
    step = round(every / (run.t[1] - run.t[0]))
    return run.q[::step], run.t[::step]


def second_arm(problem: Problem, points: ArmPoints, t: float) -> Array:
    """A second planar 3R in motion on a base at (4.5, 0) m (digest of Vargas 2013, §6.7)."""
    q = np.array([np.pi - 0.5 + 0.3 * np.sin(0.3 * t), 0.6 + 0.2 * np.sin(0.4 * t), 0.4])
    return points.at(link_poses(problem.robot.chain, q)) + np.array([4.5, 0, 0])


def barrier(half: float | None, h: float, seconds: float = 32.0) -> Run:
    """Sim. 15: joint 2 kept at −1 ± half; α = 5, k = 10."""
    start = [np.pi / 6, -0.82 if half == 0.2 else -np.pi / 6, -np.pi / 6]
    if half is None:
        return filtered(planar(), position(planar(), wave, 2), start, h, seconds)
    here = planar(J2=(-1 - half, -1 + half))
    return filtered(here, augmented(here, chosen("joint_barrier"), position(here, wave, 2)), start, h, seconds)


def obstacle_at_the_tool(weight: float, h: float, seconds: float = 32.0) -> tuple[float, float]:
    """Sim. 16: the closest that the tool comes to (2, 0.75), and its largest error, from 2 s on."""
    here = planar()
    hill = chosen("ellipsoid", weight=weight, x=2.0, y=0.75, z=0.0, a=0.2, b=0.2, c=0.2, where="tool")
    aiming = augmented(here, hill, position(here, wave, 2))
    run = filtered(here, aiming, [0.6, -1.2, 0.4], h, seconds).since(2.0)
    points = watched(here.robot, "tool")
    way = np.array([points.at(link_poses(here.robot.chain, q))[0] for q in run.q])
    return float(np.linalg.norm(way - [2, 0.75, 0], axis=1).min()), float(run.error.max())


def obstacle_at_the_links(mu: tuple[float, float], per_link: int, h: float, seconds: float) -> tuple[float, float]:
    """Fig. 4.42: the least distance of the arm from μ, and the largest error, from 3 s on; α = 5, 0 points: no term."""
    here = planar()
    aiming = position(here, level, 2)
    if per_link:
        hill = chosen("ellipsoid", x=mu[0], y=mu[1], z=0.0, a=0.2, b=0.2, c=0.2, where="links", per_link=per_link)
        aiming = augmented(here, hill, aiming)
    run = filtered(here, aiming, [0.9, -1.2, -0.6], h, seconds).since(3.0)
    return nearest(here, run, lambda t: np.array([[*mu, 0.0]]), 40), float(run.error.max())


def two_arms(weight: float, h: float, seconds: float) -> tuple[float, Run]:
    """Figs. 4.43, 4.44: the least distance from 12 points of the other arm from 3 s on; 4 of a link watch them."""
    here = planar()
    four = along_links(here.robot, 4)
    some = chosen("second_arm", weight=weight, radius=0.2)
    aiming = augmented(here, some, position(here, wave, 2), lambda t: second_arm(here, four, t))
    run = filtered(here, aiming, [0.6, -1.2, 0.4], h, seconds).since(3.0)
    return nearest(here, run, lambda t: second_arm(here, four, t), 40), run


def in_a_slab(weight: float, steepness: int, h: float, seconds: float) -> tuple[Array, Run]:
    """|y| < 0.3 asked of the tool on trajectory 1, y ∈ [−0.5, 0.5] (digest §6.8); y at each step."""
    here = planar()
    options = {"azimuth": np.pi / 2, "elevation": 0.0, "offset": 0.0, "half": 0.3}
    aiming: Aiming = position(here, wave, 2)
    if weight:
        aiming = augmented(here, chosen("slab", weight=weight, steepness=steepness, **options), aiming)
    run = filtered(here, aiming, [0.45, -1, 0.4], h, seconds)
    return np.array([tool(here, q)[1] for q in run.q]), run
