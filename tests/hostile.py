"""Hostile names, as users or files may give them, in every text of a study; and a parser for the HTML made of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, make_dataclass, replace
from html.parser import HTMLParser
from types import MappingProxyType, SimpleNamespace
from typing import Annotated, Any

import numpy as np

from helicoide.ik.method import OneOf
from helicoide.studies.study import Chart, ChartLine, Figure, Fitted, Result, Row, Statement
from helicoide.text import Text, untranslated

NAMES = (
    "<img src=x onerror=alert(1)>",
    "\"><script>alert('x')</script>",
    "' onmouseover='alert(1)",
    r"}\text{<img src=x onerror=alert(1)>}",
    "{0}",
    "{x.__class__}",
    "&amp;<b>",
    "a\nb <i>",
    "north: wall",
)
HARMLESS = {
    "a", "b", "blockquote", "br", "button", "div", "em", "figcaption", "figure", "h3", "header", "i", "li", "p", "path",
    "polyline", "pre", "rect", "span", "strong", "sub", "svg", "table", "td", "text", "th", "tr", "u", "ul", "math",
    "mfrac", "mi", "mn", "mo", "mover", "mrow", "mspace", "mstyle", "msub", "msubsup", "msup", "mtext", "munder", "ol",
}  # fmt: skip
OUTLINE = {"code", "body", "h1", "h2", "head", "html", "meta", "section", "style", "tbody", "thead", "title"}
AROUND = np.linspace(0, 2 * np.pi, 50)


def renamed(thing: Any, name: str) -> Any:
    """A copy of `thing` in which every Text, at any depth, is that name."""
    if isinstance(thing, Text):
        return untranslated(name)
    if isinstance(thing, Mapping):
        return MappingProxyType({key: renamed(value, name) for key, value in thing.items()})
    if isinstance(thing, tuple):
        return tuple(renamed(part, name) for part in thing)
    if is_dataclass(thing) and not isinstance(thing, type):
        return replace(thing, **{each.name: renamed(getattr(thing, each.name), name) for each in fields(thing)})
    return thing


def study_named(name: str) -> Any:
    """A study and its option, with that name as every text."""
    way = Annotated[str, OneOf(untranslated(name), {name: untranslated(name), "other": untranslated("other")})]
    options = make_dataclass("Options", [("way", way, name)], frozen=True)
    return SimpleNamespace(TITLE=untranslated(name), ABOUT=untranslated(name), SOURCE=name, ROBOT=name, Options=options)


def result_named(name: str) -> Result:
    """A row and a chart of each kind, with that name as every text."""
    said, chosen = Statement(untranslated(name), name, 1.0), Fitted(untranslated(name), 1.0, 0.5, 1.5, name)
    row = Row(untranslated(name), 1.0, name, said, (chosen,))
    rows = (
        row,
        replace(row, computed=2.0, erratum=name),
        replace(row, computed=2.0, why=untranslated(name)),
        Row(untranslated(name), 1.0),
    )
    lines = (
        ChartLine(untranslated(name), AROUND, np.sin(AROUND)),
        ChartLine(untranslated(name), np.cos(AROUND), np.sin(AROUND)),
    )
    charts = [Chart(untranslated(name), untranslated(name), untranslated(name), (line,)) for line in lines]
    return Result((*rows, replace(row, source=Figure(name))), tuple(charts))


class Page(HTMLParser):
    """What a browser reads in HTML: its tags, the names of their attributes, and its text."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.tags: set[str] = set()
        self.attributes: set[str] = set()
        self.text = ""
        self.feed(str(html))
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        self.attributes |= {name for name, _ in attrs}
        self.text += "".join(f" {value} " for name, value in attrs if name == "aria-label")

    @property
    def active(self) -> set[str]:
        """The attributes that load or run something."""
        return {name for name in self.attributes if name == "src" or name.startswith("on")}

    def handle_data(self, data: str) -> None:
        self.text += data
