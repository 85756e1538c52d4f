"""The architecture: which part may import which, what may print, and how large files and functions may be."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator
from functools import cache
from graphlib import TopologicalSorter
from pathlib import Path

import numpy as np
import pytest

import helicoide

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "app" / "helicoide"

# A room is a module or a package directly in `helicoide`. It may import the rooms in the rows above its own.
ROWS = """
text
arrays · content · files · kernels · markup · sheet · solids
geometry
kinematics
confinement · trajectory
ik
command · history · seat · comparison
state
advance
foresight · readout · gate
perception · console
lines
lesson
studies
export · jobs · recorder · store
view
session
contributions
commands
__main__ · teaching
"""
# Exceptions: rooms in the rows above that a room must not import.
NOT = {"view": {"jobs"}}
# External packages, and the only rooms that may import them.
OUTSIDE = {"sqlalchemy": {"store"}, "viser": {"view"}}
BUILDS = {"solids"}
LESSONS = {
    "arrays", "geometry", "kinematics", "confinement", "trajectory", "ik", "command", "seat", "state",
    "advance", "foresight", "readout", "gate", "perception", "console", "lesson", "lines", "studies", "text",
}  # fmt: skip

LEVEL = {room: level for level, row in enumerate(ROWS.split("\n")) for room in row.split(" · ") if room}
FILES = sorted(PACKAGE.rglob("*.py"))
FACE = PACKAGE / "__init__.py"
LESSON_FILES = sorted((ROOT / "lessons").glob("*/*.py"))
BUILD_FILES = sorted((ROOT / "robots").glob("*/build.py"))


@cache
def tree(file: Path) -> ast.Module:
    return ast.parse(file.read_text("utf-8"), str(file))


def module(file: Path) -> str:
    """`helicoide.ik.goal` for the file app/helicoide/ik/goal.py; a package has the name of its folder."""
    parts = file.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {module(file): file for file in FILES}


def room(name: str) -> str:
    """The room of a module; "" for the package itself."""
    return name.partition(".")[2].partition(".")[0]


def imports(file: Path) -> Iterator[str]:
    """Every module that a file imports, anywhere in it; `from package import module` counts as the module."""
    for node in ast.walk(tree(file)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0 or file in LESSON_FILES, f"{file}: a relative import"
            if node.level:
                continue
            base = node.module or ""
            for alias in node.names:
                yield f"{base}.{alias.name}" if base == "helicoide" or f"{base}.{alias.name}" in MODULES else base


def own_imports(file: Path) -> set[str]:
    return {name for name in imports(file) if name in MODULES}


def name_of(file: Path) -> str:
    return str(file.relative_to(ROOT))


def test_every_room_has_a_place_in_the_table() -> None:
    assert {room(name) for name in MODULES} - {""} == LEVEL.keys()


def test_the_table_of_the_page_is_this_one() -> None:
    """The table in CONTRIBUTING.md agrees row by row; it adds exceptions, and rows for files outside the package."""
    page = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    (table,) = re.findall(r"(?s)## Who may import whom.*?```\n(.*?)```", page)
    rows = [re.sub(r"\s{2,}\(.*", "", row) for row in table.splitlines()]
    assert rows[: ROWS.count("\n") - 2] == [*ROWS.strip().splitlines()[:-2], "commands <- __main__ · teaching"]


@pytest.mark.parametrize("file", FILES, ids=name_of)
def test_a_room_imports_from_the_rows_above_only(file: Path) -> None:
    here = room(module(file))
    if file == FACE:
        return
    there = {room(name) for name in own_imports(file)} - {here, ""}
    allowed = {other for other in LEVEL if LEVEL[other] < LEVEL.get(here, 0)} - NOT.get(here, set())
    assert there - allowed == set()


def test_the_package_itself_is_a_version_and_names_of_one_room() -> None:
    """What it imports for type checkers alone is of `teaching`, and exactly the names that it loads when used."""
    (checked,) = (node for node in tree(FACE).body if isinstance(node, ast.If))
    assert {room(name) for name in own_imports(FACE)} == {"teaching"}
    assert ast.unparse(checked.test) == "TYPE_CHECKING"
    named = {(alias.name, node.module) for node in checked.body for alias in node.names}  # type: ignore[attr-defined]
    assert named == {(name, f"helicoide.teaching.{place}") for name, place in helicoide._MODULES.items()}
    assert {name for name, _ in named} == set(helicoide.__all__)
    assert not set(helicoide.__all__) & LEVEL.keys()
    outside = [
        node for node in tree(FACE).body if node is not checked and isinstance(node, ast.Import | ast.ImportFrom)
    ]
    assert {ast.unparse(node).split()[1] for node in outside} <= {"importlib", "typing"}


def test_no_cycles() -> None:
    graph = {name: own_imports(file) - {name} for name, file in MODULES.items()}
    TopologicalSorter(graph).prepare()


@pytest.mark.parametrize("package", OUTSIDE)
def test_packages_that_belong_to_one_room(package: str) -> None:
    users = {module(file) for file in FILES if any(name.split(".")[0] == package for name in imports(file))}
    assert {name for name in users if room(name) not in OUTSIDE[package]} == set()


@pytest.mark.parametrize("file", BUILD_FILES, ids=name_of)
def test_drawings_of_robots_use_solids_alone(file: Path) -> None:
    assert {room(name) for name in own_imports(file)} <= BUILDS
    assert not {name.split(".")[0] for name in imports(file)} & OUTSIDE.keys()


@pytest.mark.parametrize("file", LESSON_FILES, ids=name_of)
def test_lessons_keep_to_the_core(file: Path) -> None:
    assert {room(name) for name in own_imports(file)} <= LESSONS
    assert not {name.split(".")[0] for name in imports(file)} & OUTSIDE.keys()


def lines_with(found: Callable[[ast.AST], bool], files: list[Path]) -> list[str]:
    return [f"{name_of(file)}:{node.lineno}" for file in files for node in ast.walk(tree(file)) if found(node)]  # type: ignore[attr-defined]


def writes_to_the_terminal(node: ast.AST) -> bool:
    """`print(...)`, `sys.stdout`, `sys.stderr`, `sys.__stdout__`, `sys.__stderr__`."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        return node.func.id == "print"
    return isinstance(node, ast.Attribute) and node.attr in {"stdout", "stderr", "__stdout__", "__stderr__"}


