"""Every multivector that is shown agrees with kingdon on random scenes, sign for sign, in both algebras."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any, get_args

import kingdon  # type: ignore[import-untyped]
import numpy as np
import pytest
from tests.readout.scenes import SCENES, scene

from helicoide import readout
from helicoide.arrays import Array
from helicoide.geometry import rigid
from helicoide.geometry.notation import BladeNaming
from helicoide.readout import ALGEBRAS, Element
from helicoide.seat import Notation, Selection, ShownAlgebra
from helicoide.state import State

NOTATIONS = [Notation(algebra, naming) for algebra in ALGEBRAS for naming in get_args(BladeNaming)]


@cache
def peer(algebra: ShownAlgebra) -> Any:
    own = ALGEBRAS[algebra]
    return kingdon.Algebra(own.p, own.q, own.r)


def blade(algebra: ShownAlgebra, name: str) -> Any:
    """A blade of kingdon as the product of the generators in the name that is shown."""
    factors = [f"e{digit}" if digit else "e0" for digit in name.removeprefix("1").split("e")[1:]]
    if factors and len(factors) == 1 and len(factors[0]) > 2:  # compact: e031 is e0 e3 e1
        factors = [f"e{digit}" for digit in factors[0][1:]]
    product = peer(algebra).multivector(e=1.0)
    for factor in factors:
        product = product * peer(algebra).blades[factor]
    return product


def in_kingdon(element: Element, state: State, notation: Notation) -> Any:
    """The sum that the page shows, from its names and numbers."""
    values = element.values(state)
    return sum(
        one.sign * float(values[one.place]) * blade(notation.algebra, one.name)
        for one in readout.coefficients(element.nature, notation)
        if values[one.place] != 0
    )


def numbers(X: Any, names: list[str], algebra: ShownAlgebra) -> Array:
    """Coefficients of a multivector of kingdon at these products of generators."""
    found = dict(X.items())
    coefficients = []
    for name in names:
        ((key, sign),) = blade(algebra, name).items()
        coefficients.append(float(sign) * float(found.get(key, 0.0)))
    return np.array(coefficients)


def framed(state: State) -> Iterator[Element]:
    yield from (element for element in readout.elements(state) if element.pose is not None)


@pytest.mark.parametrize(("name", "seed"), SCENES)
def test_motors_have_the_canonical_sign(name: str, seed: int) -> None:
    state = scene(name, seed)
    for element in framed(state):
        values = element.values(state)
        np.testing.assert_array_equal(values, rigid.canonical(values))


@pytest.mark.parametrize("notation", NOTATIONS, ids=str)
@pytest.mark.parametrize(("name", "seed"), SCENES[::3])
def test_motors_move_points_lines_and_planes_as_their_poses_do(name: str, seed: int, notation: Notation) -> None:
    """M X M~ in kingdon, with the shown names and signs, is where the 4×4 matrix takes the object."""
    state = scene(name, seed)
    rng = np.random.default_rng(seed)
    sources = notation.algebra == "Cl(0,3,1)"
    point_names, line_names = ["e2e3e", "e3e1e", "e1e2e"], ["e2e3", "e3e1", "e1e2", "e1e", "e2e", "e3e"]
    for element in framed(state):
        assert element.pose is not None
        M, T = in_kingdon(element, state, notation), element.pose(state)
        inverse = M.conjugate() if sources else M.reverse()
        x, v = rng.uniform(-1, 1, 3), rng.uniform(-1, 1, 3)
        null = 1.0 if sources else -1.0  # pga.to_modern: e → −e
        p = blade(notation.algebra, "e1e2e3") + sum(
            null * float(a) * blade(notation.algebra, b) for a, b in zip(x, point_names, strict=True)
        )
        moved = numbers(M * p * inverse, point_names, notation.algebra)
        np.testing.assert_allclose(null * moved, T[:3, :3] @ x + T[:3, 3], atol=1e-9)
        coefficients = [*v, *(null * np.cross(x, v))]
        line = sum(float(a) * blade(notation.algebra, b) for a, b in zip(coefficients, line_names, strict=True))
        turned, to = T[:3, :3] @ v, T[:3, :3] @ x + T[:3, 3]
        expected = [*turned, *(null * np.cross(to, turned))]
        np.testing.assert_allclose(numbers(M * line * inverse, line_names, notation.algebra), expected, atol=1e-9)


@pytest.mark.parametrize("notation", NOTATIONS, ids=str)
@pytest.mark.parametrize(("name", "seed"), SCENES[1::3])
def test_points_planes_and_axes_meet_in_kingdon_as_in_the_scene(name: str, seed: int, notation: Notation) -> None:
    """Points p, planes π and lines ℓ of the page: π ∧ p is their distance, and ℓ commutes with the points on it."""
    state = scene(name, seed)
    by_kind: dict[str, list[Element]] = {}
    for element in readout.elements(state):
        by_kind.setdefault(element.selection.kind, []).append(element)
    table = readout.plane_distances(state)
    null = 1.0 if notation.algebra == "Cl(0,3,1)" else -1.0
    for j, k in np.ndindex(table.shape):
        p = in_kingdon(by_kind["point"][j], state, notation)
        pi = in_kingdon(by_kind["plane"][k], state, notation)
        (volume,) = numbers(pi ^ p, ["e1e2e3e"], notation.algebra)
        assert null * volume == pytest.approx(table[j, k], abs=1e-9)
    for i, element in enumerate(by_kind["joint"]):
        line = in_kingdon(element, state, notation)
        on_it = state.arm.poses[i + 1, :3, 3] + 0.3 * state.axes[i]
        p = blade(notation.algebra, "e1e2e3") + sum(
            null * float(a) * blade(notation.algebra, b)
            for a, b in zip(on_it, ["e2e3e", "e3e1e", "e1e2e"], strict=True)
        )
        commutator = line * p - p * line
        assert np.abs([float(value) for _, value in commutator.items()] or [0.0]).max() < 1e-9


def test_every_element_has_a_selection_of_its_own_and_two_titles() -> None:
    state = scene("movemaster", 0)
    elements = readout.elements(state)
    assert len({element.selection for element in elements}) == len(elements)
    assert all(
        element.title.en and element.title.pt_BR and element.values(state).shape == (16,) for element in elements
    )
    assert len({(element.symbol, element.index) for element in elements}) == len(elements)


def test_an_object_that_is_gone_is_not_inspected() -> None:
    state = scene("movemaster", 0)
    for selection in (Selection("plane", 99), Selection("path"), Selection("entry"), None):
        assert readout.element_of(state, selection) is None


def test_the_exact_text_gives_every_number_again() -> None:
    """The copied coefficients are the floats themselves."""
    state = scene("puma560", 1)
    for element in readout.elements(state):
        for notation in NOTATIONS:
            head, *lines = readout.exact_text(element.nature, element.values(state), notation).split("\n")
            assert head == notation.algebra
            copied = {name: float(number) for name, number in (line.split("\t") for line in lines)}
            for one in readout.coefficients(element.nature, notation):
                assert copied.get(one.name, 0.0) == one.sign * element.values(state)[one.place]
