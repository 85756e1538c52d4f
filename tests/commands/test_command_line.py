"""What all subcommands share: the language of the terminal, and a reader that goes away."""

from __future__ import annotations

import io
import os
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import pytest

from helicoide import __main__, commands, kernels

APP = Path(__file__).parents[2] / "app"
GOAL = ("--position", "0.4", "0.2", "0.3", "--rpy", "3.0", "0.1", "-0.2")


def begun(*arguments: str, **streams: int) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "helicoide", *arguments]
    return subprocess.Popen(command, text=True, env={**os.environ, "PYTHONPATH": str(APP)}, **streams)


@pytest.mark.parametrize(
    "arguments",
    [
        ("study", "--list"),
        ("robots", "scara"),
        ("ik", "puma560", *GOAL, "--all", "--json"),
        ("ik", "puma560", "--position", "9", "0", "0"),
        ("fk", "planar2r", "--q", "0", "0"),
        ("doctor",),
        ("--help",),
        ("fk", "--help"),
    ],
    ids=" ".join,
)
def test_a_reader_that_has_gone_ends_a_command_quietly(arguments: tuple[str, ...]) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    with begun(*arguments, stdout=writer, stderr=subprocess.PIPE) as command:
        os.close(writer)
        assert command.communicate(timeout=120) == (None, "")
    assert command.returncode == 141


def test_a_reader_of_both_outputs_may_go_too() -> None:
    reader, writer = os.pipe()
    os.close(reader)
    with begun("study", "cerbaro_orca_convergence", "--short", stdout=writer, stderr=writer) as command:
        os.close(writer)
        assert command.wait(timeout=120) == 141


EVERY_COMMAND = [
    ("eval", "distance(point(0,0,0), plane(0,0,1,2))"),
    ("--help",),
    ("doctor",),
    ("fk", "puma560", "--q", *"000000"),
    ("fk", "nobody", "--q", "0"),
    ("ik", "puma560", *GOAL, "--all"),
    ("robots",),
    ("serve", "--port", "70000"),
    ("study", "--list"),
    ("workspace", "planar2r", "--samples", "1000", "--kind", "reachable"),
]


@pytest.mark.parametrize("arguments", EVERY_COMMAND, ids=" ".join)
@pytest.mark.parametrize(("encoding", "locale"), [("latin-1", "C"), ("ascii", "pt_BR.UTF-8")])
def test_a_poor_terminal_is_written_to_as_it_can_show(
    arguments: tuple[str, ...], encoding: str, locale: str, tmp_path: Path
) -> None:
    poor = {"PYTHONIOENCODING": encoding, "LC_ALL": locale, "XDG_CACHE_HOME": str(tmp_path), "PYTHONPATH": str(APP)}
    kept = {"NUMBA_CACHE_DIR": str(kernels.CACHE_FOLDER)}
    command = [sys.executable, "-m", "helicoide", *arguments]
    done = subprocess.run(command, env={**os.environ, **kept, **poor}, capture_output=True, check=False)
    assert done.returncode == (2 if {"nobody", "70000"} & set(arguments) else 0), done.stderr
    assert b"Traceback" not in done.stderr
    assert b"UnicodeEncodeError" not in done.stderr
    assert (done.stdout + done.stderr).decode(encoding).strip()


@pytest.mark.parametrize(
    ("encoding", "words"),
    [
        ("utf-8", "posição 5.1×10⁻⁵ m², −90…90° ≤ 7 ￭"),
        ("latin-1", "posição 5.1×10-5 m², -90...90° <= 7 ?"),
        ("ascii", "posicao 5.1x10-5 m2, -90...90 deg <= 7 ?"),
    ],
)
def test_numbers_keep_their_meaning_in_a_poor_terminal(
    monkeypatch: pytest.MonkeyPatch, encoding: str, words: str
) -> None:
    written = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written, encoding))
    with commands.exit_codes():
        print("posição 5.1×10⁻⁵ m², −90…90° ≤ 7 ￭")
    assert written.getvalue().decode(encoding) == words + "\n"


