"""The marks of a page: question, options, reveal, hints; formulas, values and links as HTML."""

from __future__ import annotations

import pytest

from helicoide.lesson.links import ProseLink, link_targets, parsed_link
from helicoide.lesson.prose import placeholders, read_sections
from helicoide.markup import prose_to_html
from helicoide.text import HelicoideError

PAGE = """\
## one: A title

Text.

- a list
- of the body

? Which one,
? of these?

- first
- second

! The first.

! Because of it.

Then do it.

> General,
> on two lines.

> slip: The other way. Note: there.

> More.
"""


def test_the_parts_of_a_section_are_told_by_their_marks() -> None:
    one = read_sections(PAGE, {"one": ("slip",)})["one"]
    assert one.body == "Text.\n\n- a list\n- of the body"
    assert one.question == "Which one,\nof these?"
    assert one.options == ("first", "second")
    assert one.reveal == "The first.\n\nBecause of it."
    assert one.task == "Then do it."
    assert one.hint == "General,\non two lines.\n\nMore."
    assert one.hints == {"slip": "The other way. Note: there."}


def test_without_its_diagnosis_a_hint_is_general() -> None:
    assert "slip: The other way" in read_sections(PAGE, {})["one"].hint


NOT_SO = ["## one: A\n\nText.\n", "## one: A\n\n> Hint.\n", "Text.\n", "## One: A\n\nT\n\n> H\n"]


@pytest.mark.parametrize("page", NOT_SO)
def test_a_section_of_another_form_is_refused(page: str) -> None:
    with pytest.raises(HelicoideError, match="not so"):
        read_sections(page, {})


def test_braces_of_a_formula_are_no_value() -> None:
    assert placeholders(r"{height} and $\frac{a}{b}$ and $$e^{x}$$ and {speed}") == ["height", "speed"]


def test_prose_becomes_html_and_names_in_turn() -> None:
    before, name, after = prose_to_html(r"A *word* {height} and $\frac{a}{b}$ <b>")
    assert name == "height"
    assert before == "<p>A <em>word</em> "
    assert "<math" in after
    assert "&lt;b&gt;" in after


def test_a_link_that_does_something_is_a_button() -> None:
    (shown,) = prose_to_html("[show *it*](layer:twist), [read](https://example.org)")
    assert '<button type="button" class="helicoide-go" data-go="layer:twist">show <em>it</em></button>' in shown
    assert '<a href="https://example.org" target="_blank" rel="noopener">read</a>' in shown
    assert link_targets("[a](layer:twist) ![b](c.svg) [d](e)") == ["layer:twist", "e"]
    assert parsed_link("layer:twist") == ProseLink("layer", "twist")
    assert parsed_link("https://example.org") is None
    assert parsed_link("arm:x") is None


def test_pictures_of_the_folder_are_part_of_the_text() -> None:
    pictures = (("a.svg", '<svg xmlns="http://www.w3.org/2000/svg"/>'), ("b.png", "data:image/png;base64,AAAA"))
    (shown,) = prose_to_html("![An arm](a.svg) ![Another](b.png)", pictures)
    assert 'aria-label="An arm"' in shown
    assert 'src="data:image/png;base64,AAAA"' in shown
    assert 'alt="Another"' in shown
