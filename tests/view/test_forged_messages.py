"""What a browser may send by mistake or by malice, in viser's own wire format: nothing moves, nothing breaks."""

from __future__ import annotations

import contextlib
import json
import math
import struct
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import msgspec
import numpy as np
import pytest
import viser
import zstandard
from websockets.exceptions import ConnectionClosedError
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin, Subprotocol

from helicoide import gate
from helicoide.kinematics.robot import Robot
from helicoide.session import Session
from helicoide.state import Hold, State, ToJoints
from helicoide.view.channel import PATH

CAMERA = {
    "type": "ViewerCameraMessage",
    "wxyz": (1.0, 0.0, 0.0, 0.0),
    "position": (1.0, 1.0, 1.0),
    "fov": 1.2,
    "near": 0.01,
    "far": 1000.0,
    "image_height": 600,
    "image_width": 800,
    "look_at": (0.0, 0.0, 0.0),
    "up_direction": (0.0, 0.0, 1.0),
}


class Page:
    """A browser's part of viser's protocol: keeps what was created, answers for its storage, sends anything."""

    def __init__(self, port: int) -> None:
        origin, protocol = Origin(f"http://127.0.0.1:{port}"), Subprotocol(f"viser-v{viser.__version__}")
        self.socket: ClientConnection = connect(
            f"ws://127.0.0.1:{port}/", origin=origin, subprotocols=[protocol], compression=None, max_size=None
        )
        self.made: dict[str, dict[str, Any]] = {}
        self.owner = ""
        self.send(CAMERA)
        threading.Thread(target=self._listen, daemon=True).start()

    def send(self, message: dict[str, Any]) -> None:
        self.socket.send(msgspec.msgpack.encode(message))

    def _listen(self) -> None:
        with contextlib.suppress(ConnectionClosedError):  # viser drops whoever sends junk
            for raw in self.socket:
                assert isinstance(raw, bytes)
                plain, packed = struct.unpack_from("<QQ", raw)
                text = zstandard.ZstdDecompressor().decompress(raw[16 : 16 + packed], max_output_size=plain)
                for message in msgspec.msgpack.decode(text)["messages"]:
                    self._take(message)

    def _take(self, message: dict[str, Any]) -> None:
        if message["type"] == "LocalStorageGetItemRequestMessage":
            answer = {"value": None, "error": None, "request_uuid": message["request_uuid"]}
            self.send({"type": "LocalStorageGetItemResponseMessage", **answer})
        elif message["type"].startswith("Gui") and "label" in message.get("props", {}):
            self.made[message["props"]["label"]] = message

    def give(self, label: str, value: object) -> None:
        """Set the value of a control, as its slider, box or button would; it may still be on its way."""
        assert eventually(lambda: label in self.made)
        self.send({"type": "GuiUpdateMessage", "uuid": self.made[label]["uuid"], "updates": {"value": value}})

    def drag(self, phase: str, name: str = "/target", **pose: object) -> None:
        message = {"Start": "DragStart", "Move": "Update", "End": "DragEnd"}[phase]
        self.send({"type": f"TransformControls{message}Message", "name": name, "owner": self.owner, **pose})


def eventually(condition: Callable[[], bool], seconds: float = 60.0) -> bool:
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.01)
    return condition()


@pytest.fixture(scope="module")
def session(robot: Robot) -> Iterator[Session]:
    session = Session(robot, "en", None)
    session.open("127.0.0.1", 0)
    assert eventually(lambda: session.ready, 300)
    yield session
    session.close()


@pytest.fixture
def page(session: Session) -> Iterator[Page]:
    page = Page(session.server.get_port())
    assert eventually(lambda: "5 wrist roll" in page.made and len(session.windows) == 1)
    page.owner = next(iter(session.windows.values())).client.scene._owner_id
    yield page
    page.socket.close()
    assert eventually(lambda: not session.windows)


def after_ticks(session: Session, n: int = 30) -> State:
    """The state n ticks later: the loop is alive."""
    now = session.ticks
    assert eventually(lambda: session.ticks >= now + n)
    return session.state


def moved(session: Session, act: Callable[[], object]) -> bool:
    """Whether the arm, its planes or its wish are different after what a page did."""
    before = session.state
    act()
    after = after_ticks(session)
    return bool(
        (after.q != before.q).any() or after.problem is not before.problem or after.command is not before.command
    )


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 1e9, -91.0, 90.2])
def test_a_joint_slider_beyond_its_range_moves_nothing(session: Session, page: Page, value: float) -> None:
    assert not moved(session, lambda: page.give("1 waist", value))
    assert session.state.notice is not None


