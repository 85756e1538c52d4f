"""A picture of the scene, drawn by the browser of a window in its present view."""

from __future__ import annotations

import io

import imageio.v3
import viser

PATIENCE = 30.0  # s; a page in the background draws nothing


def scene_picture(client: viser.ClientHandle, size: tuple[int, int]) -> bytes:
    """The scene as PNG with a transparent background, (width, height) in pixels. It blocks until the page has drawn.

    Raises RuntimeError if the window closes meanwhile, and TimeoutError if its page draws nothing.
    """
    width, height = size
    pixels = client.get_render(height, width, transport_format="png", timeout=PATIENCE)
    file = io.BytesIO()
    imageio.v3.imwrite(file, pixels, extension=".png")
    return file.getvalue()
