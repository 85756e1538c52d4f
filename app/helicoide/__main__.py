"""The command line: a subcommand for each module of commands/. Without a subcommand, `serve` runs.

Exit code 2 means wrong input, 141 that the reader of the output has closed the pipe; commands/ lists all codes.
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
    """Run a subcommand. A HelicoideError is printed as one line to the error output."""
    arguments = sys.argv[1:]
    if not arguments or (arguments[0].startswith("-") and arguments[0] not in ("-h", "--help")):
        arguments = ["serve", *arguments]
    with commands.exit_codes():
        if arguments == ["serve", "--version"]:
            commands.print_version()
        else:
            _run(arguments)


def _run(arguments: list[str]) -> None:
    """Run the command that is asked for. No other command module is imported, and --help imports none."""
    names = content.module_names(commands.__name__)
    functions = {name: _run_of(name) if name == arguments[0] else _with_command_named(name) for name in names}
    tyro.extras.subcommand_cli_from_dict(functions, prog="helicoide", description=ABOUT, args=arguments)


def _run_of(name: str) -> Callable[..., None]:
    """The `run` function of a command module. Garbage collection is off meanwhile: it takes a sixth of import time."""
    gc.disable()
    try:
        run: Callable[..., None] = importlib.import_module(f"{commands.__name__}.{name}").run
        return run
    finally:
        gc.freeze()
        gc.enable()


def _with_command_named(name: str) -> Callable[[], None]:
    """A function with the docstring of the command's `run` for --help, read from the source without an import."""
    text = (Path(commands.__path__[0]) / f"{name}.py").read_text("utf-8")
    (run,) = (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef) and node.name == "run")

    def described() -> None:
        raise AssertionError(f"{name} was not imported")

    described.__doc__ = ast.get_docstring(run)
    return described


if __name__ == "__main__":
    main()
