"""The tool frame of the code is the end effector on the screen."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import helicoide

TOOL = re.compile(r"(?<![\w.`])tools?(?![\w.`]| frame)", re.IGNORECASE)
# These are about a real tool that somebody mounts on the arm.
MOUNTED = {"campos_workspaces.py"}
APP = Path(helicoide.__file__).parent


def texts(file: Path) -> Iterator[tuple[int, str]]:
    """The line and the words of each language of every Text in a file."""
    for node in ast.walk(ast.parse(file.read_text("utf-8"))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Text":
            for word in node.keywords:
                if isinstance(word.value, ast.Constant) and isinstance(word.value.value, str):
                    yield node.lineno, word.value.value


def test_no_text_says_tool_or_ferramenta() -> None:
    found = [
        f"{file.name}:{line}: {words[:60]}"
        for file in sorted(APP.rglob("*.py"))
        if file.name not in MOUNTED
        for line, words in texts(file)
        if TOOL.search(words) or "ferramenta" in words.lower()
    ]
    assert found == []
