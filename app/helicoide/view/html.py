"""HTML on its way to the page: only Markup is taken as HTML, any other string is shown as the text that it is.

Here alone HTML reaches viser, and here alone what another library wrote is taken as Markup. Everywhere else Markup is
made of literals, whose `format` and `join` escape what is filled in.
"""

from __future__ import annotations

from functools import lru_cache
from html import unescape
from xml.etree.ElementTree import Element, SubElement, tostring

import viser
from latex2mathml.converter import convert_to_element
from markdown_it import MarkdownIt
from markupsafe import Markup, escape

_markdown = MarkdownIt("commonmark", {"html": False})


def add(gui: viser.GuiApi, html: str, visible: bool = True) -> viser.GuiHtmlHandle:
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


def markdown(text: str) -> Markup:
    """Markdown as HTML; tags in it are shown as text."""
    return Markup(_markdown.render(text))


@lru_cache(maxsize=256)
def formula(tex: str, index: str = "") -> Markup:
    """A formula as MathML; index: a name that stands below it, as it is."""
    math = convert_to_element(tex)
    for node in math.iter():
        node.text = unescape(node.text or "")  # the library writes its signs as numbers of HTML
    if index:
        below = Element("msub")
        below.extend(math)
        SubElement(below, "mtext").text = index
        math[:] = [below]
    return Markup(tostring(math, encoding="unicode"))
