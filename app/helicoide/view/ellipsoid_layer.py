"""A layer that shows an ellipsoid at the tool, its semi-axes and their lengths."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.kinematics.manipulability import Ellipsoid
from helicoide.state import State
from helicoide.text import Text
from helicoide.view.colours import Colour
from helicoide.view.figures import Names, Segments
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.pose import place_node
from helicoide.view.window_view import View

# The least semi-axis that is drawn, × size, m, since three.js cannot scale by zero; below the second, × the longest, a
# semi-axis has no number.
FLAT, NAMED = 1e-4, 1e-6
INFINITE = Text(en="∞", pt_BR="∞")


class EllipsoidLayer(OptionalLayer):
    """A translucent ellipsoid and its semi-axes.

    semi_axes: gives the ellipsoid of a state and its drawn semi-axes (3,), m; words: the text of a semi-axis.
    """

    def __init__(
        self,
        stage: Stage,
        name: str,
        colour: Colour,
        semi_axes: Callable[[State], tuple[Ellipsoid, Array]],
        words: Text,
    ) -> None:
        super().__init__(stage, name)
        self.colour, self.semi_axes, self.words = colour, semi_axes, words
        self.ball: viser.IcosphereHandle | None = None
        self.axes = Segments(stage, f"/{name}/semi-axes", colour)
        self.names = Names(stage, f"/{name}")

    def draw(self, view: View) -> None:
        """Place and scale the ellipsoid."""
        ellipsoid, lengths = self.semi_axes(view.state)
        tool = view.state.T_world_tool[:3, 3]
        if self.ball is None:
            self.ball = self.stage.scene.add_icosphere(
                f"/{self.name}/ball", 1.0, self.colour, opacity=0.3, cast_shadow=False, receive_shadow=False
            )
        place_node(self.ball, _frame(ellipsoid.axes, tool))
        x, y, z = np.maximum(lengths, FLAT * self.stage.size).tolist()
        self.ball.scale = (x, y, z)
        ends = tool + (lengths * ellipsoid.axes).T
        self.axes.write(np.stack([2 * tool - ends, ends], axis=1))
        named = lengths > NAMED * lengths.max()
        self.names.write(
            [self._said(value)[view.seat.language] for value in ellipsoid.lengths[named].tolist()], ends[named]
        )

    def _said(self, value: float) -> Text:
        return self.words.format(value=value) if np.isfinite(value) else INFINITE


def _frame(axes: Array, origin: Array) -> Array:
    """The pose (4, 4) of a right-handed frame along orthogonal axes (3, 3): one is turned round if necessary."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = axes, origin
    T[:3, 2] = np.cross(axes[:, 0], axes[:, 1])
    return T
