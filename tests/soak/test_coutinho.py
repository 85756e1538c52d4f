"""Coutinho's simulations and his experiment at 2 ms, the leaks of a damped arm, the rod's circle: whole forms."""

from __future__ import annotations

import pytest
from tests.studies.test_coutinho import held, ran

pytestmark = pytest.mark.soak


@pytest.mark.parametrize(
    ("name", "options", "least"),
    [
        ("coutinho_s1", {}, 8),
        ("coutinho_s2", {}, 21),
        ("coutinho_s4", {}, 21),
        ("coutinho_inverses", {}, 36),
        ("coutinho_e1", {"gains": "simulations"}, 20),
        ("coutinho_e1", {"gains": "experiments"}, 20),
        ("coutinho_rod", {}, 14),
        ("coutinho_hand", {}, 5),
        ("coutinho_hand", {"inverse": "damped"}, 5),
        ("coutinho_older", {}, 3),
    ],
    ids=str,
)
def test_whole_forms(name: str, options: dict[str, str], least: int) -> None:
    result = ran(name, short=False, **options)
    for row in result.rows:
        print(f"{row.quantity.en}: {row.ours:.6g} ({row.relation} {row.digest}) {row.unit}")
    assert held(result) >= least
