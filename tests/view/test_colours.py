"""Colours that mean different things in one picture look different, also to people with dichromatic vision."""

from __future__ import annotations

import re
from collections.abc import Mapping
from itertools import combinations

import numpy as np
import pytest
from tests.view.colour_vision import VISIONS, ciede2000, contrast, difference, lab

from helicoide import content
from helicoide.confinement import Zone
from helicoide.export import svg
from helicoide.view import colours, workspace_rows
from helicoide.view.layers import (
    all_layers,
    axes,
    cloud,
    compared,
    goal,
    linked,
    obstacles,
    path,
    planes,
    playground,
    target,
    trail,
)

LEAST, SHADE, TINT = 10.0, 3.0, 1.3  # ΔE₀₀, and the contrast of lines and of translucent bodies with the background
LEGIBLE = 4.5  # contrast of text with its background
BACKGROUNDS = {"light": (255, 255, 255), "dark": (20, 20, 20)}  # of viser's scene
STYLES = {name: (content.STATIC / name).read_text("utf-8") for name in ("panel.css", "helicoide.css")}


def rgb(code: str) -> tuple[int, ...]:
    return tuple(int(code[i : i + 2], 16) for i in (1, 3, 5))


def variables(scheme: str, *names: str) -> dict[str, tuple[int, ...]]:
    """Colours of the style sheet in one look."""
    light, dark = (dict(re.findall(r"--([\w-]+): (#\w{6});", block)) for block in STYLES["panel.css"].split("}")[:2])
    return {name: rgb((light | dark if scheme == "dark" else light)[name]) for name in names}


GRADES, VERDICTS = [f"grade-{k}" for k in range(5)], ["printed", "erratum", "fitted", "differs"]
PICTURES: Mapping[str, Mapping[str, tuple[int, ...]]] = {
    "planes": {**{zone.value: colour for zone, colour in planes.COLOURS.items()}, "off": planes.OFF},
    "outlines": {
        "goal": goal.MET,
        "missed goal": goal.MISSED,
        "compared arm": compared.COLOUR,
        "linked posture": linked.COLOUR,
    },
    "lines": {
        "trail": trail.COLOUR,
        "path": path.COLOUR,
        "axes": axes.COLOUR,
        "near target": target.NEAR,
        "far target": target.FAR,
    },
    "cloud": {"on": cloud.ON_IT, "off": cloud.OFF_IT},
    "obstacles": {"free": obstacles.FREE, "limits the arm": obstacles.HOLDS},
    "charts": {code: rgb(code) for code in svg.COLOURS},
    "palette": {str(colour): colour for colour in colours.PALETTE},
    "tones": {
        tone: rgb(code)
        for tone, code in re.findall(r'\[data-tone="(\w+)"\] \{\s+--tone: (#\w{6});', STYLES["helicoide.css"])
    },
    **{f"grades, {scheme}": variables(scheme, *GRADES) for scheme in BACKGROUNDS},
    **{f"verdicts, {scheme}": variables(scheme, *VERDICTS) for scheme in BACKGROUNDS},
}
# Pictures in which something else says the same as the colour.
SAID_OTHERWISE = {
    "grades, light": "each grade has a row of its own, and each coefficient the name of its blade",
    "grades, dark": "the same",
    "verdicts, light": "each verdict begins with a sign of its own",
    "verdicts, dark": "the same",
    "tones": "the words of the status line",
}


def too_near(picture: Mapping[str, tuple[int, ...]]) -> list[tuple[str, str, str, float]]:
    """The pairs of a picture that a vision can hardly tell apart."""
    return [
        (vision, one, other, round(apart, 1))
        for vision in VISIONS
        for (one, a), (other, b) in combinations(picture.items(), 2)
        if (apart := difference(a, b, vision)) < LEAST
    ]


@pytest.mark.parametrize("name", PICTURES)
def test_every_vision_tells_the_colours_of_a_picture_apart(name: str) -> None:
    assert len(PICTURES[name]) > 1
    found = too_near(PICTURES[name])
    assert bool(found) == (name in SAID_OTHERWISE), found


def test_each_grade_has_a_row_and_each_verdict_a_sign() -> None:
    for grade, row in ((1, 2), (2, 3), (3, 4)):
        assert f".helicoide-grid .g{grade} {{ grid-row: {row}; }}" in STYLES["helicoide.css"]


