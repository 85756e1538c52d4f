"""Names in the scene: those that would overlap are one label."""

from __future__ import annotations

import numpy as np
import pytest
from tests.view.drawn import Drawn, served

from helicoide.kinematics.library import load_robot
from helicoide.state import initial_state
from helicoide.view.figures import NEAR, joined_names
from helicoide.view.layers import dh


def test_near_names_are_joined_in_their_order_and_far_ones_stay() -> None:
    places = np.array([[0.0, 0, 0], [1, 0, 0], [0.04, 0, 0], [1, 0.05, 0], [0, 0, 2]])
    texts, kept = joined_names(["a", "b", "c", "d", "e"], places, 0.06)
    assert texts == ["a · c", "b · d", "e"]
    np.testing.assert_allclose(kept, [[0, 0, 0], [1, 0, 0], [0, 0, 2]])


def test_no_name_is_none() -> None:
    texts, kept = joined_names([], np.zeros((0, 3)), 0.06)
    assert texts == []
    assert kept.shape == (0, 3)


@pytest.mark.parametrize("robot", ["puma560", "dia10"])
def test_the_parameters_of_a_dh_row_do_not_overlap(robot: str) -> None:
    with served() as server:
        drawn = Drawn(server, dh, initial_state(load_robot(robot)))
        labels = [label for label in drawn.layer.names.labels if label.visible]
        assert any(" · " in label.text for label in labels)
        places_shown = np.array([label.position for label in labels])
        apart = np.linalg.norm(places_shown[:, None] - places_shown, axis=2)[np.triu_indices(len(places_shown), 1)]
        assert apart.min() > 0.99 * NEAR * drawn.stage.size
