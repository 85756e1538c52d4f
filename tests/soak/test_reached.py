"""Two thousand arms by chance, each brought back to a pose that it takes. Run with `make soak`."""

from __future__ import annotations

import pytest
from tests.ik.postures.test_reached import lost

pytestmark = pytest.mark.soak

ARMS, MOST_LOST = 2_000, 2


def test_what_arms_by_chance_take_they_reach() -> None:
    found = lost(range(ARMS))
    print(f"{len(found)} of {ARMS} not reached: {found}")
    assert len(found) <= MOST_LOST
