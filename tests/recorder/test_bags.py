"""Rosbags of versions 1 and 2 and MCAP with JointState and the messages of Cerbaro's Movemaster; damaged files."""

from __future__ import annotations

import random
import zipfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore
from tests.recorder.recordings import moved, recorded

from helicoide.advance import advance
from helicoide.arrays import Array
from helicoide.contributions.trials import with_joints
from helicoide.kinematics.library import load_robot
from helicoide.readout import plane_distances
from helicoide.recorder import bags, mcap_file
from helicoide.recorder.joint_log import MOST_SAMPLES
from helicoide.recorder.read_back import read_back
from helicoide.recorder.reading import read_recording
from helicoide.recorder.recorded_arm import recorded_arm
from helicoide.recorder.recording import Recording
from helicoide.recorder.replay import replay_recording
from helicoide.recorder.ros import DEFINITIONS, JOINT_STATE, SETPOINT, STATUS
from helicoide.state import initial_state
from helicoide.text import HelicoideError

START, STEP = 1_600_000_000_000_000_000, 50_000_000
ANGLES = np.column_stack(
    [np.linspace(0.0, 0.4, 40), np.full(40, 0.5), np.full(40, -1.3), np.linspace(-0.3, 0.2, 40), np.linspace(0, 1, 40)]
)
Messages = list[tuple[str, str, int, object]]


def definitions(ros: Stores) -> Typestore:
    store = get_typestore(ros)
    for name, text in DEFINITIONS.items():
        store.register(get_types_from_msg(text, name))
    return store


