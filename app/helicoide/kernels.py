"""Numba's settings: where compiled kernels are kept, the one decorator, and the progress of compilation.

Numba needs a writable cache folder before it is imported and does not notice a change in another file that a kernel
calls; the folder is therefore chosen here, and its name carries a digest of every file that holds a kernel.
"""

from __future__ import annotations

import atexit
import hashlib
import os
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar, cast

from platformdirs import user_cache_path

from helicoide.text import Text

Function = TypeVar("Function", bound=Callable[..., Any])


def _digest() -> str:
    """Digest of the sources of all kernels of the package."""
    digest = hashlib.sha256()
    for file in sorted(Path(__file__).parent.rglob("*.py")):
        source = file.read_bytes()
        if b"@kernel" in source:
            digest.update(source)
    return digest.hexdigest()[:12]


def _is_writable(folder: Path) -> bool:
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return True
    except OSError:
        return False


def _choose_cache() -> tuple[Path, Text | None]:
    """The cache folder, and a line of explanation when it is not the usual one."""
    given = Path(os.environ.get("NUMBA_CACHE_DIR") or user_cache_path("helicoide") / "kernels")
    usual = given if given.name == _digest() else given / _digest()  # a child process inherits the chosen folder
    if _is_writable(usual):
        return usual, None
    temporary = Path(tempfile.mkdtemp(prefix="helicoide-"))
    atexit.register(shutil.rmtree, temporary, ignore_errors=True)
    return temporary / _digest(), Text(
        en="The cache folder {usual} cannot be written; kernels are compiled into {temporary} for this run only.",
        pt_BR="Não dá para escrever na pasta de cache {usual}; os kernels são compilados em {temporary} só nesta vez.",
    ).format(usual=usual, temporary=temporary)


CACHE_FOLDER, CACHE_NOTE = _choose_cache()
os.environ["NUMBA_CACHE_DIR"] = str(CACHE_FOLDER)

import numba  # noqa: E402  (needs its cache folder first)
from numba.core import event  # noqa: E402

KERNELS: list[str] = []


def kernel(function: Function) -> Function:
    """Compile a function of numbers and arrays on its first call, and keep the machine code on disk."""
    KERNELS.append(f"{function.__module__}.{function.__qualname__}")
    return cast(Function, numba.njit(cache=True, error_model="numpy")(function))


def plain(compiled: Function) -> Function:
    """The Python function behind a kernel: slow, but there before anything is compiled."""
    return cast(Function, cast(Any, compiled).py_func)


def is_cached(name: str) -> bool:
    """Whether machine code for a kernel of `KERNELS` lies in the cache folder."""
    function = name.rsplit(".", 1)[1]
    return any(CACHE_FOLDER.rglob(f"*.{function}-*.nbi"))


@contextmanager
def counted(report: Callable[[int], None]) -> Iterator[None]:
    """Call `report` with the number of kernels compiled so far, each time one is done."""
    done = 0

    class Listener(event.Listener):
        def on_start(self, event: object) -> None:
            pass

        def on_end(self, event: event.Event) -> None:
            nonlocal done
            if event.data["dispatcher"].py_func.__module__.startswith("helicoide."):
                done += 1
                report(done)

    with event.install_listener("numba:compile", Listener()):
        yield
