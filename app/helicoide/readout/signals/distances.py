"""Distances: of the monitored points to the planes, of the arm to the obstacles and to itself."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache, partial

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.guard.collision import clearances
from helicoide.ik.packing import packed
from helicoide.readout.distances import plane_distances
from helicoide.readout.signal import Band, PhasePlane, Signal, scalar, subscript
from helicoide.state import State
from helicoide.text import Text, untranslated

TITLE = Text(en="Distances", pt_BR="Distâncias")
ORDER = 3
PRESET = ("planes", "obstacles", "own bodies")
PHASES: tuple[PhasePlane, ...] = ()

LEAST = Text(en="Least distance to each plane", pt_BR="Menor distância a cada plano")
WARNING = Text(en="warning distance", pt_BR="distância de aviso")
SAFETY = Text(en="safety distance", pt_BR="distância de segurança")


def signals(problem: Problem, with_orientation: bool) -> Iterator[Signal]:
    """The least distance to each plane, to each obstacle, and between bodies; then every point to each plane."""
    panes, points, robot = problem.planes.panes, problem.robot.monitored, problem.robot
    if panes and points:
        names = tuple(pane.title for pane in panes)
        yield Signal("planes", LEAST, "l", "mm", names, least_plane_distances, plane_bands)
    if problem.obstacles.radii.size and len(problem.pairs) > len(robot.self_collision):
        title = Text(en="Least distance to each obstacle", pt_BR="Menor distância a cada obstáculo")
        names = tuple(untranslated(subscript("d", k + 1)) for k in range(len(problem.obstacles.radii)))
        yield Signal("obstacles", title, "d", "mm", names, obstacle_distances, body_bands)
    if robot.self_collision:
        title = Text(en="Least distance between two links", pt_BR="Menor distância entre dois elos")
        yield Signal("own bodies", title, "d", "mm", (untranslated("d"),), own_distance, body_bands)
    for k, pane in enumerate(panes if points else ()):
        title = Text(en="Distances to plane {name} ({pane})", pt_BR="Distâncias ao plano {name} ({pane})")
        named = title.format(name=pane.name, pane=pane.title)
        curves = tuple(point.title for point in points)
        yield Signal(f"plane {k}", named, "l", "mm", curves, partial(_to_plane, k), plane_bands)


def least_plane_distances(state: State) -> Array:
    """The distance of the nearest monitored point to each plane, (k,), mm."""
    return np.asarray(1000 * plane_distances(state).min(axis=0))


def _to_plane(k: int, state: State) -> Array:
    return np.asarray(1000 * plane_distances(state)[:, k])


@lru_cache(maxsize=8)  # the signals of one state share it
def body_distances(state: State) -> Array:
    """The distance of each of `Problem.pairs` from surface to surface, (b,), m."""
    problem = state.problem
    every = clearances(packed(problem), state.arm.q)
    return np.asarray(every[len(every) - len(problem.pairs) :] + problem.zones.body_clearance)


def obstacle_distances(state: State) -> Array:
    """The distance of the nearest body of the arm to each obstacle, (k,), mm."""
    problem, first = state.problem, len(state.robot.bodies)
    found = np.full(len(problem.obstacles.radii), np.inf)
    for (_, other), distance in zip(problem.pairs, body_distances(state), strict=True):
        if other >= first:
            found[other - first] = min(found[other - first], 1000 * distance)
    return found


def own_distance(state: State) -> Array:
    """The least distance between two bodies of the arm that are kept apart, (1,), mm."""
    return scalar(1000 * body_distances(state)[: len(state.robot.self_collision)].min())


def plane_bands(state: State) -> tuple[Band, ...]:
    """The zones of the distance from a plane."""
    critical, warning = 1000 * state.problem.zones.critical, 1000 * state.problem.zones.warning
    return Band(WARNING, critical, warning, "warning"), Band(SAFETY, -np.inf, critical)


def body_bands(state: State) -> tuple[Band, ...]:
    """The distance that two bodies keep from each other."""
    return (Band(SAFETY, -np.inf, 1000 * state.problem.zones.body_clearance),)
