"""HTML on its way to the page: only Markup is taken as HTML, any other string is shown as the text that it is.

Here alone HTML reaches viser.
"""

from __future__ import annotations

import viser
from markupsafe import Markup, escape


def put_html(gui: viser.GuiApi, html: str, visible: bool = True) -> viser.GuiHtmlHandle:
    """Put HTML where the GUI stands."""
    return gui.add_html(str(escape(html)), visible=visible)


def show(handle: viser.GuiHtmlHandle, html: str) -> None:
    """Put other HTML in its place."""
    written = str(escape(html))
    if written != handle.content:
        handle.content = written


def note(words: str) -> Markup:
    """A sentence in small letters."""
    return Markup("<p class='helicoide-note'>{}</p>").format(words)
