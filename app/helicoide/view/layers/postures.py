"""All postures of the target as ghosts: a click on one goes there."""

from __future__ import annotations

import numpy as np
import trimesh
import viser

from helicoide import gate, readout
from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik.postures.choice import OUT_OF_LIMITS
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.state import PostureList
from helicoide.text import Text
from helicoide.view import bind
from helicoide.view.colours import GREEN, GREY
from helicoide.view.figures import Names
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.requests import ForArm, ListPostures
from helicoide.view.window_view import View

NAME = "postures"
SHARED = False
TITLE = Text(en="All postures of the target", pt_BR="Todas as posturas do alvo")
SHOWN = False
KIND = "comparison"
SAID = Text(
    en="A ghost for each posture that brings the end effector to the target, with its number in the list. Click one to "
    "go there; grey ones are outside the joint limits.",
    pt_BR="Um fantasma para cada postura que leva o efetuador ao alvo, com o número dela na lista. Clique em um para "
    "ir até ela; os cinzas estão fora dos limites das juntas.",
)

SAME = 1e-6  # m, and entries of the rotation: two goals that differ by less are the same
OPACITY = 0.35
TOGETHER = 3  # decimals, m: ghosts whose elbows are at the same place share one label
BAR = 0.016  # radius of the bars × size, m


def build(stage: Stage) -> PosturesLayer:
    """The layer, without ghosts at first."""
    return PosturesLayer(stage, NAME)


def ghost_bars(robot: Robot, poses: Array) -> Array:
    """The bars of one ghost, (b, 2, 3), m: between the points of successive joints, and to the tool.

    Args: poses (m + 1, 4, 4) of `link_poses`.
    """
    tool = poses[-1] @ robot.T_link_tool
    points = np.array([*poses[:, :3, 3], tool[:3, 3]])
    bars = np.stack([points[:-1], points[1:]], axis=1)
    return np.asarray(bars[np.linalg.norm(bars[:, 1] - bars[:, 0], axis=1) > 1e-6])


def needs(view: View) -> ListPostures | None:
    """The list, if the arm is at rest and has none for its target."""
    state, listing = view.state, view.state.postures.listing
    if state.arm.moving or state.arm.parked or state.request.drag is not None:
        return None
    if listing is not None and listing.with_orientation == state.request.with_orientation:
        missed = np.abs(listing.T_world_goal - readout.target_pose(state)).max()
        return ListPostures() if missed > SAME else None
    return ListPostures()


class PosturesLayer(OptionalLayer):
    """The bars of all ghosts as one mesh with many instances, and their numbers."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.mesh: viser.BatchedMeshHandle | None = None
        self.names = Names(stage, f"/{name}")
        self.places: list[int] = []

    def depends(self, view: View) -> tuple[object, ...]:
        """The list."""
        return (view.state.postures.listing,)

    def draw(self, view: View) -> None:
        """Make the ghosts of a list."""
        if self.mesh is not None:
            self.mesh.remove()
            self.mesh = None
        listing = view.state.postures.listing
        if listing is None or not listing.rows:
            self.names.write([], [])
            return
        bars, self.places = _bars(self.stage.robot, listing)
        outside = [listing.rows[place].dropped is OUT_OF_LIMITS for place in self.places]
        self.mesh = _bar_mesh(self.stage, f"/{self.name}/bars", bars, np.where(np.array(outside)[:, None], GREY, GREEN))
        bind.on_instance(self.mesh, self._clicked)
        named = _named(self.stage.robot, listing)
        self.names.write(list(named.values()), list(map(np.array, named)))

    def _clicked(self, instance: int) -> None:
        if instance in range(len(self.places)):
            self.stage.act(ForArm(gate.go_to_posture(self.places[instance])))


def _bars(robot: Robot, listing: PostureList) -> tuple[Array, list[int]]:
    """The bars of all ghosts (b, 2, 3), m, and for each the place of its posture in the list."""
    every = [ghost_bars(robot, link_poses(robot.chain, row.q)) for row in listing.rows]
    return np.concatenate(every), [place for place, bars in enumerate(every) for _ in bars]


def _named(robot: Robot, listing: PostureList) -> dict[tuple[float, ...], str]:
    """Numbers by the place, m, where they stand: at the joint whose position differs most between the postures."""
    points = np.array([link_poses(robot.chain, row.q)[1:, :3, 3] for row in listing.rows])
    elbows = points[:, points.var(axis=0).sum(axis=1).argmax()].round(TOGETHER)
    named: dict[tuple[float, ...], str] = {}
    for number, elbow in enumerate(map(tuple, elbows.tolist()), start=1):
        named[elbow] = f"{named[elbow]}, {number}" if elbow in named else str(number)
    return named


def _bar_mesh(stage: Stage, name: str, bars: Array, colours: Array) -> viser.BatchedMeshHandle:
    """A cylinder for each bar (b, 2, 3), m, in its colour (b, 3)."""
    way = bars[:, 1] - bars[:, 0]
    lengths = np.linalg.norm(way, axis=1)
    radius = np.full(len(bars), BAR * stage.size)
    cylinder = trimesh.creation.cylinder(1.0, 1.0, sections=10)
    mesh: viser.BatchedMeshHandle = stage.scene.add_batched_meshes_simple(
        name,
        np.asarray(cylinder.vertices),
        np.asarray(cylinder.faces),
        rotation.from_matrix(np.array([_along_z(unit) for unit in way / lengths[:, None]])),
        bars.mean(axis=1),
        batched_scales=np.column_stack([radius, radius, lengths]),
        batched_colors=colours.astype(np.uint8),
        opacity=OPACITY,
        lod="off",
        cast_shadow=False,
        receive_shadow=False,
    )
    return mesh


def _along_z(unit: Array) -> Array:
    """A rotation (3, 3) whose z is a unit vector (3,)."""
    x = np.cross(unit, np.eye(3)[np.argmin(np.abs(unit))])
    x = x / np.linalg.norm(x)
    return np.column_stack([x, np.cross(unit, x), unit])
