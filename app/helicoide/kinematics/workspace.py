"""Workspace maps from many random postures: reached positions, share of orientations, or manipulability.

A map is counted in chunks, each with its own seed. The result does not depend on their order, nor on which process
counts them. A cell that a posture hits is reachable; a cell that none hits may be reachable too.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kernels import CACHE_FOLDER
from helicoide.kinematics.chain import Chain
from helicoide.kinematics.grid import Counts, Mask, WorkspaceGrid
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace_kernels import BANDS, HEADINGS, PLANAR_BINS, ROLLS, MapPart, count_into_cells
from helicoide.text import HelicoideError, Text, numbers_text

MapKind = Literal["reachable", "dexterous", "manipulability"]
MAP_KINDS: tuple[MapKind, ...] = get_args(MapKind)
# Postures in a chunk; postures per cell, and per orientation bin; least and largest number of cells along an axis, for
# d = 2 and 3.
CHUNK, PER_CELL, PER_SECTOR, ACROSS = 1 << 16, 40, 10, {2: (8, 400), 3: (8, 80)}
PARALLEL = 1e-9
POINT = 1e-3  # half the edge of the only cell of an arm whose tool point is fixed, as a fraction of the reach
FIXED_TOOL = Text(
    en="{name}: the end effector stays at {position} m for all joint values; only its orientation changes",
    pt_BR="{name}: o efetuador fica em {position} m para todos os valores das juntas; só a orientação muda",
)


@dataclass(frozen=True, eq=False)
class MapPlan:
    """The input of a map: arrays alone, so that any process can count a part."""

    kind: MapKind
    samples: int
    seed: int
    cells: WorkspaceGrid
    chain: Chain
    T_link_tool: Array
    lower: Array
    upper: Array

    @property
    def chunks(self) -> int:
        """Number of chunks to count."""
        return -(-self.samples // CHUNK)

    @property
    def orientation_bins(self) -> int:
        """Number of orientation bins."""
        return PLANAR_BINS if len(self.cells.shape) == 2 else BANDS * HEADINGS * ROLLS

    @property
    def key(self) -> str:
        """A checksum of the arm, the settings and the code: equal keys have equal maps."""
        joints = [self.chain[field] for field in self.chain.dtype.names or ()]
        grid = (self.cells.origin, self.cells.axes, self.cells.size, self.cells.shape)
        checksum = hashlib.sha256(f"{CACHE_FOLDER.name} {self.kind} {self.samples} {self.seed}".encode())
        for part in (*joints, self.T_link_tool, self.lower, self.upper, *grid):
            checksum.update(np.ascontiguousarray(part).tobytes() + b"|")
        return checksum.hexdigest()


@dataclass(frozen=True, eq=False)
class WorkspaceMap:
    """The finished map: hits (count,) and values (count,).

    values of a cell: 1 if it is reached; or the share of orientation bins with which it is reached; or the largest
    manipulability of position in it, m^d for revolute joints; 0 if no posture hits it.
    """

    kind: MapKind
    samples: int
    cells: WorkspaceGrid
    hits: Counts
    values: Array

    @property
    def reached(self) -> Mask:
        """Which cells (count,) were reached."""
        return self.hits > 0

    @property
    def measure(self) -> float:
        """Reached area, m², of a planar arm, or reached volume, m³."""
        return self.cells.measure(self.reached)


def plane_normal(robot: Robot) -> Array | None:
    """Normal of the plane in which the tool point of a planar arm moves, (3,); None for other arms."""
    turning = [joint.direction for joint in robot.joints if not joint.is_prismatic]
    if not turning:
        return None
    z = turning[0]
    apart = max(float(np.linalg.norm(np.cross(z, direction))) for direction in turning)
    along = max((abs(float(z @ joint.direction)) for joint in robot.joints if joint.is_prismatic), default=0.0)
    return z if max(apart, along) < PARALLEL else None


def fixed_tool_text(robot: Robot, name: str | Text) -> Text:
    """The sentence on an arm whose tool point is fixed, under the name of the map."""
    return FIXED_TOOL.format(name=name, position=numbers_text(robot.T_world_tool_0[:3, 3].round(3) + 0.0, ".3f"))


def reach_sphere(robot: Robot) -> tuple[Array, float]:
    """Centre (3,), m, and radius, m, of a sphere that contains every tool point: the stretched arm."""
    ways = np.diff([*robot.points, robot.T_world_tool_0[:3, 3]], axis=0)
    z = robot.directions[0]
    up = (ways[0] @ z) * z
    ways[0] -= up
    return robot.points[0] + up, float(np.linalg.norm(ways, axis=1).sum() + robot.slide_travel.sum())


def plan_map(robot: Robot, kind: MapKind, samples: int, seed: int = 0) -> MapPlan:
    """The plan of a map from `samples` random postures within the joint limits; their number sets the cell size.

    Raises HelicoideError for fewer than one posture or an unknown kind.
    """
    if kind not in MAP_KINDS:
        raise HelicoideError(
            Text(
                en="There is no map of kind {kind!r}; kinds: {known}.",
                pt_BR="Não há mapa do tipo {kind!r}; tipos: {known}.",
            ).format(kind=kind, known=", ".join(MAP_KINDS))
        )
    if samples < 1:
        raise HelicoideError(
            Text(
                en="A map takes at least one posture, not {samples}.",
                pt_BR="Um mapa requer ao menos uma postura, não {samples}.",
            ).format(samples=samples)
        )
    return MapPlan(
        kind, samples, seed, _cells(robot, kind, samples), robot.chain, robot.T_link_tool, robot.lower, robot.upper
    )


def _cells(robot: Robot, kind: MapKind, samples: int) -> WorkspaceGrid:
    normal = plane_normal(robot)
    axes = np.eye(3) if normal is None else _across(normal)
    d = len(axes)
    each = PER_CELL if kind != "dexterous" else PER_SECTOR * (PLANAR_BINS if d == 2 else BANDS * HEADINGS * ROLLS)
    least, most = ACROSS[d]
    # an even number, so that the first axis, in the middle, runs between cells
    across = 2 * (min(max(int((samples / each) ** (1 / d)), least), most) // 2)
    centre, reach = reach_sphere(robot)
    if robot.fixed_tool_point:  # one cell around where the tool stays
        half, across = POINT * robot.reach, 1
    else:
        half = reach * (1 + 1e-9)
    if robot.fixed_tool_point:
        centre = robot.T_world_tool_0[:3, 3]
    elif normal is not None:
        centre = centre + ((robot.T_world_tool_0[:3, 3] - centre) @ normal) * normal
    return WorkspaceGrid(frozen(centre - half * axes.sum(axis=0)), frozen(axes), 2 * half / across, (across,) * d)


def _across(normal: Array) -> Array:
    """Two orthonormal directions of the plane, (2, 3), as close to the axes of the base as possible."""
    x = np.eye(3)[np.argmin(np.abs(normal))]
    x = x - (x @ normal) * normal
    x /= np.linalg.norm(x)
    return np.array([x, np.cross(normal, x)])


def count_chunk(plan: MapPlan, chunk: int) -> MapPart:
    """Count the random postures of a chunk of the plan, numbered from 0."""
    part = empty_part(plan)
    size = min(CHUNK, plan.samples - chunk * CHUNK)
    postures = np.random.default_rng([plan.seed, chunk]).uniform(plan.lower, plan.upper, (size, len(plan.lower)))
    count_into_cells(plan.chain, plan.T_link_tool, postures, plan.cells.packed, part)
    return part


def empty_part(plan: MapPlan) -> MapPart:
    """The result of no posture."""
    count = plan.cells.count
    turned, moved = (count if plan.kind == kind else 0 for kind in ("dexterous", "manipulability"))
    return MapPart(np.zeros(count, np.int64), np.zeros((turned, plan.orientation_bins), np.uint8), np.zeros(moved))


def merge_parts(one: MapPart, other: MapPart) -> MapPart:
    """Two parts merged; the order does not matter."""
    return MapPart(one.hits + other.hits, one.orientations | other.orientations, np.maximum(one.best, other.best))


def map_from_part(plan: MapPlan, part: MapPart) -> WorkspaceMap:
    """The map from the merged parts."""
    match plan.kind:
        case "reachable":
            values = (part.hits > 0).astype(np.float64)
        case "dexterous":
            values = part.orientations.mean(axis=1)
        case "manipulability":
            values = part.best
    return WorkspaceMap(plan.kind, plan.samples, plan.cells, part.hits, frozen(values))


def count_chunks(plan: MapPlan) -> Iterator[MapPart]:
    """The parts of a plan, counted one after another."""
    return (count_chunk(plan, chunk) for chunk in range(plan.chunks))


def collect_map(plan: MapPlan, found: Iterator[MapPart], progress: Callable[[float], None]) -> WorkspaceMap:
    """The map from its parts in any order; `progress` is called with the share that is done, 0 to 1."""
    whole = empty_part(plan)
    for done, part in enumerate(found, start=1):
        whole = merge_parts(whole, part)
        progress(done / plan.chunks)
    return map_from_part(plan, whole)
