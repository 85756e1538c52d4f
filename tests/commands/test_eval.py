"""`helicoide eval` as people run it."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable

import pytest

from helicoide import __main__

Evaluated = Callable[..., tuple[str, str, object]]
POINTS = "join(point(1,2,3),point(2,-2,3),point(-1,1,0))"


@pytest.fixture
def evaluated(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Evaluated:
    """What the command prints, and what it writes on the error output, with its exit code."""

    def run(*arguments: str) -> tuple[str, str, object]:
        monkeypatch.setattr(sys, "argv", ["helicoide", "eval", *arguments])
        code: object = 0
        try:
            __main__.main()
        except SystemExit as ended:
            code = ended.code
        out, err = capsys.readouterr()
        return out, err, code

    return run


def test_the_plane_of_the_source(evaluated: Evaluated) -> None:
    """Cerbaro 2022, eq. 30, with the sign of `join`."""
    out, err, code = evaluated(POINTS)
    assert (out, err, code) == ("0.78446*e1 + 0.19612*e2 - 0.58835*e3 - 0.58835*e   (plane)\n", "", 0)


def test_a_portuguese_terminal_gets_decimal_commas(evaluated: Evaluated, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LC_ALL", "pt_BR.UTF-8")
    out, _, _ = evaluated("p = point(0.5, 0, 0)")
    assert out == "p = e1e2e3 + 0,5*e2e3e   (ponto)\n"


def test_json_has_every_digit_and_the_names_of_the_arm(evaluated: Evaluated) -> None:
    posture = ("--robot", "movemaster", "--q", "30", "60", "-90", "-30", "90", "--deg", "--json")
    out, _, code = evaluated("# the example of eqs. 4-6", "M_tool", "theta2/pi*180", *posture)
    comment, motor, angle = json.loads(out)
    assert (code, comment) == (0, None)
    assert motor["kind"] == "motor"
    assert motor["algebra"] == "Cl(0,3,1)"
    assert motor["values"]["e1e"] == pytest.approx(0.060801270, abs=1e-9)
    assert angle["values"] == {"1": pytest.approx(60)}


def test_an_error_points_at_its_character(evaluated: Evaluated) -> None:
    out, err, code = evaluated("p = point(1,2,3)", "1 + jion(p, p)")
    assert (out, code) == ("", 2)
    first, line, caret = err.splitlines()
    assert first.startswith("helicoide: character 5: there is no function jion")
    assert (line, caret) == ("1 + jion(p, p)", "    ^^^^")


@pytest.mark.parametrize("arguments", [(), ("a",), ("e1", "--q", "0"), ("M_tool",), ("e1" * 300,)])
def test_wrong_input_ends_with_2(evaluated: Evaluated, arguments: tuple[str, ...]) -> None:
    out, err, code = evaluated(*arguments)
    assert (out, code) == ("", 2)
    assert err
