"""Long work in a process of its own, which reports its progress and can be stopped at any time."""

from __future__ import annotations

import asyncio
import multiprocessing
import os
import pickle
import signal
import threading
import traceback
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any, cast

from helicoide.jobs.throttle import throttled

Report = Callable[[Any], None]
Work = Callable[..., object]
PROCESS_POLL = 1.0
KILL_SIGNAL = getattr(signal, "SIGKILL", signal.SIGTERM)  # on Windows SIGTERM kills a process too


class JobFailed(Exception):
    """The work raised an exception; the message is its traceback."""


class JobKilled(JobFailed):
    """The process ended without a result and not by `stop`: it crashed or was killed, perhaps for lack of memory."""


class ProcessJob:
    """A call `work(report, *arguments)` in another process; work is a function of a module, to be picklable."""

    def __init__(self, work: Work, *arguments: object) -> None:
        self._asked = pickle.dumps((work, arguments))
        self._child: BaseProcess | None = None
        self.stopped = False
        self.result: Any = None

    def reports(self) -> Iterator[Any]:
        """Start the work and yield its reports until it is done or stopped; `result` then holds its return value.

        Raises Failed, with the traceback, when the work raised, and Killed when its process ended otherwise. After
        that the work may be started again.
        """
        if self.stopped:
            return
        receiver, sender = multiprocessing.Pipe(duplex=False)
        spawn = multiprocessing.get_context("spawn")
        self._child = child = spawn.Process(target=_call, args=(sender, self._asked), daemon=True)
        child.start()
        sender.close()
        if self.stopped:
            child.terminate()
        last = ""
        for last, what in _messages(receiver, child):
            if last == "report":
                yield what
            elif last == "failed":
                raise JobFailed(what)
            else:
                self.result = what
        child.join()
        if last != "result" and not self.stopped:
            raise JobKilled(f"the process was ended from outside, with exit code {child.exitcode}")

    def stop(self) -> None:
        """Stop the work; a later start returns at once."""
        self.stopped = True
        if self._child is not None and self._child.pid is not None:
            self._child.terminate()


async def follow_job(job: ProcessJob, tell: Callable[[Any], object]) -> None:
    """Run a job, and call `tell` on this event loop with each of its reports; raises as `progress` does.

    A thread of its own reads the reports, so that the shared pool of threads is never exhausted.
    """
    loop = asyncio.get_running_loop()

    def listen() -> None:
        for what in job.reports():
            loop.call_soon_threadsafe(tell, what)

    ear = ThreadPoolExecutor(1, "helicoide job")
    try:
        await loop.run_in_executor(ear, listen)
    finally:
        ear.shutdown(wait=False)


def kill_processes() -> None:
    """End every process that was started from this one."""
    for child in multiprocessing.active_children():
        with suppress(OSError):  # it has already ended
            os.kill(cast(int, child.pid), KILL_SIGNAL)  # joblib's processes have no kill method


def _messages(receiver: Connection, child: BaseProcess) -> Iterator[tuple[str, Any]]:
    """Yield the messages of a process until it ends; an incomplete message is dropped.

    The pipe may stay open after the process has ended, in a child of that process.
    """
    while receiver.poll(PROCESS_POLL) or child.is_alive() or receiver.poll():
        try:
            if receiver.poll():
                yield receiver.recv()
        except (EOFError, OSError):
            return


def exit_with_parent() -> None:
    """End this process as soon as its parent ends, even if the parent is killed."""
    parent = multiprocessing.parent_process()
    assert parent is not None

    def end() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=end, daemon=True).start()


def _call(sender: Connection, call: bytes) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl+C reaches every process of the terminal: the parent decides
    exit_with_parent()
    try:
        work, arguments = pickle.loads(call)
        result = work(throttled(lambda what: sender.send(("report", what))), *arguments)
        sender.send(("result", result))
    except Exception:
        sender.send(("failed", traceback.format_exc()))
