"""Compiled functions: their decorators, their cache on disk, and the progress of compilation."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar, cast

import numba
from numba.core import event, sigutils, types

from helicoide.kernels import cache_folder
from helicoide.kernels.cache import KernelCache, NotCached, only_cached, read_sealed
from helicoide.kernels.interpreted import Interpretable, run_compiled, run_interpreted, run_none

__all__ = [
    "CACHE_FOLDER",
    "CACHE_NOTE",
    "KERNELS",
    "Kernel",
    "KernelCache",
    "NotCached",
    "count_compiled",
    "is_cached",
    "kernel",
    "kernel_into",
    "only_cached",
    "python_function",
    "run_compiled",
    "run_interpreted",
    "run_none",
    "typed_entry",
]

Function = TypeVar("Function", bound=Callable[..., Any])

CACHE_FOLDER, CACHE_NOTE = cache_folder.choose_cache_folder()
os.environ["NUMBA_CACHE_DIR"] = str(CACHE_FOLDER)

KERNELS: dict[str, Kernel] = {}


class Kernel(Interpretable):
    """A compiled function with the same machine code for writable and read-only arrays, and for literal numbers.

    numba by itself compiles once for each combination: sixteen times for four arrays. A combination that first occurs
    during a motion would stop the arm for seconds. The price: nothing prevents a kernel from writing into a read-only
    array, so a kernel that writes must be given a writable one.
    """

    def __init__(self, function: Callable[..., Any], makes_arrays: bool = True) -> None:
        super().__init__(function, targetoptions={"nopython": True, "error_model": "numpy", "_nrt": makes_arrays})
        self._cache = KernelCache(CACHE_FOLDER, function)
        self._linked_signatures: set[tuple[Any, ...]] = set()

    def compile(self, sig: Any) -> Any:
        """The machine code for these types of arguments: loaded from disk, or compiled and saved."""
        given, _ = sigutils.normalize_signature(sig)
        taken = tuple(map(_writable, given))
        code = super().compile(taken)
        if given != taken and given not in self._linked_signatures:
            cast(Any, self)._insert([kind._code for kind in given], code, False)
            self._linked_signatures.add(given)
        return code

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """The same for a call from another kernel, also with a constant array of its module, which is read-only."""
        return super().get_call_template([*map(_writable, args)], {name: _writable(kind) for name, kind in kws.items()})


def _writable(kind: Any) -> Any:
    """The type of an argument with writable arrays and without literal numbers."""
    kind = types.unliteral(kind)
    if isinstance(kind, types.Array):
        return kind if kind.mutable else kind.copy(readonly=False)
    if isinstance(kind, types.BaseTuple):
        parts = [_writable(one) for one in cast(Any, kind)]
        return types.BaseTuple.from_types(parts, getattr(kind, "instance_class", None))
    return kind


def kernel(function: Function) -> Function:
    """Compile a function of numbers and arrays on its first call, and save the machine code on disk."""
    return _compiled(function, makes_arrays=True)


def kernel_into(function: Function) -> Function:
    """Like `kernel`, for a function that creates and returns no array but writes into its arguments.

    numba then omits reference counting, which saves 20 to 35 ns per array argument; a function that creates an array
    does not compile. A function that returns a tuple of views may be called only from another `kernel_into`: a `kernel`
    would release their memory.
    """
    return _compiled(function, makes_arrays=False)


def _compiled(function: Function, makes_arrays: bool) -> Function:
    if cast(Any, numba.config).DISABLE_JIT:
        return function
    compiled = KERNELS[f"{function.__module__}.{function.__qualname__}"] = Kernel(function, makes_arrays)
    return cast(Function, compiled)


def python_function(compiled: Function) -> Function:
    """The Python function of a kernel: slow, but available before compilation."""
    return cast(Function, getattr(compiled, "py_func", compiled))


def typed_entry(compiled: Function, *like: object) -> Function:
    """The compiled function of a kernel for arguments like these, without the 60 to 120 ns for checking their types.

    The caller must guarantee the types: other numbers, or arrays that are not contiguous, would be misread.
    """
    return compiled.compile(tuple(map(numba.typeof, like))) if isinstance(compiled, Kernel) else compiled


def is_cached(name: str) -> bool:
    """Whether the cache folder holds undamaged machine code of this installation for a kernel of `KERNELS`."""
    files = KERNELS[name]._cache.files
    return bool(files) and all(read_sealed(file) is not None for file in files)


@contextmanager
def count_compiled(report: Callable[[int], None]) -> Iterator[None]:
    """Call `report` with the number of kernels ready, on disk or compiled, each time it grows."""
    done = {one for name, one in KERNELS.items() if is_cached(name)}

    class Listener(event.Listener):
        def on_start(self, event: object) -> None:
            pass

        def on_end(self, event: event.Event) -> None:
            compiled = event.data["dispatcher"]
            if isinstance(compiled, Kernel) and compiled not in done:
                done.add(compiled)
                report(len(done))

    with event.install_listener("numba:compile", Listener()):
        yield
