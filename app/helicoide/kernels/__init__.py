"""The one decorator of compiled functions, what is kept of them on disk, and the progress of compilation."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar, cast

import numba
from numba.core import event, sigutils, types

from helicoide.kernels import cache_folder
from helicoide.kernels.cache import KernelCache, NotCached, only_cached, read_sealed
from helicoide.kernels.interpreted import Interpretable, run_compiled, run_interpreted

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
    "typed_entry",
]

Function = TypeVar("Function", bound=Callable[..., Any])

CACHE_FOLDER, CACHE_NOTE = cache_folder.choose_cache_folder()
os.environ["NUMBA_CACHE_DIR"] = str(CACHE_FOLDER)

KERNELS: dict[str, Kernel] = {}


class Kernel(Interpretable):
    """A compiled function, whose machine code is the same whether or not the arrays that it is given may be written,
    and whether or not a number is known beforehand.

    numba by itself compiles anew for each combination of the two, of which four arrays have sixteen; one that is met
    for the first time in the middle of a motion would stop it for seconds. A kernel that writes into an array must
    therefore be given one that may be written: nothing else keeps it from that.
    """

    def __init__(self, function: Callable[..., Any], makes_arrays: bool = True) -> None:
        super().__init__(function, targetoptions={"nopython": True, "error_model": "numpy", "_nrt": makes_arrays})
        self._cache = KernelCache(CACHE_FOLDER, function)
        self._linked_signatures: set[tuple[Any, ...]] = set()

    def compile(self, sig: Any) -> Any:
        """The machine code for these types of arguments: loaded, or compiled and kept."""
        given, _ = sigutils.normalize_signature(sig)
        taken = tuple(map(_writable, given))
        code = super().compile(taken)
        if given != taken and given not in self._linked_signatures:
            cast(Any, self)._insert([kind._code for kind in given], code, False)
            self._linked_signatures.add(given)
        return code

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """The same for a call from another kernel, also with an array of its module, which cannot be written."""
        return super().get_call_template([*map(_writable, args)], {name: _writable(kind) for name, kind in kws.items()})


def _writable(kind: Any) -> Any:
    """The type of the same arguments when their arrays may be written, and no number is a constant."""
    kind = types.unliteral(kind)
    if isinstance(kind, types.Array):
        return kind if kind.mutable else kind.copy(readonly=False)
    if isinstance(kind, types.BaseTuple):
        parts = [_writable(one) for one in cast(Any, kind)]
        return types.BaseTuple.from_types(parts, getattr(kind, "instance_class", None))
    return kind


def kernel(function: Function) -> Function:
    """Compile a function of numbers and arrays on its first call, and keep the machine code on disk."""
    return _compiled(function, makes_arrays=True)


def kernel_into(function: Function) -> Function:
    """The same of a function that makes no array and returns none, but writes into what it is given.

    numba need not count who holds its arrays, which saves 20 to 35 ns of each that a call hands in; where one is made
    all the same, it refuses to compile. One that returns a tuple of views may be called by its own kind alone: a
    `kernel` would count them out of memory.
    """
    return _compiled(function, makes_arrays=False)


def _compiled(function: Function, makes_arrays: bool) -> Function:
    if cast(Any, numba.config).DISABLE_JIT:
        return function
    compiled = KERNELS[f"{function.__module__}.{function.__qualname__}"] = Kernel(function, makes_arrays)
    return cast(Function, compiled)


def python_function(compiled: Function) -> Function:
    """The Python function behind a kernel: slow, but there before anything is compiled."""
    return cast(Function, getattr(compiled, "py_func", compiled))


def typed_entry(compiled: Function, *like: object) -> Function:
    """What runs a kernel for arguments like these, without the 60 to 120 ns in which numba looks at what they are.

    Who calls it answers for that: numbers of another type, or not side by side, would be read as if they were these.
    """
    return compiled.compile(tuple(map(numba.typeof, like))) if isinstance(compiled, Kernel) else compiled


def is_cached(name: str) -> bool:
    """Whether machine code for a kernel of `KERNELS` lies undamaged in the cache folder, made by this installation."""
    files = KERNELS[name]._cache.files
    return bool(files) and all(read_sealed(file) is not None for file in files)


@contextmanager
def count_compiled(report: Callable[[int], None]) -> Iterator[None]:
    """Call `report` with the number of kernels that there are, on disk or compiled, each time another one is."""
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
