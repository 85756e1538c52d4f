"""Zones adjusted within their bounds, and the damping between them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.confinement import Zone, Zones
from helicoide.confinement.zones import SHELL_THICKNESS
from helicoide.text import HelicoideError

distances = st.floats(-1, 1)


def test_zones_change_where_they_were_put() -> None:
    zones = Zones(body_clearance=0.02).adjusted(0.09, 0.2)
    assert (zones.critical, zones.warning, zones.body_clearance) == (0.09, 0.2, 0.02)
    assert [zones.zone_of(distance) for distance in (0.09, 0.0901, 0.1999, 0.2)] == [
        Zone.CRITICAL,
        Zone.WARNING,
        Zone.WARNING,
        Zone.FREE,
    ]


@given(critical=st.floats(), warning=st.floats())
def test_no_adjusted_zone_lets_the_shell_touch_a_plane(critical: float, warning: float) -> None:
    try:
        zones = Zones().adjusted(critical, warning)
    except HelicoideError:
        assert not (0.075 <= critical <= 0.15 and critical + 0.01 <= warning <= 0.25)
    else:
        assert zones.critical >= SHELL_THICKNESS + 0.010
        assert zones.critical + 0.010 <= zones.warning <= 0.250


@pytest.mark.parametrize(
    ("critical", "warning"),
    [(0.0749, 0.11), (0.151, 0.2), (0.08, 0.0899), (0.08, 0.251), (float("nan"), 0.11), (0.08, float("inf"))],
)
def test_bounds_of_zones_are_said_in_words(critical: float, warning: float) -> None:
    with pytest.raises(
        HelicoideError, match=r"75 to 150 mm .* 65 mm thick.* at least 10 mm larger, and at most 250 mm"
    ):
        Zones().adjusted(critical, warning)


def test_bounds_themselves_are_allowed() -> None:
    assert Zones().adjusted(0.075, 0.085) == Zones(0.075, 0.085)
    assert Zones().adjusted(0.15, 0.25) == Zones(0.15, 0.25)
