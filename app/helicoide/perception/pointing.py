"""The point under a ray from the camera of the page: a measured point, else the nearest object of the scene."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from helicoide.arrays import Array
from helicoide.confinement import Planes
from helicoide.perception.camera import ray_depths
from helicoide.state import State

# A measured point is chosen if its angle to the ray is less than this, rad.
NEAR = 0.01


def point_under_ray(state: State, eye: Array, ray: Array) -> Array | None:
    """The point under a ray, (3,), m; None if it meets nothing or is not finite.

    Measured points of the clouds come first, then the nearest pane or obstacle, then the floor. Panes are transparent
    from behind, as seen from outside the enclosure.
    Args: eye, where the ray starts, (3,), m; ray (3,), its direction.
    """
    length = float(np.linalg.norm(ray))
    if not (np.isfinite(eye).all() and np.isfinite(length) and length > 0):
        return None
    along = ray / length
    measured = _measured(state, eye, along)
    if measured is not None:
        return measured
    planes = state.problem.planes
    faced = [k for k, normal in enumerate(planes.normals) if normal @ along < 0]
    faces = Planes(planes.normals[faced], planes.centres[faced], tuple(planes.panes[k] for k in faced))
    scene = replace(state, problem=replace(state.problem, planes=faces))
    depth = float(ray_depths(scene, eye, along[None])[0])
    with np.errstate(divide="ignore"):
        to_floor = (state.robot.floor - eye[2]) / along[2]
    far = min(depth, to_floor if to_floor > 0 else np.inf)
    return eye + far * along if np.isfinite(far) else None


def _measured(state: State, eye: Array, along: Array) -> Array | None:
    """Of the cloud points close to the ray, the one nearest to the eye."""
    points = np.concatenate([np.empty((0, 3)), *(seen.points for seen in state.clouds.values())])
    ways = points - eye
    depths = ways @ along
    aside = np.linalg.norm(ways - depths[:, None] * along, axis=1)
    meant = np.flatnonzero((depths > 0) & (aside < NEAR * depths))
    return np.asarray(points[meant[np.argmin(depths[meant])]]) if len(meant) else None
