"""`helicoide workspace` as people run it: the same map for every number of workers, kept and recomputed as needed."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.kinematics.arms import arm
from tests.kinematics.urdfs import chain_of

from helicoide import __main__
from helicoide.commands import workspace as command
from helicoide.jobs import chunks
from helicoide.jobs.chunks import Backend
from helicoide.kinematics import workspace
from helicoide.kinematics.workspace import MapPlan, WorkspaceMap
from helicoide.kinematics.workspace_kernels import MapPart
from helicoide.text import HelicoideError

SAMPLES = 3 * workspace.CHUNK + 11


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A cache folder of its own; that of the kernels stays."""
    monkeypatch.setattr(chunks, "user_cache_path", lambda name: tmp_path / "cache" / name)
    return tmp_path / "cache" / "helicoide" / "workspace"


@pytest.fixture(scope="module")
def plan() -> MapPlan:
    return workspace.plan_map(arm("puma560"), "manipulability", SAMPLES)


@pytest.fixture(scope="module")
def expected(plan: MapPlan) -> WorkspaceMap:
    return workspace.collect_map(plan, workspace.count_chunks(plan), lambda share: None)


def same(one: WorkspaceMap, other: WorkspaceMap) -> bool:
    return np.array_equal(one.hits, other.hits) and np.array_equal(one.values, other.values)


@pytest.mark.parametrize("workers", [1, 2])
def test_the_map_is_the_same_for_every_number_of_workers(plan: MapPlan, expected: WorkspaceMap, workers: int) -> None:
    shares: list[float] = []
    assert same(chunks.workspace_map(plan, workers, progress=shares.append), expected)
    assert shares == [0.25, 0.5, 0.75, 1.0]


@pytest.fixture
def cluster(monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    """A Dask cluster of two processes, as it could stand on two machines: all that is known of it is its address."""
    import distributed

    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address="127.0.0.1:0") as running:
        monkeypatch.setenv("DASK_SCHEDULER_ADDRESS", running.scheduler_address)
        yield running


def test_a_dask_cluster_gives_the_identical_map(plan: MapPlan, expected: WorkspaceMap, cluster: Any) -> None:
    shares: list[float] = []
    assert same(chunks.workspace_map(plan, 2, "dask", shares.append), expected)
    assert shares == [0.25, 0.5, 0.75, 1.0]
    with cluster.get_client() as client:
        done = client.run_on_scheduler(_finished)
    assert done >= plan.chunks


def _finished(dask_scheduler: Any) -> int:
    """How many tasks its workers have had."""
    return sum(finish == "memory" for _, _, finish, *_ in dask_scheduler.transition_log)


