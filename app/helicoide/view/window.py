"""One browser window: its panels in its language, its own layers of the scene, its place in the queue of wishes."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from types import MappingProxyType

import viser

from helicoide import gate
from helicoide.kinematics.robot import Robot
from helicoide.readout import status
from helicoide.state import Seat, Update
from helicoide.text import LANGUAGES, Language, Text, same
from helicoide.view import bind, layers, panels
from helicoide.view.channel import Control, Notice, introduce
from helicoide.view.layers import Stage
from helicoide.view.page import STOP
from helicoide.view.placed import Placed, place
from helicoide.view.rows import Choice, ForArm, ForSeat, Row, View, Wish
from helicoide.view.shapes import Shape

Client = viser.ClientHandle
LANGUAGE_NAMES: dict[Language, str] = {"en": "English", "pt_BR": "Português (Brasil)"}
PANEL = same("Helicoide")
SEAT_KEY = "helicoide-seat"
ANSWER_WITHIN = 5.0
UPRIGHT_POSITION, UPRIGHT_LOOK_AT = (1.95, -1.05, 0.75), (0.4, -0.05, -0.22)


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
    ) -> None:
        self.client, self.robot, self.control, self.post, self.reseat = client, robot, control, post, reseat
        self.view = view
        self.placed: list[Placed] = []
        stage = Stage(client.scene, robot, shapes, self.act, str(client.client_id))
        self.layers = [layer.build(stage) for layer in layers.found() if not layer.SHARED]
        self.drawn: View | None = None
        if client.camera.aspect < 1.0:  # upright: the panel is a sheet over the lower half
            client.camera.position = UPRIGHT_POSITION
            client.camera.look_at = UPRIGHT_LOOK_AT
        self._furnish()
        introduce(client, view.seat.token)

    def act(self, wish: Wish) -> None:
        """Hand on what the person wishes."""
        match wish:
            case ForArm(update):
                self.post(update)
            case ForSeat(update):
                self.reseat(update(self.view.seat))

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
        for row in self.placed:
            row.refresh(view)
        said = status(view.state)
        self.control.push(view.seat.token, Notice(view.seat.language, said.text, said.tone))

    def _furnish(self) -> None:
        """Build all panels in the language of the seat."""
        gui, language = self.client.gui, self.view.seat.language
        gui.reset()
        gui.set_panel_label(PANEL[language])
        self.placed = list(place(gui, iter([_language()]), self.view, self.act))
        tabs = gui.add_tab_group()
        for panel in panels.found():
            with tabs.add_tab(panel.TITLE[language], panel.ICON):
                self.placed += place(gui, iter(panel.rows(self.robot)), self.view, self.act)
        self._commands(language)

    def _post(self, update: Callable[[], Update]) -> None:
        self.post(update())

    def _commands(self, language: Language) -> None:
        """The palette: what the panels and the page have as buttons, by name."""
        for text, update in (
            (STOP, gate.stop),
            (Text(en="Ready", pt_BR="Pronto"), gate.get_ready),
            (Text(en="Park", pt_BR="Estacionar"), gate.park),
            (Text(en="Play the path", pt_BR="Iniciar a trajetória"), gate.play),
            (Text(en="Pause the path", pt_BR="Pausar a trajetória"), gate.pause),
        ):
            command = self.client.gui.add_command(text[language])
            bind.on_trigger(command, partial(self._post, update))


def _language() -> Row:
    return Choice(
        Text(en="Language · Idioma", pt_BR="Idioma · Language"),
        [(language, same(LANGUAGE_NAMES[language])) for language in LANGUAGES],
        lambda view: view.seat.language,
        lambda key: ForSeat(lambda seat: replace(seat, language="pt_BR" if key == "pt_BR" else "en")),
    )
