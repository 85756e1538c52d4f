"""One browser window: its panels in its language, its own layers of the scene, its place in the queue of wishes."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from types import MappingProxyType

import numpy as np
import viser

from helicoide import gate
from helicoide.ik import methods
from helicoide.kinematics.library import titles
from helicoide.kinematics.robot import Robot
from helicoide.readout import status
from helicoide.state import Seat, Update
from helicoide.studies.desk import DeskUpdate
from helicoide.text import LANGUAGES, Language, Text, same
from helicoide.view import bind, layers, panels
from helicoide.view.channel import Control, Notice, introduce
from helicoide.view.layers import Stage
from helicoide.view.page import STOP
from helicoide.view.placed import Placed, place
from helicoide.view.rows import (
    Choice,
    CountMap,
    ForArm,
    ForDesk,
    ForLab,
    ForSeat,
    Play,
    PlayFastest,
    PlayTaught,
    ReadCloud,
    Row,
    Save,
    Tour,
    View,
    Wish,
)
from helicoide.view.scene import outlook
from helicoide.view.shapes import Shape

Client = viser.ClientHandle
LANGUAGE_NAMES: dict[Language, str] = {"en": "English", "pt_BR": "Português (Brasil)"}
PANEL = same("Helicoide")
SEAT_KEY = "helicoide-seat"
ANSWER_WITHIN = 5.0
# On an upright page the panel is a sheet over the lower half: look from farther in front, and below the arm.
UPRIGHT_POSITION, UPRIGHT_LOOK_AT = np.array([1.89, -1.22, 1.18]), np.array([-0.15, -0.06, -0.6])


def seated(token: str, language: Language, lesson: str | None) -> Seat:
    """A new person, with every optional layer shown or not as it says of itself."""
    shows = MappingProxyType({layer.NAME: bool(layer.SHOWN) for layer in layers.optional()})
    return Seat(token=token, language=language, lesson=lesson, shows=shows)


async def remembered(client: Client) -> str | None:
    """The token of the seat that this browser had before; none when it does not answer in time."""
    try:
        return await asyncio.to_thread(client.local_storage.get_item, SEAT_KEY, ANSWER_WITHIN)
    except TimeoutError:
        return None


def remember(client: Client, token: str) -> None:
    """Leave the token of its seat with a browser."""
    client.local_storage.set_item(SEAT_KEY, token)


class Window:
    """A client of viser and the seat in front of it."""

    def __init__(
        self,
        client: Client,
        robot: Robot,
        shapes: list[Shape],
        view: View,
        control: Control,
        post: Callable[[Update], None],
        reseat: Callable[[Seat], None],
        change: Callable[[str], None],
        redesk: Callable[[str, DeskUpdate], None],
        ask: Callable[[Wish], None],
    ) -> None:
        self.client, self.control, self.post, self.reseat, self.change = client, control, post, reseat, change
        self.redesk, self.ask = redesk, ask
        self._stage(robot, shapes, view)
        self._furnish()
        introduce(client, view.seat.token)

    def mount(self, robot: Robot, shapes: list[Shape], view: View) -> None:
        """Put another robot in front of the person: its layers, its rows in every panel, a look at it."""
        self._stage(robot, shapes, view)
        self._fill()

    def clear(self) -> None:
        """Take everything off this window's scene."""
        self.layers.clear()
        self.client.scene.reset()
        self.client.flush()

    def _stage(self, robot: Robot, shapes: list[Shape], view: View) -> None:
        self.robot, self.view = robot, view
        stage = Stage(self.client.scene, robot, shapes, self.act, str(self.client.client_id))
        self.layers = [layer.build(stage) for layer in layers.found() if not layer.SHARED]
        self.drawn: View | None = None
        self._look()

    def _look(self) -> None:
        camera, (position, centre) = self.client.camera, outlook(self.robot)
        if camera.aspect < 1.0:
            centre = centre + self.robot.reach * UPRIGHT_LOOK_AT
            position = centre + self.robot.reach * UPRIGHT_POSITION
        camera.position, camera.look_at = position, centre

    def act(self, wish: Wish) -> None:
        """Hand on what the person wishes."""
        match wish:
            case ForArm(update):
                self.post(update)
            case ForSeat(update):
                self.reseat(update(self.view.seat))
            case ForLab(robot):
                self.change(robot)
            case ForDesk(update):
                self.redesk(self.view.seat.token, update)
            case Save(name, content):
                self.client.send_file_download(name, content)
            case Play() | Tour() | ReadCloud() | CountMap() | PlayTaught() | PlayFastest():
                self.ask(wish)

    def draw(self, view: View) -> None:
        """Bring this window's layers to a view, and let the browser have it now."""
        for layer in self.layers:
            layer.update(self.drawn, view)
        self.drawn = view
        self.client.flush()  # the server's own flush leaves what is sent to one client waiting

    def write(self, view: View) -> None:
        """Bring the words and controls to a view; another language furnishes the window anew."""
        old, self.view = self.view, view
        if old.seat.language != view.seat.language:
            self._furnish()
        for row in (*self.top, *self.placed):
            row.refresh(view)
        said = status(view.state)
        self.control.push(view.seat.token, Notice(view.seat.language, said.text, said.tone))

    def _furnish(self) -> None:
        """Build all panels in the language of the seat."""
        gui, language = self.client.gui, self.view.seat.language
        gui.reset()
        gui.set_panel_label(PANEL[language])
        self.top = place(gui, [_language()], self.view, self.act)
        tabs = gui.add_tab_group()
        self.tabs = [tabs.add_tab(panel.TITLE[language], panel.ICON) for panel in panels.found()]
        self.placed: list[Placed] = []
        self.commands: list[viser.CommandHandle] = []
        self._fill()

    def _fill(self) -> None:
        """Put the rows and commands for this robot in place of those that are there."""
        for row in self.placed:
            row.remove()
        for command in self.commands:
            command.remove()
        self.placed, self.commands = [], [self._command(text, wish) for text, wish in self._wishes()]
        for tab, panel in zip(self.tabs, panels.found(), strict=True):
            with tab:
                self.placed += place(self.client.gui, panel.rows(self.robot), self.view, self.act)

    def _wishes(self) -> Iterator[tuple[Text, Wish]]:
        """The palette: what the panels and the page have as buttons, by name, and every arm."""
        yield STOP, ForArm(gate.stop())
        yield Text(en="Ready", pt_BR="Pronto"), ForArm(gate.get_ready())
        if self.robot.panes:
            yield Text(en="Park", pt_BR="Estacionar"), ForArm(gate.park())
        yield Text(en="Play the path", pt_BR="Iniciar a trajetória"), ForArm(gate.play())
        yield Text(en="Pause the path", pt_BR="Pausar a trajetória"), ForArm(gate.pause())
        for name in methods.names():
            title = methods.named(name).TITLE
            yield (
                Text(en="Method: {title}", pt_BR="Método: {title}").format(title=title),
                ForArm(gate.choose_method(name)),
            )
        for name, title in titles().items():
            yield Text(en="Arm: {title}", pt_BR="Braço: {title}").format(title=title), ForLab(name)

    def _command(self, text: Text, wish: Wish) -> viser.CommandHandle:
        command = self.client.gui.add_command(text[self.view.seat.language])
        bind.on_trigger(command, partial(self.act, wish))
        return command


def _language() -> Row:
    return Choice(
        Text(en="Language · Idioma", pt_BR="Idioma · Language"),
        [(language, same(LANGUAGE_NAMES[language])) for language in LANGUAGES],
        lambda view: view.seat.language,
        lambda key: ForSeat(lambda seat: replace(seat, language="pt_BR" if key == "pt_BR" else "en")),
    )
