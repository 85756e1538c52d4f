"""What is wrong with a contribution of one's own is said in words, in both languages."""

from __future__ import annotations

import importlib
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from helicoide import content, contributions, lesson, studies
from helicoide.contributions import Kind
from helicoide.contributions.examples import EXAMPLES, NAME, made
from helicoide.contributions.lesson_playing import done
from helicoide.contributions.methods import pairs
from helicoide.ik import methods
from helicoide.lesson import AtSeat
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.text import HelicoideError

# Kind, file, what is replaced in the example, by what, and words of the faults that then are said.
MISTAKES: dict[str, tuple[Kind, str, str, str, list[str]]] = {
    "zeros": ("method", "{}.py", "Solution(B @ task.rate", "Solution(0 * task.q", ["answer is zero", "CONVERGES"]),
    "not finite": ("method", "{}.py", "Solution(B @ task.rate", "Solution(task.q * np.nan", ["not finite"]),
    "no promise": (
        "method",
        "{}.py",
        "frozenset({Promise.CONVERGES, Promise.BOUNDED})",
        "frozenset()",
        ["NO_PROMISES"],
    ),
    "a promise broken": ("method", "{}.py", "Promise.BOUNDED", "Promise.EXACT", ["EXACT", "J q̇ differs"]),
    "no limits kept": ("method", "{}.py", "Promise.BOUNDED", "Promise.KEEPS_LIMITS", ["KEEPS_LIMITS"]),
    "a name lacking": ("method", "{}.py", "EQUATION =", "EQUATIONS =", ["lacks: EQUATION"]),
    "no Python": ("method", "{}.py", "def start(", "def start", ["no Python"]),
    "one language": ("study", "{}.py", 'pt_BR="Estudo novo ({})"', 'pt_BR=""', ["TITLE is empty in pt_BR"]),
    "unexplained": ("study", "{}.py", '"1.00"', '"1.10"', ["largest distance", "why is not said"]),
    "no such robot": ("study", "{}.py", 'ROBOT = "planar3r"', 'ROBOT = "planar9r"', ["no robot named 'planar9r'"]),
    "a curve of nan": ("study", "{}.py", "times, far)", "times, far * np.nan)", ["two finite points"]),
    "it raises": ("study", "{}.py", "progress(1.0)", "[][1]", ["stops with IndexError"]),
    "unreached": ("lesson", "lesson.py", "ANGLE), 3.0", "ANGLE), 0.1", ["step elbow", "does not reach"]),
    "met at once": ("lesson", "lesson.py", "return bool(abs", "return True or bool(abs", ["before anything is done"]),
    "needless": (
        "lesson",
        "lesson.py",
        "ANGLE), 3.0),",
        "ANGLE), 3.0), (gate.stop(), 1.0),",
        ["after 1 of the 2 parts"],
    ),
    "no hint": (
        "lesson",
        "en.md",
        "The slider of the second joint is below this text, and in the **Robot** tab.",
        "Look.",
        ["hint", "bold"],
    ),
    "not on screen": ("lesson", "en.md", "**Robot**", "**Robots**", ["bold is for words of the screen", "Robots"]),
    "other numbers": ("lesson", "pt_BR.md", "as três juntas perto", "as 3 juntas perto", ["other numbers"]),
    "other values": ("lesson", "pt_BR.md", "agora em {elbow}", "agora em {angle}", ["other values"]),
    "other formulas": ("lesson", "en.md", "the whole arm beyond", "$2q_1$ beyond", ["other formulas"]),
    "no formula": ("lesson", "en.md", "the whole arm beyond", r"$\nosuch$ $a_b_c$ beyond", ["cannot show the formula"]),
    "no value": ("lesson", "lesson.py", 'ANGLE, "°"', "float('nan'), \"°\"", ["the value angle is no finite number"]),
    "computed at load": (
        "lesson",
        "lesson.py",
        'ROBOT = "planar3r"',
        'from helicoide.geometry import rigid\nROBOT = "planar3r"\nrigid.screw_motor([0, 0, 1], [0, 0, 0], 0.3)',
        ["lesson.py", "line 17", "computes while the file is loaded"],
    ),
    "no wrong path": ("lesson", "lesson.py", "((gate.set_joint(ELBOW, -ANGLE), 3.0),)),", "()),", ["no wrong path"]),
    "another mistake": ("lesson", "lesson.py", "ELBOW, -ANGLE", "ELBOW, 0.5 * ANGLE", ["does not lead to it"]),
    "no mistake": ("lesson", "lesson.py", "ELBOW, -ANGLE", "ELBOW, ANGLE", ["wrong path reaches the goal"]),
    "mistaken at once": ("lesson", "lesson.py", "q[ELBOW] < -WITHIN", "q[ELBOW] < 9.0", ["applies before anything"]),
    "no such layer": ("lesson", "en.md", "the whole arm", "[the arm](layer:nowhere)", ["no layer 'nowhere'"]),
    "no such address": ("lesson", "en.md", "the whole arm", "[the arm](somewhere)", ["a link is https://"]),
    "no such signal": ("lesson", "lesson.py", "joints=(0, 1, 2)", 'charts=("speed_of_light",)', ["no signal"]),
    "no such lesson": (
        "lesson",
        "lesson.py",
        'ROBOT = "planar3r"',
        'NEEDS = ("x",)\nROBOT = "planar3r"',
        ["no lesson 'x'"],
    ),
    "no number": ("lesson", "lesson.py", "Choice(right=1)", "Choice(right=1.5)", ["one of the 3 options"]),
    "no title": ("robot", "robot.toml", 'pt_BR = "Braço novo ({})"', 'pt_BR = ""', ["title is empty in pt_BR"]),
    "a title taken": ("robot", "robot.toml", "New arm ({})", "Planar 3R", ["robot planar3r has the same title"]),
    "no mesh": ("robot", "{}.urdf", '<box size="0.4 0.06 0.04"/>', '<mesh filename="a.stl"/>', ["no mesh a.stl"]),
    "no robot": ("robot", "robot.toml", "[poses.ready]", "[poses.begin]", ["ready is missing"]),
}


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A user's folder with nothing in it, from which methods and studies are found too."""
    monkeypatch.setattr(content, "user_folder", lambda: tmp_path)
    for package in (methods, studies):
        kind = package.__name__.rpartition(".")[2]
        monkeypatch.setattr(package, "__path__", [package.__path__[0], str(tmp_path / kind)])
    look_again()
    yield tmp_path
    look_again()
    for forget in (methods.named, studies.study_named, lesson.load_lesson, pairs):
        forget.cache_clear()


