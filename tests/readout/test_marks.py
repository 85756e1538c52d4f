"""What a coefficient lights up lies on what is drawn: from exact coefficients to 1e-9, from shown digits as rounded."""

from __future__ import annotations

import numpy as np
import pytest
from tests.readout.scenes import SCENES, scene

from helicoide import readout
from helicoide.arrays import Array
from helicoide.geometry.clifford import CL031
from helicoide.readout import Element
from helicoide.seat import Notation
from helicoide.state import State
from helicoide.text import LANGUAGES
from helicoide.view.layers.screw import axis_segment

EXACT = 1e-9


def to_line(points: Array, on_it: Array, direction: Array) -> float:
    """The largest distance of points (..., 3) from a line."""
    return float(np.linalg.norm(np.cross(points.reshape(-1, 3) - on_it, direction), axis=1).max())


def copied(element: Element, state: State, algebra: str = "Cl(3,0,1)") -> Array:
    """The coefficients as the copy button gives them, read again."""
    notation = Notation(algebra, "compact")  # type: ignore[arg-type]
    text = readout.exact_text(element.nature, element.values(state), notation)
    read = dict(line.split("\t") for line in text.split("\n")[1:])
    values = np.zeros(16)
    for one in readout.coefficients(element.nature, notation):
        values[one.place] = one.sign * float(read.get(one.name, 0.0))
    return values


def error(state: State, element: Element, values: Array, blade: str) -> float:
    """How far the marks of a coefficient are from the drawn object, m."""
    reach = state.robot.reach
    marks, index = readout.coefficient_marks(element.nature, values, blade, reach), element.selection.index
    if not any(map(len, (marks.arrows, marks.segments, marks.area))):
        return 0.0
    match element.nature:
        case "line":
            on_it = marks.arrows[0] if len(marks.arrows) else marks.area[1:3]
            away = to_line(on_it, state.arm.poses[index + 1, :3, 3], state.axes[index])
            lever = [segment for segment in marks.segments if np.allclose(segment[0], 0)]
            return max(
                [away, *(to_line(one[1], state.arm.poses[index + 1, :3, 3], state.axes[index]) for one in lever)]
            )
        case "plane":
            planes = state.problem.planes
            foot = marks.arrows[0, 0] if len(marks.arrows) else marks.segments[0, 1]
            return abs(float(planes.normals[index] @ foot - planes.offsets[index]))
        case "point":
            drawn = state.problem.entry.point if element.selection.kind == "entry" and state.problem.entry else None
            point = state.monitored_points[index] if drawn is None else drawn
            end = marks.arrows[0, 1] if len(marks.arrows) else marks.segments[0, 1]
            return float(np.linalg.norm(end - point))
    drawn_screw = readout.drawn_screw(state, element)
    assert drawn_screw is not None
    if drawn_screw.screw.angle == 0:
        return float(np.linalg.norm(marks.arrows[0, 1] - drawn_screw.helix[-1]))
    start, end = axis_segment(drawn_screw, reach)
    axis = (end - start) / np.linalg.norm(end - start)
    if blade == "1":  # the half arc is the first half of the drawn one
        return float(np.linalg.norm(marks.segments[-1, 1] - drawn_screw.arc()[len(drawn_screw.arc()) // 2]))
    on_axis = [marks.arrows[0]] if len(marks.arrows) else list(marks.segments)
    return max(to_line(np.asarray(one), start, axis) for one in on_axis)


@pytest.mark.parametrize(("name", "seed"), SCENES)
def test_what_is_lit_lies_on_what_is_drawn(name: str, seed: int) -> None:
    state = scene(name, seed)
    for element in readout.elements(state):
        for algebra in ("Cl(0,3,1)", "Cl(3,0,1)"):
            values = copied(element, state, algebra)
            np.testing.assert_array_equal(values, element.values(state))
            for blade in CL031.names:
                assert error(state, element, values, blade) < EXACT * max(1.0, state.robot.reach), (element, blade)


@pytest.mark.parametrize("name", [name for name, seed in SCENES if seed == 0])
def test_a_component_that_is_zero_has_no_arrow(name: str) -> None:
    """The first axis of an arm is often vertical: its x and y components are zero, and an arrow has a head."""
    state = scene(name, 0)
    for element in readout.elements(state):
        values = element.values(state)
        for blade in CL031.names:
            arrows = readout.coefficient_marks(element.nature, values, blade, state.robot.reach).arrows
            assert (np.linalg.norm(arrows[:, 1] - arrows[:, 0], axis=1) > 1e-7).all(), (element.title.en, blade)


@pytest.mark.parametrize(("name", "seed"), SCENES)
def test_the_helix_begins_at_the_base_and_ends_at_the_frame(name: str, seed: int) -> None:
    state = scene(name, seed)
    for element in readout.elements(state):
        drawn = readout.drawn_screw(state, element)
        if element.pose is not None:
            assert drawn is not None
            np.testing.assert_allclose(drawn.helix[0], np.zeros(3), atol=EXACT)
            np.testing.assert_allclose(drawn.helix[-1], element.pose(state)[:3, 3], atol=EXACT)
        assert (drawn is None) == (element.nature in ("plane", "point"))


@pytest.mark.parametrize(("name", "seed"), SCENES[::3])
def test_from_the_displayed_digits_the_error_is_that_of_their_rounding(name: str, seed: int) -> None:
    """Three decimals of coefficients up to size s move points of the object by a few times 5e-4 (1 + s), m."""
    state = scene(name, seed)
    for element in readout.elements(state):
        if element.nature == "motor":
            continue  # a screw axis is not a continuous function of its motor near a translation
        exact = element.values(state)
        rounded = np.round(exact, 3)
        size = 1 + float(np.abs(exact).max()) + state.robot.reach
        for blade in CL031.names:
            assert error(state, element, rounded, blade) < 4 * 5e-4 * size, (element.title.en, blade)


@pytest.mark.parametrize(("name", "seed"), SCENES[::3])
def test_every_coefficient_is_explained_in_both_languages(name: str, seed: int) -> None:
    """Each in words without a gap in them; those that are always 0 say so, and are 0."""
    state = scene(name, seed)
    for element in readout.elements(state):
        values = element.values(state)
        for blade, value in zip(CL031.names, values, strict=True):
            said = readout.meaning(element.nature, values, blade)
            assert all(said[language] and "{" not in said[language] for language in LANGUAGES)
            if readout.role_of(element.nature, blade) is None:
                assert value == 0
