"""The blades of an algebra: their order, and their names in both namings."""

from __future__ import annotations

from functools import reduce

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.geometry.clifford import CL031, PGA, Algebra
from helicoide.text import HelicoideError

ORDER = "1 e1 e2 e3 e e1e2 e1e3 e2e3 e1e e2e e3e e1e2e3 e1e2e e1e3e e2e3e e1e2e3e"
signatures = st.tuples(*[st.integers(0, 5)] * 3).filter(lambda pqr: sum(pqr) <= 5)


def test_blades_stand_in_the_order_of_the_source() -> None:
    assert " ".join(CL031.names) == ORDER
    assert CL031.blades[8] == (0, 3)
    assert CL031.grades.tolist() == [0] + [1] * 4 + [2] * 6 + [3] * 4 + [4]


def test_more_null_generators_are_numbered() -> None:
    assert Algebra(1, 0, 2).names == ("1", "e1", "e2", "e3", "e1e2", "e1e3", "e2e3", "e1e2e3")


@pytest.mark.parametrize("signature", [(4, 3, 0), (-1, 3, 1)])
def test_signatures_out_of_range_are_refused(signature: tuple[int, int, int]) -> None:
    with pytest.raises(HelicoideError, match=r"p \+ q \+ r ≤ 6"):
        Algebra(*signature)


@pytest.mark.parametrize(
    ("name", "place", "sign"),
    [
        ("1", "1", 1),
        ("e31", "e1e3", -1),
        ("e3e1", "e1e3", -1),
        ("e0", "e", 1),
        ("e1e", "e1e", 1),
        ("e01", "e1e", -1),
        ("e10", "e1e", 1),
        ("e012", "e1e2e", 1),
        ("e032", "e2e3e", -1),
        ("ee1", "e1e", -1),
        ("e12e", "e1e2e", 1),
        ("e0123", "e1e2e3e", -1),
    ],
)
def test_blades_are_read_in_either_naming_and_any_order(name: str, place: str, sign: int) -> None:
    assert CL031.parse_blade(name) == (CL031.names.index(place), sign)
    np.testing.assert_array_equal(CL031.blade(name), sign * np.eye(16)[CL031.names.index(place)])


@given(signatures)
def test_names_of_both_kinds_are_those_of_the_blades(signature: tuple[int, int, int]) -> None:
    algebra = Algebra(*signature)
    places = list(range(len(algebra.blades)))
    assert [algebra.parse_blade(name) for name in algebra.names] == [(place, 1) for place in places]
    assert [algebra.parse_blade(name)[0] for name in algebra.compact_names] == places
    generators = [algebra.blade(name) for name in algebra.names[1 : len(algebra.squares) + 1]]
    product = reduce(algebra.product, generators, algebra.blade("1"))
    np.testing.assert_array_equal(product, algebra.blade(algebra.names[-1]))


def test_compact_names_begin_with_the_null_generator() -> None:
    assert " ".join(PGA.compact_names) == "1 e1 e2 e3 e0 e12 e13 e23 e01 e02 e03 e123 e012 e013 e023 e0123"
    assert Algebra(1, 0, 2).compact_names == ("1", "e1", "e2", "e3", "e12", "e13", "e23", "e123")
    assert PGA.parse_blade("e0123") == (15, -1)


@pytest.mark.parametrize("name", ["", "e4", "e11", "e0e", "x", "e1 e2", "2", "11", "e1e2e1", "E1"])
def test_unknown_blades_are_refused_with_the_generators(name: str) -> None:
    with pytest.raises(HelicoideError, match="e1, e2, e3, e, each at most once, as in e1e2e3e, e0123") as caught:
        CL031.parse_blade(name)
    assert f'"{name}"' in caught.value.text.pt_BR