@pytest.mark.parametrize("scheme", BACKGROUNDS)
def test_text_is_legible_in_both_looks(scheme: str) -> None:
    (ground,) = variables(scheme, "ground").values()
    for name, colour in variables(
        scheme, "ink", "dimmed", "faint", "accent", "danger", "good", *GRADES, *VERDICTS
    ).items():
        assert contrast(colour, ground) >= LEGIBLE, name


def test_no_text_has_a_colour_of_one_look_alone() -> None:
    """A rule names the colour of its text as a variable, unless it also gives the background."""
    for file in content.STATIC.glob("*.css"):
        for rule in file.read_text("utf-8").split("}"):
            assert "background: " in rule or not re.search(r"(?<![\w-])(color|fill): #", rule), (file.name, rule)


@pytest.mark.parametrize("background", BACKGROUNDS)
def test_lines_are_seen_on_both_backgrounds(background: str) -> None:
    for colour in (*colours.LINES, planes.COLOURS[Zone.FREE], planes.COLOURS[Zone.CRITICAL]):
        assert contrast(colour, BACKGROUNDS[background]) >= SHADE, colour


@pytest.mark.parametrize("background", BACKGROUNDS.values())
def test_the_ball_of_quaternions_and_its_circles_are_seen_on_both_backgrounds(background: tuple[int, ...]) -> None:
    share = playground.OPACITY
    mixed = [share * a + (1 - share) * b for a, b in zip(playground.BALL, background, strict=True)]
    assert contrast(tuple(map(round, mixed)), background) >= TINT
    assert playground.BALL in colours.LINES


def test_the_colours_of_lines_and_outlines_are_of_the_palette() -> None:
    names = ("outlines", "lines", "cloud")
    assert {colour for name in names for colour in PICTURES[name].values()} <= set(colours.PALETTE)
    assert [rgb(code) for code in svg.COLOURS] == [*colours.PALETTE]


def test_a_map_grows_lighter_in_every_vision() -> None:
    for vision in VISIONS:
        lightness = [lab(anchor, vision)[0] for anchor in workspace_rows.ANCHORS]
        assert (np.diff(lightness) > 5).all(), vision


def test_every_layer_is_looked_at() -> None:
    """A layer with colours that are not of the palette belongs to a picture, or is named here with its reason.

    Optional layers name their parts in the scene, so that colours of the palette may come again.
    """
    alone = {
        "ball": "its natural colours",
        "frames": "x, y and z in red, green and blue, as everywhere",
        "entry": "a ball, the only one",
        "lit": "thicker than all other lines, and in one place; magenta marks a part of it",
        "picked": "points, while a plane is picked",
        "map": "a scale of lightness",
    }
    known = {module.NAME for module in (axes, cloud, compared, goal, linked, obstacles, path, planes, target, trail)}
    coloured = {
        layer.NAME
        for layer in all_layers()
        if any(
            isinstance(value, tuple)
            and len(value) == 3
            and all(type(v) is int for v in value)
            and value not in colours.PALETTE
            for value in vars(layer).values()
        )
    }
    assert coloured - known - alone.keys() == set()


@pytest.mark.parametrize(
    ("one", "other", "apart"),
    [
        ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
        ((50.0, 2.4900, -0.0010), (50.0, -2.4900, 0.0011), 7.2195),
        ((50.0, 2.5, 0.0), (73.0, 25.0, -18.0), 27.1492),
        ((22.7233, 20.0904, -46.6940), (23.0331, 14.9730, -42.5619), 2.0373),
        ((2.0776, 0.0795, -1.1350), (0.9033, -0.0636, -0.5514), 0.9082),
    ],
)
def test_the_colour_difference_is_that_of_its_source(
    one: tuple[float, ...], other: tuple[float, ...], apart: float
) -> None:
    """Sharma, Wu and Dalal 2005, table 1."""
    assert ciede2000(np.array(one), np.array(other)) == pytest.approx(apart, abs=1e-4)


def test_visions_keep_white_and_lose_what_they_should() -> None:
    for vision in VISIONS:
        np.testing.assert_allclose(lab((255, 255, 255), vision), [100, 0, 0], atol=0.1)
    assert difference((44, 160, 44), (255, 127, 14), "protan") < 2 < difference((44, 160, 44), (255, 127, 14), "normal")
