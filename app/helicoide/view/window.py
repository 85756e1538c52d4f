"""One browser window: its panels, in the language of its seat, and its own layers of the scene."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from functools import partial
from itertools import chain
from time import monotonic, perf_counter
from types import MappingProxyType

import numpy as np
import viser
from viser._messages import GuiUpdateMessage, SetOrientationMessage, SetPositionMessage

from helicoide.arrays import Array
from helicoide.kinematics.robot import Robot
from helicoide.lesson import entered
from helicoide.seat import LinkedPosture, Seat
from helicoide.text import Language, Text, untranslated
from helicoide.view import bind, layers, panels
from helicoide.view.camera import camera_pose
from helicoide.view.channel import share_link, show_tab
from helicoide.view.docked import DockedLesson
from helicoide.view.layers import Layers, Stage
from helicoide.view.link import Link
from helicoide.view.open_step import step_camera
from helicoide.view.palette import palette
from helicoide.view.placed_rows import WindowRow, place_rows
from helicoide.view.requests import CopyLink, Look, PageRequest, ShowTab
from helicoide.view.scene import outlook
from helicoide.view.serve import set_theme
from helicoide.view.shapes import Shape
from helicoide.view.share import SharedView, encode_link
from helicoide.view.top_rows import top_rows
from helicoide.view.uploads import Uploads
from helicoide.view.window_view import View

Client = viser.ClientHandle
PANEL = untranslated("Helicoide")
LATE = Text(
    en="The command arrived more than a second late and was ignored: the computer or the network is slow. Please try "
    "again.",
    pt_BR="O comando chegou com mais de um segundo de atraso e foi ignorado: o computador ou a rede está lento. Tente "
    "de novo.",
)
COPIED = Text(
    en="The address of this page now shows this view. Where the browser allows it, it is on the clipboard too.",
    pt_BR="O endereço desta página agora mostra esta vista. Onde o navegador permite, ele também foi copiado.",
)
TOLD_FOR = 10.0
AT_A_TIME = 0.004  # s of writing rows, after which other tasks get a turn
# s that a browser needs to clear a scene: a node that is removed and added in one message keeps its old pose
CLEARED = 0.15
# Scale of handles and lines on a projector; the style sheet enlarges text and panel.
WEIGHT = 1.6


def new_seat(token: str, language: Language, lesson: str | None, projector: bool = False, dark: bool = False) -> Seat:
    """A new seat; each optional layer is shown or hidden by its own default."""
    shows = MappingProxyType({layer.NAME: bool(layer.SHOWN) for layer in layers.optional()})
    seat = Seat(token=token, language=language, visible_layers=shows, projector=projector, dark=dark)
    return entered(seat, lesson)


def preload(robot: Robot) -> None:
    """Import all layers and panels, which takes most of the first window's time; from any thread."""
    layers.all_layers()
    for panel in panels.all_panels():
        panel.rows(robot)