def is_a_bare_except(node: ast.AST) -> bool:
    return isinstance(node, ast.ExceptHandler) and node.type is None


def test_only_commands_print() -> None:
    others = [file for file in FILES if room(module(file)) != "commands"]
    assert lines_with(writes_to_the_terminal, others + LESSON_FILES) == []


def test_no_bare_except() -> None:
    assert lines_with(is_a_bare_except, FILES + LESSON_FILES + BUILD_FILES) == []


# HTML is made with Markup only, since a text may contain a name from a user or a file.
TRUSTS, WRITES = PACKAGE / "markup.py", PACKAGE / "view" / "html.py"
HTML_ROOMS = [file for file in FILES if room(module(file)) in {"view", "export", "geometry", "teaching"}]
TAG = re.compile(r"</?\w|<!|</?$")
TO_THE_PAGE = {"add_html", "add_markdown"}


def is_markup(node: ast.AST) -> bool:
    """`Markup(...)`."""
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Markup"


def trusts_what_is_no_literal(node: ast.AST) -> bool:
    """`Markup(text)` with anything but a literal, which makes HTML of it unescaped; also another name for Markup."""
    if isinstance(node, ast.ImportFrom | ast.Import):
        return any("markupsafe" in (alias.name, getattr(node, "module", "")) and alias.asname for alias in node.names)
    if isinstance(node, ast.Attribute):
        return node.attr == "Markup"
    return is_markup(node) and [type(argument) for argument in node.args] != [ast.Constant]  # type: ignore[attr-defined]


def writes_to_the_page(node: ast.AST) -> bool:
    """`gui.add_html(...)` and `handle.content = ...`."""
    if not isinstance(node, ast.Attribute):
        return False
    return node.attr in TO_THE_PAGE or (node.attr == "content" and isinstance(node.ctx, ast.Store))


