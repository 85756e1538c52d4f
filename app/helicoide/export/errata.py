"""The page about the sources: their errors, what they leave open, and what was chosen, in each language."""

from __future__ import annotations

from functools import cache

from markupsafe import Markup

from helicoide import content
from helicoide.markup import markdown_to_html
from helicoide.text import Language


@cache
def sources_page(language: Language) -> Markup:
    """The page as HTML with its drawings; each erratum, such as "vargas-2", is an anchor."""
    pages = content.STATIC / "pages"
    drawings = {file.name: file.read_text("utf-8") for file in (pages / "drawings").glob("*.svg")}
    return markdown_to_html((pages / language / "sources.md").read_text("utf-8"), drawings)