def test_the_version_is_printed_at_once() -> None:
    """That is, without the packages that take long to import."""
    code = "import sys; from helicoide.__main__ import main; main(); print({'numba', 'viser'} & set(sys.modules))"
    command = [sys.executable, "-c", code, "--version"]
    environment = {**os.environ, "PYTHONPATH": str(APP)}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert done.stdout == f"helicoide {metadata.version('helicoide')}\nset()\n"


def test_the_beginning_of_a_list_can_be_read_alone() -> None:
    with begun("study", "--list", stdout=subprocess.PIPE, stderr=subprocess.PIPE) as command:
        assert command.stdout is not None
        assert "(" in command.stdout.readline()
        command.stdout.close()
        assert command.wait(timeout=120) in (0, 141)  # 0 where all was written before the pipe was closed
        assert command.stderr is not None
        assert command.stderr.read() == ""


@pytest.mark.parametrize(
    ("environment", "language"),
    [
        ({}, "en"),
        ({"LANG": "pt_BR.UTF-8"}, "pt_BR"),
        ({"LANG": "pt_PT"}, "pt_BR"),
        ({"LANG": "de_DE.UTF-8"}, "en"),
        ({"LANG": "en_US.UTF-8", "LC_ALL": "pt_BR.UTF-8"}, "pt_BR"),
        ({"LANG": "pt_BR.UTF-8", "LC_ALL": "en_US.UTF-8"}, "en"),
        ({"LANG": "pt_BR.UTF-8", "LC_ALL": "C"}, "en"),
        ({"LANG": "pt_BR.UTF-8", "LC_ALL": ""}, "pt_BR"),
        ({"LANG": "en_US.UTF-8", "LC_MESSAGES": "pt_BR"}, "pt_BR"),
        ({"LANG": "en_US.UTF-8", "LC_CTYPE": "pt_BR.UTF-8"}, "en"),
        ({"LANG": "en_US.UTF-8", "LANGUAGE": "pt_BR:en"}, "pt_BR"),
        ({"LANG": "pt_BR.UTF-8", "LANGUAGE": "en_GB"}, "en"),
        ({"LANG": "en_US.UTF-8", "LANGUAGE": "de:pt:en"}, "pt_BR"),
        ({"LANG": "pt_BR.UTF-8", "LANGUAGE": "de"}, "pt_BR"),
        ({"LC_ALL": "C", "LANGUAGE": "pt_BR"}, "en"),
        ({"LC_ALL": "C.UTF-8", "LANGUAGE": "pt_BR"}, "pt_BR"),
    ],
)
def test_the_terminal_says_which_language(
    monkeypatch: pytest.MonkeyPatch, environment: dict[str, str], language: str
) -> None:
    for name in ("LANGUAGE", "LC_ALL", "LC_MESSAGES", "LC_CTYPE", "LANG"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert commands.language() == language


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("doctor",), ("pacotes: viser", "compilados em", "lições: ")),
        (("robots", "scara"), ("4 juntas; alcance", "as três formulações diferem")),
        (("study", "--list"), ("fator de passo",)),
        (("workspace", "planar2r", "--samples", "1000", "--kind", "dexterous"), ("uma área", "células", "média")),
    ],
)
def test_commands_speak_the_language_of_the_terminal(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    arguments: tuple[str, ...],
    words: tuple[str, ...],
) -> None:
    monkeypatch.setattr("helicoide.jobs.chunks.user_cache_path", lambda name: tmp_path / name)
    monkeypatch.setenv("LC_ALL", "pt_BR.UTF-8")
    monkeypatch.setattr(sys, "argv", ["helicoide", *arguments])
    __main__.main()
    out = capsys.readouterr().out
    assert [word for word in words if word not in out] == []
