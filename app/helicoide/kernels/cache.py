"""Compiled kernels on disk: what is damaged counts as missing, and what cannot be written is not kept.

A file begins with the digest of the rest: machine code in which a bit has changed would bring the program down or,
worse, count wrong.
"""

from __future__ import annotations

import hashlib
import inspect
import os
import pickle
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache
from pathlib import Path
from typing import Any, ClassVar

import numba
from numba.core.caching import NullCache
from numba.core.compiler import CompileResult
from numba.core.registry import cpu_target
from numba.core.serialize import dumps

from helicoide.kernels.cache_folder import KERNEL_SUFFIX

SEAL_BYTES = hashlib.sha256().digest_size
VERSIONS = (sys.implementation.cache_tag, numba.__version__)

_only_kept: ContextVar[bool] = ContextVar("only_kept", default=False)


class NotCached(Exception):
    """A kernel is not on disk and was not to be compiled, or cannot be kept there and was to be."""


@contextmanager
def only_cached() -> Iterator[None]:
    """Within, in this thread, kernels are loaded and not compiled: one that is not on disk raises `NotCached`."""
    before = _only_kept.set(True)
    try:
        yield
    finally:
        _only_kept.reset(before)


def read_sealed(file: Path) -> bytes | None:
    """What was written into a file; None where there is none or it has been damaged since."""
    try:
        sealed = file.read_bytes()
    except OSError:
        return None
    return sealed[SEAL_BYTES:] if hashlib.sha256(sealed[SEAL_BYTES:]).digest() == sealed[:SEAL_BYTES] else None


def write_sealed(file: Path, data: bytes) -> None:
    """Write a file whole or not at all: beside it first, then in its place. Makes the folder."""
    file.parent.mkdir(parents=True, exist_ok=True)
    handle, beside = tempfile.mkstemp(dir=file.parent, suffix=".part")
    try:
        with open(handle, "wb") as stream:
            stream.write(hashlib.sha256(data).digest() + data)
        os.replace(beside, file)
    except BaseException:
        os.unlink(beside)
        raise


class KernelCache(NullCache):
    """The compiled versions of one function, a file for each; what numba asks for by the types of the arguments."""

    refusal: ClassVar[OSError | None] = None
    """Why the last kernel that could not be written could not."""

    def __init__(self, folder: Path, function: Callable[..., Any]) -> None:
        self._folder, self._function = folder, function
        self._stem = f"{function.__module__}.{function.__qualname__}".replace("<locals>", "locals")

    @property
    def files(self) -> list[Path]:
        """Those that lie on disk and would be loaded here; others may lie beside them, made by another Python."""
        return [*self._folder.glob(f"{self._stem}-{self._maker()}-*{KERNEL_SUFFIX}")]

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The compiled version for the types of the arguments, if it is kept."""
        target_context.refresh()
        data = read_sealed(self._file(sig))
        if data is not None:
            return CompileResult._rebuild(target_context, *pickle.loads(data))
        if _only_kept.get():
            raise NotCached(self._stem)
        return None

    def save_overload(self, sig: Any, cres: Any) -> None:
        """Keep a compiled version, if it can be kept."""
        if cres.library.has_dynamic_globals:  # addresses of this process
            return
        try:
            write_sealed(self._file(sig), dumps(cres._reduce()))
        except OSError as error:
            KernelCache.refusal = error

    def _file(self, sig: Any) -> Path:
        return self._folder / f"{self._stem}-{self._maker()}-{_digest(str(sig))}{KERNEL_SUFFIX}"

    def _maker(self) -> str:
        """What made the machine code: this Python and numba, for this processor, from this very source."""
        processor = cpu_target.target_context.codegen().magic_tuple()
        source = _digest_of(inspect.getfile(self._function))
        return _digest(repr((VERSIONS, processor, source, self._function.__code__.co_firstlineno)))


def _digest(words: str) -> str:
    return hashlib.sha256(words.encode()).hexdigest()[:16]


@lru_cache
def _digest_of(file: str) -> str:
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()
