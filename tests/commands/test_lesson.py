"""`helicoide lesson list` names every lesson, in the order of the course."""

from __future__ import annotations

import json
import sys

import pytest

from helicoide import __main__, lesson


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
