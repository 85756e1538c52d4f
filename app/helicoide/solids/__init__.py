"""Machine parts as triangle meshes: outlines, rounded prisms, lathe parts, cables, bolts; and their GLB files.

A drawing uses one unit of length, which `glb` converts to metres. An outline is an (n, 2) array (u, v),
counter-clockwise, seen from the tip of `axis`: u to the right and v up. For a vertical axis u is x, and v is y (axis
"z") or -y (axis "-z").
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Literal

import manifold3d
import numpy as np
import trimesh
from numpy.typing import ArrayLike, NDArray
from shapely import LineString, MultiPoint, Polygon
from trimesh.visual.material import PBRMaterial

Array = NDArray[np.float64]
Axis = Literal["x", "y", "z", "-x", "-y", "-z"]
ORIGIN = (0.0, 0.0, 0.0)
# Rows are where u, v and the axis itself point to.
_FRAMES: dict[Axis, Array] = {
    "x": np.array([[0.0, 1, 0], [0, 0, 1], [1, 0, 0]]),
    "y": np.array([[-1.0, 0, 0], [0, 0, 1], [0, 1, 0]]),
    "z": np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 1]]),
    "-x": np.array([[0.0, -1, 0], [0, 0, 1], [-1, 0, 0]]),
    "-y": np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]),
    "-z": np.array([[1.0, 0, 0], [0, -1, 0], [0, 0, -1]]),
}
SMOOTH_COS = np.cos(np.radians(50.0))  # flatter edges are shaded round: a 45° chamfer looks like a fillet


# --- outlines -------------------------------------------------------------------------------------------------------


def circle(radius: float, sides: int = 32, centre: ArrayLike = (0.0, 0.0)) -> Array:
    """A regular polygon with the given circumscribed radius."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring: Array = radius * np.column_stack([np.cos(angle), np.sin(angle)]) + np.asarray(centre)
    return ring


def hull(*outlines: ArrayLike) -> Array:
    """The convex outline around all the given points."""
    points = np.vstack([np.atleast_2d(outline) for outline in outlines])
    return _counter_clockwise(np.asarray(MultiPoint(points).convex_hull.exterior.coords)[:-1])


def stadium(a: ArrayLike, b: ArrayLike, radius_a: float, radius_b: float | None = None, sides: int = 32) -> Array:
    """The outline of a link: circles about two points, and their common tangents."""
    return hull(circle(radius_a, sides, a), circle(radius_a if radius_b is None else radius_b, sides, b))


def rectangle(width: float, height: float, corner: float = 0.0, steps: int = 4) -> Array:
    """A rectangle about the origin with rounded corners."""
    half = np.array([width, height]) / 2 - corner
    if corner == 0.0:
        return np.array([[-1.0, -1], [1, -1], [1, 1], [-1, 1]]) * half
    arc = np.linspace(0, np.pi / 2, steps + 1)
    corners = [(0.0, (1, 1)), (np.pi / 2, (-1, 1)), (np.pi, (-1, -1)), (3 * np.pi / 2, (1, -1))]
    return np.vstack([
        half * sign + corner * np.column_stack([np.cos(arc + turn), np.sin(arc + turn)]) for turn, sign in corners
    ])  # fmt: skip


def rounded(points: ArrayLike, radius: float, steps: int = 3) -> Array:
    """The polygon through the points with all its corners rounded."""
    shape = Polygon(np.asarray(points)).buffer(-radius, join_style="mitre").buffer(radius, quad_segs=steps)
    shape = shape.buffer(radius, quad_segs=steps).buffer(-radius, quad_segs=steps).simplify(radius * 1e-3)
    return _counter_clockwise(np.asarray(shape.exterior.coords)[:-1])


def inset(outline: Array, distance: float) -> Array:
    """The outline moved inwards by the distance, or outwards if negative, with the same number of points."""
    edge = np.roll(outline, -1, axis=0) - outline
    edge /= np.linalg.norm(edge, axis=1, keepdims=True)
    inward = np.column_stack([-edge[:, 1], edge[:, 0]])
    before = np.roll(inward, 1, axis=0)
    moved: Array = outline + distance * (inward + before) / (1 + np.sum(inward * before, axis=1, keepdims=True))
    return moved


def gear(radius: float, teeth: int, depth: float) -> Array:
    """A gear wheel: straight-sided teeth of that depth below the outer radius."""
    part = np.array([0.0, 0.25, 0.4, 0.85])
    angle = 2 * np.pi * (np.arange(teeth)[:, None] + part) / teeth
    reach = np.broadcast_to([radius, radius, radius - depth, radius - depth], angle.shape)
    return np.column_stack([(reach * np.cos(angle)).ravel(), (reach * np.sin(angle)).ravel()])


def _counter_clockwise(ring: Array) -> Array:
    following = np.roll(ring, -1, axis=0)
    area = np.sum(ring[:, 0] * following[:, 1] - following[:, 0] * ring[:, 1])
    return ring if area > 0 else ring[::-1]


# --- solids ---------------------------------------------------------------------------------------------------------


