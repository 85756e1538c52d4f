"""The control loop as a block diagram in SVG; the numbers on its arrows are those of the state."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator
from functools import lru_cache

import numpy as np
from markupsafe import Markup, escape

from helicoide.readout.loop import LoopBlock, SideBlock, control_loop
from helicoide.readout.signals import signals_of
from helicoide.state import State
from helicoide.text import Language, Text, join_texts, significant_text, untranslated
from helicoide.view.window_view import View

# Lengths in units of the drawing, which is as wide as the panel.
WIDTH, LEFT, BLOCK, SIDE_LEFT, SIDE, RETURN = 344, 4, 186, 210, 120, 338
LINE, PADDING, ARROW = 17, 7, 30
CHARACTERS, SIDE_CHARACTERS, DIGITS = 21, 16, 3
TINY = 1e-9  # a value nearer to zero is written as 0
ON_ARROW = {"asked speed": 0}  # the only curve of a signal that is on the arrow; the others are of other places
MIDDLE = LEFT + BLOCK // 4

LOOP = Text(en="Control loop", pt_BR="Malha de controle")
DRAWING = Markup(
    "<figure class='helicoide-chart helicoide-loop'><svg viewBox='0 0 {} {}' role='img' aria-label='{}'>"
    "<defs><marker id='helicoide-tip' viewBox='0 0 8 8' refX='7' refY='4' markerWidth='8' markerHeight='8' "
    "orient='auto-start-reverse'><path d='M0 0L8 4L0 8Z'/></marker></defs>{}</svg></figure>"
)
BOX = Markup("<rect class='box' x='{}' y='{}' width='{}' height='{}' rx='4'/>")
WORDS = Markup("<text x='{}' y='{}' class='{}'>{}</text>")
PATH = Markup("<path class='line' d='{}' marker-end='url(#helicoide-tip)'/>")
SUBSCRIPT = Markup("<tspan dy='3' class='subscript'>{}</tspan><tspan dy='-3'>{}</tspan>")
PRESSED = Markup("<g data-helicoide-press='{}'>{}</g>")


def loop_diagram(view: View) -> Markup:
    """The loop of the arm in the language of the seat."""
    return drawn_loop(view.state, view.seat.language)


@lru_cache(maxsize=8)  # all windows show the same drawing
def drawn_loop(state: State, language: Language) -> Markup:
    """The loop of a state, from top to bottom; the last arrow leads back to the first block."""
    parts: list[Markup] = []
    top = 4
    blocks = control_loop(state)
    first = top + PADDING + LINE // 2
    for block in blocks:
        drawn, bottom = _drawn_block(state, block, top, language)
        parts += drawn
        parts += _arrow(state, block, (top, bottom), first, language)
        top = bottom + _arrow_height(block)
    return DRAWING.format(WIDTH, top + 4, LOOP[language], Markup("").join(parts))


def _arrow_height(block: LoopBlock) -> int:
    """The height of the arrow that leaves a block: a line for each signal."""
    return ARROW if len(block.signals) < 2 else ARROW + (len(block.signals) - 1) * LINE


def _drawn_block(state: State, block: LoopBlock, top: int, language: Language) -> tuple[list[Markup], int]:
    """A block with the blocks at its side, and where its lower edge is."""
    lines = textwrap.wrap(block.title[language], CHARACTERS)
    sides = [(side, _wrapped(side.title[language])) for side in block.sides]
    heights = [PADDING + LINE * (len(words) + len(side.signals)) for side, words in sides]
    height = max(2 * PADDING + LINE * (len(lines) + 1), sum(heights) + 6 * (len(heights) - 1))
    parts = [BOX.format(LEFT, top, BLOCK, height)]
    for i, line in enumerate(lines, 1):
        parts.append(WORDS.format(LEFT + 8, top + i * LINE + 2, "title", line))
    parts.append(WORDS.format(LEFT + 8, top + (len(lines) + 1) * LINE + 2, "equation", _typeset(block.equation)))
    at = top
    for (side, words), tall in zip(sides, heights, strict=True):
        parts += _drawn_side(state, side, words, (at, tall), language)
        at += tall + 6
    return parts, top + height


def _wrapped(title: str) -> list[str]:
    return textwrap.wrap(title, SIDE_CHARACTERS, break_long_words=False)


def _drawn_side(
    state: State, side: SideBlock, words: list[str], place: tuple[int, int], language: Language
) -> Iterator[Markup]:
    """A block at the side, with its numbers inside. place: its upper edge and its height."""
    top, height = place
    yield BOX.format(SIDE_LEFT, top, SIDE, height)
    yield PATH.format(f"M{SIDE_LEFT} {top + height // 2}H{LEFT + BLOCK + 2}")
    for i, line in enumerate(words, 1):
        yield WORDS.format(SIDE_LEFT + 6, top + i * LINE, "equation", line)
    for i, name in enumerate(side.signals, len(words) + 1):
        yield _number(state, name, (SIDE_LEFT + 6, top + i * LINE), language)


def _arrow(state: State, block: LoopBlock, edges: tuple[int, int], first: int, language: Language) -> Iterator[Markup]:
    """The arrow from a block to the next, or back to the first, whose middle is at `first`."""
    _, bottom = edges
    height = _arrow_height(block)
    if block.returns:
        yield PATH.format(f"M{MIDDLE} {bottom}V{bottom + height - 4}H{RETURN}V{first}H{LEFT + BLOCK + 2}")
    else:
        yield PATH.format(f"M{MIDDLE} {bottom}V{bottom + height - 1}")
    yield WORDS.format(MIDDLE - 10, bottom + 19, "symbol", _typeset(block.symbol))
    for i, name in enumerate(block.signals):
        yield _number(state, name, (MIDDLE + 8, bottom + 19 + i * LINE), language)


def _number(state: State, name: str, place: tuple[int, int], language: Language) -> Markup:
    """The symbol of a signal and its values; a click on it does the same as its button."""
    signal = signals_of(state)[name]
    values = signal.read(state)
    if name in ON_ARROW:
        values = values[[ON_ARROW[name]]]
    shown = "–" if np.isnan(values).all() else _values(values, signal.unit)[language]
    named = "" if len(values) > 1 else f"{signal.symbol} = "
    words = WORDS.format(*place, "number", _typeset(named) + shown)
    return PRESSED.format(signal.title[language], words)


def _values(values: np.ndarray, unit: str) -> Text:
    """The value of one curve; of several, the least and the largest."""
    finite = values[np.isfinite(values)]
    few = [finite.min(), finite.max()] if len(finite) > 1 else finite
    said = [significant_text(float(value) if abs(value) > TINY else 0.0, DIGITS) for value in few]
    return untranslated("{said} {unit}").format(said=join_texts(said, " … "), unit=unit)


def _typeset(words: str) -> Markup:
    """Words with letters after an underscore as subscripts."""
    first, *rest = re.split(r"_(\w+)", words)
    lowered = (SUBSCRIPT.format(low, after) for low, after in zip(rest[::2], rest[1::2], strict=True))
    return escape(first) + Markup("").join(lowered)
