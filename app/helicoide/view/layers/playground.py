"""The quaternion playground beside the arm: two rotations in the ball of quaternions, and the ways between them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.geometry.quaternion_paths import lerp, slerp
from helicoide.seat import AxisAngle, Playground, Seat, SeatUpdate
from helicoide.text import Text
from helicoide.view import bind
from helicoide.view.colours import BLUE, GREEN, GREY, VERMILION
from helicoide.view.figures import polyline
from helicoide.view.layers import Stage
from helicoide.view.requests import ForSeat
from helicoide.view.window_view import View

NAME = "playground"
SHARED = False
TITLE = Text(en="Quaternion playground", pt_BR="Laboratório de quatérnios")
SHOWN = False
KIND = "algebra"
SAID = Text(
    en="The vector parts of q₁, −q₁ and q₂ in the unit ball, slerp and lerp between them, and the frames q₁q₂ and "
    "q₂q₁.",
    pt_BR="As partes vetoriais de q₁, −q₁ e q₂ na bola unitária, o slerp e o lerp entre elas e os referenciais q₁q₂ e "
    "q₂q₁.",
)

FIRST, SECOND, SLERP, LERP, BALL = BLUE, GREEN, BLUE, VERMILION, GREY
RADIUS, LEFT, UP = 0.26, -0.75, 0.45  # × size, m: radius of the ball, and where its centre is
OPACITY = 0.3  # of the ball
STEPS, DOTS = 48, 10
SAME = 1 - 1e-12  # |q·p| above which q and p are the same rotation
OFFSETS = {"q₁q₂": -0.22, "q₂q₁": 0.22}  # of the two products from the ball's centre, × size, m


@dataclass(frozen=True, eq=False)
class PlaygroundNodes:
    """The ball with its frame and gizmo; points of q₁, −q₁, q₂; both ways with their dots; the two products."""

    root: viser.FrameHandle
    gizmo: viser.TransformControlsHandle
    turned: viser.FrameHandle
    points: viser.PointCloudHandle
    slerp: viser.LineSegmentsHandle
    lerp: viser.LineSegmentsHandle
    slerp_dots: viser.PointCloudHandle
    lerp_dots: viser.PointCloudHandle
    axis: viser.ArrowsHandle
    products: tuple[viser.FrameHandle, ...]
    names: tuple[viser.LabelHandle, ...]


def build(stage: Stage) -> PlaygroundLayer:
    """All nodes below one root, hidden until the layer is shown."""
    scene, size, none = stage.scene, stage.size, np.zeros((1, 2, 3))
    r, cloud = RADIUS * size, np.zeros((1, 3), dtype=np.float32)
    centre = np.array([LEFT * size, 0.0, stage.robot.floor + UP * size])
    root = scene.add_frame("/playground", show_axes=False, position=centre, visible=False)
    scene.add_icosphere("/playground/ball", r, BALL, opacity=OPACITY, cast_shadow=False)
    scene.add_line_segments("/playground/circles", (r * great_circles()).astype(np.float32), BALL, thickness=0.01 * r)
    gizmo = scene.add_transform_controls(
        "/playground/gizmo",
        scale=1.9 * r,
        line_width=3.0 * stage.weight,
        disable_axes=True,
        disable_sliders=True,
        depth_test=False,
    )
    bind.on_drag(gizmo, lambda phase, position, wxyz: stage.act(ForSeat(_turned(wxyz))))
    products = tuple(
        scene.add_frame(
            f"/playground/product{k}",
            axes_length=0.5 * r,
            axes_radius=0.02 * r,
            position=(offset * size, 0.0, -1.4 * r),
        )
        for k, offset in enumerate(OFFSETS.values())
    )
    for k, name in enumerate(OFFSETS):
        scene.add_label(f"/playground/product{k}/name", name, anchor="top-center")
    nodes = PlaygroundNodes(
        root,
        gizmo,
        scene.add_frame("/playground/turned", axes_length=0.8 * r, axes_radius=0.02 * r),
        scene.add_point_cloud("/playground/points", np.zeros((3, 3), np.float32), FIRST, point_size=0.08 * r),
        scene.add_line_segments("/playground/slerp", none, SLERP, thickness=0.02 * r),
        scene.add_line_segments("/playground/lerp", none, LERP, thickness=0.02 * r),
        scene.add_point_cloud("/playground/slerp_dots", cloud, SLERP, point_size=0.05 * r, point_shape="circle"),
        scene.add_point_cloud("/playground/lerp_dots", cloud, LERP, point_size=0.05 * r, point_shape="square"),
        scene.add_arrows(
            "/playground/axis", none, FIRST, shaft_radius=0.02 * r, head_radius=0.05 * r, head_length=0.13 * r
        ),
        products,
        tuple(scene.add_label(f"/playground/name{k}", name, anchor="bottom-center") for k, name in enumerate(NAMES)),
    )
    return PlaygroundLayer(nodes, r)


NAMES = ("q₁", "−q₁", "q₂")


def _turned(wxyz: Array) -> SeatUpdate:
    """The first rotation as the gizmo shows it."""

    def update(seat: Seat) -> Seat:
        length = float(np.linalg.norm(wxyz))
        if not (np.isfinite(length) and length > 0):
            return seat
        axis, angle = rotation.axis_angle(wxyz / length)
        x, y, z = axis.tolist()
        first = AxisAngle((x, y, z), float(angle))
        return replace(seat, playground=replace(seat.playground, first=first, opposite=False))

    return update


def great_circles() -> Array:
    """The segments (k, 2, 3) of the circles in which the coordinate planes cut the unit ball."""
    angle = np.linspace(0.0, 2 * np.pi, STEPS + 1)
    circle = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=1)
    return polyline(np.array([np.roll(circle, k, axis=1) for k in range(3)]))


def _stretched(q: Array) -> Array:
    """Quaternions (k, 4) stretched to length one; one of length zero stays."""
    length = np.linalg.norm(q, axis=-1, keepdims=True)
    return np.asarray(np.divide(q, length, out=np.zeros_like(q), where=length > 0))


class PlaygroundLayer:
    """The playground of one window. radius: of the unit ball as it is drawn, m."""

    def __init__(self, nodes: PlaygroundNodes, radius: float) -> None:
        self.nodes, self.radius = nodes, radius

    def update(self, old: View | None, new: View) -> None:
        """Show the two rotations of the seat."""
        shown, root = new.seat.visible_layers[NAME], self.nodes.root
        if root.visible != shown:
            root.visible = shown
        before = old is not None and old.seat.visible_layers[NAME]
        if shown and not (before and old is not None and old.seat.playground == new.seat.playground):
            self._draw(new.seat.playground)

    def _draw(self, play: Playground) -> None:
        nodes, (p, q) = self.nodes, play.quaternions
        r, t = self.radius, np.linspace(0.0, 1.0, STEPS + 1)
        for line, way in ((nodes.slerp, slerp(p, q, t)), (nodes.lerp, lerp(p, q, t))):
            line.points = r * np.stack([way[:-1, 1:], way[1:, 1:]], axis=1).astype(np.float32)
        dots = np.append(np.linspace(0.0, 1.0, DOTS + 1), play.t)
        nodes.slerp_dots.points = (r * slerp(p, q, dots)[:, 1:]).astype(np.float32)
        nodes.lerp_dots.points = (r * _stretched(lerp(p, q, dots))[:, 1:]).astype(np.float32)
        ends = np.array([p[1:], -p[1:], q[1:]])
        nodes.points.points = (r * ends).astype(np.float32)
        nodes.points.colors = np.array([FIRST, FIRST, SECOND], dtype=np.uint8)
        for name, end in zip(nodes.names, ends, strict=True):
            name.position = r * end
        nodes.axis.points = r * np.array([[np.zeros(3), play.first.axis]], dtype=np.float32)
        if abs(float(nodes.gizmo.wxyz @ p)) < SAME:  # during a drag, writing it would lose the end of the drag
            nodes.gizmo.wxyz = p
        nodes.turned.wxyz = slerp(p, q, play.t)
        for frame, product in zip(nodes.products, rotation.multiply(np.array([p, q]), np.array([q, p])), strict=True):
            frame.wxyz = product
