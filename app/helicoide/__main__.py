"""The command line: a subcommand for each file of commands/; without one the lab is served."""

from __future__ import annotations

import importlib
import locale
import pkgutil
import signal
import sys

import tyro

from helicoide import commands
from helicoide.text import HelicoideError, Language


def main() -> None:
    """Run a subcommand; a HelicoideError is one line on the error output."""
    names = [module.name for module in pkgutil.iter_modules(commands.__path__)]
    arguments = sys.argv[1:]
    if not arguments or (arguments[0].startswith("-") and arguments[0] not in ("-h", "--help")):
        arguments = ["serve", *arguments]
    # only the command that is asked for is imported: fk needs no browser, serve no tests
    chosen = [name for name in names if name == arguments[0]] or names
    functions = {name: importlib.import_module(f"{commands.__name__}.{name}").run for name in chosen}
    try:
        tyro.extras.subcommand_cli_from_dict(functions, prog="helicoide", args=arguments)
    except HelicoideError as error:
        sys.exit(f"helicoide: {error.text[_language()]}")
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)


def _language() -> Language:
    return "pt_BR" if (locale.getlocale()[0] or "").startswith("pt") else "en"


if __name__ == "__main__":
    main()
