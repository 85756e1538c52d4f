"""The code that is taken along runs, and computes the multivector that the page shows."""

from __future__ import annotations

import contextlib
import io
import re
from collections.abc import Callable
from typing import Any, get_args

import numpy as np
import pytest
from latex2mathml.converter import convert
from tests.driving import with_joints
from tests.kinematics.arms import arm
from tests.readout.scenes import SCENES, scene

from helicoide import readout
from helicoide.arrays import Array
from helicoide.export.algebra_code import VARIABLES, Formula, galaga_code, kingdon_code, latex_text
from helicoide.geometry.notation import BladeNaming
from helicoide.readout import ALGEBRAS, Element
from helicoide.seat import Notation
from helicoide.state import State, initial_state

NOTATIONS = [Notation(algebra, naming) for algebra in ALGEBRAS for naming in get_args(BladeNaming)]


def run(code: str) -> dict[str, Any]:
    names: dict[str, Any] = {}
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(code, names)
    assert printed.getvalue().strip()
    return names


def from_kingdon(names: dict[str, Any], symbol: str, notation: Notation) -> Array:
    """Coefficients by the stored blades; kingdon numbers the null generator 0 and puts it first."""
    algebra, found = ALGEBRAS[notation.algebra], np.zeros(16)
    peer = names["algebra"]
    blades = {key: name for name, key in peer.canon2bin.items()}
    for key, value in names[symbol].items():
        place, sign = algebra.parse_blade("1" if blades[key] == "e" else blades[key])
        found[place] = sign * float(value)
    return found


def from_galaga(names: dict[str, Any], symbol: str, notation: Notation) -> Array:
    """Coefficients by the stored blades; galaga numbers a blade by the bits of its generators, in their order."""
    algebra = ALGEBRAS[notation.algebra]
    return np.array([float(names[symbol].data[sum(1 << g for g in blade)]) for blade in algebra.blades])


LIBRARIES: dict[str, tuple[Callable[[Formula], str], Callable[[dict[str, Any], str, Notation], Array]]] = {
    "kingdon": (kingdon_code, from_kingdon),
    "galaga": (galaga_code, from_galaga),
}


def formula(state: State, element: Element, notation: Notation) -> Formula:
    return Formula(element.nature, element.values(state), notation, readout.chain_of(state, element))


@pytest.mark.parametrize("library", LIBRARIES)
@pytest.mark.parametrize("notation", NOTATIONS[::2], ids=str)
@pytest.mark.parametrize(("name", "seed"), SCENES[::3])
def test_the_code_computes_the_multivector(name: str, seed: int, notation: Notation, library: str) -> None:
    state = scene(name, seed)
    written, read = LIBRARIES[library]
    seen = set()
    for element in readout.elements(state):
        if element.selection.kind in seen:
            continue
        seen.add(element.selection.kind)
        names = run(written(formula(state, element, notation)))
        expected = readout.in_algebra(element.nature, element.values(state), notation.algebra)
        found = read(names, VARIABLES[element.nature], notation)
        np.testing.assert_allclose(found, expected, atol=1e-12, err_msg=element.title.en)


@pytest.mark.parametrize("notation", NOTATIONS, ids=str)
@pytest.mark.parametrize(("name", "seed"), SCENES[::3])
def test_latex_has_every_coefficient_with_all_digits(name: str, seed: int, notation: Notation) -> None:
    """The last line is read again: sums of numbers and blades; a converter of formulas takes each line."""
    state = scene(name, seed)
    algebra = ALGEBRAS[notation.algebra]
    for element in readout.elements(state):
        text = latex_text(formula(state, element, notation))
        lines = text.split("\\begin{align*}\n")[1].split("\n\\end")[0].replace("&", "").split(" \\\\\n")
        assert all("<math" in convert(line) for line in lines)
        found = np.zeros(16)
        for term in re.findall(r"[+-]?[\d.]+(?: \\times 10\^\{-?\d+\})?(?:\\,(?:e(?:_\{\d+\})?)+)?", lines[-1]):
            number, _, blade = term.partition("\\,")
            place, sign = algebra.parse_blade(re.sub(r"[_{}]", "", blade) or "1")
            found[place] = sign * float(re.sub(r" \\times 10\^\{(-?\d+)\}", r"e\1", number))
        expected = readout.in_algebra(element.nature, element.values(state), notation.algebra)
        np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("name", ["puma560", "polar_rp"])
def test_latex_writes_a_tiny_joint_value_as_a_power_of_ten(name: str) -> None:
    state = with_joints(initial_state(arm(name)), np.full(len(arm(name).variables), 1.5e-9))
    text = latex_text(formula(state, readout.elements(state)[0], Notation()))
    assert r"\times 10^{-" in text
    assert not re.search(r"\de", text)
