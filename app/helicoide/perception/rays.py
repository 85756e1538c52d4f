"""Where rays e + t v first meet a pane or a capsule: t in lengths of v, infinite where they miss it."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array


def ray_to_pane(eye: Array, rays: Array, centre: Array, R_world_pane: Array, size: tuple[float, float]) -> Array:
    """The rectangle around a centre: t = n·(c − e)/n·v, where e + t v is inside. Either face is seen.

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
    """The body within a radius, m, of the piece between two ends (2, 3), m: t > 0 where the ray enters, or leaves it.

    It is convex, so that what a line has inside of it reaches from the first of its parts, side and balls, to the last.
    Args: eye (3,), m; rays (k, 3); both ends alike are a ball. Returns (k,); of an eye inside, where the ray leaves.
    """
    spans = [_in_side(eye, rays, ends, radius), *(_in_ball(eye, rays, end, radius) for end in ends)]
    enters = np.min([span[0] for span in spans], axis=0)
    leaves = np.max([span[1] for span in spans], axis=0)
    return np.where(enters > 0, enters, np.where(leaves > 0, leaves, np.inf))


Span = tuple[Array, Array]


def _in_ball(eye: Array, rays: Array, centre: Array, radius: float) -> Span:
    """Where a line is within a radius of a point: ‖e + t v − c‖ ≤ r."""
    start = eye - centre
    return _between_roots(np.einsum("ka,ka->k", rays, rays), rays @ start, float(start @ start) - radius**2)


def _in_side(eye: Array, rays: Array, ends: Array, radius: float) -> Span:
    """Where a line is within a radius of another, and between two planes through the ends of a piece of it."""
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
    """Where a t² + 2 b t + c ≤ 0, a ≥ 0: from the lesser root to the greater; from ∞ to −∞ where nowhere."""
    discriminant = b * b - a * c
    with np.errstate(divide="ignore", invalid="ignore"):
        half = np.sqrt(np.maximum(discriminant, 0.0))
        enters, leaves = (-b - half) / a, (-b + half) / a
    everywhere, nowhere = (a == 0.0) & (c <= 0.0), (discriminant < 0.0) | ((a == 0.0) & (c > 0.0))
    enters = np.where(everywhere, -np.inf, np.where(nowhere, np.inf, enters))
    return enters, np.where(everywhere, np.inf, np.where(nowhere, -np.inf, leaves))
