"""The object that a click in the scene points at."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from helicoide.arrays import Array
from helicoide.confinement.planes import pane_axes
from helicoide.geometry.rigid import coordinates
from helicoide.perception.rays import ray_to_capsule, ray_to_pane
from helicoide.readout import elements
from helicoide.seat import Selection
from helicoide.state import State

# As fractions of the reach: radius of the ball about a point that takes a click, of the cylinder about an axis, and
# half the length of that cylinder.
BALL, AXIS, HALF = 0.03, 0.012, 0.15
# A point or an axis inside the arm is meant if it is no deeper than this behind the surface.
DEEP = 0.12


def selection_under_ray(state: State, eye: Array, ray: Array) -> Selection | None:
    """The nearest object under a ray from the camera of the page; None if it meets none or is not finite.

    Points and frames inside a link are meant before joint axes, these before the link. Planes are transparent from
    behind.
    Args: eye, where the ray starts, (3,), m; ray (3,), its direction.
    """
    length = float(np.linalg.norm(ray))
    if not (np.isfinite(eye).all() and np.isfinite(length) and length > 0):
        return None
    along = (ray / length)[None]
    surfaces = list(_surfaces(state, eye, along))
    first = min((depth for depth, _ in surfaces), default=np.inf)
    for inside in (_points(state, eye, along), _axes(state, eye, along)):
        near = [found for found in inside if np.isfinite(found[0]) and found[0] < first + DEEP * state.robot.reach]
        if near:
            return min(near, key=lambda found: found[0])[1]
    return min(surfaces, key=lambda found: found[0])[1] if np.isfinite(first) else None


Found = tuple[float, Selection]


def _surfaces(state: State, eye: Array, along: Array) -> Iterator[Found]:
    """Links and the front sides of planes, with the depth at which the ray meets them."""
    for body in state.robot.bodies:
        carriers = state.arm.poses[list(body.links)]
        ends = np.einsum("kij,kj->ki", carriers[:, :3, :3], body.ends) + carriers[:, :3, 3]
        if (link := max(body.links)) > 0:
            yield float(ray_to_capsule(eye, along, ends, body.radius)[0]), Selection("link", link - 1)
    planes = state.problem.planes
    for k, (normal, centre, pane) in enumerate(zip(planes.normals, planes.centres, planes.panes, strict=True)):
        if normal @ along[0] < 0:
            depth = ray_to_pane(eye, along, centre, pane_axes(normal), pane.size)
            yield float(depth[0]), Selection("plane", k)


def _points(state: State, eye: Array, along: Array) -> Iterator[Found]:
    """Points and frames: a ball about each takes the click."""
    for centre, selection in _balls(state):
        depth = ray_to_capsule(eye, along, np.array([centre, centre]), BALL * state.robot.reach)
        yield float(depth[0]), selection


def _axes(state: State, eye: Array, along: Array) -> Iterator[Found]:
    """Joint axes: a cylinder about each takes the click."""
    reach = state.robot.reach
    for i, (axis, centre) in enumerate(zip(state.axes, state.arm.poses[1:, :3, 3], strict=True)):
        ends = np.array([centre - HALF * reach * axis, centre + HALF * reach * axis])
        yield float(ray_to_capsule(eye, along, ends, AXIS * reach)[0]), Selection("joint", i)


def _balls(state: State) -> Iterator[tuple[Array, Selection]]:
    """The points that take a click. Of equal ones the first is meant."""
    for element in elements(state):
        if element.nature == "point":
            yield coordinates(element.values(state)), element.selection
        elif element.pose is not None and element.selection.kind != "link":  # a link is clicked on its surface
            yield element.pose(state)[:3, 3], element.selection
