"""Intersections of rays e + t v with a pane or a capsule: t in lengths of v, infinite if they miss."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array


def ray_to_pane(eye: Array, rays: Array, centre: Array, R_world_pane: Array, size: tuple[float, float]) -> Array:
    """Intersection with a rectangle about a centre: t = n·(c − e)/n·v if e + t v is inside; from either side.

    Args: eye, centre (3,), m; rays (k, 3); R_world_pane (3, 3), z its normal; size: full lengths along x and y, m.
    Returns (k,).
    """
    start, along = (eye - centre) @ R_world_pane, rays @ R_world_pane
    with np.errstate(divide="ignore", invalid="ignore"):
        t = -start[2] / along[:, 2]
        across = np.abs(start[:2] + t[:, None] * along[:, :2])
        hit = (t > 0) & np.isfinite(t) & (across <= np.asarray(size) / 2).all(axis=1)
    return np.where(hit, t, np.inf)


def ray_to_capsule(eye: Array, rays: Array, ends: Array, radius: float) -> Array:
    """Intersection with the capsule of a radius, m, about the segment between two ends (2, 3), m: least t > 0.

    A capsule is convex, so a line is inside it from its first to its last intersection with cylinder and spheres.
    Args: eye (3,), m; rays (k, 3); equal ends make a sphere. Returns (k,); from inside, where the ray leaves.
    """
    spans = [_in_side(eye, rays, ends, radius), *(_in_ball(eye, rays, end, radius) for end in ends)]
    enters = np.min([span[0] for span in spans], axis=0)
    leaves = np.max([span[1] for span in spans], axis=0)
    return np.where(enters > 0, enters, np.where(leaves > 0, leaves, np.inf))


Span = tuple[Array, Array]


def _in_ball(eye: Array, rays: Array, centre: Array, radius: float) -> Span:
    """Interval of t in a sphere: ‖e + t v − c‖ ≤ r."""
    start = eye - centre
    return _between_roots(np.einsum("ka,ka->k", rays, rays), rays @ start, float(start @ start) - radius**2)


def _in_side(eye: Array, rays: Array, ends: Array, radius: float) -> Span:
    """Interval of t in the cylinder of a capsule, between the planes through its ends."""
    length = float(np.linalg.norm(ends[1] - ends[0]))
    if length == 0.0:
        return np.full(len(rays), np.inf), np.full(len(rays), -np.inf)
    axis = (ends[1] - ends[0]) / length
    start, height = eye - ends[0], rays @ axis
    begun = start @ axis
    offset, across = start - begun * axis, rays - height[:, None] * axis
    enters, leaves = _between_roots(
        np.einsum("ka,ka->k", across, across), across @ offset, float(offset @ offset) - radius**2
    )
    with np.errstate(divide="ignore", invalid="ignore"):
        faces = np.sort([-begun / height, (length - begun) / height], axis=0)
    level = height == 0.0
    faces = np.where(level, np.array([[-np.inf], [np.inf]]) * (1 if 0 <= begun <= length else -1), faces)
    enters, leaves = np.maximum(enters, faces[0]), np.minimum(leaves, faces[1])
    missed = enters > leaves
    return np.where(missed, np.inf, enters), np.where(missed, -np.inf, leaves)


def _between_roots(a: Array, b: Array, c: float) -> Span:
    """Interval with a t² + 2 b t + c ≤ 0, a ≥ 0, between the two roots; from ∞ to −∞ if it is empty."""
    discriminant = b * b - a * c
    with np.errstate(divide="ignore", invalid="ignore"):
        half = np.sqrt(np.maximum(discriminant, 0.0))
        enters, leaves = (-b - half) / a, (-b + half) / a
    everywhere, nowhere = (a == 0.0) & (c <= 0.0), (discriminant < 0.0) | ((a == 0.0) & (c > 0.0))
    enters = np.where(everywhere, -np.inf, np.where(nowhere, np.inf, enters))
    return enters, np.where(everywhere, np.inf, np.where(nowhere, -np.inf, leaves))
