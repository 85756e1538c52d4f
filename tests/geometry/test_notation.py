"""Multivectors on paper: both namings say the same multivector, and what is written can be read back."""

from __future__ import annotations

import re
from html import unescape

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.content import STATIC
from helicoide.geometry import notation
from helicoide.geometry.clifford import CL031, PGA, Algebra, Array
from helicoide.geometry.notation import BladeNaming

NAMINGS: tuple[BladeNaming, ...] = ("factors", "compact")
signatures = st.tuples(*[st.integers(0, 4)] * 3).filter(lambda pqr: sum(pqr) <= 4)


def of(**coefficients: float) -> Array:
    return np.asarray(sum(value * CL031.blade(name) for name, value in coefficients.items()))


def read_back(written: str, algebra: Algebra) -> Array:
    """Sum of the terms of a text; a blade that is missing is 1, and so is a number."""
    values = np.zeros(len(algebra.blades))
    for term in re.findall(r"-?[^ +-][^+-]*", written.replace("- ", "-")):
        number, name = re.fullmatch(r"(-?[\d.]*) ?(e.*)?", term.strip()).groups()  # type: ignore[union-attr]
        values += (float(number) if number.strip("-") else float(number + "1")) * algebra.blade(name or "1")
    return values


def test_a_rotor_in_each_notation() -> None:
    rotor = np.cos(np.pi / 6) * CL031.blade("1") + np.sin(np.pi / 6) * CL031.blade("e1e2")
    assert notation.multivector_text(rotor, CL031) == "0.866 + 0.5 e1e2"
    assert notation.multivector_text(rotor, CL031, "compact") == "0.866 + 0.5 e12"
    assert notation.multivector_latex(rotor, CL031) == r"0.866 + 0.5\,e_{1}e_{2}"
    assert notation.multivector_latex(rotor, CL031, "compact") == r"0.866 + 0.5\,e_{12}"


def test_the_null_generator_is_e_or_0_in_front() -> None:
    values = of(e=-1, e1e=2, e1e2e=3, e1e2e3e=1)
    assert notation.multivector_text(values, CL031) == "-e + 2 e1e + 3 e1e2e + e1e2e3e"
    assert notation.multivector_text(values, CL031, "compact") == "-e0 - 2 e01 - 3 e021 - e0123"
    assert notation.multivector_latex(values, CL031) == r"-e + 2\,e_{1}e + 3\,e_{1}e_{2}e + e_{1}e_{2}e_{3}e"
    assert notation.multivector_latex(values, CL031, "compact") == r"-e_{0} - 2\,e_{01} - 3\,e_{021} - e_{0123}"


def test_numbers_are_rounded_and_never_written_with_a_power() -> None:
    assert notation.multivector_text(of(e1=4e-4, e2=-1.0004), CL031) == "-e2"
    assert notation.multivector_text(of(e1=4e-4), CL031) == "0"
    assert notation.multivector_text(of(e1=-2.5e16, e2=100), CL031) == "-25000000000000000 e1 + 100 e2"
    assert notation.multivector_text(-PGA.blade("1"), PGA) == "-1"
    assert notation.multivector_text(10 * PGA.blade("1"), PGA) == "10"


@pytest.mark.parametrize("naming", NAMINGS)
def test_mathml_is_one_element_with_every_index(naming: BladeNaming) -> None:
    written = notation.multivector_mathml(of(e1e2=0.5, e=-2), CL031, naming)
    assert re.fullmatch(r"<math.*</math>", written)
    assert (
        unescape("".join(re.findall(r"<m[nio][^>]*>([^<]*)<", written)))
        == {
            "factors": "−2e+0.5e1e2",
            "compact": "−2e0+0.5e12",
        }[naming]
    )


@given(signatures, st.data())
def test_both_namings_are_read_back_as_the_same_multivector(
    signature: tuple[int, int, int], data: st.DataObject
) -> None:
    algebra = Algebra(*signature)
    count = len(algebra.blades)
    values = np.array(data.draw(st.lists(st.integers(-4000, 4000), min_size=count, max_size=count))) / 1000
    for naming in NAMINGS:
        np.testing.assert_allclose(
            read_back(notation.multivector_text(values, algebra, naming), algebra), values, atol=1e-12
        )


COLOURED = re.compile(r'<span style="color:([^"]+)">([^<]*(?:<sub>\d+</sub>[^<]*)*)</span>')


@given(st.data(), signatures)
def test_html_is_the_text_in_the_colours_of_the_grades(data: st.DataObject, pqr: tuple[int, int, int]) -> None:
    algebra = Algebra(*pqr)
    numbers = st.floats(-3, 3).map(lambda x: round(x, 2))
    values = np.array(data.draw(st.lists(numbers, min_size=algebra.count, max_size=algebra.count)))
    for naming in NAMINGS:
        page = notation.multivector_html(values, algebra, naming)
        plain = unescape(re.sub("<[^>]+>", "", page)).replace("−", "-")
        assert plain == notation.multivector_text(values, algebra, naming)
        for colour, term in COLOURED.findall(page):
            name = re.sub("<[^>]+>", "", term).partition("e")
            grade = algebra.grades[algebra.parse_blade(name[1] + name[2] or "1")[0]]
            assert colour == notation.GRADE_COLOURS[grade % 5]


def test_colours_are_those_of_the_page() -> None:
    light, _ = (STATIC / "panel.css").read_text("utf-8").split("}", 1)
    colours = re.findall(r"--grade-(\d): (#\w+);", light)
    assert [colour for grade, colour in colours if grade != "0"] == list(notation.GRADE_COLOURS[1:])
