"""A window of Firefox or WebKit on a lab, and what a person does in it by hand."""

from __future__ import annotations

import io
from base64 import b64decode
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from PIL import Image
from tests.soak.engines import Ask, opened, until

CONTROL, ENTER, ESCAPE = "\ue009", "\ue007", "\ue00c"
DRAWN = "() => Boolean(window.__viserMutable?.nodeRefFromName['/arm/wrist'])"
# The middle of the first element that fits a selector, and holds this text and no other if any is given; nothing while
# something else covers it.
MIDDLE = """([selector, text]) => {
  const fits = (e) => e.checkVisibility() && (!text || e.textContent.trim() === text);
  const found = [...document.querySelectorAll(selector)].find(fits);
  if (!found) return null;
  found.scrollIntoView({block: 'nearest'});
  const box = found.getBoundingClientRect();
  const [x, y] = [Math.round(box.left + box.width / 2), Math.round(box.top + box.height / 2)];
  return found.contains(document.elementFromPoint(x, y)) ? [x, y] : null;
}"""
FRAMES = 5
NEXT_FRAME = "() => new Promise((drawn) => requestAnimationFrame(() => drawn(true)))"
IN_FRONT = "(name) => document.querySelector('[role=tab][aria-selected=true]').textContent.trim() === name"


@dataclass(frozen=True)
class Window:
    """A page, as it is seen and touched."""

    ask: Ask

    def evaluate(self, function: str, argument: object = None) -> Any:
        """Call a function of JavaScript on the page."""
        return self.ask("ExecuteScript", script=f"return ({function})(...arguments)", args=[argument])

    def text(self, selector: str) -> str:
        """The words of an element that is there."""
        return str(self.evaluate("(selector) => document.querySelector(selector).textContent", selector))

    def picture(self) -> Image.Image:
        """What the window shows."""
        return Image.open(io.BytesIO(b64decode(self.ask("TakeScreenshot")))).convert("RGB")

    def middle(self, selector: str, text: str = "") -> tuple[int, int]:
        """Where an element is, once it stays there while the page is drawn."""
        seen: deque[Any] = deque(maxlen=FRAMES)

        def rests() -> bool:
            seen.append(self.evaluate(MIDDLE, [selector, text]))
            self.evaluate(NEXT_FRAME)
            return seen[-1] is not None and seen.count(seen[-1]) == FRAMES

        until(rests, f"{selector} {text} is there and rests")
        x, y = seen[-1]
        return x, y

    def drag(self, start: tuple[int, int], right: int = 0) -> None:
        """Press the mouse, move it to the right by some pixels, and let go."""
        x, y = start
        path = [
            {"type": "pointerMove", "x": x, "y": y},
            {"type": "pointerDown", "button": 0},
            {"type": "pointerMove", "x": x + right, "y": y},
            {"type": "pointerUp", "button": 0},
        ]
        self.ask("PerformActions", actions=[{"type": "pointer", "id": "mouse", "actions": path}])

    def press(self, selector: str, text: str = "") -> None:
        """Press an element."""
        self.drag(self.middle(selector, text))

    def tab(self, name: str) -> None:
        """Bring a panel to the front; a press that a page misses while its panels unfold is made again."""

        def in_front() -> object:
            self.press("[role=tab]", name)
            return self.evaluate(IN_FRONT, name)

        until(in_front, f"{name} is in front")

    def keys(self, *keys: str) -> None:
        """Press keys together, and let go."""
        path = [{"type": "keyDown", "value": key} for key in keys] + [{"type": "keyUp", "value": key} for key in keys]
        self.ask("PerformActions", actions=[{"type": "key", "id": "keyboard", "actions": path}])

    def fill(self, selector: str, words: str) -> None:
        """Write into a box in place of what it holds."""
        self.press(selector)
        self.keys(CONTROL, "a")
        for key in (*words, ENTER):
            self.keys(key)

    def connected(self) -> None:
        """Wait until the page's own channel is open."""
        until(lambda: self.evaluate("() => document.querySelector('#helicoide-stop[data-link=up]')"), "connected")


@contextmanager
def window(engine: str, port: int, language: str = "en_US") -> Iterator[Window]:
    """Open a window on a port, drawn and connected."""
    with opened(engine, language) as ask:
        page = Window(ask)
        ask("Navigate", url=f"http://127.0.0.1:{port}/")
        until(lambda: page.evaluate(DRAWN), "the arm is in the scene")
        page.connected()
        yield page
