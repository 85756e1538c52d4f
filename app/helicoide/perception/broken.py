"""How formats refuse a file."""

from __future__ import annotations

from helicoide.text import HelicoideError


class BrokenFile(HelicoideError):
    """What is wrong with a file, as the part of a sentence."""
