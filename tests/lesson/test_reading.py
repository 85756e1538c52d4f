"""Lesson files: a valid lesson is found, and each fault gives one error that names the file."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from helicoide import content, lesson
from helicoide.text import LANGUAGES, HelicoideError

GOOD = """
from helicoide.lesson import Step
from helicoide.text import untranslated
TITLE = untranslated("Tour")
ROBOT = "movemaster"
STEPS = (
    Step("first", lambda state: state, lambda state, seat: True, ()),
    Step("second", lambda state: state, lambda state, seat: True, ()),
)
"""
REFUSED = """
from helicoide.text import HelicoideError, Text
raise HelicoideError(Text(en="three points on a line", pt_BR="três pontos numa reta"))
"""
PAGE = "## first: One\n\nText.\n\nMore.\n\n> Hint\n> on two lines.\n\n## second: Two\n\nText.\n\n> Hint.\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A valid lesson named `tour` in the user's folder."""
    monkeypatch.setattr(content, "user_folder", lambda: tmp_path)
    tour = tmp_path / "lessons" / "tour"
    tour.mkdir(parents=True)
    (tour / "lesson.py").write_text(GOOD, encoding="utf-8")
    for language in LANGUAGES:
        (tour / f"{language}.md").write_text(PAGE, encoding="utf-8")
    yield tour
    lesson.load_lesson.cache_clear()


def test_a_lesson_of_ones_own_is_found(folder: Path) -> None:
    tour = lesson.load_lesson("tour")
    assert [step.id for step in tour.steps] == ["first", "second"]
    first = tour.prose["first"]
    assert (tour.about.en, tour.needs, tour.sources, tour.own_arm) == ("", (), (), False)
    assert (first.title.en, first.body.pt_BR, first.hint.en) == ("One", "Text.\n\nMore.", "Hint\non two lines.")
    assert lesson.load_lesson("tour") is tour


def test_a_long_lesson_has_further_files_which_are_read_anew(folder: Path) -> None:
    for title in ("Tour", "Another tour"):
        (folder / "words.py").write_text(f"NAME = {title!r}", encoding="utf-8")
        (folder / "lesson.py").write_text(
            GOOD.replace('untranslated("Tour")', "untranslated(NAME)").replace("\n", "\nfrom .words import NAME\n", 1),
            encoding="utf-8",
        )
        assert lesson.read_lesson("tour").title.en == title


def test_a_long_lesson_is_read_in_many_threads_at_once(folder: Path) -> None:
    (folder / "words.py").write_text("NAME = 'Tour'", encoding="utf-8")
    (folder / "lesson.py").write_text("from .words import NAME\n" + GOOD, encoding="utf-8")
    with ThreadPoolExecutor(8) as threads:
        assert {one.title.en for one in threads.map(lesson.read_lesson, ["tour"] * 64)} == {"Tour"}
    assert not [name for name in sys.modules if name.startswith("helicoide_lessons.tour")]


@pytest.mark.parametrize(("text", "said"), [("\n1 / 0", "line 2 stops with ZeroDivisionError"), ("(", "no Python")])
def test_a_fault_in_a_further_file_is_found_there(folder: Path, text: str, said: str) -> None:
    (folder / "words.py").write_text(text, encoding="utf-8")
    (folder / "lesson.py").write_text("from .words import NAME\n" + GOOD, encoding="utf-8")
    with pytest.raises(HelicoideError, match=rf"words\.py is not a valid lesson.*{said}"):
        lesson.read_lesson("tour")


