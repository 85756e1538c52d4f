"""Serve the lab to a browser."""

from __future__ import annotations

import signal
import threading
from typing import Annotated, Literal

import tyro

from helicoide import kernels
from helicoide.commands import language
from helicoide.kinematics.library import load, welcome
from helicoide.lesson import load as read_lesson
from helicoide.session import Session
from helicoide.text import Language


def run(
    robot: str | None = None,
    tip: str | None = None,
    set: tuple[str, ...] = (),
    host: str = "127.0.0.1",
    port: int = 8080,
    lang: Annotated[
        Literal["en", "pt_BR"] | None,
        tyro.conf.arg(help="language of new windows and of this terminal; that of the terminal if none"),
    ] = None,
    lesson: str | None = None,
) -> None:
    """Open the lab in a browser.

    Args:
        robot: name of a robot (see the command robots), or the path of a URDF file; that of the lesson if none.
        tip: the link of a URDF where the arm ends.
        set: parameters of a robot to change, mm, such as l1=1500.
        host: address to listen on.
        port: port to listen on; 0 takes any free one.
        lesson: name of the lesson to begin with.
    """
    spoken: Language = lang or language()
    default = "movemaster" if lesson is None else read_lesson(lesson).robot
    arm = load(robot or default, tip, set)
    welcome(arm)
    session = Session(arm, spoken, lesson)
    if kernels.CACHE_NOTE is not None:
        print(kernels.CACHE_NOTE[spoken])
    stopped = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stopped.set())
    print(f"Helicoide: http://{host}:{session.open(host, port)}", flush=True)
    stopped.wait()
    session.close()
