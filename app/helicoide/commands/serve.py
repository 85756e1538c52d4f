"""Serve the lab to a browser."""

from __future__ import annotations

import signal
import threading
from typing import Annotated, Literal

import tyro

from helicoide import content, kernels
from helicoide.kinematics.library import load
from helicoide.session import Session
from helicoide.text import Language


def run(
    robot: str = "movemaster",
    host: str = "127.0.0.1",
    port: int = 8080,
    lang: Annotated[Literal["en", "pt_BR"], tyro.conf.arg(help="language of new windows")] = "en",
    lesson: str | None = None,
) -> None:
    """Open the lab in a browser.

    Args:
        robot: name of a robot.
        host: address to listen on.
        port: port to listen on; 0 takes any free one.
        lang: language of new windows.
        lesson: name of the lesson to begin with.
    """
    language: Language = lang
    if lesson is not None:
        content.folder("lessons", lesson)
    session = Session(load(robot), language, lesson)
    if kernels.CACHE_NOTE is not None:
        print(kernels.CACHE_NOTE[language])
    stopped = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stopped.set())
    print(f"Helicoide: http://{host}:{session.open(host, port)}", flush=True)
    stopped.wait()
    session.close()
