"""Links of the prose that do something: `[text](layer:twist)` shows a layer, `[text](lesson:id)` begins a lesson."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal, get_args

LinkKind = Literal["layer", "sheet", "study", "tab", "lesson"]
LINK = re.compile(r"(?<!!)\[[^\]]+\]\(([^)\s]+)\)")


@dataclass(frozen=True)
class ProseLink:
    """What a link does: kind and name of what it shows or opens."""

    kind: LinkKind
    name: str


def parsed_link(target: str) -> ProseLink | None:
    """The link with a target such as "layer:twist"; None for another address."""
    kind, colon, name = target.partition(":")
    return ProseLink(kind, name) if colon and kind in get_args(LinkKind) else None  # type: ignore[arg-type]


def link_targets(text: str) -> list[str]:
    """The targets of all links in a text, pictures not among them."""
    return LINK.findall(text)
