"""No text of an exception of Python, of a package or of the system reaches the user: it is in one language only."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.test_architecture import FILES, LESSON_FILES, PACKAGE, name_of, tree

OURS = {"HelicoideError", "ExpressionError", "Broken", "NotDrawn"}
# Attributes of an error that may be read, and functions that may take it: they give texts in both languages, or a path.
ASKED = {"errno", "code", "lineno", "colno", "offset", "start", "end", "object", "text"}
LOG = {"log.warning", "log.error"}
TRANSLATORS = {"isinstance", "type", "os_error_reason", "database_reason", "stopped", "raised_in", "where_raised"}
# These translate errors of a package, pass an error to another process, and write the log.
EXCEPT = {PACKAGE / "files" / "toml.py", PACKAGE / "jobs" / "parallel.py", PACKAGE / "view" / "news.py"}
USUAL = {"error", "failure", "exception"}


def caught(handler: ast.ExceptHandler) -> set[str]:
    """The names of the exceptions that a handler catches."""
    kinds = handler.type.elts if isinstance(handler.type, ast.Tuple) else [handler.type]
    return {kind.id if isinstance(kind, ast.Name) else "?" for kind in kinds}


def is_harmless(parent: ast.AST) -> bool:
    """Whether a use of an error cannot bring its text to the user."""
    match parent:
        case ast.Raise() | ast.Assign():
            return True
        case ast.keyword():
            return parent.arg == "exc_info"
        case ast.Attribute():
            return parent.attr in ASKED
        case ast.Call():
            return ast.unparse(parent.func) in TRANSLATORS | LOG
    return False


def writes(node: ast.AST) -> Iterator[ast.expr]:
    """The expressions that are put into a text by an f-string, `str(...)` or `.format(...)`."""
    if isinstance(node, ast.FormattedValue):
        yield node.value
    elif isinstance(node, ast.Call) and (
        (isinstance(node.func, ast.Name) and node.func.id in {"str", "repr", "same"})
        or (isinstance(node.func, ast.Attribute) and node.func.attr == "format")
    ):
        yield from (*node.args, *(keyword.value for keyword in node.keywords))


def foreign(source: ast.Module) -> set[int]:
    """The lines where the text of an error that is not ours may become part of a text."""
    lines = set[int]()
    for node in ast.walk(source):
        lines |= {value.lineno for value in writes(node) if isinstance(value, ast.Name) and value.id in USUAL}
        if isinstance(node, ast.Attribute) and node.attr == "strerror":
            lines.add(node.lineno)
        if isinstance(node, ast.ExceptHandler) and node.name and not caught(node) <= OURS:
            lines |= {
                use.lineno
                for parent in ast.walk(node)
                for use in ast.iter_child_nodes(parent)
                if isinstance(use, ast.Name) and use.id == node.name and not is_harmless(parent)
            }
    return lines


@pytest.mark.parametrize("file", [*FILES, *LESSON_FILES], ids=name_of)
def test_no_word_of_an_error_becomes_a_reason(file: Path) -> None:
    assert file in EXCEPT or foreign(tree(file)) == set()


@pytest.mark.parametrize(
    "source",
    [
        "raise HelicoideError(TEXT.format(why=error)) from error",
        "raise HelicoideError(TEXT.format(why=error.strerror)) from error",
        "raise HelicoideError(TEXT.format(why=error.args[0])) from error",
        "raise broken(path, error) from error",
        "raise broken(path, f'{type(error).__name__}: {error}') from error",
        "say(str(error))",
        "say(same(repr(error)))",
        "say(error.msg)",
        "say(Text(en='%s' % error, pt_BR=''))",
    ],
)
def test_the_watch_sees_words_of_errors(source: str) -> None:
    assert foreign(ast.parse(f"try:\n    pass\nexcept (OSError, ValueError) as error:\n    {source}"))


def test_the_watch_sees_an_error_that_was_caught_elsewhere() -> None:
    assert foreign(ast.parse("def f(outcome):\n    error = outcome.failure\n    return same(f'{error}')"))


@pytest.mark.parametrize(
    "source",
    [
        "raise HelicoideError(TEXT) from error",
        "raise HelicoideError(TEXT.format(line=error.lineno, why=os_error_reason(error))) from error",
        "say(TEXT.format(kind=type(error).__name__))",
        "log.error('it stopped', exc_info=error)",
    ],
)
def test_the_watch_passes_over_what_is_put_into_our_words(source: str) -> None:
    assert foreign(ast.parse(f"try:\n    pass\nexcept OSError as error:\n    {source}")) == set()
