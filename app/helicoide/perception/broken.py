"""The error of formats for an invalid file."""

from __future__ import annotations

from helicoide.text import HelicoideError


class BrokenFile(HelicoideError):
    """What is wrong with a file, as part of a sentence."""
