"""Progress of a person in lessons, small and arbitrary."""

from __future__ import annotations

from hypothesis import strategies as st

from helicoide.seat import LessonProgress, PredictionAnswer
from helicoide.store.merging import Progress

STEPS = {"screws": ("axis", "pitch", "moves", "open"), "motors": ("sign", "product")}
TOKEN, OTHER = "abcdefghijklmnop", "ponmlkjihgfedcba"
PROGRESS: Progress = {
    "screws": LessonProgress(
        "screws",
        2,
        frozenset({"axis"}),
        frozenset({"pitch"}),
        {
            "axis": PredictionAnswer((1,), True),
            "pitch": PredictionAnswer((2, 0, 1), False),
            "moves": PredictionAnswer((0.25,)),
        },
        {"moves": ("exp(theta/2 * l)", "θ ≠ 0")},
        frozenset({("axis", "wrong_way"), ("moves", "half")}),
    ),
    "motors": LessonProgress("motors", 1, frozenset({"sign", "product"}), finished=True),
}


def answers() -> st.SearchStrategy[PredictionAnswer]:
    numbers = st.integers(0, 9) | st.floats(-1e6, 1e6)
    return st.builds(PredictionAnswer, st.lists(numbers, max_size=3).map(tuple), st.none() | st.booleans())


@st.composite
def lessons(draw: st.DrawFn, name: str) -> LessonProgress:
    steps = STEPS[name]
    marks = {step: draw(st.sampled_from(("done", "skipped", ""))) for step in steps}
    return LessonProgress(
        name,
        draw(st.integers(0, len(steps))),
        frozenset(step for step, mark in marks.items() if mark == "done"),
        frozenset(step for step, mark in marks.items() if mark == "skipped"),
        draw(st.dictionaries(st.sampled_from(steps), answers())),
        draw(
            st.dictionaries(
                st.sampled_from(steps), st.lists(st.sampled_from(("e1", "2 + 2", "é")), max_size=2).map(tuple)
            )
        ),
        draw(st.frozensets(st.tuples(st.sampled_from(steps), st.sampled_from(("sign", "half"))))),
        draw(st.booleans()),
    )


@st.composite
def progresses(draw: st.DrawFn) -> Progress:
    return {name: draw(lessons(name)) for name in STEPS if draw(st.booleans())}
