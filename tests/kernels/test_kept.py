"""Compiled kernels on disk: loaded again, made anew where they are damaged, done without where there is no room."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numba
import numpy as np
import pytest
from numpy.typing import NDArray

from helicoide import kernels
from helicoide.kernels import Kernel, KernelCache, NotCached, only_cached
from helicoide.kernels.cache_folder import KERNEL_SUFFIX

Array = NDArray[np.float64]
NUMBERS = np.arange(4.0)


def total(numbers: Array) -> float:
    sum = 0.0
    for number in numbers:
        sum += number
    return sum


def fresh(folder: Path) -> Any:
    """The kernel as another process has it at its start."""
    kernel = Kernel(total)
    kernel._cache = KernelCache(folder, total)
    return kernel


def compilations(kernel: Any) -> int:
    return sum(kernel.stats.cache_misses.values())


class Another:
    """What numba says of a processor that is not this one."""

    def codegen(self) -> Another:
        return self

    def magic_tuple(self) -> tuple[str, ...]:
        return ("another",)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    assert fresh(tmp_path)(NUMBERS) == 6.0
    (kept,) = tmp_path.iterdir()
    assert kept.suffix == KERNEL_SUFFIX
    return kept


@pytest.fixture(autouse=True)
def nothing_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(KernelCache, "refusal", None)


def test_what_one_process_compiled_another_one_loads(file: Path) -> None:
    again = fresh(file.parent)
    assert again(NUMBERS) == 6.0
    assert compilations(again) == 0


def flipped(data: bytes) -> bytes:
    """The same with one bit of the machine code changed, in the middle of a pickle that can still be read."""
    at = data.index(b"\x7fELF") + 200
    return data[:at] + bytes([data[at] ^ 1]) + data[at + 1 :]


DAMAGES: dict[str, Callable[[bytes], bytes]] = {
    "empty": lambda data: b"",
    "cut short": lambda data: data[: len(data) // 2],
    "last byte gone": lambda data: data[:-1],
    "random": lambda data: np.random.default_rng(0).bytes(len(data)),
    "one bit of the machine code": flipped,
    "one bit of the digest": lambda data: bytes([data[0] ^ 1]) + data[1:],
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_file_is_made_anew(file: Path, damage: str) -> None:
    whole = file.read_bytes()
    file.write_bytes(DAMAGES[damage](whole))
    repaired, again = fresh(file.parent), fresh(file.parent)
    assert (repaired(NUMBERS), compilations(repaired)) == (6.0, 1)
    assert (again(NUMBERS), compilations(again)) == (6.0, 0)


def test_a_folder_in_the_place_of_a_file_does_no_harm(file: Path) -> None:
    file.unlink()
    file.mkdir()
    kernel = fresh(file.parent)
    assert kernel(NUMBERS) == 6.0
    assert isinstance(KernelCache.refusal, OSError)


@pytest.mark.parametrize("failing", ["replace", "open", "mkdir"])
def test_without_room_a_kernel_runs_all_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, failing: str) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    target = {"replace": "os.replace", "open": "helicoide.kernels.cache.open", "mkdir": "pathlib.Path.mkdir"}[failing]
    monkeypatch.setattr(target, full, raising=False)
    kernel = fresh(tmp_path)
    assert kernel(NUMBERS) == 6.0
    assert KernelCache.refusal is not None
    assert KernelCache.refusal.errno == errno.ENOSPC
    assert list(tmp_path.iterdir()) == [], "nothing is left behind"


def test_a_file_that_cannot_be_written_in_full_is_not_kept(tmp_path: Path) -> None:
    resource = pytest.importorskip("resource")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, before[1]))
    try:
        kernel = fresh(tmp_path)
        assert kernel(NUMBERS) == 6.0
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert KernelCache.refusal is not None
    assert list(tmp_path.iterdir()) == []
    assert fresh(tmp_path)(NUMBERS) == 6.0
    assert len(os.listdir(tmp_path)) == 1, "there is room again"


def test_what_is_on_disk_counts_as_done(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And what is damaged there does not."""
    here, other, done = fresh(file.parent), Kernel(lambda: 1.0), list[int]()
    monkeypatch.setattr(kernels, "KERNELS", {"total": here})
    with kernels.count_compiled(done.append):
        here(NUMBERS)
        other()
    file.write_bytes(b"")
    with kernels.count_compiled(done.append):
        fresh(file.parent)(NUMBERS)
    assert done == [2, 1]


def test_what_is_only_to_be_loaded_is_not_compiled(tmp_path: Path) -> None:
    with only_cached(), pytest.raises(NotCached, match="total"):
        fresh(tmp_path)(NUMBERS)
    assert fresh(tmp_path)(NUMBERS) == 6.0
    with only_cached():
        assert fresh(tmp_path)(NUMBERS) == 6.0


def test_a_kernel_whose_source_has_changed_is_compiled_anew(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("helicoide.kernels.cache._digest_of", lambda file: "another")
    changed = fresh(file.parent)
    assert (changed(NUMBERS), compilations(changed)) == (6.0, 1)


@pytest.mark.parametrize(
    ("what", "other"),
    [
        ("VERSIONS", ("cpython-399", numba.__version__)),
        ("VERSIONS", (sys.implementation.cache_tag, "0.1")),
        ("cpu_target", SimpleNamespace(target_context=Another())),
        ("_digest_of", lambda file: "another"),
    ],
    ids=["another Python", "another numba", "another processor", "another source"],
)
def test_what_another_made_does_not_count(
    file: Path, monkeypatch: pytest.MonkeyPatch, what: str, other: object
) -> None:
    """It lies beside ours, where ours will lie, and is neither loaded nor touched."""
    monkeypatch.setattr(kernels, "KERNELS", {"total": fresh(file.parent)})
    assert kernels.is_cached("total")
    monkeypatch.setattr(f"helicoide.kernels.cache.{what}", other)
    assert not kernels.is_cached("total")
    ours = fresh(file.parent)
    assert (ours(NUMBERS), compilations(ours)) == (6.0, 1)
    assert kernels.is_cached("total")
    assert file in file.parent.iterdir()