def tags_outside_markup(source: ast.Module) -> list[int]:
    """The lines of strings with a tag, except docstrings and literals in `Markup(...)`."""
    nodes = list(ast.walk(source))
    inside = {id(argument) for node in nodes if is_markup(node) for argument in node.args}  # type: ignore[attr-defined]
    said = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}
    strings = [node for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    return [node.lineno for node in strings if TAG.search(node.value) and id(node) not in inside | said]  # type: ignore[arg-type]


@pytest.mark.parametrize("file", HTML_ROOMS, ids=name_of)
def test_html_is_made_of_markup_alone(file: Path) -> None:
    assert tags_outside_markup(tree(file)) == []


def test_one_file_alone_trusts_html_and_one_writes_it_to_the_page() -> None:
    assert lines_with(trusts_what_is_no_literal, [file for file in FILES if file != TRUSTS]) == []
    assert lines_with(writes_to_the_page, [file for file in HTML_ROOMS if file != WRITES]) == []


@pytest.mark.parametrize(
    "source",
    [
        "f'<b>{name}</b>'",
        "'<b>{}</b>'.format(name)",
        "'</p>' + name",
        "f'<{name}>'",
        "Text(en='<b>', pt_BR='')",
        "Markup(f'<p>{name}')",
        "Markup('<p>' + name)",
        "Markup('').join(['<p>'])",
    ],
)
def test_the_watch_sees_tags_outside_markup(source: str) -> None:
    assert tags_outside_markup(ast.parse(f"page = {source}"))


def test_the_watch_passes_over_literals_in_markup_and_docstrings() -> None:
    source = "def f(a):\n    'Tags <b>.'\n    return Markup('<b>' '{}</b>').format(a) if a < 1 else 'a < b'"
    assert tags_outside_markup(ast.parse(source)) == []


@pytest.mark.parametrize(
    ("found", "source"),
    [
        (trusts_what_is_no_literal, "Markup(name)"),
        (trusts_what_is_no_literal, "Markup(f'{name}')"),
        (trusts_what_is_no_literal, "markupsafe.Markup(name)"),
        (trusts_what_is_no_literal, "map(markupsafe.Markup, names)"),
        (trusts_what_is_no_literal, "from markupsafe import Markup as M"),
        (trusts_what_is_no_literal, "import markupsafe as m"),
        (writes_to_the_page, "gui.add_html(name)"),
        (writes_to_the_page, "handle.content = name"),
        (writes_to_the_terminal, "print(1)"),
        (writes_to_the_terminal, "import sys\nsys.stdout.write('a')"),
        (is_a_bare_except, "try:\n    pass\nexcept:\n    pass"),
    ],
)
def test_the_watch_sees_what_it_watches_for(found: Callable[[ast.AST], bool], source: str) -> None:
    assert any(found(node) for node in ast.walk(ast.parse(source)))


Function = ast.FunctionDef | ast.AsyncFunctionDef


def length(function: Function) -> int:
    """Lines of a function, with its decorators, without its docstring."""
    start = min([function.lineno, *(node.lineno for node in function.decorator_list)])
    end = function.end_lineno or start
    first = function.body[0]
    said = (first.end_lineno or 0) - first.lineno + 1 if ast.get_docstring(function) is not None else 0
    return end - start + 1 - said


def shares(values: list[int]) -> str:
    return f"{len(values)}, median {np.median(values):.0f}, p95 {np.percentile(values, 95):.0f}, largest {max(values)}"


def test_files_and_functions_stay_small() -> None:
    """File median ≤ 120 lines, 95th percentile ≤ 300; function median ≤ 8, 95th percentile ≤ 35, none over 60."""
    files = FILES + LESSON_FILES + BUILD_FILES
    of_files = [len(file.read_text("utf-8").splitlines()) for file in files]
    functions = {
        f"{name_of(file)}:{node.name}": length(node)
        for file in files
        for node in ast.walk(tree(file))
        if isinstance(node, Function)
    }
    of_functions = list(functions.values())
    print(f"files: {shares(of_files)}; functions: {shares(of_functions)}")
    assert np.median(of_files) <= 120
    assert np.percentile(of_files, 95) <= 300
    assert np.median(of_functions) <= 8
    assert np.percentile(of_functions, 95) <= 35
    assert [name for name, lines in functions.items() if lines > 60] == []
