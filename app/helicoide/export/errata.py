"""The pages of text in each language, and that about the sources: their errors, and what they leave open."""

from __future__ import annotations

from functools import cache

from markupsafe import Markup

from helicoide import content
from helicoide.markup import markdown_to_html
from helicoide.text import Language


@cache
def text_page(name: str, language: Language) -> Markup:
    """The page static/pages/<language>/<name>.md as HTML with its drawings; its headings are anchors."""
    pages = content.STATIC / "pages"
    drawings = {file.name: file.read_text("utf-8") for file in (pages / "drawings").glob("*.svg")}
    return markdown_to_html((pages / language / f"{name}.md").read_text("utf-8"), drawings)


def sources_page(language: Language) -> Markup:
    """The page about the sources as HTML; each erratum, such as "vargas-2", is an anchor."""
    return text_page("sources", language)