def stacked(
    layers: Sequence[tuple[Array, float]], axis: Axis = "z", at: ArrayLike = ORIGIN, bottom: bool = True
) -> trimesh.Trimesh:
    """The solid skinned over outlines of equal point count, each at its height along the axis, lowest first."""
    rings = [np.column_stack([outline, np.full(len(outline), height)]) for outline, height in layers]
    caps = [manifold3d.triangulate([layers[-1][0]]) + len(rings[0]) * (len(rings) - 1)]
    if bottom:
        caps.append(manifold3d.triangulate([layers[0][0]])[:, ::-1])
    return _moved_to(rings, caps, axis, at)


def prism(
    outline: Array, length: float, edge: float = 0.0, steps: int = 1, axis: Axis = "z", at: ArrayLike = ORIGIN
) -> trimesh.Trimesh:
    """The outline extruded along the axis; its rims are chamfered (one step) or rounded (more) by `edge`."""
    turn = np.linspace(0, np.pi / 2, steps + 1) if edge else np.array([0.0])
    rim = [(inset(outline, edge * (1 - np.cos(t))), length / 2 - edge * (1 - np.sin(t))) for t in turn]
    return stacked([(ring, -height) for ring, height in reversed(rim)] + rim, axis, at)


def raised(
    outline: Array, height: float, edge: float = 0.0, steps: int = 1, axis: Axis = "z", at: ArrayLike = ORIGIN
) -> trimesh.Trimesh:
    """A cover on the plane through `at`, open underneath, with its outer rim chamfered or rounded."""
    turn = np.linspace(0, np.pi / 2, steps + 1) if edge else np.array([0.0])
    rim = [(inset(outline, edge * (1 - np.cos(t))), height - edge * (1 - np.sin(t))) for t in turn]
    return stacked([(outline, 0.0), *rim], axis, at, bottom=False)


def cylinder(
    radius: float,
    length: float,
    edge: float = 0.0,
    steps: int = 1,
    axis: Axis = "z",
    at: ArrayLike = ORIGIN,
    sides: int = 32,
) -> trimesh.Trimesh:
    """A round bar with chamfered or rounded rims."""
    return prism(circle(radius, sides), length, edge, steps, axis, at)


def box(
    size: tuple[float, float, float],
    corner: float = 0.0,
    edge: float = 0.0,
    steps: int = 1,
    axis: Axis = "z",
    at: ArrayLike = ORIGIN,
) -> trimesh.Trimesh:
    """A box of that size in x, y, z: `corner` rounds the edges along the axis, `edge` those around its two ends."""
    u, v, run = np.abs(_FRAMES[axis] @ np.asarray(size))
    return prism(rectangle(u, v, corner), run, edge, steps, axis, at)


def turned(
    profile: Sequence[tuple[float, float]], axis: Axis = "z", at: ArrayLike = ORIGIN, sides: int = 32
) -> trimesh.Trimesh:
    """A lathe part: (radius, height) pairs from one end face to the other."""
    return stacked([(circle(radius, sides), height) for radius, height in profile], axis, at)


