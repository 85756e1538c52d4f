"""The windows in front of one workcell: what is put into their common scene goes to each of them, and to no other."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Any, cast

import viser
from viser._messages import Message, RemoveSceneNodeMessage
from viser.infra._async_message_buffer import AsyncMessageBuffer

Client = viser.ClientHandle
Server = viser.ViserServer


class Audience:
    """Some clients of a server, and a scene for all of them.

    viser knows scenes of all clients and of one. To the scene of an audience this is the connection of a client that
    owns what all clients own, and so its messages are those of a scene of all; they are kept for whoever comes later.
    """

    client_id = ""

    def __init__(self, server: Server) -> None:
        self._viser_server = server
        self._websock_connection = self
        self.clients: list[Client] = []
        self._said = AsyncMessageBuffer(server.get_event_loop(), persistent_messages=True)
        self._said.atomic_start()  # nobody waits for it: each message would wake the event loop else
        self.scene = viser.SceneApi(cast(Any, self), server._thread_executor, server.get_event_loop())
        self.scene.world_axes.visible = False

    def register_handler(self, kind: type[Message], callback: object) -> None:
        """Nobody answers to a common scene: what a hand holds is in the scene of its own window."""

    def get_message_buffer(self) -> AsyncMessageBuffer:
        """What has been said, without what is outdated."""
        return self._said

    def queue_message(self, message: Message) -> None:
        """Say something to everybody, and to whoever comes later."""
        self._said.push(message)
        for client in self.clients:
            client._websock_connection.queue_message(message)

    def enter(self, client: Client) -> None:
        """One more client, who is shown what the others see."""
        with client.atomic():
            for message in tuple(self._said.message_from_id.values()):
                client._websock_connection.queue_message(message)
        self.clients.append(client)

    def leave(self, client: Client, shown: bool) -> None:
        """A client is shown no more; what it sees is taken away where it still shows anything."""
        self.clients.remove(client)
        for name in self._roots() if shown else ():
            message = RemoveSceneNodeMessage(name)
            client._websock_connection.queue_message(message)

    def _roots(self) -> list[str]:
        return [name for name in self.scene._handle_from_node_name if name.count("/") == 1]

    @contextmanager
    def atomic(self) -> Iterator[None]:
        """What is said meanwhile reaches each client in one piece."""
        with ExitStack() as held:
            for client in self.clients:
                held.enter_context(client.atomic())
            yield
