"""Serve the lab to a browser."""

from __future__ import annotations

import atexit
import os
import signal
import sys
import threading
import warnings
from pathlib import Path
from typing import Literal, NoReturn

from helicoide import content, kernels
from helicoide.commands import language, print_remarks
from helicoide.jobs.process import kill_processes
from helicoide.kinematics.library import load_robot, register_robot
from helicoide.lesson import load_lesson as read_lesson
from helicoide.session.lab import Lab
from helicoide.store.database import Store
from helicoide.text import HelicoideError, Text

CLOSE_TIMEOUT = 1.5
POLL_PERIOD = 0.25
PROGRESS_FILE = "progress.sqlite"
ANOTHER_STORE = Text(
    en="{place}: {why} --store names another file, which need not exist yet, or an empty database.",
    pt_BR="{place}: {why} Com --store se indica outro arquivo, que pode nem existir ainda, ou um banco vazio.",
)


def run(
    robot: str | None = None,
    tip: str | None = None,
    base: str | None = None,
    set: tuple[str, ...] = (),
    host: str = "127.0.0.1",
    port: int = 8080,
    origin: tuple[str, ...] = (),
    lang: Literal["en", "pt_BR"] | None = None,
    lesson: str | None = None,
    lessons: Path | None = None,
    projector: bool = False,
    store: str | None = None,
) -> None:
    """Open the lab in a browser.

    Args:
        robot: name of a robot (see the command robots), or the path of a URDF file; the robot of the lesson if none.
        tip: the link of a URDF where the arm ends.
        base: the link of a URDF where the arm begins; its root if none.
        set: parameters of a robot to change, mm, such as l1=1500.
        host: address to listen on.
        port: port to listen on; 0 takes any free one.
        origin: further addresses at which browsers find the page, such as https://lab.example.org behind a proxy.
        lang: language of new windows, else what their browser asks for, and of this terminal.
        lesson: name of the lesson to begin with.
        lessons: a folder with further lessons.
        projector: large words and handles in new windows, for the back row.
        store: where the progress in lessons is kept: a file, the URL of a database, or none; else a file in your own
            folder (see the command doctor).
    """
    if lessons is not None:
        content.add_lessons(lessons)
    default = "movemaster" if lesson is None else read_lesson(lesson).robot
    arm = load_robot(robot or default, tip, set, base)
    register_robot(arm)
    kept = None if store == "none" else Store(store or content.user_folder() / PROGRESS_FILE)
    lab = Lab(arm, lang, lesson, projector, kept)
    if kernels.CACHE_NOTE is not None:
        print(kernels.CACHE_NOTE[lang or language()])
    stopped = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stopped.set())
    print(f"Helicoide: http://{host}:{lab.open(host, port, origin)}", flush=True)
    print_remarks(arm, with_visuals=True, lang=lang)
    if kept is not None:
        try:
            kept.open()
        except HelicoideError as error:  # the lab goes on without it, and says so in its windows
            print(ANOTHER_STORE.format(place=kept.name, why=error.text)[lang or language()], flush=True)
    while not stopped.wait(POLL_PERIOD):  # without a timeout, Ctrl+C is not seen on Windows
        pass
    _end(lab)


def _end(lab: Lab) -> NoReturn:
    """End the program without waiting for busy threads, as Python would: compiling takes minutes."""
    closing = threading.Thread(target=_close, args=(lab,), daemon=True)
    closing.start()
    closing.join(CLOSE_TIMEOUT)
    kill_processes()
    sys.stdout.flush()
    os._exit(0)


def _close(lab: Lab) -> None:
    warnings.simplefilter("ignore")  # from viser, about drawing while its server stops
    lab.close()
    kill_processes()
    sys.setswitchinterval(CLOSE_TIMEOUT)  # a thread that still loads kernels would add to what is being ended here
    atexit._run_exitfuncs()
