"""What a browser may send by mistake or by malice, in viser's own wire format: nothing moves, nothing breaks."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Iterator
from typing import Any

import msgspec
import numpy as np
import pytest
from tests.pages import Hand
from tests.session.labs import after_ticks, eventually, running
from tests.session.labs import state as arm
from websockets.exceptions import ConnectionClosed

from helicoide import gate
from helicoide.command import HoldPosition, MoveToJoints
from helicoide.seat import Selection
from helicoide.session.lab import Lab
from helicoide.view.news import tell_once
from helicoide.view.window import Window


class Page(Hand):
    """A page whose hand may send anything."""

    @property
    def made(self) -> dict[str, dict[str, Any]]:
        return self.page.made

    def give(self, label: str, value: object) -> None:
        self.do(self.page.give(label, value))

    def send(self, message: dict[str, Any]) -> None:
        self.do(self.page.send(message))

    def drag(self, phase: str, name: str = "/target", **pose: object) -> None:
        event = {"Start": "DragStart", "Move": "Update", "End": "DragEnd"}[phase]
        with contextlib.suppress(ConnectionClosed):  # viser drops whoever sends junk
            self.do(self.page.gizmo(event, name, **pose))


@pytest.fixture(scope="module")
def session() -> Iterator[Lab]:
    with running() as lab:
        yield lab


@pytest.fixture
def page(session: Lab) -> Iterator[Page]:
    page = Page(session.server.get_port())
    assert eventually(lambda: "5 wrist roll" in page.made and len(windows(session)) == 1)
    assert eventually(page.page.may_drive.is_set)
    yield page
    page.close()
    assert eventually(lambda: not session.visitors)


def windows(lab: Lab) -> list[Window]:
    """Those in front of the shared arm."""
    return [] if lab.shared.display is None else list(lab.shared.display.windows)


def moved(lab: Lab, act: Callable[[], object]) -> bool:
    """Whether the arm, its planes or its command are different after what a page did."""
    before = arm(lab)
    act()
    after = after_ticks(lab)
    return bool(
        (after.arm.q != before.arm.q).any()
        or after.problem is not before.problem
        or after.request.command is not before.request.command
    )


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 1e9, -91.0, 90.2])
def test_a_joint_slider_beyond_its_range_moves_nothing(session: Lab, page: Page, value: float) -> None:
    assert not moved(session, lambda: page.give("1 waist", value))
    assert arm(session).notice is not None


@pytest.mark.parametrize("value", ["abc", None, [], {"x": 1}, "9" * 400])
def test_a_value_of_another_type_moves_nothing(session: Lab, page: Page, value: object) -> None:
    assert not moved(session, lambda: page.give("1 waist", value))


@pytest.mark.parametrize("value", [math.nan, -1.0, 101.0])
def test_the_gripper_takes_only_its_range(session: Lab, page: Page, value: float) -> None:
    target = arm(session).request.gripper
    assert not moved(session, lambda: page.give("Gripper [%]", value))
    assert arm(session).request.gripper == target


@pytest.mark.parametrize(
    "position", [(math.nan, 0.0, 0.3), (math.inf, 0.0, 0.3), (1e6, 0.0, 0.3), (0.0, 0.0), ("a", "b", "c")]
)
def test_a_gizmo_dragged_to_no_place_moves_nothing(session: Lab, page: Page, position: tuple[object]) -> None:
    def drag() -> None:
        page.drag("Start")
        page.drag("Move", wxyz=(1.0, 0.0, 0.0, 0.0), position=position)
        page.drag("End")

    before = arm(session).T_world_tool
    drag()
    assert np.allclose(after_ticks(session).T_world_tool, before, atol=1e-9)


def test_a_gizmo_with_no_orientation_moves_nothing(session: Lab, page: Page) -> None:
    before = arm(session).T_world_tool
    page.drag("Start")
    page.drag("Move", wxyz=(0.0, 0.0, 0.0, 0.0), position=(0.5, 0.0, 0.3))
    page.drag("End")
    assert np.allclose(after_ticks(session).T_world_tool, before, atol=1e-9)


def test_an_update_without_a_grasp_moves_nothing(session: Lab, page: Page) -> None:
    pose = {"wxyz": (1.0, 0.0, 0.0, 0.0), "position": (0.5, 0.2, 0.3)}
    assert not moved(session, lambda: page.drag("Move", **pose))


def test_a_drag_whose_end_gets_lost_ends_when_the_pointer_is_let_go(session: Lab, page: Page) -> None:
    page.drag("Start")
    page.drag("Move", wxyz=(1.0, 0.0, 0.0, 0.0), position=(0.5, 0.1, 0.3))
    assert eventually(lambda: arm(session).request.drag is not None)
    page.do(page.page.tell(released=True))
    assert eventually(lambda: arm(session).request.drag is None)
    assert eventually(lambda: arm(session).request.searched)
    command = arm(session).request.command
    page.drag("Move", wxyz=(1.0, 0.0, 0.0, 0.0), position=(0.4, 0.2, 0.3))
    after_ticks(session)
    assert arm(session).request.command is command
    page.drag("Start")
    assert eventually(lambda: arm(session).request.drag is not None)
    stranger = Page(session.server.get_port())
    stranger.do(stranger.page.tell(released=True))
    after_ticks(session, 80)
    stranger.close()
    assert arm(session).request.drag is not None, "another person's pointer"
    page.drag("End")
    assert eventually(lambda: arm(session).request.drag is None)


def test_what_is_taken_hold_of_right_after_a_release_stays_in_the_hand(session: Lab, page: Page) -> None:
    page.do(page.page.tell(released=True))
    page.drag("Start")
    assert eventually(lambda: arm(session).request.drag is not None)
    after_ticks(session, 80)
    assert arm(session).request.drag is not None
    page.drag("End")
    assert eventually(lambda: arm(session).request.drag is None)


@pytest.mark.parametrize("position", [(math.nan, 0.0, 0.3), (math.inf, 0.0, 0.3), (1e6, 0.0, 0.3)])
def test_an_obstacle_dragged_to_no_place_stays(session: Lab, page: Page, position: tuple[object]) -> None:
    page.give("Add sphere", True)
    assert eventually(lambda: len(arm(session).problem.obstacles.radii) == 1)
    before = arm(session).problem.obstacles.ends
    page.drag("Start", "/handles/obstacle 0")
    page.drag("Move", "/handles/obstacle 0", wxyz=(1.0, 0.0, 0.0, 0.0), position=position)
    page.drag("End", "/handles/obstacle 0")
    page.drag("Start", "/handles/obstacle 5")
    page.drag("Start", "/handles/entry")
    after_ticks(session)
    np.testing.assert_array_equal(arm(session).problem.obstacles.ends, before)
    assert eventually(lambda: "Remove sphere 1" in page.made)
    page.give("Sphere 1: radius [mm]", 1e9)
    after_ticks(session)
    np.testing.assert_array_equal(arm(session).problem.obstacles.ends, before)
    page.give("Remove sphere 1", True)
    assert eventually(lambda: not arm(session).problem.obstacles.radii.size)
    del page.made["Remove sphere 1"]


def test_what_is_lit_up_may_go(session: Lab, page: Page) -> None:
    """A plane that is lit up is taken away: the window goes on, and the list no longer offers it."""
    page.give("Highlight", "plane p9 (p9)")
    after_ticks(session)
    assert chosen(session) is None, "there is no such plane"
    session.shared.workcell.tell(gate.add_plane([0.0, 0.0, -1.0, -0.62]))
    assert eventually(lambda: NEW in listed(session))
    page.give("Highlight", NEW)
    assert eventually(lambda: chosen(session) == Selection("plane", 4))
    session.shared.workcell.tell(gate.remove_plane(4))
    assert eventually(lambda: NEW not in listed(session))
    after_ticks(session)
    session.shared.workcell.tell(gate.restore_planes())


NEW = "plane p1 (p1)"


def listed(session: Lab) -> tuple[str, ...]:
    """What the only window offers to light up."""
    return tuple(control(session, "Highlight").options)


def chosen(session: Lab) -> Selection | None:
    (window,) = windows(session)
    return window.view.seat.selected


def test_the_fixed_plane_and_unknown_names_move_nothing(session: Lab, page: Page) -> None:
    pose = {"wxyz": (1.0, 0.0, 0.0, 0.0), "position": (0.5, 0.2, 0.3)}

    def drag() -> None:
        for name in ("/handles/plane 3", "/handles/plane 99", "/nothing", "", "/arm/waist"):
            page.drag("Start", name)
            page.drag("Move", name, **pose)
            page.drag("End", name)
        page.send({"type": "GuiUpdateMessage", "uuid": "no-such-control", "updates": {"value": 3.0}})
        page.send({"type": "CommandTriggerMessage", "uuid": "no-such-command"})

    assert not moved(session, drag)


def test_a_disabled_control_moves_nothing(session: Lab, page: Page) -> None:
    page.give("Park (planes off)", True)
    assert eventually(lambda: arm(session).arm.parked and arm(session).request.command == HoldPosition())
    assert eventually(lambda: control(session, "1 waist").disabled)
    assert not moved(session, lambda: page.give("1 waist", 20.0))
    assert not moved(session, lambda: page.give("Play", True))
    page.give("Ready pose", True)
    assert eventually(lambda: not arm(session).arm.parked and arm(session).request.command == HoldPosition())


def control(session: Lab, label: str) -> Any:
    """The control of the only window with a label."""
    (window,) = windows(session)
    handles = window.client.gui._gui_input_handle_from_uuid.values()
    return next(handle for handle in list(handles) if getattr(handle, "label", "") == label)


def test_a_control_that_a_page_breaks_costs_that_page_one_row(
    session: Lab, page: Page, caplog: pytest.LogCaptureFixture
) -> None:
    """viser writes whatever attribute a message names into its handle."""
    session.shared.workcell.tell(gate.get_ready())
    waist = control(session, "1 waist")
    page.send({"type": "GuiUpdateMessage", "uuid": page.made["1 waist"]["uuid"], "updates": {"props": None}})
    assert eventually(lambda: waist._impl.props is None)
    page.give("2 shoulder", 21.0)
    assert eventually(lambda: abs(math.degrees(arm(session).arm.q[1]) - 21) < 0.1)
    session.shared.workcell.tell(gate.set_joint(1, math.radians(25)))
    assert eventually(lambda: control(session, "2 shoulder").value == 25.0)
    failed = [record for record in caplog.records if "row" in record.getMessage()]
    assert [record.getMessage() for record in failed] == ["A row of a panel failed: Slider."]
    assert failed[0].exc_info is not None


def test_messages_that_viser_does_not_know_end_at_most_their_own_connection(session: Lab) -> None:
    port = session.server.get_port()
    for junk in (b"", b"\xff\xfe junk", msgspec.msgpack.encode({"type": "NoSuchMessage"}), b"x" * 100_000):
        page = Page(port)
        page.do(page.page.socket.send(junk))
        after_ticks(session, 10)
        page.close()
    good = Page(port)
    assert eventually(good.page.may_drive.is_set)
    good.give("1 waist", 12.0)
    assert eventually(lambda: isinstance(arm(session).request.command, MoveToJoints))
    assert eventually(lambda: abs(math.degrees(arm(session).arm.q[0]) - 12) < 0.1)
    good.close()


def test_values_that_viser_cannot_use_cost_one_line_of_the_log_per_kind(
    session: Lab, page: Page, caplog: pytest.LogCaptureFixture
) -> None:
    tell_once()
    for number in range(100):
        for value in ("a\nb" + "9" * number, None):
            page.give("1 waist", value)
    page.give("1 waist", 3.0)
    assert eventually(lambda: abs(math.degrees(arm(session).arm.q[0]) - 3) < 0.1)
    said = [record.getMessage() for record in caplog.records]
    assert len(said) == 2
    assert all("could not be used" in line and "\n" not in line for line in said)
    assert all(record.exc_info is None for record in caplog.records)
