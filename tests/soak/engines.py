"""Firefox and WebKit, the engine of Safari, on a screen that nobody sees.

Both take the commands of WebDriver: Firefox on a socket of its own (Marionette), WebKit through a program that listens
to HTTP. WebGL needs a screen, if a virtual one: without it Firefox refuses to draw.
"""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, contextmanager
from ctypes.util import find_library
from glob import glob
from http.client import HTTPConnection
from pathlib import Path
from tempfile import TemporaryDirectory
from time import monotonic, sleep
from typing import IO, Any

PATIENCE_S = 300.0  # what is slow is not wrong
WIDTH, HEIGHT = 1280, 800
# Debian's packages, and the program or library by which each is known.
SCREEN = {"xvfb": "Xvfb", "libegl1": "EGL"}
NEEDS = {
    "firefox": {"firefox-esr": "firefox-esr", **SCREEN},
    "webkit": {"webkit2gtk-driver": "WebKitWebDriver", **SCREEN},
}
MINIBROWSER = "/usr/lib/*/webkit2gtk-4.1/MiniBrowser"
ROUTES = {
    "SetWindowRect": "POST /window/rect",
    "Navigate": "POST /url",
    "ExecuteScript": "POST /execute/sync",
    "PerformActions": "POST /actions",
    "TakeScreenshot": "GET /screenshot",
}

Ask = Callable[..., Any]  # the command, and its parameters by name


def until(condition: Callable[[], object], what: str) -> None:
    """Wait for a condition, generously."""
    end = monotonic() + PATIENCE_S
    while not condition():
        assert monotonic() < end, f"{what}: not within {PATIENCE_S:.0f} s"
        sleep(0.1)


@contextmanager
def opened(engine: str, language: str) -> Iterator[Ask]:
    """Start a browser for a person who reads a language, such as pt_BR."""
    absent = [package for package, name in NEEDS[engine].items() if not (shutil.which(name) or find_library(name))]
    assert not absent, f"{engine} needs the Debian packages {' '.join(absent)}: `make soak` installs them"
    with TemporaryDirectory(ignore_cleanup_errors=True) as home, ExitStack() as stack:
        display = stack.enter_context(screen())
        environment = {
            **os.environ,
            "HOME": home,
            "DISPLAY": display,
            "LANG": f"{language}.UTF-8",
            "LC_ALL": f"{language}.UTF-8",
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS": "1",  # root can have no sandbox; the only page seen is ours
        }
        start = {"firefox": firefox, "webkit": webkit}[engine]
        ask = stack.enter_context(start(Path(home), language, environment))
        ask("SetWindowRect", x=0, y=0, width=WIDTH, height=HEIGHT)
        yield ask


@contextmanager
def running(command: list[str], **options: Any) -> Iterator[subprocess.Popen[str]]:
    """A program, ended on the way out."""
    with subprocess.Popen(command, encoding="utf-8", **options) as process:
        try:
            yield process
        finally:
            process.terminate()


@contextmanager
def screen() -> Iterator[str]:
    """A virtual screen, by its name."""
    command = ["Xvfb", "-displayfd", "1", "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-nolisten", "tcp"]
    with running(command, stdout=subprocess.PIPE) as server:
        assert server.stdout is not None
        yield f":{int(server.stdout.readline())}"


@contextmanager
def firefox(home: Path, language: str, environment: dict[str, str]) -> Iterator[Ask]:
    """Firefox, which writes down the port on which it listens."""
    preferences = {"marionette.port": 0, "intl.accept_languages": language.replace("_", "-")}
    lines = (f"user_pref({json.dumps(k)}, {json.dumps(v)});\n" for k, v in preferences.items())
    (home / "user.js").write_text("".join(lines))
    noted = home / "MarionetteActivePort"
    with running(["firefox-esr", "--marionette", "--kiosk", "--profile", str(home)], env=environment):
        until(lambda: noted.exists() and noted.read_text(), "Firefox listens")
        with (
            socket.create_connection(("127.0.0.1", int(noted.read_text())), PATIENCE_S) as line,
            line.makefile("rwb") as stream,
        ):
            received(stream)  # its greeting

            def ask(command: str, **parameters: object) -> Any:
                message = json.dumps([0, 0, f"WebDriver:{command}", parameters]).encode()
                stream.write(b"%d:%b" % (len(message), message))
                stream.flush()
                _, _, error, answer = received(stream)
                assert error is None, error
                return answer.get("value")

            ask("NewSession")
            yield ask


def received(stream: IO[bytes]) -> Any:
    """One message of Marionette: its length, a colon, JSON."""
    length = b""
    while (character := stream.read(1)) != b":":
        assert character, "Firefox has gone"
        length += character
    return json.loads(stream.read(int(length)))


@contextmanager
def webkit(home: Path, language: str, environment: dict[str, str]) -> Iterator[Ask]:
    """WebKit in its own small browser."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    options = {"binary": glob(MINIBROWSER)[0], "args": ["--automation"]}
    with running(["WebKitWebDriver", f"--port={port}"], env=environment):
        until(lambda: listens(port), "WebKit listens")
        body = {"capabilities": {"alwaysMatch": {"webkitgtk:browserOptions": options}}}
        session = f"/session/{http(port, 'POST', '/session', **body)['sessionId']}"

        def ask(command: str, **parameters: object) -> Any:
            method, path = ROUTES[command].split()
            return http(port, method, session + path, **parameters)

        try:
            yield ask
        finally:
            http(port, "DELETE", session)


def listens(port: int) -> bool:
    """Say whether a port is open."""
    with socket.socket() as line:
        return line.connect_ex(("127.0.0.1", port)) == 0


def http(port: int, method: str, path: str, **parameters: object) -> Any:
    """One request of WebDriver; its answer."""
    with closing(HTTPConnection("127.0.0.1", port, timeout=PATIENCE_S)) as line:
        line.request(method, path, json.dumps(parameters) if method == "POST" else None)
        answer = line.getresponse()
        value = json.load(answer)["value"]
        assert answer.status == 200, value
        return value