BROKEN = {
    "no page": ("pt_BR.md", None),
    "a page in another encoding": ("en.md", PAGE.replace("Text", "Lição").encode("latin-1")),
    "an empty page": ("en.md", b""),
    "a section missing": ("pt_BR.md", PAGE.split("## second")[0].encode()),
    "a section left over": ("en.md", (PAGE + "\n## third: Three\n\nText.\n\n> Hint.\n").encode()),
    "a section twice": ("en.md", (PAGE + "\n" + PAGE[PAGE.index("## second") :]).encode()),
    "another id": ("en.md", PAGE.replace("second", "other").encode()),
    "another order": ("en.md", (PAGE[PAGE.index("## second") :] + "\n" + PAGE.split("## second")[0]).encode()),
    "a heading without an id": ("en.md", PAGE.replace("second: Two", "Two").encode()),
    "a heading without a title": ("en.md", PAGE.replace("second: Two", "second:").encode()),
    "a heading of another level": ("en.md", PAGE.replace("## second", "### second").encode()),
    "text before the first step": ("en.md", ("# Tour\n\n" + PAGE).encode()),
    "no text": ("pt_BR.md", PAGE.replace("## second: Two\n\nText.\n", "## second: Two\n").encode()),
    "no hint": ("pt_BR.md", PAGE.replace("\n> Hint.\n", "\n").encode()),
    "an empty hint": ("pt_BR.md", PAGE.replace("> Hint.", "> ").encode()),
    "a syntax error": ("lesson.py", b"STEPS = ("),
    "a failing import": ("lesson.py", b"import no_such_module"),
    "a failing line": ("lesson.py", b"1 / 0"),
    "a refused request": ("lesson.py", REFUSED.encode()),
    "an end": ("lesson.py", b"raise SystemExit"),
    "no robot": ("lesson.py", GOOD.replace('"movemaster"', '"nobody"').encode()),
    "no title": ("lesson.py", GOOD.replace("TITLE", "NAME").encode()),
    "no steps": ("lesson.py", GOOD.replace("STEPS", "PASSOS").encode()),
    "empty steps": ("lesson.py", (GOOD + "\nSTEPS = ()").encode()),
    "something else as a step": ("lesson.py", (GOOD + "\nSTEPS = ('first', 'second')").encode()),
}


SAID = {
    "no page": ("there is no such file", "esse arquivo não existe"),
    "a page in another encoding": ("is no text in utf-8", "não é texto em utf-8"),
    "a syntax error": ("line 1 is no Python", "a linha 1 não é Python"),
    "a failing import": ("line 1 imports no_such_module", "a linha 1 importa no_such_module"),
    "a failing line": ("line 1 stops with ZeroDivisionError", "a linha 1 para com ZeroDivisionError"),
    "a refused request": ("line 3: three points on a line", "linha 3: três pontos numa reta"),
    "an end": ("line 1 stops with SystemExit", "a linha 1 para com SystemExit"),
}


@pytest.mark.parametrize(("file", "broken"), BROKEN.values(), ids=BROKEN)
def test_a_broken_lesson_gives_one_error_that_names_the_file(folder: Path, file: str, broken: bytes | None) -> None:
    path = folder / file
    if broken is None:
        path.unlink()
    else:
        path.write_bytes(broken)
    with pytest.raises(HelicoideError) as caught:
        lesson.load_lesson("tour")
    assert str(path) in caught.value.text.en
    assert str(path) in caught.value.text.pt_BR
    assert "\n" not in caught.value.text.en


@pytest.mark.parametrize("case", SAID)
def test_what_is_wrong_with_a_lesson_is_said_in_both_languages(folder: Path, case: str) -> None:
    file, broken = BROKEN[case]
    (folder / file).unlink()
    if broken is not None:
        (folder / file).write_bytes(broken)
    with pytest.raises(HelicoideError) as caught:
        lesson.load_lesson("tour")
    assert SAID[case][0] in caught.value.text.en
    assert SAID[case][1] in caught.value.text.pt_BR


def test_two_steps_of_one_name_are_refused(folder: Path) -> None:
    (folder / "lesson.py").write_text(GOOD.replace('"second"', '"first"'), encoding="utf-8")
    for language in LANGUAGES:
        (folder / f"{language}.md").write_text(PAGE.replace("second", "first"), encoding="utf-8")
    with pytest.raises(HelicoideError, match="first, first"):
        lesson.load_lesson("tour")


def test_an_unknown_lesson_lists_those_there_are(folder: Path) -> None:
    with pytest.raises(HelicoideError, match="tour"):
        lesson.load_lesson("detour")


