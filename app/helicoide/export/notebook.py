"""Jupyter notebooks in the format of nbformat 4.5, made of cells of text and of code."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal

from helicoide import content
from helicoide.text import Language

FENCE = re.compile(r"^```(\w+)\n(.*?)^```\n", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class NotebookCell:
    """A cell: Markdown, or Python code."""

    kind: Literal["markdown", "code"]
    source: str


def notebook_file(cells: Iterable[NotebookCell]) -> bytes:
    """The file of a notebook that has not been run. Source: nbformat 4.5, the schema of Jupyter."""
    document = {
        "nbformat": 4,
        "nbformat_minor": 5,
        "metadata": {
            "kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"},
            "language_info": {"name": "python"},
        },
        "cells": [_cell(number, cell) for number, cell in enumerate(cells)],
    }
    return json.dumps(document, ensure_ascii=False, indent=1).encode()


def _cell(number: int, cell: NotebookCell) -> dict[str, Any]:
    not_run: dict[str, Any] = {"execution_count": None, "outputs": []} if cell.kind == "code" else {}
    lines = cell.source.splitlines(keepends=True)
    return {"id": f"cell-{number}", "cell_type": cell.kind, "metadata": {}, "source": lines, **not_run}


@cache
def notebook_of_page(language: Language) -> bytes:
    """The page about notebooks as a notebook: blocks of Python are cells, stated results are left out."""
    return notebook_file(cell for cell, _ in page_cells(language))


def page_cells(language: Language) -> list[tuple[NotebookCell, str | None]]:
    """The cells of the page about notebooks, each with the result that the page states, None if it states none."""
    page = (content.STATIC / "pages" / language / "notebook.md").read_text("utf-8")
    cells: list[tuple[NotebookCell, str | None]] = []
    words, *blocks = FENCE.split(page)
    cells.append((NotebookCell("markdown", words.strip()), None))
    for kind, block, words in zip(blocks[::3], blocks[1::3], blocks[2::3], strict=True):
        if kind == "python":
            cells.append((NotebookCell("code", block.rstrip()), None))
        else:
            cells[-1] = (cells[-1][0], block.strip())
        if words.strip():
            cells.append((NotebookCell("markdown", words.strip()), None))
    return cells