class Window:
    """A client of viser and its seat.

    Panels are built and updated row by row, so that other tasks of the event loop run in between.
    """

    def __init__(self, client: Client, link: Link, view: View, hand_on: Callable[[Window, PageRequest], None]) -> None:
        self.client, self.link, self.view, self.hand_on = client, link, view, hand_on
        self.written: View | None = None
        self.layers: Layers | None = None
        self.placed: list[list[WindowRow]] = []
        self.tab: int | None = None
        self.robot = view.state.robot  # the robot of the rows
        self.top: list[WindowRow] = []
        self.commands: list[viser.CommandHandle] = []
        self.gone = False
        self.shapes: list[Shape] = []
        self.weight = 1.0
        self.panel_language, self.dark = view.seat.language, view.seat.dark  # of the panels, and of the page
        self.looks_at: Robot | None = None
        self.told_late = -TOLD_FOR
        self.uploads = Uploads(client, self.tell)
        self._busy = asyncio.Lock()

    def leave(self) -> None:
        """Mark the page as closed and end its uploads."""
        self.gone = True
        self.uploads.close()

    def tell(self, text: Text) -> None:
        """Show a notification in this window alone."""
        self.client.add_notification(PANEL[self.language], text[self.language], auto_close_seconds=TOLD_FOR)

    def tell_late(self) -> None:
        """Say that an action arrived too late; at most once in `TOLD_FOR` seconds, since a drag is many messages."""
        if monotonic() - self.told_late >= TOLD_FOR:
            self.told_late = monotonic()
            self.tell(LATE)

    @property
    def language(self) -> Language:
        """The language of the seat."""
        return self.view.seat.language

    def act(self, request: PageRequest) -> None:
        """Pass a request on. The page is then written again, whether or not the request is granted."""
        match request:
            case ShowTab(index):
                show_tab(self.client, index)
            case Look(preset):
                camera = self.client.camera
                self.look(*camera_pose(preset, self.view.state, camera.fov, camera.aspect))
            case CopyLink():
                share_link(self.client, encode_link(self._shared()))
                self.tell(COPIED)
            case _:
                self.written = None
                self.hand_on(self, request)

    def _shared(self) -> SharedView:
        """What a link to this window shows."""
        state, camera = self.view.state, self.client.camera
        posture = LinkedPosture(state.robot.name, tuple(state.arm.q.tolist()))
        looks = np.array(camera.position), np.array(camera.look_at)
        return SharedView(posture, looks, self.tab or 0, self.view.seat.sheet)

    def look(self, position: Array, target: Array) -> None:
        """Move the camera of this window to a position, and turn it to a target, (3,) m each."""
        self.client.camera.position, self.client.camera.look_at = position, target

    def stage(self, view: View, shapes: list[Shape]) -> None:
        """Add this window's own layers for the arm of a view, and point the camera at a new arm."""
        self.view, robot = view, view.state.robot
        who = str(self.client.client_id)
        self.shapes, self.weight = shapes, _weight(view.seat)
        self.layers = Layers(Stage(self.client.scene, robot, shapes, self.act, who, self.weight), shared=False)
        if self.looks_at is not robot:
            self.looks_at = robot
            self._look_first(view)

    def _look_first(self, view: View) -> None:
        """Look at a new arm, from where the open step of a lesson shows it if it says so."""
        camera, preset = self.client.camera, step_camera(view)
        if preset is None:
            self.look(*outlook(view.state.robot, upright=camera.aspect < 1.0))
        else:
            self.look(*camera_pose(preset, view.state, camera.fov, camera.aspect))

    async def _restage(self, view: View) -> None:
        """Replace this window's own layers by larger or smaller ones."""
        self.clear()
        self.client.flush()
        await asyncio.sleep(CLEARED)
        if self.layers is None and not self.gone and view.state.robot is self.looks_at:
            self.stage(view, self.shapes)
            self.draw(view)

    def clear(self) -> None:
        """Remove everything from this window's scene."""
        self.layers = None
        self.client.scene.reset()

    def draw(self, view: View) -> None:
        """Update this window's layers to a view."""
        if self.layers is not None:
            with self.client.atomic():
                self.layers.update(view)

    async def furnish(self, view: View) -> None:
        """Build all panels, in the language of the seat."""
        async with self._busy:
            self.view = view
            gui, language = self.client.gui, view.seat.language
            gui.reset()
            self.panel_language, self.dark = language, view.seat.dark
            set_theme(gui, self.dark)
            gui.set_panel_label(PANEL[language])
            self.placed, self.commands = [], []
            self.top = place_rows(gui, top_rows(), view, self.act)
            self.docked = DockedLesson(gui, self.act)
            tabs = gui.add_tab_group()
            self.tabs = [tabs.add_tab(panel.TITLE[language], panel.ICON) for panel in panels.all_panels()]
            await self._fill(view)

    async def fill(self, view: View) -> None:
        """Replace the rows and commands by those for the arm of a view."""
        async with self._busy:
            for row in chain.from_iterable(self.placed):
                row.remove()
            for command in self.commands:
                command.remove()
            await self._fill(view)

    async def _fill(self, view: View) -> None:
        robot = self.robot = view.state.robot
        self.view, self.written = view, None
        self.placed, self.commands = [], [self._command(text, request) for text, request in palette(robot)]
        for tab, panel in zip(self.tabs, panels.all_panels(), strict=True):
            self.placed.append([])
            for row in panel.rows(robot):
                if self.gone:
                    return
                with tab:
                    self.placed[-1] += place_rows(self.client.gui, [row], view, self.act)
                await asyncio.sleep(0)

    async def write(self, view: View) -> float:
        """Update the rows to a view if it has changed. In another language all panels are built again.

        Returns the time that this took, s, without the time of other tasks in between.
        """
        if (
            self._busy.locked()
            or self.gone
            or view.state.robot is not self.robot
            or (self.written is not None and _same(self.written, view))
        ):
            return 0.0
        if self.panel_language != view.seat.language:
            await self.furnish(view)
        if self.dark != view.seat.dark:
            self.dark = view.seat.dark
            set_theme(self.client.gui, self.dark)
        if self.layers is not None and self.weight != _weight(view.seat):
            await self._restage(view)
        self.view = self.written = view
        took, began = 0.0, perf_counter()
        self.docked.show(view)
        for row in (*self.top, *self._in_front()):
            if self.view is not view or self._busy.locked() or self.gone:  # superseded
                break
            with self.client.atomic():
                row.refresh(view)
            if (since := perf_counter() - began) > AT_A_TIME:
                await asyncio.sleep(0)
                took, began = took + since, perf_counter()
        return took + perf_counter() - began

    def _in_front(self) -> list[WindowRow]:
        """The rows of the tab in front, or of all tabs until the page has said which one is in front."""
        known = self.tab is not None and 0 <= self.tab < len(self.placed)
        return self.placed[self.tab or 0] if known else [*chain.from_iterable(self.placed)]

    def restore(self) -> None:
        """Send every handle's pose and every control's value again: a rejected action may have changed them."""
        for name, gizmo in self.client.scene._handle_from_transform_controls_name.items():
            x, y, z = map(float, gizmo.position)
            self.client.scene._queue_scene_message(SetPositionMessage(name, (x, y, z)))
            w, x, y, z = map(float, gizmo.wxyz)
            self.client.scene._queue_scene_message(SetOrientationMessage(name, (w, x, y, z)))
        for uuid, control in self.client.gui._gui_input_handle_from_uuid.items():
            if not control._impl.is_button:
                message = GuiUpdateMessage(uuid, {"value": control.value})
                self.client.gui._websock_interface.queue_message(message)
        self.written = None

    def _command(self, text: Text, request: PageRequest) -> viser.CommandHandle:
        command = self.client.gui.add_command(text[self.view.seat.language])
        bind.on_trigger(command, partial(self.act, request))
        return command


def _weight(seat: Seat) -> float:
    return WEIGHT if seat.projector else 1.0


def _same(old: View, new: View) -> bool:
    """Whether two views of a window are the same."""
    return (
        old.state is new.state
        and old.seat is new.seat
        and old.study_panel is new.study_panel
        and old.history is new.history
        and old.recordings is new.recordings
        and old.line_check is new.line_check
    ) and (old.ready, old.own, old.recorder) == (new.ready, new.own, new.recorder)
