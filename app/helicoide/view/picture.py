"""A picture of the scene, drawn by the browser of a window in its present view."""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager

import imageio.v3
import viser

PATIENCE = 30.0  # s; a page in the background draws nothing
HEAD_BYTES = 1 << 16  # of a picture and of the message around it


def scene_picture(client: viser.ClientHandle, size: tuple[int, int]) -> bytes:
    """The scene as PNG with a transparent background, (width, height) in pixels. It blocks until the page has drawn.

    Raises RuntimeError if the window closes meanwhile, and TimeoutError if its page draws nothing.
    """
    width, height = size
    with _long_messages(client, 4 * width * height + HEAD_BYTES):
        pixels = client.get_render(height, width, transport_format="png", timeout=PATIENCE)
    file = io.BytesIO()
    imageio.v3.imwrite(file, pixels, extension=".png")
    return file.getvalue()


@contextmanager
def _long_messages(client: viser.ClientHandle, size: int) -> Iterator[None]:
    """Accept messages of this size, bytes, from one client: a picture is longer than any other message of a page."""
    connection = client._viser_server._websock_server._live_connections.get(client.client_id)
    if connection is None:
        raise RuntimeError("the window has closed")
    before = connection.protocol.max_message_size
    connection.protocol.max_message_size = size
    try:
        yield
    finally:
        connection.protocol.max_message_size = before
