"""Where robots and lessons are found, and where compiled kernels are cached."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from helicoide import content
from helicoide.text import HelicoideError, Text, untranslated

APP = Path(__file__).parents[1] / "app"
CALL = """
import numpy as np
from helicoide import kernels
from helicoide.ik.guard import qp
print(kernels.CACHE_FOLDER)
print("" if kernels.CACHE_NOTE is None else kernels.CACHE_NOTE.en)
print("" if kernels.CACHE_NOTE is None else kernels.CACHE_NOTE.pt_BR)
print(kernels.is_cached("helicoide.ik.guard.qp.inner_product"))
assert qp.inner_product(np.ones(3), np.ones(3)) == 3.0
print(sum(qp.inner_product.stats.cache_misses.values()))
print(kernels.is_cached("helicoide.ik.guard.qp.inner_product"))
print("helicoide.ik.guard.qp.inner_product" in kernels.KERNELS)
"""


def run(code: str, **environment: str) -> list[str]:
    given = {k: v for k, v in os.environ.items() if k != "NUMBA_CACHE_DIR"}
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        env={**given, "PYTHONPATH": str(APP), **environment},
        timeout=120,
        check=True,
    )
    assert done.stderr == ""
    return done.stdout.splitlines()


def test_kernels_are_kept_in_the_given_folder(tmp_path: Path) -> None:
    first = run(CALL, NUMBA_CACHE_DIR=str(tmp_path))
    assert Path(first[0]).parent == tmp_path
    assert first[1:] == ["", "", "False", "1", "True", "True"]
    again = run(CALL, NUMBA_CACHE_DIR=str(tmp_path))
    assert again[1:] == ["", "", "True", "0", "True", "True"], "the second process loads what the first compiled"


def test_a_child_process_keeps_its_parents_folder(tmp_path: Path) -> None:
    (folder, *_) = run(CALL, NUMBA_CACHE_DIR=str(tmp_path))
    (inherited, *_) = run(CALL, NUMBA_CACHE_DIR=folder)
    assert inherited == folder


@pytest.mark.parametrize("names", [("NUMBA_CACHE_DIR",), ("XDG_CACHE_HOME",), ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME")])
def test_a_cache_that_cannot_be_written_is_replaced_and_told_in_one_line(
    tmp_path: Path, names: tuple[str, ...]
) -> None:
    """A file is in the place of the folder, which also stops root."""
    blocked = tmp_path / "blocked"
    blocked.write_text("a file")
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    lines = run(CALL, TMPDIR=str(temporary), **dict.fromkeys(names, str(blocked)))
    folder, english, portuguese, before, compiled, after, known = lines
    assert temporary in Path(folder).parents
    for words in (english, portuguese):
        assert str(blocked) in words
        assert str(temporary) in words
    assert english != portuguese
    assert [before, compiled, after, known] == ["False", "1", "True", "True"]


def test_shipped_robots_are_found() -> None:
    assert "movemaster" in content.content_folders("robots")
    assert (content.content_folder("robots", "movemaster") / "robot.toml").is_file()
    assert content.STATIC.is_dir()


def test_a_users_robot_is_added_and_comes_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(content, "user_folder", lambda: tmp_path)
    for name in ("own", "movemaster"):
        (tmp_path / "robots" / name).mkdir(parents=True)
        (tmp_path / "robots" / name / "robot.toml").touch()
    (tmp_path / "robots" / "unfinished").mkdir()
    found = content.content_folders("robots")
    assert {name: found[name] for name in ("own", "movemaster")} == {
        name: tmp_path / "robots" / name for name in ("own", "movemaster")
    }
    assert "unfinished" not in found


@pytest.mark.parametrize("kind", ["robots", "lessons"])
def test_an_unknown_name_lists_those_there_are(kind: content.ContentKind) -> None:
    with pytest.raises(HelicoideError) as caught:
        content.content_folder(kind, "nowhere")
    for words in (caught.value.text.en, caught.value.text.pt_BR):
        assert all(name in words for name in ("nowhere", *content.content_folders(kind)))


def test_a_text_fills_each_language_with_its_own_words() -> None:
    text = Text(en="the {what} is {n}", pt_BR="o {what} é {n}").format(what=Text(en="plane", pt_BR="plano"), n=1)
    assert (text["en"], text["pt_BR"]) == ("the plane is 1", "o plano é 1")
    assert untranslated("π")["en"] == untranslated("π")["pt_BR"] == "π"
    assert str(HelicoideError(text)) == "the plane is 1"
