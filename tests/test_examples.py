"""Property tests draw the same examples every time, whichever other tests run."""

from __future__ import annotations

import importlib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st


def test_a_module_that_is_imported_changes_no_example(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[str] = []

    @given(st.floats())
    def draw(x: float) -> None:
        drawn.append(repr(x))

    draw()
    before = drawn.copy()
    drawn.clear()
    (tmp_path / "full_of_numbers.py").write_text(f"NUMBERS = {[k + 0.123 for k in range(100)]}")
    monkeypatch.syspath_prepend(tmp_path)
    importlib.import_module("full_of_numbers")
    draw()
    assert drawn == before
