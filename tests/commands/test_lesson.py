"""`helicoide lesson list` names every lesson, in the order of the course."""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

import pytest

from helicoide import __main__, content, lesson


def words(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    monkeypatch.setattr(sys, "argv", ["helicoide", "lesson", *arguments])
    __main__.main()
    return capsys.readouterr().out


@pytest.mark.parametrize("arguments", [(), ("list",)])
def test_every_lesson_has_its_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...]
) -> None:
    lines = [line for line in words(monkeypatch, capsys, *arguments).splitlines() if not line.startswith(" ")]
    assert [line.partition(":")[0] for line in lines] == [each.id for each in lesson.all_lessons()]
    assert all("robot" in line and "steps" in line for line in lines)


def test_the_list_as_json(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    listed = json.loads(words(monkeypatch, capsys, "list", "--json"))
    assert [each["id"] for each in listed] == [each.id for each in lesson.all_lessons()]
    assert listed[0]["steps"] == [step.id for step in lesson.all_lessons()[0].steps]


def test_the_lessons_of_another_folder(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setattr(content, "_LESSON_FOLDERS", [])
    shutil.copytree(content.STATIC / "examples" / "lesson", tmp_path / "bend_it")
    try:
        assert "\nbend_it: New lesson" in words(monkeypatch, capsys, "list", "--lessons", str(tmp_path))
        monkeypatch.setattr(sys, "argv", ["helicoide", "check", "bend_it"])
        __main__.main()
        assert "bend_it: no faults" in capsys.readouterr().out
    finally:
        lesson.load_lesson.cache_clear()


@pytest.mark.parametrize(("folder", "said"), [("", "contains no lesson"), ("bend_it", "Here that is {}")])
def test_a_folder_without_lessons_is_refused(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path, folder: str, said: str
) -> None:
    monkeypatch.setattr(content, "_LESSON_FOLDERS", [])
    if folder:
        shutil.copytree(content.STATIC / "examples" / "lesson", tmp_path / folder)
    monkeypatch.setattr(sys, "argv", ["helicoide", "lesson", "list", "--lessons", str(tmp_path / folder)])
    with pytest.raises(SystemExit) as stopped:
        __main__.main()
    assert stopped.value.code == 2
    assert said.format(tmp_path.resolve()) in capsys.readouterr().err
    assert content._LESSON_FOLDERS == []