def cable(path: ArrayLike, radius: float, sides: int = 8, samples: int = 16) -> trimesh.Trimesh:
    """A round cable along a smooth curve through the points (Catmull-Rom)."""
    points = _catmull_rom(np.asarray(path, dtype=float), samples)
    tangent = np.gradient(points, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    side = np.cross(tangent[0], np.eye(3)[np.argmin(np.abs(tangent[0]))])
    rings = []
    for point, along in zip(points, tangent, strict=True):
        side = side - along * (side @ along)
        side /= np.linalg.norm(side)
        rings.append(point + circle(radius, sides) @ np.array([side, np.cross(along, side)]))
    top = manifold3d.triangulate([circle(radius, sides)])
    return _moved_to(rings, [top[:, ::-1], top + sides * (len(rings) - 1)], "z", ORIGIN)


def letters(strokes: Iterable[ArrayLike], thickness: float, depth: float, axis: Axis, at: ArrayLike) -> trimesh.Trimesh:
    """Raised lettering: each stroke is a polyline of (u, v) points drawn with a square pen."""
    shapes = [LineString(np.asarray(s)).buffer(thickness / 2, cap_style="flat", join_style="mitre") for s in strokes]
    outlines = [_counter_clockwise(np.asarray(shape.exterior.coords)[:-1]) for shape in shapes]
    return joined(raised(outline, depth, axis=axis, at=at) for outline in outlines)


def _catmull_rom(points: Array, samples: int) -> Array:
    padded = np.vstack([2 * points[0] - points[1], points, 2 * points[-1] - points[-2]])
    t = np.linspace(0, len(points) - 1, samples)
    i = np.minimum(t.astype(int), len(points) - 2)
    u = (t - i)[:, None]
    a, b, c, d = (padded[i + k] for k in range(4))
    curve: Array = 0.5 * (2 * b + (c - a) * u + (2 * a - 5 * b + 4 * c - d) * u**2 + (3 * b - a - 3 * c + d) * u**3)
    return curve


def _moved_to(rings: Sequence[Array], caps: Sequence[NDArray[np.int32]], axis: Axis, at: ArrayLike) -> trimesh.Trimesh:
    count, here = len(rings[0]), np.arange(len(rings[0]))
    there = np.roll(here, -1)
    sides = [
        np.vstack([np.column_stack([here, there, there + count]), np.column_stack([here, there + count, here + count])])
        + count * level
        for level in range(len(rings) - 1)
    ]
    vertices = np.vstack(rings) @ _FRAMES[axis] + np.asarray(at)
    return trimesh.Trimesh(vertices, np.vstack([*sides, *caps]), process=False)


# --- fasteners ------------------------------------------------------------------------------------------------------


def ring_of_points(count: int, radius: float, axis: Axis, at: ArrayLike, phase: float = 0.0) -> Array:
    """Points evenly spread on a circle about the axis through `at`; the phase is in parts of the spacing."""
    angle = 2 * np.pi * (np.arange(count) + phase) / count
    flat = radius * np.column_stack([np.cos(angle), np.sin(angle), np.zeros(count)])
    points: Array = flat @ _FRAMES[axis] + np.asarray(at)
    return points


def bolts(points: Iterable[ArrayLike], radius: float, height: float, axis: Axis) -> trimesh.Trimesh:
    """A chamfered screw head on each of the points, looking along the axis."""
    return joined(raised(circle(radius, 8), height, radius / 4, axis=axis, at=point) for point in points)


# --- assembly -------------------------------------------------------------------------------------------------------


def mirrored(solid: trimesh.Trimesh) -> trimesh.Trimesh:
    """The solid on the other side of the xz plane."""
    return trimesh.Trimesh(solid.vertices * np.array([1.0, -1.0, 1.0]), solid.faces[:, ::-1], process=False)


def joined(solids: Iterable[trimesh.Trimesh]) -> trimesh.Trimesh:
    """All the solids as one mesh; they may overlap."""
    parts = list(solids)
    first = np.cumsum([0] + [len(part.vertices) for part in parts[:-1]])
    faces = np.vstack([part.faces + start for part, start in zip(parts, first, strict=True)])
    return trimesh.Trimesh(np.vstack([part.vertices for part in parts]), faces, process=False)


def wrapped(*solids: trimesh.Trimesh) -> trimesh.Trimesh:
    """The convex hull of the solids, such as a housing between two shapes."""
    skin: trimesh.Trimesh = trimesh.convex.convex_hull(np.vstack([solid.vertices for solid in solids]))
    return skin


def cut(body: trimesh.Trimesh, *tools: trimesh.Trimesh) -> trimesh.Trimesh:
    """The body without the volumes of the tools."""
    rest: trimesh.Trimesh = trimesh.boolean.difference([body, *tools], engine="manifold")
    return rest


def paint(red: int, green: int, blue: int, roughness: float, metallic: float = 0.0) -> PBRMaterial:
    """A material of a colour in sRGB, 0 to 255; glTF stores it linear."""
    screen = np.array([red, green, blue]) / 255
    linear = np.where(screen <= 0.04045, screen / 12.92, ((screen + 0.055) / 1.055) ** 2.4)
    return PBRMaterial(baseColorFactor=[*linear, 1.0], roughnessFactor=roughness, metallicFactor=metallic)


def shaded(solid: trimesh.Trimesh, unit: float = 1.0) -> trimesh.Trimesh:
    """The solid in metres, vertices split at sharp edges, normals weighted by area so that flat faces stay flat."""
    solid = trimesh.Trimesh(solid.vertices * unit, solid.faces, process=False)
    solid.merge_vertices(digits_vertex=7)
    solid.update_faces(solid.area_faces > 1e-14)
    corner_vertex, corner_face = solid.faces.ravel(), np.repeat(np.arange(len(solid.faces)), 3)
    around = solid.vertex_faces[corner_vertex]
    close = np.einsum("cfk,ck->cf", solid.face_normals[around], solid.face_normals[corner_face]) > SMOOTH_COS
    own = solid.faces[around] == corner_vertex[:, None, None]
    opening = np.sum(solid.face_angles[around] * own, axis=2)
    weight = np.where(close & (around >= 0), solid.area_faces[around] * opening, 0.0)
    normal = np.einsum("cf,cfk->ck", weight, solid.face_normals[around])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    keys = np.column_stack([corner_vertex, np.round(normal, 3)])
    _, first, index = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    return trimesh.Trimesh(
        solid.vertices[corner_vertex[first]], index.reshape(-1, 3), vertex_normals=normal[first], process=False
    )


def glb(parts: Mapping[str, tuple[PBRMaterial, Sequence[trimesh.Trimesh]]], unit: float = 1.0) -> bytes:
    """One GLB file in metres, a mesh for each named surface; `unit` is the drawing's unit of length in metres."""
    scene = trimesh.Scene()
    for name, (material, solids) in parts.items():
        solid = shaded(joined(solids), unit)
        solid.visual = trimesh.visual.TextureVisuals(material=material)
        scene.add_geometry(solid, geom_name=name, node_name=name)
    data: bytes = scene.export(file_type="glb", include_normals=True)
    return data
