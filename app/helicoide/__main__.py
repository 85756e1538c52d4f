"""The command line: a subcommand for each file of commands/; without one the lab is served.

It ends with 2 for wrong input, and with 141 when the reader of what it prints has gone; commands/ has all codes.
"""

from __future__ import annotations

import ast
import gc
import importlib
import sys
from collections.abc import Callable
from pathlib import Path

import tyro

from helicoide import __version__, commands, content

ABOUT = f"Helicoide {__version__}, a lab for robot arms. Without a subcommand, serve. --version prints the version."


def main() -> None:
    """Run a subcommand; a HelicoideError is one line on the error output."""
    arguments = sys.argv[1:]
    if not arguments or (arguments[0].startswith("-") and arguments[0] not in ("-h", "--help")):
        arguments = ["serve", *arguments]
    with commands.exit_codes():
        if arguments == ["serve", "--version"]:
            commands.print_version()
        else:
            _run(arguments)


def _run(arguments: list[str]) -> None:
    """Import the command that is asked for, and no other: fk needs no browser, and --help none of them."""
    names = content.module_names(commands.__name__)
    functions = {name: _run_of(name) if name == arguments[0] else _told(name) for name in names}
    tyro.extras.subcommand_cli_from_dict(functions, prog="helicoide", description=ABOUT, args=arguments)


def _run_of(name: str) -> Callable[..., None]:
    """What runs a command. Nothing of what is imported is garbage, and looking for it takes a sixth of the time."""
    gc.disable()
    try:
        run: Callable[..., None] = importlib.import_module(f"{commands.__name__}.{name}").run
        return run
    finally:
        gc.freeze()
        gc.enable()


def _told(name: str) -> Callable[[], None]:
    """What --help says of a command: the docstring of its `run`, read and not imported."""
    text = (Path(commands.__path__[0]) / f"{name}.py").read_text("utf-8")
    (run,) = (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef) and node.name == "run")

    def told() -> None:
        raise AssertionError(f"{name} was not imported")

    told.__doc__ = ast.get_docstring(run)
    return told


if __name__ == "__main__":
    main()
