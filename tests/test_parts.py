"""What `make test` runs and prints: after a failure, and with a missing package, all other parts run."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest
from tests import parts, system
from tests.sample import sampled

LACKING = {"browser": "chromium"}


@pytest.fixture
def ends(monkeypatch: pytest.MonkeyPatch) -> dict[str, int]:
    """Exit codes by the name of the module that is run, otherwise 0; no command is really run."""
    codes: dict[str, int] = {}
    monkeypatch.setattr(
        subprocess, "run", lambda words, check: subprocess.CompletedProcess(words, codes.get(words[2], 0))
    )
    return codes


def test_what_follows_a_failure_runs_and_the_last_lines_tell(
    ends: dict[str, int], capsys: pytest.CaptureFixture[str]
) -> None:
    ends["mypy"] = 2
    assert parts.run(parts.to_test([], {}), {}, False) == 1
    told = capsys.readouterr().out.splitlines()
    assert told[-5:] == ["lint: passed", "format: passed", "types: FAILED", "tests: passed", "browser: passed"]


def test_nothing_to_run_is_an_error_unless_tests_were_chosen(ends: dict[str, int]) -> None:
    ends["pytest"] = parts.NO_TEST_CHOSEN
    assert parts.run(parts.to_check([]), {}, False) == 1
    assert parts.run(parts.to_check(["-k", "word"]), {}, True) == 0


def test_tests_without_their_package_are_left_out_and_told(
    ends: dict[str, int], capsys: pytest.CaptureFixture[str]
) -> None:
    chosen = parts.to_test([], LACKING)
    assert "browser" not in chosen
    assert "not browser" in " ".join(chosen["tests"])
    assert parts.run(chosen, LACKING, False) == 1
    assert capsys.readouterr().out.splitlines()[-2:] == ["tests: passed", "browser: NOT RUN, install chromium"]


def test_every_package_has_a_mark_of_its_own(pytestconfig: pytest.Config) -> None:
    marks = {line.split(":")[0] for line in pytestconfig.getini("markers")}
    assert system.MARKS.keys() <= marks


def test_a_package_that_cannot_be_installed_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[str, ...]] = []
    monkeypatch.setattr(system, "install", asked.append)
    monkeypatch.setitem(system.MARKS, "browser", system.System(("no-such-command",), ("one", "two")))
    assert system.missing("browser") == {"browser": "one two"}
    assert asked == [("one", "two")]
    monkeypatch.setitem(system.MARKS, "browser", system.System(("no-such-command", "sh"), ("one", "two")))
    assert system.missing("browser") == {}
    assert len(asked) == 1


@dataclass
class Item:
    path: Path
    place: int


def test_a_sample_is_evenly_spaced_in_every_file() -> None:
    items = [Item(Path(name), place) for name, count in {"long": 10, "short": 3}.items() for place in range(count)]
    chosen = sampled(items, 4)  # type: ignore[arg-type]
    assert [(item.path.name, item.place) for item in chosen] == [
        *(("long", place) for place in (0, 2, 5, 7)),
        *(("short", place) for place in (0, 1, 2)),
    ]