@pytest.mark.parametrize("value", ["abc", None, [], {"x": 1}, "9" * 400])
def test_a_value_of_another_type_moves_nothing(session: Session, page: Page, value: object) -> None:
    assert not moved(session, lambda: page.give("1 waist", value))


@pytest.mark.parametrize("value", [math.nan, -1.0, 101.0])
def test_the_gripper_takes_only_its_range(session: Session, page: Page, value: float) -> None:
    target = session.state.gripper_target
    assert not moved(session, lambda: page.give("Gripper [%]", value))
    assert session.state.gripper_target == target


@pytest.mark.parametrize(
    "position", [(math.nan, 0.0, 0.3), (math.inf, 0.0, 0.3), (1e6, 0.0, 0.3), (0.0, 0.0), ("a", "b", "c")]
)
def test_a_gizmo_dragged_to_no_place_moves_nothing(session: Session, page: Page, position: tuple[object]) -> None:
    def drag() -> None:
        page.drag("Start")
        page.drag("Move", wxyz=(1.0, 0.0, 0.0, 0.0), position=position)
        page.drag("End")

    before = session.state.T_world_tool
    drag()
    assert np.allclose(after_ticks(session).T_world_tool, before, atol=1e-9)


def test_a_gizmo_with_no_orientation_moves_nothing(session: Session, page: Page) -> None:
    before = session.state.T_world_tool
    page.drag("Start")
    page.drag("Move", wxyz=(0.0, 0.0, 0.0, 0.0), position=(0.5, 0.0, 0.3))
    page.drag("End")
    assert np.allclose(after_ticks(session).T_world_tool, before, atol=1e-9)


def test_an_update_without_a_grasp_moves_nothing(session: Session, page: Page) -> None:
    pose = {"wxyz": (1.0, 0.0, 0.0, 0.0), "position": (0.5, 0.2, 0.3)}
    assert not moved(session, lambda: page.drag("Move", **pose))


def test_a_drag_whose_end_gets_lost_ends_when_the_pointer_is_let_go(session: Session, page: Page) -> None:
    port = session.server.get_port()
    (window,) = session.windows.values()
    with connect(f"ws://127.0.0.1:{port}{PATH}", origin=Origin(f"http://127.0.0.1:{port}")) as control:
        control.send(json.dumps({"seat": window.view.seat.token}))
        page.drag("Start")
        page.drag("Move", wxyz=(1.0, 0.0, 0.0, 0.0), position=(0.5, 0.1, 0.3))
        assert eventually(lambda: session.state.grasp is not None)
        control.send('{"released": true}')
        assert eventually(lambda: session.state.grasp is None)
        wished = session.state.command
        page.drag("Move", wxyz=(1.0, 0.0, 0.0, 0.0), position=(0.4, 0.2, 0.3))
        after_ticks(session)
        assert session.state.command is wished
        page.drag("Start")
        assert eventually(lambda: session.state.grasp is not None)
        with connect(f"ws://127.0.0.1:{port}{PATH}", origin=Origin(f"http://127.0.0.1:{port}")) as stranger:
            stranger.send('{"released": true}')
            stranger.send('{"beat": true}')
            stranger.recv(5)
        after_ticks(session, 80)
        assert session.state.grasp is not None, "another person's pointer"
        page.drag("End")
        assert eventually(lambda: session.state.grasp is None)


@pytest.mark.parametrize("position", [(math.nan, 0.0, 0.3), (math.inf, 0.0, 0.3), (1e6, 0.0, 0.3)])
def test_an_obstacle_dragged_to_no_place_stays(session: Session, page: Page, position: tuple[object]) -> None:
    page.give("Add a sphere", True)
    assert eventually(lambda: len(session.state.problem.obstacles.radii) == 1)
    before = session.state.problem.obstacles.ends
    page.drag("Start", "/handles/obstacle 0")
    page.drag("Move", "/handles/obstacle 0", wxyz=(1.0, 0.0, 0.0, 0.0), position=position)
    page.drag("End", "/handles/obstacle 0")
    page.drag("Start", "/handles/obstacle 5")
    page.drag("Start", "/handles/entry")
    after_ticks(session)
    np.testing.assert_array_equal(session.state.problem.obstacles.ends, before)
    assert eventually(lambda: "Take sphere 1 away" in page.made)
    page.give("sphere 1: radius [mm]", 1e9)
    after_ticks(session)
    np.testing.assert_array_equal(session.state.problem.obstacles.ends, before)
    page.give("Take sphere 1 away", True)
    assert eventually(lambda: not session.state.problem.obstacles.radii.size)
    del page.made["Take sphere 1 away"]