def look_again() -> None:
    """What other processes would do: see the files that were written since."""
    importlib.invalidate_caches()
    studies.study_names.cache_clear()


def example(kind: Kind, name: str, file: str, old: str, new: str) -> None:
    """The example under a name, with something replaced in one of its files."""
    written = {path.name: path for path in made(kind, name, own=True)}
    path = written[file.format(name)]
    text, old = path.read_text("utf-8"), old.replace("({})", f"({name})")
    assert old in text
    path.write_text(text.replace(old, new, 1), "utf-8")
    look_again()


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_fault_is_said(home: Path, mistake: str) -> None:
    kind, file, old, new, words = MISTAKES[mistake]
    name = f"wrong_{mistake.replace(' ', '_').lower()}"
    example(kind, name, file, old, new)
    assert contributions.named(name) == [(kind, name)]
    said = contributions.faults(kind, name)
    assert [word for word in words if word not in " | ".join(fault.en for fault in said)] == []
    assert all(fault.pt_BR.strip() for fault in said)


def test_a_method_may_say_why_it_promises_nothing(home: Path) -> None:
    why = 'frozenset()\nNO_PROMISES = Text(en="An experiment.", pt_BR="Um experimento.")'
    example("method", "an_experiment", "{}.py", "frozenset({Promise.CONVERGES, Promise.BOUNDED})", why)
    assert contributions.faults("method", "an_experiment") == ()


def test_a_step_may_be_solved_at_the_seat(state: State) -> None:
    seat = Seat(token="", language="en")
    after, seat = done(state, seat, (AtSeat(lambda seat: seat.with_layer("axes", True)), 0.1))
    assert seat.visible_layers == {"axes": True}
    assert after.t > state.t


@pytest.mark.parametrize("name", ["Arm", "my-arm", "1arm", "", "class", "braço", "../arm", "a b"])
def test_a_name_that_cannot_be_is_refused(home: Path, name: str) -> None:
    with pytest.raises(HelicoideError, match="small letters"):
        made("robot", name, own=True)
    assert list(home.iterdir()) == []


def test_a_name_or_a_place_that_is_taken_is_refused(home: Path) -> None:
    for kind, name in (("robot", "scara"), ("method", "damped"), ("lesson", "drive_the_arm"), ("study", "vargas_01")):
        with pytest.raises(HelicoideError, match=f"already a {kind} named {name}"):
            made(kind, name, own=True)  # type: ignore[arg-type]
    for kind, name in (("study", "panel_state"), ("study", "vargas")):
        with pytest.raises(HelicoideError, match="already exists"):
            made(kind, name, own=True)  # type: ignore[arg-type]
    (home / "robots" / "mine").mkdir(parents=True)
    with pytest.raises(HelicoideError, match="already exists"):
        made("robot", "mine", own=True)


def test_a_folder_that_cannot_be_written_is_said(home: Path) -> None:
    (home / "robots").write_text("a file")
    with pytest.raises(HelicoideError, match="cannot be written"):
        made("robot", "mine", own=True)


def test_a_broken_file_of_ones_own_stops_nothing(home: Path, caplog: pytest.LogCaptureFixture) -> None:
    for package, names in ((methods, methods.names), (studies, studies.study_names)):
        folder = Path(package.__path__[-1])
        folder.mkdir()
        (folder / f"broken_{folder.name}.py").write_text("import nothing_of_the_kind")
        look_again()
        assert f"broken_{folder.name}" not in names()
        assert f"helicoide check broken_{folder.name}" in caplog.text


def test_the_examples_are_called_alike() -> None:
    assert all(NAME in file.read_text("utf-8") or file.suffix == ".md" for file in EXAMPLES.rglob("*.*"))


def test_a_copy_of_a_shipped_robot_has_its_title_twice(home: Path) -> None:
    shutil.copytree(content.content_folder("robots", "scara"), home / "robots" / "scara2")
    assert any("robot scara has the same title" in fault.en for fault in contributions.faults("robot", "scara2"))
