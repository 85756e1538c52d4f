"""The file of waypoints: there and back again to the last bit; everything else is refused in words."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.kinematics.arms import NAMES, arm
from tests.trajectory.taught import taught

from helicoide.text import HelicoideError
from helicoide.trajectory.waypoint_file import FORMAT, decode_waypoints, encode_waypoints
from helicoide.trajectory.waypoints import GRIPPER_ACTIONS, MOVE_TYPES, WaypointList, waypoint

NAME = st.text(min_size=1, max_size=60).filter(lambda name: name.isprintable() and name == name.strip())
ROBOT = arm("movemaster")


def are_alike(one: WaypointList, other: WaypointList) -> None:
    assert one.robot is other.robot
    assert one.names == other.names
    for a, b in zip(one.waypoints, other.waypoints, strict=True):
        assert a.q.tobytes() == b.q.tobytes()
        assert (a.move_type, a.dwell, a.gripper) == (b.move_type, b.dwell, b.gripper)


@pytest.mark.parametrize("name", NAMES)
def test_there_and_back_for_every_robot(name: str) -> None:
    here = taught(name, [f"point {i}" for i in range(7)])
    are_alike(decode_waypoints(encode_waypoints(here), here.robot), here)


@given(
    points=st.lists(
        st.tuples(
            NAME,
            st.tuples(*[st.floats(low, high) for low, high in zip(ROBOT.lower, ROBOT.upper, strict=True)]),
            st.sampled_from(list(MOVE_TYPES)),
            st.floats(0, 3600),
            st.sampled_from(list(GRIPPER_ACTIONS)),
        ),
        max_size=5,
        unique_by=lambda point: point[0],
    )
)
def test_there_and_back_to_the_last_bit(points: list[tuple[str, tuple[float, ...], str, float, str]]) -> None:
    """Any name that a person can read, and every float, −0.0 and the smallest among them."""
    here = WaypointList(ROBOT, tuple(waypoint(ROBOT, *point) for point in points))
    are_alike(decode_waypoints(encode_waypoints(here), ROBOT), here)


def test_any_name_of_a_robot_can_be_written() -> None:
    """Those of URDF files may hold anything."""
    odd = replace(ROBOT, name='odd "\\ \n\t\x00\x7f ção')
    are_alike(decode_waypoints(encode_waypoints(WaypointList(odd)), odd), WaypointList(odd))


def test_a_person_can_read_it() -> None:
    q = [0.1, 0.5, -1.0, 0.0, 1e-07]
    file = encode_waypoints(WaypointList(ROBOT, (waypoint(ROBOT, 'above the "ball"', q, "line", 0.5),))).decode()
    assert [line for line in file.splitlines() if not line.startswith("#")] == [
        'format = "helicoide waypoints 1"',
        'robot = "movemaster"',
        'joints = ["J1", "J2", "J3", "J4", "J5"]',
        "",
        "[[waypoint]]",
        'name = "above the \\"ball\\""',
        "q = [0.1, 0.5, -1.0, 0.0, 1e-07]",
        'way = "line"',
        "dwell = 0.5",
    ]


def test_a_gripper_that_opens_or_closes_has_a_line_of_its_own() -> None:
    here = WaypointList(ROBOT, (waypoint(ROBOT, "x", [0, 0, -1, 0, 0], gripper="closed"),))
    assert encode_waypoints(here).decode().splitlines()[-1] == 'gripper = "closed"'


def test_what_a_person_leaves_out_or_writes_as_a_whole_number() -> None:
    file = encode_waypoints(WaypointList(ROBOT)) + b'[[waypoint]]\nname = "zero"\nq = [0, 0, -1, 0, 0]\n'
    (point,) = decode_waypoints(file, ROBOT).waypoints
    np.testing.assert_array_equal(point.q, [0, 0, -1, 0, 0])
    assert (point.move_type, point.dwell, point.gripper) == ("joints", 0.0, "")


def test_the_file_of_another_robot_is_refused_with_both_names() -> None:
    with pytest.raises(HelicoideError, match="taught to puma560, and this robot is movemaster") as refused:
        decode_waypoints(encode_waypoints(taught("puma560")), ROBOT)
    assert "robô puma560, e este é o movemaster" in refused.value.text.pt_BR


def test_an_arm_without_a_gripper_has_none_to_open() -> None:
    with pytest.raises(HelicoideError, match="sets the gripper to open, but this robot has no gripper") as refused:
        waypoint(arm("puma560"), "x", arm("puma560").poses["ready"], gripper="open")
    assert "pede a garra aberta" in refused.value.text.pt_BR


def test_the_file_of_a_robot_with_other_joints_is_refused() -> None:
    file = encode_waypoints(taught("movemaster")).replace(b'"J2", "J3"', b'"J3", "J2"')
    with pytest.raises(HelicoideError, match="with the joints J1, J3, J2, J4, J5; this one has J1, J2, J3, J4, J5"):
        decode_waypoints(file, ROBOT)


GOOD = encode_waypoints(taught("movemaster")).decode()
HEADER = encode_waypoints(WaypointList(ROBOT)).decode()
POINT = '[[waypoint]]\nname = "x"\nq = [0.0, 0.0, -1.0, 0.0, 0.0]\n'


@pytest.mark.parametrize(
    ("file", "words"),
    [
        (b"", "it is empty"),
        (b"# only words", "format must be 'helicoide waypoints 1', not something else or nothing"),
        (b"a." * 30000 + b"a = 1", "too many dots"),
        (b"#" * 1_000_001, "at most 1000 kB"),
        (b"\xff\xfe", "not a waypoint file"),
        (b"\x00" * 100, "not a waypoint file"),
        (b"= = =", "not a waypoint file"),
        (b"a = " + b"[" * 5000, "not a waypoint file"),
        (f"format = {FORMAT!r}".encode(), "the required robot is missing"),
        (GOOD.replace("waypoints 1", "waypoints 2"), "not 'helicoide waypoints 2'"),
        (GOOD[: len(GOOD) // 2], "not a waypoint file"),
        (GOOD + "speed = 3\n", "no such key as speed (at $.waypoint[2])"),
        (GOOD.replace('name = "b"', 'name = "a"'), "already a waypoint 'a'"),
        (GOOD.replace('"line"', '"jump"'), "the move types are: joints (joint move), line"),
        (GOOD.replace('"line"', "3"), "not a waypoint file"),
        (GOOD.replace("dwell = 0.5", "dwell = -0.5"), "0 to 3600 s, not -0.5"),
        (GOOD.replace("dwell = 0.5", "dwell = nan"), "0 to 3600 s, not nan"),
        (GOOD.replace("dwell = 0.5", "dwell = 1e999"), "0 to 3600 s, not inf"),
        (HEADER + POINT + 'gripper = "ajar"\n', "cannot be 'ajar' at waypoint 'x'; it may be: open, closed"),
        (HEADER + POINT + "gripper = 1\n", "not a waypoint file"),
        (HEADER + POINT.replace("[0.0, ", "["), "takes 5 finite joint values"),
        (HEADER + POINT.replace("-1.0", "nan"), "takes 5 finite joint values"),
        (HEADER + POINT.replace("-1.0", "-inf"), "takes 5 finite joint values"),
        (HEADER + POINT.replace("-1.0", "1e300"), "sets J3 to 1×10³⁰⁰ rad"),
        (HEADER + POINT.replace("-1.0", "1" + "0" * 400), "not a waypoint file"),
        (HEADER + POINT.replace("-1.0", "'one'"), "not a waypoint file"),
        (HEADER + POINT.replace('"x"', '"x\\u0000"'), "visible characters"),
        (HEADER + "waypoint = 3\n", "not a waypoint file"),
    ],
)
def test_broken_files_are_refused_in_words(file: str | bytes, words: str) -> None:
    with pytest.raises(HelicoideError) as refused:
        decode_waypoints(file if isinstance(file, bytes) else file.encode(), ROBOT)
    assert words in refused.value.text.en
    assert refused.value.text.pt_BR != refused.value.text.en


def read(content: bytes) -> WaypointList | HelicoideError:
    """What is in a file, or why it is refused."""
    try:
        return decode_waypoints(content, ROBOT)
    except HelicoideError as refused:
        return refused


@given(noise=st.binary(max_size=200), at=st.integers(0, len(GOOD.encode())))
def test_no_noise_in_a_file_crashes(noise: bytes, at: int) -> None:
    good = GOOD.encode()
    found = read(good[:at] + noise + good[at:])
    assert isinstance(found, HelicoideError) or all(np.isfinite(point.q).all() for point in found.waypoints)


@given(at=st.integers(0, len(GOOD.encode()) - 1))
def test_no_cut_in_a_file_crashes(at: int) -> None:
    """What is left is refused, unless it is a file itself: then its waypoints are the first of the whole."""
    whole, found = decode_waypoints(GOOD.encode(), ROBOT), read(GOOD.encode()[:at])
    assert isinstance(found, HelicoideError) or found.names == whole.names[: len(found.names)]