def header(store: Typestore, ns: int) -> object:
    stamp = store.types["builtin_interfaces/msg/Time"](ns // 10**9, ns % 10**9)
    kind = store.types["std_msgs/msg/Header"]
    return kind(0, stamp, "base") if "seq" in kind.__annotations__ else kind(stamp, "base")


def joint_states(store: Typestore, names: list[str]) -> Messages:
    kind = store.types[JOINT_STATE]
    return [
        (
            "/joint_state",
            JOINT_STATE,
            START + k * STEP,
            kind(header(store, START + k * STEP), names, np.array(q), np.zeros(0), np.zeros(0)),
        )
        for k, q in enumerate(ANGLES)
    ]


def movemaster(store: Typestore) -> Messages:
    """What the source's node sends: angles of the motors, deg, and a status with the pulses of each joint."""
    motors = np.degrees(ANGLES)
    motors[:, 4] -= motors[:, 3]
    pulses = motors * [185, 228, 186, 155, 116]
    messages: Messages = []
    for k, (angles, counts) in enumerate(zip(motors, pulses, strict=True)):
        ns = START + k * STEP
        setpoint = store.types[SETPOINT](*map(float, angles), False, 0, False)
        messages.append(("/setpoint", SETPOINT, ns, setpoint))
        for joint, count in enumerate(counts, 1):
            status = store.types[STATUS](f"J{joint}", 0.0, float(count), 0.0, 0.0, 0.0, True)
            messages.append((f"/status_{joint}", STATUS, ns + joint, status))
    return messages


def write_bag1(path: Path, store: Typestore, messages: Messages) -> Path:
    with Writer1(path) as bag:
        channels = {
            topic: bag.add_connection(topic, kind, typestore=store) for topic, kind in {(m[0], m[1]) for m in messages}
        }
        for topic, kind, ns, message in messages:
            bag.write(channels[topic], ns, store.serialize_ros1(message, kind))
    return path


def write_bag2(path: Path, store: Typestore, messages: Messages, plugin: StoragePlugin) -> Path:
    with Writer2(path, version=9, storage_plugin=plugin) as bag:
        channels = {
            topic: bag.add_connection(topic, kind, typestore=store) for topic, kind in {(m[0], m[1]) for m in messages}
        }
        for topic, kind, ns, message in messages:
            bag.write(channels[topic], ns, store.serialize_cdr(message, kind))
    return path


def bag1(folder: Path, make: Callable[[Typestore], Messages]) -> Path:
    store = definitions(Stores.ROS1_NOETIC)
    return write_bag1(folder / "run.bag", store, make(store))


def db3(folder: Path, make: Callable[[Typestore], Messages]) -> Path:
    store = definitions(Stores.ROS2_HUMBLE)
    return next(write_bag2(folder / "run", store, make(store), StoragePlugin.SQLITE3).glob("*.db3"))


def mcap(folder: Path, make: Callable[[Typestore], Messages]) -> Path:
    store = definitions(Stores.ROS2_HUMBLE)
    return next(write_bag2(folder / "run", store, make(store), StoragePlugin.MCAP).glob("*.mcap"))


def zipped(folder: Path, make: Callable[[Typestore], Messages]) -> Path:
    packed = folder / "run.zip"
    with zipfile.ZipFile(packed, "w") as archive:
        for file in db3(folder, make).parent.iterdir():
            archive.write(file, f"run/{file.name}")
    return packed


BAGS = {"rosbag1": bag1, "db3": db3, "mcap": mcap, "zip": zipped}
every = pytest.mark.parametrize("kind", BAGS)


def read(path: Path) -> Recording:
    return read_recording(path, path.name)


@every
def test_joint_states_are_read_by_name(kind: str, tmp_path: Path) -> None:
    names = ["J5", "J4", "J3", "J2", "J1"]
    recording = read(BAGS[kind](tmp_path, lambda store: joint_states(store, names)))
    np.testing.assert_array_equal(recording.samples.q, ANGLES)
    np.testing.assert_allclose(recording.samples.times, 0.05 * np.arange(40), atol=1e-9)
    on_arm = read_back(recording, initial_state(load_robot("movemaster")))
    np.testing.assert_array_equal(on_arm.samples.q, ANGLES[:, ::-1])


@every
def test_the_encoders_of_the_movemaster_are_read_back(kind: str, tmp_path: Path) -> None:
    """Pulses and motor angles in single precision; the roll of the wrist is without that of its pitch (fig. 20)."""
    state = initial_state(load_robot("movemaster"))
    recording = read(BAGS[kind](tmp_path, movemaster))
    assert recording.arm.name == "movemaster"
    assert recording.setpoints is not None
    np.testing.assert_allclose(recording.setpoints.q, ANGLES, atol=1e-6)
    last = recording.samples.q[[int(np.argmin(np.abs(recording.samples.times - 0.05 * k))) for k in range(1, 40)]]
    np.testing.assert_allclose(last, ANGLES[1:], atol=1e-6)
    on_arm = read_back(recording, state)
    assert on_arm.sent_trail is not None
    assert on_arm.chart is not None
    np.testing.assert_allclose(on_arm.trail[-1], on_arm.sent_trail[-1], atol=1e-5)
    there = with_joints(state, recording.samples.q[-1])
    np.testing.assert_allclose(there.T_world_tool[:3, 3], on_arm.trail[-1], atol=1e-12)
    nearest = plane_distances(there).min(axis=0)
    np.testing.assert_allclose([line.y[-1] for line in on_arm.chart.lines[:4]], 1000 * nearest, atol=1e-9)


def test_a_stop_or_a_way_home_is_no_setpoint(tmp_path: Path) -> None:
    store = definitions(Stores.ROS1_NOETIC)
    kind = store.types[SETPOINT]
    sent = [(10.0, False, 0), (99.0, True, 0), (99.0, False, 1), (20.0, False, 0)]
    messages: Messages = [
        ("/setpoint", SETPOINT, START + k * STEP, kind(angle, 0.0, 0.0, 0.0, 0.0, False, home, stop))
        for k, (angle, stop, home) in enumerate(sent)
    ]
    recording = read(write_bag1(tmp_path / "run.bag", store, messages))
    np.testing.assert_allclose(np.degrees(recording.samples.q[:, 0]), [10.0, 20.0], atol=1e-5)


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -1e308])
def test_samples_with_unusable_values_or_the_time_of_another_are_left_out(wrong: float, tmp_path: Path) -> None:
    store = definitions(Stores.ROS2_HUMBLE)
    messages = joint_states(store, ["J1", "J2", "J3", "J4", "J5"])
    messages[3][3].position[2] = wrong  # type: ignore[attr-defined]
    messages.append((*messages[5][:3], messages[6][3]))
    recording = read(next(write_bag2(tmp_path / "run", store, messages, StoragePlugin.MCAP).glob("*.mcap")))
    np.testing.assert_array_equal(recording.samples.q, np.delete(ANGLES, 3, axis=0))
    (note,) = recording.notes
    assert note.en.startswith("Left out")
    assert "2 of 41" in note.en


