"""Filter the log: errors caused by other programs are dropped, and each kind of failure is logged once."""

from __future__ import annotations

import logging
import traceback
from pathlib import Path

from websockets.exceptions import ConnectionClosed, InvalidHandshake

OURS = str(Path(__file__).parents[1])
UNUSABLE = "a message from a page could not be used: %s: %.200r (%s, line %d)"


class Once(logging.Filter):
    """Drops errors that other programs cause, and errors that were logged before.

    Other programs may send something that is not HTTP, leave a connection unused, or disconnect at any time. A message
    that viser cannot use becomes one line; a traceback through our own code is kept.
    """

    def __init__(self) -> None:
        super().__init__()
        self.told: set[tuple[str, type[BaseException], str, int | None]] = set()

    def filter(self, record: logging.LogRecord) -> bool:
        """Whether a record is logged."""
        error = record.exc_info[1] if record.exc_info else None
        if error is None:
            return True
        if isinstance(error, (InvalidHandshake, ConnectionClosed)):
            return False
        frames = traceback.extract_tb(error.__traceback__)
        where = frames[-1] if frames else traceback.FrameSummary("", 0, "")
        kind = (record.name, type(error), where.filename, where.lineno)
        if kind in self.told:
            return False
        self.told.add(kind)
        if record.name == "asyncio" and not any(frame.filename.startswith(OURS) for frame in frames):
            record.msg = UNUSABLE
            record.args = (type(error).__name__, str(error), Path(where.filename).name, where.lineno or 0)
            record.exc_info = None
        return True


def tell_once() -> None:
    """Log each kind of failure once from now on."""
    for name in ("websockets.server", "asyncio", "helicoide"):
        logger = logging.getLogger(name)
        for old in [one for one in logger.filters if isinstance(one, Once)]:
            logger.removeFilter(old)
        logger.addFilter(Once())