def test_what_is_lit_up_may_go(session: Session, page: Page) -> None:
    """A plane that is lit up is taken away: the window goes on, and the list no longer offers it."""
    page.give("Light up", "plane p9 (p9)")
    after_ticks(session)
    assert chosen(session) is None, "there is no such plane"
    session.loop.call_soon_threadsafe(session.post, gate.add_plane([0.0, 0.0, -1.0, -0.62]))
    assert eventually(lambda: NEW in listed(session))
    page.give("Light up", NEW)
    assert eventually(lambda: chosen(session) == "plane 4")
    session.loop.call_soon_threadsafe(session.post, gate.remove_plane(4))
    assert eventually(lambda: NEW not in listed(session))
    frames = session.frames
    assert eventually(lambda: session.frames > frames + 5)
    session.loop.call_soon_threadsafe(session.post, gate.restore_planes())


NEW = "plane p1 (p1)"


def listed(session: Session) -> tuple[str, ...]:
    """What the only window offers to light up."""
    return tuple(control(session, "Light up").options)


def chosen(session: Session) -> str | None:
    (window,) = session.windows.values()
    return window.view.seat.selected


def test_the_fixed_plane_and_unknown_names_move_nothing(session: Session, page: Page) -> None:
    pose = {"wxyz": (1.0, 0.0, 0.0, 0.0), "position": (0.5, 0.2, 0.3)}

    def drag() -> None:
        for name in ("/handles/plane 3", "/handles/plane 99", "/nothing", "", "/arm/waist"):
            page.drag("Start", name)
            page.drag("Move", name, **pose)
            page.drag("End", name)
        page.send({"type": "GuiUpdateMessage", "uuid": "no-such-control", "updates": {"value": 3.0}})
        page.send({"type": "CommandTriggerMessage", "uuid": "no-such-command"})

    assert not moved(session, drag)


def test_a_disabled_control_moves_nothing(session: Session, page: Page) -> None:
    page.give("Park", True)
    assert eventually(lambda: session.state.parked and session.state.command == Hold())
    assert eventually(lambda: control(session, "1 waist").disabled)
    assert not moved(session, lambda: page.give("1 waist", 20.0))
    assert not moved(session, lambda: page.give("Play", True))
    page.give("Ready", True)
    assert eventually(lambda: not session.state.parked and session.state.command == Hold())


def control(session: Session, label: str) -> Any:
    """The control of the only window with a label."""
    (window,) = session.windows.values()
    handles = window.client.gui._gui_input_handle_from_uuid.values()
    return next(handle for handle in list(handles) if getattr(handle, "label", "") == label)


def test_a_control_that_a_page_breaks_costs_that_page_one_row(
    session: Session, page: Page, caplog: pytest.LogCaptureFixture
) -> None:
    """viser writes whatever attribute a message names into its handle."""
    session.loop.call_soon_threadsafe(session.post, gate.get_ready())
    waist = control(session, "1 waist")
    page.send({"type": "GuiUpdateMessage", "uuid": page.made["1 waist"]["uuid"], "updates": {"props": None}})
    assert eventually(lambda: waist._impl.props is None)
    page.give("2 shoulder", 21.0)
    assert eventually(lambda: abs(math.degrees(session.state.q[1]) - 21) < 0.1)
    session.loop.call_soon_threadsafe(session.post, gate.set_joint(1, math.radians(25)))
    assert eventually(lambda: control(session, "2 shoulder").value == 25.0)
    failed = [record for record in caplog.records if "row" in record.getMessage()]
    assert [record.getMessage() for record in failed] == ["A row of a panel failed: Slider."]
    assert failed[0].exc_info is not None


def test_messages_that_viser_does_not_know_end_at_most_their_own_connection(session: Session, robot: Robot) -> None:
    port = session.server.get_port()
    for junk in (b"", b"\xff\xfe junk", msgspec.msgpack.encode({"type": "NoSuchMessage"}), b"x" * 100_000):
        page = Page(port)
        page.socket.send(junk)
        after_ticks(session, 10)
        page.socket.close()
    good = Page(port)
    assert eventually(lambda: "1 waist" in good.made)
    good.give("1 waist", 12.0)
    assert eventually(lambda: isinstance(session.state.command, ToJoints))
    assert eventually(lambda: abs(math.degrees(session.state.q[0]) - 12) < 0.1)
    good.socket.close()
