"""The command line: a subcommand for each file of commands/; without one the lab is served.

It ends with 2 for wrong input, and with 141 when the reader of what it prints has gone; commands/ has all codes.
"""

from __future__ import annotations

import importlib
import pkgutil
import sys

import tyro

from helicoide import __version__, commands

ABOUT = f"Helicoide {__version__}, a lab for robot arms. Without a subcommand, serve. --version prints the version."


def main() -> None:
    """Run a subcommand; a HelicoideError is one line on the error output."""
    arguments = sys.argv[1:]
    if not arguments or (arguments[0].startswith("-") and arguments[0] not in ("-h", "--help")):
        arguments = ["serve", *arguments]
    with commands.ending():
        if arguments == ["serve", "--version"]:
            commands.tell_version()
        else:
            _run(arguments)


def _run(arguments: list[str]) -> None:
    """Import the command that is asked for, and no other: fk needs no browser, serve no tests."""
    names = [module.name for module in pkgutil.iter_modules(commands.__path__)]
    chosen = [name for name in names if name == arguments[0]] or names
    functions = {name: importlib.import_module(f"{commands.__name__}.{name}").run for name in chosen}
    tyro.extras.subcommand_cli_from_dict(functions, prog="helicoide", description=ABOUT, args=arguments)


if __name__ == "__main__":
    main()
