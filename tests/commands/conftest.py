"""The command line in a terminal that speaks English, and how it refuses what was typed."""

from __future__ import annotations

import sys
from collections.abc import Callable

import pytest

from helicoide import __main__


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the terminal speaks in which the tests run."""
    monkeypatch.delenv("LANGUAGE", raising=False)
    monkeypatch.setenv("LC_ALL", "C.UTF-8")


@pytest.fixture
def refused(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> Callable[..., str]:
    """The one line on the error output, and nothing else, with which wrong input ends the command, and with 2."""

    def run(*arguments: str) -> str:
        monkeypatch.setattr(sys, "argv", ["helicoide", *arguments])
        with pytest.raises(SystemExit) as caught:
            __main__.main()
        out, err = capfd.readouterr()
        assert (caught.value.code, out) == (2, "")
        [line] = err.splitlines()
        return line

    return run
