"""Requests for files that take their time to be made, before they are downloaded."""

from __future__ import annotations

from dataclasses import dataclass

from helicoide.studies.study import Motion


@dataclass(frozen=True)
class SaveNotebook:
    """A request for the scene as a Jupyter notebook."""


@dataclass(frozen=True, eq=False)
class SaveClip:
    """A request for a clip of a motion, or of the last seconds if there is none."""

    motion: Motion | None = None


@dataclass(frozen=True)
class SavePicture:
    """A request for a picture of the scene, (width, height) in pixels."""

    size: tuple[int, int]


FileRequest = SaveNotebook | SaveClip | SavePicture
