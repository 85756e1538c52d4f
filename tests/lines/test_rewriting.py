"""Lines that equal the expected one are accepted, however they are written."""

from __future__ import annotations

import random

import pytest
from tests.lines.exercises import EXERCISES
from tests.lines.rewriting import rewritten

from helicoide.lines import Accepted, Refused, check_line

COUNT = 500


@pytest.mark.parametrize("name", EXERCISES)
def test_the_expected_line_is_accepted(name: str) -> None:
    assert check_line(EXERCISES[name], EXERCISES[name].expected) == Accepted()


def test_rewritten_lines_are_accepted() -> None:
    source, forms = random.Random(16), set[str]()
    for n in range(COUNT):
        name = sorted(EXERCISES)[n % len(EXERCISES)]
        text = rewritten(EXERCISES[name], source, 2 + n % 12)
        verdict = check_line(EXERCISES[name], text)
        assert verdict == Accepted(), (name, text, verdict.error.text.en if isinstance(verdict, Refused) else verdict)
        forms.add(text)
    assert len(forms) > 0.8 * COUNT
