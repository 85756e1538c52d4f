"""The glossary of CONTRIBUTING: code names exist, retired names are not defined, retired phrases are not written."""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from tests.test_architecture import FILES, PACKAGE, name_of, tree

GLOSSARY = (PACKAGE.parents[1] / "CONTRIBUTING.md").read_text("utf-8").partition("## Glossary")[2]
# Names that a contract asks of each file of a kind.
CONTRACT = {
    "Options", "Memory", "applies", "build", "cost", "find", "gradient", "rows", "run", "start", "step", "names",
    "named", "faults", "product", "sandwich", "coordinates", "main", "moves", "needs", "signals",
}  # fmt: skip
# Its functions have the names of those that do the same with arrays.
TEACHING = "app/helicoide/teaching/elements.py"
FORMER_KEY = ("app/helicoide/kinematics/robot_file.py", "ours")  # of robot.toml, still read
WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])")


@cache
def retired(beginning: str) -> tuple[frozenset[str], frozenset[str]]:
    """What a paragraph of the glossary lists between its marks, before “No name is” and after."""
    (paragraph,) = (part for part in GLOSSARY.split("\n\n") if part.startswith(beginning))
    words, _, whole = paragraph.partition("No name is")
    return _marked(words), _marked(whole)


def _marked(text: str) -> frozenset[str]:
    return frozenset(a or b for a, b in re.findall(r'`(\w+)`|"([^"]+)"', text))


def defined(file: Path) -> Iterator[str]:
    """Names of the module, and of its classes, functions, fields and parameters."""
    yield from file.relative_to(PACKAGE).with_suffix("").parts
    for node in ast.walk(tree(file)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            yield node.name
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            yield from (arg.arg for arg in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs))
        if isinstance(node, ast.ClassDef):
            fields = (line for line in node.body if isinstance(line, ast.AnnAssign))
            yield from (field.target.id for field in fields if isinstance(field.target, ast.Name))


def written(file: Path) -> Iterator[str]:
    """Docstrings, and strings of `Text(...)`."""
    for node in ast.walk(tree(file)):
        if isinstance(node, ast.Module | ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            yield ast.get_docstring(node) or ""
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Text":
            for keyword in node.keywords:
                yield from (
                    part.value
                    for part in ast.walk(keyword.value)
                    if isinstance(part, ast.Constant) and isinstance(part.value, str)
                )


@pytest.mark.parametrize("file", FILES, ids=name_of)
def test_no_retired_name_is_defined(file: Path) -> None:
    words, whole = retired("Retired names")
    found = {name for name in defined(file) if {part.lower() for part in WORD.findall(name)} & words or name in whole}
    assert {name for name in found if (name_of(file), name) != FORMER_KEY} == set()


@pytest.mark.parametrize("file", FILES, ids=name_of)
def test_no_retired_phrase_is_written(file: Path) -> None:
    phrases, _ = retired("Retired phrases")
    text = " ".join(" ".join(written(file)).split()).lower()
    assert {phrase for phrase in phrases if re.search(rf"\b{re.escape(phrase)}\b", text)} == set()


def test_the_lists_of_what_is_retired_are_read() -> None:
    assert {"wish", "wished", "road"} <= retired("Retired names")[0]
    assert "rests" in retired("Retired names")[1]
    assert {"joint rates", "retido por"} <= retired("Retired phrases")[0]


def test_a_public_class_or_function_is_defined_once() -> None:
    places = defaultdict(list)
    for file in FILES:
        for node in tree(file).body:
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef) and not node.name.startswith(
                "_"
            ):
                places[node.name].append(name_of(file))
    double = {name: [file for file in files if file != TEACHING] for name, files in places.items()}
    assert {name: files for name, files in double.items() if len(files) > 1 and name not in CONTRACT} == {}


def test_the_code_names_of_the_glossary_exist() -> None:
    """Each term in the first column is a name, or the words of one."""
    names = {name for file in FILES for name in defined(file)}
    said = "\n".join(file.read_text("utf-8") for file in FILES)
    terms = re.findall(r"^\| `([^`]+)` \|", GLOSSARY, re.M)
    assert len(terms) > 40
    assert [term for term in terms if term not in names and term not in said] == []
