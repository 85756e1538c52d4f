"""`helicoide study`: the list, one study, all of them, and what is refused."""

from __future__ import annotations

import errno
import json
import re
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from helicoide import __main__, studies
from helicoide.ik.method import settings
from helicoide.studies import cerbaro_orca_convergence as quick
from helicoide.studies.study import Result, Row, printed_statement
from helicoide.text import HelicoideError, Text, untranslated

NAME = "cerbaro_orca_convergence"
Said = tuple[str, str]


@pytest.fixture
def study(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Callable[..., Said]:
    """What the command writes to its two outputs."""

    def run(*arguments: str) -> Said:
        monkeypatch.setattr(sys, "argv", ["helicoide", "study", *arguments])
        __main__.main()
        return capsys.readouterr()

    return run


def put(monkeypatch: pytest.MonkeyPatch, result: Result | Exception) -> None:
    """A study that comes to a given result."""

    def run(options: Any, short: bool, progress: Callable[[float], None]) -> Result:
        if isinstance(result, Exception):
            raise result
        return result

    stand_in = SimpleNamespace(
        TITLE=quick.TITLE, SOURCE=quick.SOURCE, ABOUT=quick.ABOUT, ROBOT=quick.ROBOT, Options=quick.Options, run=run
    )
    monkeypatch.setattr(studies, "study_named", lambda name: stand_in)


def test_the_list_has_every_study_and_its_options(study: Callable[..., Said]) -> None:
    said = study("--list")[0]
    for name in studies.study_names():
        assert f"{name}: {studies.study_named(name).TITLE.en} ({studies.study_named(name).SOURCE})" in said
        for option in settings(studies.study_named(name).Options):
            assert f"   {option}=" in said
    assert studies.study_named(NAME).TITLE.pt_BR in study("--list", "--lang", "pt_BR")[0]


def test_a_study_prints_a_table_and_a_bar_on_the_error_output(study: Callable[..., Said]) -> None:
    said, bar = study(NAME)
    assert any(line.startswith("quantity") for line in said.splitlines())
    assert [word for word in ("the source says", "here", "verdict", "What differs") if word not in said] == []
    assert "%" in bar
    assert "%" not in said


def test_the_table_is_there_in_portuguese(study: Callable[..., Said]) -> None:
    said = study(NAME, "--lang", "pt_BR")[0]
    for word in ("grandeza", "veredito", "a fonte diz", "fator de passo", "O que difere"):
        assert word in said


def test_json_has_rows_curves_and_motion(study: Callable[..., Said]) -> None:
    [found] = json.loads(study(NAME, "--json", "--short", "--set", "factor=1")[0])
    assert found["name"] == NAME
    assert found["options"] == {"factor": 1.0}
    assert found["short"] is True
    first = found["rows"][0]
    assert first["ours"] == 3
    assert first["verdict"] == "ours"
    assert found["charts"][0]["lines"][0]["x"][:2] == [0, 1]
    motion = found["motions"][0]
    assert len(motion["times"]) == len(motion["q"]) > 2


def test_a_difference_ends_with_one(
    study: Callable[..., Said], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    row = Row(untranslated("height"), 2.0, "m", printed_statement("1,0", "§1"))
    put(monkeypatch, Result((row, Row(untranslated("nothing"), float("nan")))))
    with pytest.raises(SystemExit) as caught:
        study(NAME)
    assert caught.value.code == 1
    assert "differs" in capsys.readouterr().out
    with pytest.raises(SystemExit):
        study(NAME, "--json")
    assert [r["ours"] for r in json.loads(capsys.readouterr().out)[0]["rows"]] == [2.0, None]


def test_a_difference_whose_cause_is_known_ends_well(
    study: Callable[..., Said], monkeypatch: pytest.MonkeyPatch
) -> None:
    why = Text(en="the gains are unknown", pt_BR="os ganhos são desconhecidos")
    put(monkeypatch, Result((Row(untranslated("height"), 2.0, "m", printed_statement("1,0", "§1"), why=why),)))
    said = study(NAME)[0]
    assert "differs: the gains are unknown" in said
    assert (
        "the source says 1.0 m (§1); computed here: 2.00 m; the gains are unknown" in said.partition("What differs")[2]
    )
    (row,) = json.loads(study(NAME, "--json")[0])[0]["rows"]
    assert row["source"]["words"] == {"en": "1.0", "pt_BR": "1,0"}
    assert (row["verdict"], row["why"]["en"]) == ("differs", why.en)


def test_a_study_that_does_not_end_is_reported_and_ends_with_three(
    study: Callable[..., Said], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    put(monkeypatch, HelicoideError(Text(en="out of metal", pt_BR="sem metal")))
    with pytest.raises(SystemExit) as caught:
        study(NAME)
    assert caught.value.code == 3
    assert "did not run to its end: out of metal" in capsys.readouterr().out


def test_a_study_that_crashes_is_told_in_words_and_where_in_the_log(
    study: Callable[..., Said],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    caplog: pytest.LogCaptureFixture,
) -> None:
    put(monkeypatch, ZeroDivisionError("float division by zero"))
    with pytest.raises(SystemExit):
        study(NAME, "--lang", "pt_BR")
    assert "o programa falhou; o terminal mostra onde\n" in capsys.readouterr().out
    assert "division by zero" in caplog.text


def test_a_report_that_finds_no_room_is_told_of_in_words(
    study: Callable[..., Said],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "write_text", full)
    report = str(tmp_path / "report.html")
    with pytest.raises(SystemExit):
        study(NAME, "--short", "--report", report)
    assert f"{report} cannot be written: the disk is full." in capsys.readouterr().err


def test_all_are_run_in_processes_and_reported(
    study: Callable[..., Said], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    names = (NAME, "cerbaro_movemaster_convergence")
    monkeypatch.setattr(studies, "study_names", lambda: names)
    said, bar = study("--all", "--short", "--report", str(tmp_path / "report.html"), "--lang", "pt_BR")
    page = (tmp_path / "report.html").read_text("utf-8")
    for name in names:
        assert studies.study_named(name).TITLE.pt_BR in said
        assert f'id="{name}"' in page
    assert "com estudos em paralelo" in said
    assert "com estudos em paralelo" in page
    assert "execução rápida" in page
    assert bar


@dataclass(frozen=True)
class Wrong:
    """Arguments that are refused, and what the one line says."""

    arguments: tuple[str, ...]
    words: str


WRONG = [
    Wrong((), rf"--list.*{NAME}"),
    Wrong(("nothing",), rf"'nothing'.*{NAME}"),
    Wrong((NAME, "--set", "speed=3"), r"speed.*factor"),
    Wrong((NAME, "--set", "factor"), r"0\.1 … 1"),
    Wrong((NAME, "--set", "factor=fast"), r"0\.1 … 1.*'fast'"),
    Wrong((NAME, "--set", "factor=7"), r"0\.1 … 1.*7"),
    Wrong((NAME, "--set", "factor=nan"), r"0\.1 … 1"),
    Wrong(("cerbaro_confined_line", "--set", "former=none"), r"wanted, adapted.*'none'"),
    Wrong(("--all", "--set", "factor=1"), r"--all"),
    Wrong((NAME, "--all"), r"--all"),
    Wrong((NAME, "--workers", "0"), r"1 … 64"),
    Wrong((NAME, "--report", "."), r"cannot be written"),
    Wrong((NAME, "--report", "no/such/folder/report.html"), r"cannot be written"),
]


@pytest.mark.parametrize("wrong", WRONG, ids=lambda wrong: " ".join(wrong.arguments) or "nothing")
def test_what_is_refused_is_one_line_that_says_what_is_valid(refused: Callable[..., str], wrong: Wrong) -> None:
    assert re.search(wrong.words, refused("study", *wrong.arguments))