def test_a_bag_of_other_joints_is_refused(tmp_path: Path) -> None:
    recording = read(bag1(tmp_path, lambda store: joint_states(store, ["a", "b", "c", "d", "J1"])))
    with pytest.raises(HelicoideError, match="has the joints a, b, c, d, J1"):
        read_back(recording, initial_state(load_robot("movemaster")))
    with pytest.raises(HelicoideError, match="This arm has"):
        read_back(recording, initial_state(load_robot("planar3r")))


def test_a_recording_of_another_arm_is_refused_and_nothing_moves(tmp_path: Path) -> None:
    recorded(moved("planar3r"), tmp_path / "planar.mcap")
    recording = read(tmp_path / "planar.mcap")
    state = initial_state(load_robot("movemaster"))
    refused = replay_recording(recording)(state)
    assert refused.request is state.request
    assert refused.notice is not None
    assert "planar.mcap is of the arm planar3r" in refused.notice.en
    longer = initial_state(load_robot("planar3r", None, ("l1=1500",)))
    assert "lengths" in (replay_recording(recording)(longer).notice or state.robot.title).en


def test_a_replay_equals_the_recording(tmp_path: Path) -> None:
    """Within what the guarded step lags behind a motion that it made itself."""
    states = moved()
    recorded(states, tmp_path / "arm.mcap")
    recording = read(tmp_path / "arm.mcap")
    state = replay_recording(recording)(states[0])
    passed = []
    for _ in range(len(states) + 50):
        state = advance(state, 0.01)
        passed.append(state.arm.q)
    for time in (0.5, 1.0, 2.0):
        gaps = np.abs(np.array(passed) - recording.samples.q_at(time)).max(axis=1)
        assert gaps.min() < 2e-3
    np.testing.assert_allclose(passed[-1], states[-1].arm.q, atol=1e-3)


def reason(path: Path) -> str:
    """What is said of a file; both languages say what would be valid."""
    with pytest.raises(HelicoideError) as refusal:
        read(path)
    text = refusal.value.text
    assert "Valid are MCAP (.mcap), rosbag 1 (.bag)" in text.en
    assert text.pt_BR.startswith(f"Não dá para ler {path.name}: ")
    return text.en.removeprefix(f"{path.name} cannot be read: ").partition(". Valid")[0]


def test_a_recording_of_an_arm_at_rest_is_refused(tmp_path: Path) -> None:
    recorded(moved()[:1], tmp_path / "rest.mcap")
    assert reason(tmp_path / "rest.mcap") == "the arm did not move while it was recorded"


@every
def test_a_bag_without_joints_is_refused_in_words(kind: str, tmp_path: Path) -> None:
    assert reason(BAGS[kind](tmp_path, lambda _: [])).startswith("there are no two samples of joints in it")


