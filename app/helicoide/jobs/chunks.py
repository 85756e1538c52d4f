"""Workspace maps computed in chunks, by processes of this machine or of a cluster, with progress and a cache."""

from __future__ import annotations

import importlib
import os
import tempfile
import warnings
import zipfile
import zlib
from collections.abc import Callable, Generator, Iterator, Mapping
from contextlib import closing, contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal, TypeVar, get_args

import joblib
import numpy as np
from numpy.typing import NDArray
from platformdirs import user_cache_path

from helicoide.arrays import frozen
from helicoide.jobs.throttle import throttled
from helicoide.kinematics import workspace
from helicoide.text import HelicoideError, Text

Outcome = TypeVar("Outcome")
Arrays = Mapping[str, NDArray[Any]]
Progress = Callable[[float], None]
# loky: processes of this machine. dask and ray: the cluster that DASK_SCHEDULER_ADDRESS or RAY_ADDRESS names, else a
# local one that is started here.
Backend = Literal["loky", "dask", "ray"]
BACKENDS: tuple[Backend, ...] = get_args(Backend)


def parallel_map(
    work: Callable[[Any, int], Outcome], what: Any, count: int, workers: int, backend: Backend = "loky"
) -> Generator[Outcome]:
    """Yield work(what, 0), work(what, 1), … in this order, computed by `workers` processes.

    With one worker of this machine, the work is done in this process.

    Raises HelicoideError for fewer than one worker, an unknown backend, or one whose package is not installed.
    """
    if workers < 1:
        raise HelicoideError(
            Text(
                en="It takes at least one worker, not {workers}.",
                pt_BR="É preciso ao menos um processo, não {workers}.",
            ).format(workers=workers)
        )
    with _cluster(backend, workers), joblib.parallel_config(backend=backend, n_jobs=workers):
        found = joblib.Parallel(return_as="generator")(joblib.delayed(work)(what, number) for number in range(count))
        try:
            for outcome in found:  # noqa: UP028 (it is closed below)
                yield outcome
        finally:
            with warnings.catch_warnings():  # about unfinished work, when the caller stops early
                warnings.simplefilter("ignore")
                found.close()


@contextmanager
def _cluster(backend: Backend, workers: int) -> Iterator[None]:
    """Start and stop what the backend needs."""
    if backend not in BACKENDS:
        raise HelicoideError(
            Text(
                en="There is no backend {backend!r}; there is: {known}.",
                pt_BR="Não há backend {backend!r}; há: {known}.",
            ).format(backend=backend, known=", ".join(BACKENDS))
        )
    if backend == "dask":
        own = {"n_workers": workers, "threads_per_worker": 1, "dashboard_address": "127.0.0.1:0"}
        address = os.environ.get("DASK_SCHEDULER_ADDRESS")
        with _package("distributed").Client(**({"address": address} if address else own)):
            yield
        return
    if backend == "ray":
        _package("ray.util.joblib").register_ray()
    yield


def _package(name: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError as error:
        package = name.partition(".")[0]
        raise HelicoideError(
            Text(
                en="This backend needs the package {package}: pip install {package}. loky needs none.",
                pt_BR="Este backend precisa do pacote {package}: pip install {package}. O loky não precisa de nenhum.",
            ).format(package=package)
        ) from error


def workspace_map(
    plan: workspace.MapPlan, workers: int = 1, backend: Backend = "loky", progress: Progress = lambda share: None
) -> workspace.WorkspaceMap:
    """The map of a plan, from the cache or computed chunk by chunk; it does not depend on the number of workers."""
    if (there := cached_map(plan)) is not None:
        progress(1.0)
        return there
    workspace.count_chunk(replace(plan, samples=1), 0)  # compiles the kernels once, and not in every process
    with closing(parallel_map(workspace.count_chunk, plan, plan.chunks, workers, backend)) as parts:
        found = workspace.collect_map(plan, parts, throttled(progress))
    with suppress(OSError):  # a map that cannot be stored is computed again next time
        write_arrays(_file(plan), {"hits": found.hits, "values": found.values})
    return found


def _file(plan: workspace.MapPlan) -> Path:
    return user_cache_path("helicoide") / "workspace" / f"{plan.key}.npz"


def cached_map(plan: workspace.MapPlan) -> workspace.WorkspaceMap | None:
    """The map of a plan in the cache; None if there is none or its file is damaged."""
    try:
        with _file(plan).open("rb") as stream, np.load(stream, allow_pickle=False) as arrays:
            hits, values = arrays["hits"], arrays["values"]
    except (OSError, EOFError, ValueError, KeyError, zipfile.BadZipFile, zlib.error):
        return None
    count = (plan.cells.count,)
    if (hits.shape, values.shape, hits.dtype, values.dtype) != (count, count, np.int64, np.float64):
        return None
    return workspace.WorkspaceMap(plan.kind, plan.samples, plan.cells, hits, frozen(values))


def write_arrays(file: Path, arrays: Arrays) -> None:
    """Write arrays to an .npz file atomically, by a temporary file that replaces it; creates the folder."""
    file.parent.mkdir(parents=True, exist_ok=True)
    handle, beside = tempfile.mkstemp(dir=file.parent, suffix=".part")
    try:
        with open(handle, "wb") as stream:
            np.savez_compressed(stream, allow_pickle=False, **dict(arrays))
        os.replace(beside, file)
    except BaseException:
        os.unlink(beside)
        raise
