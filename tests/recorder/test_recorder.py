"""A recording holds what the states held, for our reader and for others, also after a kill or on a full disk."""

from __future__ import annotations

import csv
import errno
import io
import os
import signal
import subprocess
import sys
import types
from dataclasses import replace
from pathlib import Path
from typing import Any, BinaryIO, cast

import numpy as np
import pytest
from mcap.reader import make_reader
from rosbags.highlevel import AnyReader
from tests.recorder.recordings import PATIENCE, moved, recorded, recording_of

from helicoide import gate
from helicoide.geometry import rotation
from helicoide.kinematics.library import load_robot
from helicoide.readout import status, target_pose
from helicoide.recorder import recorder as recorder_module
from helicoide.recorder.reading import read_recording
from helicoide.recorder.recorder import SAMPLED, Recorder
from helicoide.recorder.table import encode_recording
from helicoide.state import FittedCloud, State, initial_state
from helicoide.text import Text

ROUNDING = 1e-9  # s: times are whole nanoseconds


@pytest.fixture(scope="module")
def states() -> list[State]:
    return moved()


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "arm.mcap"


def three(states: list[State]) -> list[State]:
    """The first state, one in the middle and the last one that is sampled: every second tick is."""
    return [states[k] for k in (0, len(states) // 4 * 2, (len(states) - 1) // 2 * 2)]


def seconds(state: State, states: list[State]) -> float:
    return state.t - states[0].t


def xyz_wxyz(T: np.ndarray) -> list[float]:
    return [*T[:3, 3], *rotation.from_matrix(T[:3, :3])]


def test_our_reader_gives_the_states_back(states: list[State], path: Path) -> None:
    recording = recording_of(states, path)
    assert recording.tool is not None
    assert recording.target is not None
    for state in three(states):
        k = int(np.argmin(np.abs(recording.samples.times - seconds(state, states))))
        assert abs(recording.samples.times[k] - seconds(state, states)) <= ROUNDING
        np.testing.assert_array_equal(recording.samples.q[k], state.arm.q)
        np.testing.assert_array_equal(recording.samples.velocities[k], state.arm.velocities)
        np.testing.assert_array_equal(recording.tool[k], xyz_wxyz(state.T_world_tool))
        np.testing.assert_array_equal(recording.target[k], xyz_wxyz(target_pose(state)))
    planes = recording.planes_at(0.0)
    assert planes is not None
    np.testing.assert_allclose(planes.normals, states[0].problem.planes.normals, atol=1e-15)
    np.testing.assert_array_equal(planes.centres, states[0].problem.planes.centres)
    assert planes.names == states[0].problem.planes.names
    assert recording.status_at(0.0) == status(states[0]).text


def test_the_reader_of_mcap_and_rosbags_give_the_states_back(states: list[State], path: Path) -> None:
    recorded(states, path)
    with path.open("rb") as file:
        counts = make_reader(file).get_summary()
        times = [m.log_time for _, channel, m in make_reader(file).iter_messages("/joint_states")]
    assert counts is not None
    assert counts.statistics is not None
    with AnyReader([path]) as bag:
        messages = [
            (topic.topic, ns, cast(Any, bag.deserialize(data, topic.msgtype))) for topic, ns, data in bag.messages()
        ]
    assert len(messages) == counts.statistics.message_count
    joints = {ns - times[0]: message for topic, ns, message in messages if topic == "/joint_states"}
    tools = {ns - times[0]: message.pose for topic, ns, message in messages if topic == "/tool"}
    assert [times[0] + ns for ns in joints] == times
    for state in three(states):
        ns = round(seconds(state, states) * 1e9)
        np.testing.assert_array_equal(joints[ns].position, state.arm.q)
        np.testing.assert_array_equal(joints[ns].velocity, state.arm.velocities)
        assert list(joints[ns].name) == [variable.name for variable in state.robot.variables]
        at = tools[ns].position
        np.testing.assert_array_equal([at.x, at.y, at.z], state.T_world_tool[:3, 3])


def test_the_table_gives_the_states_back(states: list[State], path: Path) -> None:
    table = list(csv.DictReader(io.StringIO(encode_recording(recording_of(states, path)).decode())))
    for state in three(states):
        (row,) = [row for row in table if abs(float(row["t [s]"]) - seconds(state, states)) <= ROUNDING]
        assert [float(row[f"q J{k}"]) for k in range(1, 6)] == state.arm.q.tolist()
        assert [float(row[f"dq J{k}"]) for k in range(1, 6)] == state.arm.velocities.tolist()
        assert [float(row[f"tool {axis} [m]"]) for axis in "xyz"] == state.T_world_tool[:3, 3].tolist()
        assert row["method"] == "guarded"


def test_nothing_is_recorded_twice(states: list[State], path: Path) -> None:
    doubled = [state for state in states for _ in range(2)]
    times = recording_of(doubled, path).samples.times
    assert len(times) == len(states) // 2 + 1
    assert np.diff(times).min() >= SAMPLED - 1e-6


def test_planes_obstacles_clouds_and_notices_are_written_when_they_change(states: list[State], path: Path) -> None:
    points = np.random.default_rng(0).normal(size=(50, 3))
    said = Text(en="Look here.", pt_BR="Olhe aqui.")
    changed = replace(
        gate.add_obstacle()(gate.add_plane([0, 0, -1.0, -0.9])(states[100])),
        clouds={"+z": FittedCloud(points, np.ones(50, bool), said)},
        notice=said,
    )
    after = [replace(changed, t=changed.t + 0.02 * (k + 1)) for k in range(3)]
    recorded([*states[:101], *after], path)
    with path.open("rb") as file:
        messages = [(channel.topic, m.data) for _, channel, m in make_reader(file).iter_messages()]
    count = [topic for topic, _ in messages].count
    assert (count("/planes"), count("/obstacles"), count("/clouds/+z"), count("/notice")) == (2, 2, 1, 2)
    (cloud,) = [data for topic, data in messages if topic == "/clouds/+z"]
    assert points.astype("<f4").tobytes() in cloud
    planes = read_recording(path, path.name).planes
    assert [len(known.normals) for _, known in planes] == [4, 5]


def test_what_was_recorded_until_a_kill_is_read(path: Path) -> None:
    program = [sys.executable, "-m", "tests.recorder.records_until_killed", str(path)]
    root = Path(__file__).parents[2]
    folders = os.pathsep.join([str(root / "app"), str(root)])
    with subprocess.Popen(
        program, stdout=subprocess.PIPE, text=True, cwd=root, env={**os.environ, "PYTHONPATH": folders}
    ) as child:
        assert child.stdout is not None
        while float(child.stdout.readline()) < 3.0:
            pass
        child.send_signal(signal.SIGKILL)
    recording = read_recording(path, path.name)
    assert recording.duration > 3.0 - 2.0  # a second for the thread, another for a slow machine
    assert recording.notes
    states = {round(state.t, 6): state for state in moved(seconds=recording.duration + 0.1)}
    for k, time in enumerate(recording.samples.times):
        np.testing.assert_array_equal(recording.samples.q[k], states[round(float(time), 6)].arm.q)


class FullDisk(io.RawIOBase):
    """A file on a disk with room for some bytes."""

    def __init__(self, free: int) -> None:
        self.free, self.written = free, 0

    def writable(self) -> bool:
        return True

    def write(self, data: Any) -> int:
        if self.written + len(data) > self.free:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        self.written += len(data)
        return len(data)

    def tell(self) -> int:
        return self.written


@pytest.mark.parametrize("free", [0, 100, 20_000])
def test_a_full_disk_ends_the_recording_in_words(states: list[State], path: Path, free: int) -> None:
    path.touch()
    disk = cast(BinaryIO, FullDisk(free))
    recorder = Recorder(path, states[0], lambda _: disk)
    for state in states[1:]:
        recorder.take(state)
    recorder.end(PATIENCE)
    assert not recorder.running
    assert recorder.reason is not None
    assert recorder.reason.en == "The recording has ended: the disk is full."
    assert recorder.reason.pt_BR == "A gravação terminou: o disco está cheio."
    recorder.take(states[0])  # the clock may do so until it hears of it


def test_a_vanished_folder_ends_the_recording_in_words(states: list[State], tmp_path: Path) -> None:
    path = tmp_path / "recordings" / "arm.mcap"
    recorder = Recorder(path, states[0])
    while not path.exists() and recorder.running:
        pass
    path.unlink()
    path.parent.rmdir()
    recorder._thread.join(PATIENCE)
    assert recorder.reason is not None
    assert "there is no such file or folder" in recorder.reason.en


def test_a_file_that_exists_is_not_overwritten(states: list[State], path: Path) -> None:
    path.write_bytes(b"mine")
    recorder = recorded(states, path)
    assert path.read_bytes() == b"mine"
    assert recorder.reason is not None


def test_another_arm_ends_the_recording(states: list[State], path: Path) -> None:
    other = initial_state(load_robot("planar3r"))
    recorder = recorded([*states, other, *states], path)
    assert recorder.reason == recorder_module.ANOTHER_ARM
    assert read_recording(path, path.name).duration == pytest.approx(seconds(states[-1], states), abs=0.011)


@pytest.mark.parametrize(
    ("bound", "value", "reason"), [("LONGEST", 1.0, recorder_module.LONG), ("LARGEST", 1000, recorder_module.LARGE)]
)
def test_a_recording_ends_at_its_bounds(
    states: list[State], path: Path, bound: str, value: float, reason: Text, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recorder_module, bound, value)
    recorder = Recorder(path, states[0])
    for state in states[1:]:
        recorder.take(state)
    recorder._thread.join(PATIENCE)
    assert recorder.reason == reason
    assert not read_recording(path, path.name).notes


def test_a_disk_that_does_not_keep_up_ends_the_recording(
    states: list[State], path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recorder_module, "WAITING", 10)
    recorder = recorded(states, path)
    assert recorder.reason == recorder_module.SLOW
    recorder.take(states[0])
    assert not recorder._queue


def test_a_tick_appends_to_a_deque_and_does_nothing_else(states: list[State], path: Path) -> None:
    """No file, no lock, no call of Python's: what the clock calls is the deque's own method."""
    recorder = Recorder(path, states[0])
    assert recorder.take == recorder._queue.append
    assert isinstance(recorder.take, types.BuiltinMethodType)
    recorder.end(PATIENCE)
