"""How the enclosure was measured: what its rows are worth, and by how much three points tilt a plane."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from helicoide.perception import planes
from helicoide.studies import cerbaro_detection
from helicoide.studies.cerbaro_detection import TRIPLES, Options, eq_25_row, three_point_normals, tilt
from helicoide.studies.study import Row, Verdict

WITHIN_4 = "planes found within 4° of the reference normal"


def rows() -> dict[str, Row]:
    return {row.quantity.en: row for row in cerbaro_detection.run(Options(), True, lambda share: None).rows}


def test_three_points_tilt_a_plane_and_a_fit_to_all_does_not() -> None:
    """Recomputed by other code: median 1 to 3°, 95 % within 11 to 25°, at 2 mm; 8 % on the wall from the T265."""
    found = rows()
    for wall in ("ceiling", "left wall", "right wall"):
        assert found[f"{wall}: fit to all points, median tilt"].computed < 0.3
        assert 1 < found[f"{wall}: three random points, median tilt"].computed < 3
        assert 11 < found[f"{wall}: three random points, 95 % below"].computed < 25
    assert found["left wall: points on it, camera where the T265 is"].computed == pytest.approx(8, abs=0.5)
    assert found[WITHIN_4].computed == 1


def test_a_search_that_asks_for_no_angle_finds_all_three(monkeypatch: pytest.MonkeyPatch) -> None:
    wide = partial(planes.find_plane, distance=planes.DISTANCE)
    monkeypatch.setattr(
        cerbaro_detection,
        "find_plane",
        lambda points, towards, inside, angle, seed: wide(points, towards, inside, seed=seed),
    )
    assert rows()[WITHIN_4].computed == 3


def test_with_its_points_in_another_order_the_plane_of_the_example_is_turned(monkeypatch: pytest.MonkeyPatch) -> None:
    assert eq_25_row().verdict is Verdict.PRINTED
    monkeypatch.setattr(cerbaro_detection, "POINTS", cerbaro_detection.POINTS[[1, 0, 2]])
    assert eq_25_row().verdict is Verdict.DIFFERS


def test_exact_points_give_the_exact_plane_through_any_three() -> None:
    rng = np.random.default_rng(0)
    level = np.column_stack([rng.uniform(-1, 1, (200, 2)), np.full(200, 0.3)])
    normals = three_point_normals(level, 0)
    assert 0.9 * TRIPLES < len(normals) <= TRIPLES
    assert tilt(normals, np.array([0.0, 0.0, 1.0])).max() < 1e-4
