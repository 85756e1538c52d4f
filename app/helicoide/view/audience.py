"""The clients that show one workcell: messages of their common scene go to all of them, and to no other client."""

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
    """Some clients of a server, and one scene that they share.

    viser has scenes for all clients and for one client only. This class takes the place of the client and of its
    connection, sends each message to its own clients, and keeps messages for clients that come later.
    """

    client_id = ""

    def __init__(self, server: Server) -> None:
        self._viser_server = server
        self._websock_connection = self
        self.clients: list[Client] = []
        self._said = AsyncMessageBuffer(server.get_event_loop(), persistent_messages=True)
        self._said.atomic_start()  # nothing reads this buffer live; otherwise each message would wake the event loop
        self.scene = viser.SceneApi(cast(Any, self), server._thread_executor, server.get_event_loop())
        self.scene.world_axes.visible = False

    def register_handler(self, kind: type[Message], callback: object) -> None:
        """Ignored: a common scene has no input. Handles are in the scene of each window."""

    def get_message_buffer(self) -> AsyncMessageBuffer:
        """The messages so far, without those that later ones replace."""
        return self._said

    def queue_message(self, message: Message) -> None:
        """Send a message to all clients, and keep it for those that come later."""
        self._said.push(message)
        for client in self.clients:
            client._websock_connection.queue_message(message)

    def enter(self, client: Client) -> None:
        """Add a client, and send it the current scene."""
        with client.atomic():
            for message in tuple(self._said.message_from_id.values()):
                client._websock_connection.queue_message(message)
        self.clients.append(client)

    def leave(self, client: Client, shown: bool) -> None:
        """Remove a client. shown: its page is still open, so the common scene is removed from it."""
        self.clients.remove(client)
        for name in self._roots() if shown else ():
            message = RemoveSceneNodeMessage(name)
            client._websock_connection.queue_message(message)

    def _roots(self) -> list[str]:
        return [name for name in self.scene._handle_from_node_name if name.count("/") == 1]

    @contextmanager
    def atomic(self) -> Iterator[None]:
        """Send the messages of this block to each client as one update."""
        with ExitStack() as held:
            for client in self.clients:
                held.enter_context(client.atomic())
            yield
