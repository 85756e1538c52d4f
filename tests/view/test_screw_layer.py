"""The screw of the highlighted object: its helix is always drawn, its axis only where it is near."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.view.drawn import Drawn, served

from helicoide import gate
from helicoide.geometry import rotation
from helicoide.seat import Selection
from helicoide.state import State
from helicoide.view.layers import screw


@pytest.mark.parametrize(("angle", "near"), [(1.0, True), (0.01, False), (0.0, True)])
def test_an_axis_that_is_far_away_is_not_drawn(state: State, angle: float, near: bool) -> None:
    """With 0.01 rad the axis is some 40 m away; a pure translation has its direction only, drawn from the base."""
    target = gate.set_target([0.4, 0.0, 0.3], rotation.from_axis_angle([0.0, 1.0, 0.0], angle))(state)
    with served() as server:
        drawn = Drawn(server, screw, target)
        assert drawn.node("helix") is None
        seen = replace(drawn.view, seat=replace(drawn.view.seat, selected=Selection("target")))
        drawn.layer.update(drawn.view, seen)
        shown = {name for name in ("helix", "axis", "arc", "name") if drawn.node(name) is not None}
        assert shown == {"helix", *(["axis"] if near else []), *(["arc", "name"] if near and angle else [])}
        helix = drawn.node("helix").points
        np.testing.assert_allclose(helix[[0, -1], [0, 1]], [[0, 0, 0], [0.4, 0.0, 0.3]], atol=1e-5)
