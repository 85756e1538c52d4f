"""Send HTML to the page: Markup is sent as HTML, any other string is escaped and shown as text.

No other module passes HTML to viser.
"""

from __future__ import annotations

import viser
from markupsafe import Markup, escape


def put_html(gui: viser.GuiApi, html: str, visible: bool = True) -> viser.GuiHtmlHandle:
    """Add HTML in the current container of the GUI."""
    return gui.add_html(str(escape(html)), visible=visible)


def show(handle: viser.GuiHtmlHandle, html: str) -> None:
    """Replace the HTML of a handle, if it differs."""
    written = str(escape(html))
    if written != handle.content:
        handle.content = written


def note(words: str) -> Markup:
    """A paragraph in small type."""
    return Markup("<p class='helicoide-note'>{}</p>").format(words)
