"""Planes saved and read back."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.confinement import Planes, plane_file, planes_of
from helicoide.confinement.plane_file import encode_planes
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError

# Any text that a file can hold: no halves of a pair of UTF-16.
NAMES = st.lists(st.text(st.characters(exclude_categories=["Cs"])), unique=True, min_size=1, max_size=6)
ONE = '[[planes]]\nname = "+z"\nnormal = [0, 0, -1]\ncentre_m = [0.5, 0, 0.6]\n'


def decoded(text: str) -> tuple[tuple[str, ...], Planes]:
    return plane_file.decode_planes(text.encode(), "here.toml")


@given(names=NAMES, seed=st.integers(0, 2**32 - 1))
def test_names_and_numbers_come_back_bit_by_bit(names: list[str], seed: int) -> None:
    rng = np.random.default_rng(seed)
    normals, centres = rng.normal(size=(2, len(names), 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    again, planes = decoded(encode_planes(names, Planes(normals, centres)))
    assert again == tuple(names)
    np.testing.assert_array_equal(planes.normals, normals)
    np.testing.assert_array_equal(planes.centres, centres)
    assert not planes.normals.flags.writeable


def test_planes_of_the_robot_survive_a_file(robot: Robot) -> None:
    planes = planes_of(robot.panes)
    names, again = decoded(encode_planes([pane.name for pane in robot.panes], planes))
    assert names == ("+z", "+y", "-y", "-z")
    np.testing.assert_array_equal(again.normals, planes.normals)
    np.testing.assert_array_equal(again.centres, planes.centres)


@pytest.mark.parametrize("length", ["1e-320", "3", "1e300"])
def test_a_normal_written_by_hand_is_of_any_length(length: str) -> None:
    _, planes = decoded(ONE.replace("-1", f"-{length}"))
    np.testing.assert_array_equal(planes.normals, [[0, 0, -1]])


BROKEN = {
    "nothing": ("", "it is empty"),
    "only words": ("# planes", "planes is missing"),
    "a key of many dots": ("a" + ".a" * 49000 + " = 1", "too many dots"),
    "a table of many dots": ("[" + '"a" . ' * 9000 + "a]", "too many dots"),
    "no toml": ("[[planes", "declaration is missing \\(at the end\\)"),
    "no planes": ("planes = []", "it has 0 planes"),
    "too many": (ONE.replace('"+z"', '"{}"') * 33, "it has 33 planes"),
    "another table": ("[robot]\nname = 1", "robot"),
    "an unknown key": (ONE + "colour = 3", "colour"),
    "no normal": (ONE.replace("normal", "# normal"), "normal"),
    "two numbers": (ONE.replace("[0, 0, -1]", "[0, 0]"), "normal"),
    "a word": (ONE.replace("-1]", '"up"]'), "normal"),
    "a zero normal": (ONE.replace("-1", "-0.0"), "normal of '\\+z' is zero"),
    "nan": (ONE.replace("0.6", "nan"), "no position"),
    "inf": (ONE.replace("-1", "-inf"), "no position"),
    "beyond numbers": (ONE.replace("-1", "1" + "0" * 400), ""),
    "far away": (ONE.replace("0.6", "2e3"), "no position"),
    "one name twice": (ONE + ONE, "two are named '\\+z'"),
    "deep": ("a = " + "[" * 20000, ""),
}


@pytest.mark.parametrize("case", BROKEN)
def test_broken_texts_are_refused_in_words(case: str) -> None:
    text, said = BROKEN[case]
    if case == "too many":
        text = "".join(ONE.replace("+z", str(i)) for i in range(33))
    with pytest.raises(HelicoideError, match=f"here.toml is not a plane file: .*{said}") as refused:
        decoded(text)
    assert "A plane file is TOML with 1 to 32 tables" in refused.value.text.en
    assert "Um arquivo de planos é TOML com 1 a 32 tabelas" in refused.value.text.pt_BR


@pytest.mark.parametrize(
    ("content", "said"), [(b"\xff\xfe", "utf-8"), (b"#" * 100_001, "too long"), (b"[[planes]]", "name")]
)
def test_broken_files_are_refused_in_words(content: bytes, said: str) -> None:
    with pytest.raises(HelicoideError, match=f"here.toml is not a plane file: .*{said}"):
        plane_file.decode_planes(content, "here.toml")