FULL = """
from helicoide.lesson import Choice, Diagnosis, Estimate, Order, Step, Value
from helicoide.text import Text
TITLE = Text(en="Tour", pt_BR="Passeio")
ABOUT = Text(en="A walk.", pt_BR="Um passeio.")
ROBOT = "movemaster"
NEEDS = ("drive_the_arm",)
SOURCES = ("Cerbaro 2022",)
OWN_ARM = True
VALUES = {"height": Value(lambda state, seat: state.T_world_tool[2, 3], "mm")}
STEPS = (
    Step(
        "first",
        lambda state: state,
        lambda state, seat: False,
        prediction=Choice(right=1),
        diagnoses=(Diagnosis("slip", lambda state, seat: False, ()),),
    ),
)
"""
FULL_PAGE = """\
## first: One

Height {height}, $e^{\\theta}$ ![A drawing](drawing.svg).

? Up?
- yes
- no

! No.

Now look.

> General.

> slip: Wrong way.
"""


@pytest.fixture
def full(folder: Path) -> Path:
    """A lesson with everything that a lesson may have."""
    (folder / "lesson.py").write_text(FULL, encoding="utf-8")
    for language in LANGUAGES:
        (folder / f"{language}.md").write_text(FULL_PAGE, encoding="utf-8")
    (folder / "drawing.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"></svg>', encoding="utf-8")
    return folder


def test_everything_of_a_lesson_is_read(full: Path) -> None:
    tour = lesson.load_lesson("tour")
    assert (tour.about.pt_BR, tour.needs, tour.own_arm) == ("Um passeio.", ("drive_the_arm",), True)
    assert [*tour.values] == ["height"]
    assert tour.pictures["drawing.svg"].startswith("<svg")
    first = tour.prose["first"]
    assert [option.en for option in first.options] == ["yes", "no"]
    assert (first.reveal.en, first.task.en, first.hint.en) == ("No.", "Now look.", "General.")
    assert first.hints["slip"].en == "Wrong way."


MISMATCHES = {
    "an unknown value": ("{height}", "{depth}", "depth in braces is no value"),
    "no question": ("? Up?\n- yes\n- no\n", "", "needs a question"),
    "no answer": ("! No.", "", "needs a question"),
    "one option": ("- no\n", "", "has 1 options"),
    "no hint of a mistake": ("> slip: Wrong way.", "", "hint of the diagnosis slip"),
    "a hint in the middle": ("Now look.", "> Look.\n\nNow look.", "not so: 'Now look.'"),
    "another option in one language": ("- no\n", "- no\n- who knows\n", "has 3 options"),
    "no such picture": ("drawing.svg", "other.svg", "no such file"),
    "a picture elsewhere": ("drawing.svg", "../drawing.svg", "the picture ../drawing.svg"),
    "no picture": ("drawing.svg", "lesson.py", "the picture lesson.py"),
}


@pytest.mark.parametrize("case", MISMATCHES)
def test_a_page_that_does_not_match_its_steps_is_refused(full: Path, case: str) -> None:
    old, new, said = MISMATCHES[case]
    assert old in FULL_PAGE
    (full / "pt_BR.md").write_text(FULL_PAGE.replace(old, new), encoding="utf-8")
    with pytest.raises(HelicoideError, match=re.escape(said)):
        lesson.load_lesson("tour")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('ABOUT = Text(en="A walk.", pt_BR="Um passeio.")', 'ABOUT = "A walk."', "ABOUT is of another type"),
        ('NEEDS = ("drive_the_arm",)', 'NEEDS = "drive_the_arm"', "NEEDS is of another type"),
        ("OWN_ARM = True", "OWN_ARM = 1", "OWN_ARM is of another type"),
        ("VALUES = {", "VALUES = {'a': 1, ", "VALUES is of another type"),
        ("        lambda state, seat: False,\n", "", "begins with '! '"),
        ("Choice(right=1)", "None", "no prediction in lesson.py"),
        ("Choice(right=1)", "Choice(right=2)", "needs at least 3"),
        ("Choice(right=1)", "Order(right=(0, 1))", "in the right order already"),
        ("Choice(right=1)", "Estimate(lambda state, seat: 1.0, 'mm', 1.0)", "needs 0"),
    ],
)
def test_a_lesson_of_another_form_is_refused(full: Path, old: str, new: str, said: str) -> None:
    assert old in FULL
    (full / "lesson.py").write_text(FULL.replace(old, new), encoding="utf-8")
    with pytest.raises(HelicoideError, match=re.escape(said)):
        lesson.load_lesson("tour")
