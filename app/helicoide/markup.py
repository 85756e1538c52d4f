"""HTML from Markdown and TeX.

Only this module makes Markup from text that is not a literal. Everywhere else Markup is made from literals, whose
`format` and `join` escape their arguments.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache
from html import escape, unescape
from types import MappingProxyType
from typing import Any
from xml.etree.ElementTree import Element, SubElement, tostring

from latex2mathml.converter import convert_to_element
from markdown_it import MarkdownIt
from markdown_it.renderer import RendererHTML
from markdown_it.token import Token
from markupsafe import Markup
from markupsafe import escape as escape_markup
from mdit_py_plugins.dollarmath import dollarmath_plugin

SVG = '<svg xmlns="http://www.w3.org/2000/svg"'  # start of a drawing; only a separate file needs the namespace
PLACEHOLDER = re.compile(r"\{([a-z][a-z0-9_]*)\}")
ACTION = re.compile(r"[a-z]+:[a-z0-9_]+")  # the target of a link that does something, such as layer:twist
_markdown = MarkdownIt("commonmark", {"html": False}).enable("table")
_prose = MarkdownIt("commonmark", {"html": False}).enable("table")


def markdown_to_html(text: str, drawings: Mapping[str, str] = MappingProxyType({})) -> Markup:
    """Markdown as HTML, with tags escaped. The anchor of a heading is its text up to a colon, such as "vargas-2".

    drawings: SVG by name; an image with that name is replaced by the SVG itself, which has the colour of the text.
    """
    return Markup(_markdown.render(text, {"drawings": drawings}))


@lru_cache(maxsize=1024)
def prose_to_html(text: str, pictures: tuple[tuple[str, str], ...] = (), inline: bool = False) -> tuple[Markup, ...]:
    """The Markdown of a lesson as HTML and names of placeholders, in turn: HTML, name, HTML, …

    `$…$` is a formula; a link to `layer:twist` or the like is a button with that as its `data-go`. pictures: SVG or
    data URLs by name; inline: without a paragraph around it.
    """
    env = {"drawings": dict(pictures)}
    written = _prose.renderInline(text, env) if inline else _prose.render(text, env)
    return tuple(map(Markup, PLACEHOLDER.split(written)))


def _formula(tex: str, options: Mapping[str, Any]) -> str:
    return str(formula_to_mathml(tex))


def _link_opens(renderer: RendererHTML, tokens: Sequence[Token], at: int, options: Any, env: Any) -> str:
    target = str(tokens[at].attrs["href"])
    if ACTION.fullmatch(target):
        return f'<button type="button" class="helicoide-go" data-go="{target}">'
    tokens[at].attrSet("target", "_blank")
    tokens[at].attrSet("rel", "noopener")
    return renderer.renderToken(tokens, at, options, env)


def _link_closes(renderer: RendererHTML, tokens: Sequence[Token], at: int, options: Any, env: Any) -> str:
    opening = next(token for token in reversed(tokens[:at]) if token.type == "link_open")
    return "</button>" if ACTION.fullmatch(str(opening.attrs["href"])) else "</a>"


def _heading(renderer: RendererHTML, tokens: Sequence[Token], at: int, options: Any, env: Any) -> str:
    name = tokens[at + 1].content.partition(":")[0]
    tokens[at].attrSet("id", name.lower().replace(" ", "-"))
    return renderer.renderToken(tokens, at, options, env)


def _image(renderer: RendererHTML, tokens: Sequence[Token], at: int, options: Any, env: Any) -> str:
    drawing = env["drawings"].get(tokens[at].attrs["src"])
    if drawing is None:
        return renderer.image(tokens, at, options, env)
    if drawing.startswith("data:"):
        tokens[at].attrSet("src", drawing)
        return renderer.image(tokens, at, options, env)
    return str(drawing).replace(SVG, f'<svg role="img" aria-label="{escape(tokens[at].content)}"', 1)


_markdown.add_render_rule("heading_open", _heading)
_markdown.add_render_rule("image", _image)
_prose.use(dollarmath_plugin, renderer=_formula)
_prose.add_render_rule("image", _image)
_prose.add_render_rule("link_open", _link_opens)
_prose.add_render_rule("link_close", _link_closes)


# A letter and its index, not a name such as dt_max.
_SYMBOL = re.compile(r"(?<!\w)(\w)_([A-Za-z0-9]{1,3})(?![A-Za-z0-9_])")
_UNICODE_SUBSCRIPTS = dict(zip("0123456789aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", strict=True))


def typeset(words: str) -> Markup:
    """Words with the index of each symbol as a subscript: e_p becomes e<sub>p</sub>."""
    plain, *parts = _SYMBOL.split(words)
    symbol = Markup("{}<sub>{}</sub>{}")
    return escape_markup(plain) + Markup("").join(symbol.format(*parts[i : i + 3]) for i in range(0, len(parts), 3))


def plain_subscripts(words: str) -> str:
    """The same where HTML cannot be: e_p becomes eₚ. Words with an index that Unicode cannot lower stay as they are."""
    if any(letter not in _UNICODE_SUBSCRIPTS for _, index in _SYMBOL.findall(words) for letter in index):
        return words
    return _SYMBOL.sub(lambda found: found[1] + "".join(map(_UNICODE_SUBSCRIPTS.__getitem__, found[2])), words)


@lru_cache(maxsize=256)
def formula_to_mathml(tex: str, index: str = "") -> Markup:
    """A formula as MathML; index: a subscript written as plain text."""
    math = convert_to_element(tex)
    for node in math.iter():
        node.text = unescape(node.text or "")  # the library writes symbols as HTML character references
    if index:
        below = Element("msub")
        below.extend(math)
        SubElement(below, "mtext").text = index
        math[:] = [below]
    return Markup(tostring(math, encoding="unicode"))