def test_metadata_that_name_other_joints_than_the_samples_are_not_believed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    states = moved("planar3r", 0.3)
    six = recorded_arm(load_robot("puma560"))
    monkeypatch.setattr(mcap_file, "recorded_arm", lambda _: six)
    recorded(states, tmp_path / "forged.mcap")
    recording = read(tmp_path / "forged.mcap")
    assert len(recording.arm.joints) == recording.samples.q.shape[1] == 3
    with pytest.raises(HelicoideError, match="This arm has"):
        read_back(recording, initial_state(load_robot("puma560")))


@pytest.mark.parametrize("ending", [".mcap", ".bag", ".db3", ".zip"])
@pytest.mark.parametrize("content", [b"", b"\0" * 100, b"hello", b"PK\x03\x04", b"\x89MCAP0\r\n", b"#ROSBAG V2.0\n"])
def test_a_foreign_file_is_refused(ending: str, content: bytes, tmp_path: Path) -> None:
    path = tmp_path / f"foreign{ending}"
    path.write_bytes(content)
    assert reason(path)


def test_other_endings_missing_files_and_empty_archives_are_refused(tmp_path: Path) -> None:
    (tmp_path / "arm.txt").write_text("t 0")
    assert reason(tmp_path / "arm.txt") == "no format has names that end in .txt"
    assert reason(tmp_path / "none.mcap") == "there is no such file or folder"
    with zipfile.ZipFile(tmp_path / "none.zip", "w") as archive:
        archive.writestr("../../elsewhere.txt", "no bag")
    assert reason(tmp_path / "none.zip").startswith("there is no rosbag in it")
    assert not (tmp_path.parent / "elsewhere.txt").exists()


def test_an_archive_that_unpacks_to_too_much_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bags, "MOST_UNPACKED", 1_000_000)
    with zipfile.ZipFile(tmp_path / "bomb.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("run.db3", bytes(2_000_000))
    assert "its files are larger than" in reason(tmp_path / "bomb.zip")


def test_an_endless_bag_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("helicoide.recorder.joint_log.MOST_SAMPLES", 20)
    assert f"more than {MOST_SAMPLES} samples" in reason(bag1(tmp_path, movemaster))


@every
def test_a_bag_that_is_cut_or_changed_is_read_or_refused(kind: str, tmp_path: Path) -> None:
    path, chance = BAGS[kind](tmp_path, movemaster), random.Random(1)
    whole, damaged = path.read_bytes(), tmp_path / f"damaged{path.suffix}"
    for _ in range(40):
        damaged.write_bytes(whole[: chance.randrange(len(whole))])
        read_or_refused(damaged)
        damaged.write_bytes(changed(whole, chance))
        read_or_refused(damaged)


def test_what_stands_before_a_cut_or_a_change_in_a_recording_is_read(tmp_path: Path) -> None:
    path, chance = tmp_path / "own.mcap", random.Random(2)
    recorded(moved(seconds=0.3), path)
    whole, q, damaged = path.read_bytes(), read(path).samples.q, tmp_path / "damaged.mcap"
    counts = []
    for end in range(0, len(whole), 131):
        damaged.write_bytes(whole[:end])
        counts.append(len(read_or_refused(damaged, q)))
        damaged.write_bytes(changed(whole, chance))
        read_or_refused(damaged)
    assert counts == sorted(counts)
    assert counts[-1] == len(q)


def changed(whole: bytes, chance: random.Random) -> bytes:
    data = bytearray(whole)
    for _ in range(chance.choice((1, 10, 300))):
        data[chance.randrange(len(data))] = chance.randrange(256)
    return bytes(data)


def read_or_refused(path: Path, whole: Array | None = None) -> Array:
    """The joint values that are read, (k, n), which are finite, in order, and the first of the whole file's."""
    try:
        samples = read(path).samples
    except HelicoideError:
        return np.zeros((0, 5))
    assert len(samples.times) >= 2
    assert np.isfinite(samples.q).all()
    assert (np.diff(samples.times) > 0).all()
    if whole is not None:
        np.testing.assert_array_equal(samples.q, whole[: len(samples.q)])
    return samples.q
