"""The page about the sources: their errors, what they leave open, and what was chosen; one page in each language."""

from __future__ import annotations

from functools import cache

from markupsafe import Markup

from helicoide import content
from helicoide.markup import markdown
from helicoide.text import Language


@cache
def page(language: Language) -> Markup:
    """The page as HTML; an erratum such as "vargas-2" is its anchor."""
    return markdown((content.STATIC / "pages" / language / "sources.md").read_text("utf-8"))
