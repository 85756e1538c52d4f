"""The last changes of a scene, to undo and redo them: what can be undone, and two bounded lists of changes."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, replace

from helicoide.confinement import Obstacles, Planes, Zones
from helicoide.ik import EntryPoint
from helicoide.ik.controller import Controller
from helicoide.text import Text
from helicoide.trajectory.waypoints import WaypointList

MOST_CHANGES = 100


@dataclass(frozen=True, eq=False)
class Undoable:
    """The part of a state that can be undone. No posture, no target and no velocity belong to it.

    taught: the waypoints; controller: only its method, options, gains and secondary objective count.
    """

    planes: Planes
    obstacles: Obstacles
    zones: Zones
    entry: EntryPoint | None
    taught: WaypointList
    controller: Controller


@dataclass(frozen=True, eq=False)
class Change:
    """A change in words, and what to return to. subject: the object and quantity that changed; None for several."""

    title: Text
    subject: Hashable
    other: Undoable


@dataclass(frozen=True, eq=False)
class History:
    """The changes that can be undone and redone, the newest last.

    unfinished: whether a next change of the same subject belongs to the newest one, as while a slider is held.
    """

    undo: tuple[Change, ...] = ()
    redo: tuple[Change, ...] = ()
    unfinished: bool = False

    def with_change(self, change: Change) -> History:
        """The history after one more change. It ends what could be redone, and the oldest change may be forgotten."""
        newest = self.undo[-1] if self.undo else None
        if self.unfinished and newest is not None and newest.subject == change.subject is not None:
            return self
        return History((*self.undo[1 - MOST_CHANGES :], change), (), unfinished=True)

    def finished(self) -> History:
        """The history in which any further change is a new one."""
        return replace(self, unfinished=False) if self.unfinished else self

    def undone(self, present: Undoable) -> History:
        """The history after its newest change was undone. present: what was there until then."""
        newest = self.undo[-1]
        return History(self.undo[:-1], (*self.redo, replace(newest, other=present)))

    def redone(self, present: Undoable) -> History:
        """The history after the change that was undone last was made again. present: what was there until then."""
        newest = self.redo[-1]
        return History((*self.undo, replace(newest, other=present)), self.redo[:-1])
