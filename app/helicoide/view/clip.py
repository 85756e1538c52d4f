"""A clip of the scene: one HTML file with viser's page and the recorded scene, which needs no network."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any, cast

import viser
from viser._messages import TransformControlsMessage
from viser.infra import Message, StateSerializer, WebsockMessageHandler
from viser.infra._async_message_buffer import AsyncMessageBuffer

from helicoide.arrays import Array
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.view.layers import Layers, Stage
from helicoide.view.page import TITLES
from helicoide.view.scene import Scene, light_scene
from helicoide.view.shapes import load_shapes
from helicoide.view.window_view import View

LAST = 0.5  # s that the last frame stays, before the clip begins again


class MessageRecording(WebsockMessageHandler):
    """A scene whose messages are recorded. It takes the place of a client of viser, as `Audience` does.

    Handles are left out: in a clip nothing answers to them.
    """

    client_id = ""

    def __init__(self, server: viser.ViserServer) -> None:
        super().__init__()
        self._viser_server = server
        self._websock_connection = self
        self._handles: tuple[str, ...] = ()
        self._said = AsyncMessageBuffer(server.get_event_loop(), persistent_messages=True)
        self._said.atomic_start()  # nothing reads this buffer
        self.serializer: StateSerializer = self.get_message_serializer(
            lambda message: message.include_in_scene_serialization
        )
        self.scene = viser.SceneApi(cast(Any, self), server._thread_executor, server.get_event_loop())
        self.camera = viser.InitialCameraConfig(self.queue_message)

    def get_message_buffer(self) -> AsyncMessageBuffer:
        """Unused by a recording, but asked for when a node is replaced."""
        return self._said

    def queue_message(self, message: Message) -> None:
        """Record a message, unless it is about a handle."""
        if isinstance(message, TransformControlsMessage):
            self._handles = (*self._handles, message.name)
        if not str(getattr(message, "name", "")).startswith(self._handles):
            self.serializer._insert_message(message)


def clip_html(server: viser.ViserServer, states: Sequence[State], seat: Seat, camera: tuple[Array, Array]) -> bytes:
    """The states of one robot in turn, at the speed of their times, as one HTML file.

    seat: whose layers are shown; camera: position and target of the first view, (3,) m each. It takes about a second:
    call it in a thread.
    """
    robot, recording = states[0].robot, MessageRecording(server)
    shapes = load_shapes(robot)
    light_scene(recording.scene)
    recording.camera.position, recording.camera.look_at = camera
    shared = Scene(recording.scene, robot, shapes)
    own = Layers(Stage(recording.scene, robot, shapes, lambda request: None, ""), shared=False)
    for state, seconds in zip(states, _durations(states), strict=True):
        view = View(state, seat)
        shared.update(view)
        own.update(view)
        recording.serializer.insert_sleep(seconds)
    return recording.serializer.as_html().replace(*TITLES, 1).encode()


def _durations(states: Sequence[State]) -> Iterator[float]:
    """How long each state is shown, s."""
    yield from (after.t - before.t for before, after in pairwise(states))
    yield LAST