def test_what_was_counted_is_kept(
    plan: MapPlan, expected: WorkspaceMap, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    chunks.workspace_map(plan)
    assert [file.name for file in cache.iterdir()] == [f"{plan.key}.npz"]

    def counted(plan: MapPlan, chunk: int) -> MapPart:
        raise AssertionError("counted again")

    monkeypatch.setattr(workspace, "count_chunk", counted)
    shares: list[float] = []
    assert same(chunks.workspace_map(plan, progress=shares.append), expected)
    assert shares == [1.0]


def broken(file: Path, how: str) -> None:
    """A file of the cache as a crash, a full disk or another program may leave it."""
    whole = file.read_bytes()
    match how:
        case "empty":
            file.write_bytes(b"")
        case "cut off":
            file.write_bytes(whole[: len(whole) // 2])
        case "no archive":
            file.write_bytes(b"not a map at all")
        case "a bit turned":
            middle = len(whole) // 3
            file.write_bytes(whole[:middle] + bytes([whole[middle] ^ 0x10]) + whole[middle + 1 :])
        case "another array":
            np.savez(file, hits=np.zeros(3, np.int64), values=np.zeros(3))
        case "an array too few":
            np.savez(file, hits=np.zeros(3, np.int64))
        case "objects":
            np.savez(file, hits=np.array([{}]), values=np.array([{}]))


@pytest.mark.parametrize(
    "how", ["empty", "cut off", "no archive", "a bit turned", "another array", "an array too few", "objects"]
)
def test_a_broken_file_of_the_cache_is_counted_again(
    plan: MapPlan, expected: WorkspaceMap, cache: Path, how: str
) -> None:
    chunks.workspace_map(plan)
    (file,) = cache.iterdir()
    whole = np.load(file)["hits"]
    broken(file, how)
    shares: list[float] = []
    assert same(chunks.workspace_map(plan, progress=shares.append), expected)
    assert len(shares) == plan.chunks
    np.testing.assert_array_equal(np.load(file)["hits"], whole)
    assert list(cache.iterdir()) == [file]


@pytest.mark.parametrize("workers", [1, 2])
def test_interrupted_it_leaves_nothing_and_begins_anew(
    plan: MapPlan, expected: WorkspaceMap, cache: Path, workers: int
) -> None:
    def interrupt(share: float) -> None:
        if share > 0.4:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        chunks.workspace_map(plan, workers, progress=interrupt)
    assert not cache.exists() or not list(cache.iterdir())
    assert same(chunks.workspace_map(plan, workers), expected)


def test_interrupted_while_it_writes_it_leaves_nothing(
    plan: MapPlan, expected: WorkspaceMap, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    save = np.savez_compressed

    def half(stream: Any, **arrays: Any) -> None:
        stream.write(b"half a file")
        raise KeyboardInterrupt

    monkeypatch.setattr(np, "savez_compressed", half)
    with pytest.raises(KeyboardInterrupt):
        chunks.workspace_map(plan)
    assert list(cache.iterdir()) == []
    monkeypatch.setattr(np, "savez_compressed", save)
    assert same(chunks.workspace_map(plan), expected)
    assert len(list(cache.iterdir())) == 1


def test_without_a_place_to_keep_it_the_map_is_there_all_the_same(
    plan: MapPlan, expected: WorkspaceMap, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setattr(chunks, "user_cache_path", lambda name: tmp_path / "file" / name)
    assert same(chunks.workspace_map(plan), expected)


@pytest.mark.parametrize("backend", ["dask", "ray"])
def test_a_backend_without_its_package_says_what_to_install(
    plan: MapPlan, monkeypatch: pytest.MonkeyPatch, backend: Backend
) -> None:
    for name in ("distributed", "ray", "ray.util.joblib"):
        monkeypatch.setitem(sys.modules, name, None)
    package = {"dask": "distributed", "ray": "ray"}[backend]
    with pytest.raises(HelicoideError, match=f"pip install {package}"):
        chunks.workspace_map(plan, 2, backend)


def test_wrong_workers_and_backends_are_refused(plan: MapPlan) -> None:
    with pytest.raises(HelicoideError, match="at least one worker"):
        chunks.workspace_map(plan, 0)
    with pytest.raises(HelicoideError, match="loky, dask, ray"):
        chunks.workspace_map(plan, 1, "threads")  # type: ignore[arg-type]


def printed(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    monkeypatch.setattr(sys, "argv", ["helicoide", "workspace", *arguments])
    __main__.main()
    return capsys.readouterr().out


def test_the_command_prints_numbers_and_writes_the_map(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "map.npz"
    arguments = ("planar2r", "--samples", "300000", "--workers", "1", "--out", str(out))
    said = json.loads(printed(monkeypatch, capsys, *arguments, "--json"))
    assert said["measure"] == pytest.approx(4 * np.pi * 0.7, rel=0.02)
    assert (said["robot"], said["kind"], said["samples"], said["dimensions"]) == ("planar2r", "reachable", 300_000, 2)
    with np.load(out) as written:
        assert set(written) == {"hits", "values", "origin", "axes", "size", "shape"}
        assert written["hits"].sum() == 300_000
        assert int((written["hits"] > 0).sum()) == said["reached"]
        assert written["shape"].tolist() == said["shape"]
        assert written["size"] == said["cell"]
    assert "area of 8.7" in printed(monkeypatch, capsys, *arguments)


@pytest.mark.parametrize(
    ("kind", "words"), [("dexterous", "% of all orientations"), ("manipulability", "at best w = "), ("reachable", "m³")]
)
def test_each_kind_says_its_own(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], kind: str, words: str
) -> None:
    said = printed(monkeypatch, capsys, "movemaster", "--samples", "20000", "--workers", "1", "--kind", kind)
    assert words in said
    assert "volume" in said


def test_lengths_are_set(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    said = printed(
        monkeypatch, capsys, "planar2r", "--set", "l1=500", "l2=500", "--samples", "200000", "--workers", "1", "--json"
    )
    assert json.loads(said)["measure"] == pytest.approx(np.pi, rel=0.02)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["puma", "--samples", "10"], ["'puma'", "movemaster"]),
        (["puma560", "--samples", "0"], ["at least one posture"]),
        (["puma560", "--samples", "10", "--workers", "0"], ["at least one worker"]),
        (["puma560", "--samples", "10", "--out", "/no/such/folder/map.npz"], ["/no/such/folder/map.npz", "folder"]),
    ],
)
def test_wrong_input_ends_in_one_line(refused: Callable[..., str], arguments: list[str], words: list[str]) -> None:
    said = refused("workspace", *arguments)
    assert [word for word in words if word not in said] == []


def test_a_bar_is_drawn_on_a_terminal_alone(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    command._show(0.5)
    assert capsys.readouterr().err == ""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    command._show(0.5)
    command._show(1.0)
    said = capsys.readouterr().err
    assert "█" * 20 + "·" * 20 + "  50%" in said
    assert said.endswith("100%\n")


def test_a_tool_that_stays_where_it_is_is_said_to(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    text = chain_of(["base", "plate"]).replace('xyz="0.1 0 0"', 'xyz="0 0 0.3"')
    (path := tmp_path / "plate.urdf").write_text(f'<robot name="plate">{text}</robot>', "utf-8")
    monkeypatch.setattr(sys, "argv", ["helicoide", "workspace", str(path), "--samples", "1000", "--workers", "1"])
    __main__.main()
    assert "the end effector stays at 0.000, 0.000, 0.300 m" in capsys.readouterr().out
    sys.argv.append("--json")
    __main__.main()
    told = json.loads(capsys.readouterr().out)
    assert (told["measure"], told["reached"]) == (0, 1)
    assert told["best"]["position"] == pytest.approx([0, 0, 0.3])
