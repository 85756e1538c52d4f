"""What one window shows: the state of its arm, and what belongs to its user."""

from __future__ import annotations

from dataclasses import dataclass

from helicoide.lines import LineVerdict
from helicoide.readout.signal_history import NO_SIGNAL_HISTORY, SignalHistory
from helicoide.recorder.panel_state import NO_RECORDINGS, RecordingPanelState
from helicoide.recorder.recorder import RecorderStatus
from helicoide.seat import Seat
from helicoide.sheet import SheetChange
from helicoide.state import State
from helicoide.studies.panel_state import NO_STUDY, StudyPanelState


@dataclass(frozen=True, eq=False)
class LineCheck:
    """The line of an exercise that was typed last: of which lesson and step, its text, and what came of it."""

    step: tuple[str, str]
    text: str
    verdict: LineVerdict


@dataclass(frozen=True, eq=False)
class View:
    """What one window shows: the state of its arm, its seat, and the seat's study panel.

    ready: whether the kernels are compiled; own: whether the arm belongs to this seat alone, and is not the shared one;
    recordings: the recordings that the seat looks at; recorder: the state of the arm's recorder, None if it has none;
    history: the last samples of the charted signals; time: s, for layers that move while the arm is at rest;
    address: that of the page, to which links are added, empty until it is known; line_check: of the line that was typed
    last for an exercise.
    """

    state: State
    seat: Seat
    study_panel: StudyPanelState = NO_STUDY
    ready: bool = True
    own: bool = False
    recordings: RecordingPanelState = NO_RECORDINGS
    recorder: RecorderStatus | None = None
    history: SignalHistory = NO_SIGNAL_HISTORY
    time: float = 0.0
    address: str = ""
    line_check: LineCheck | None = None

    @property
    def sheet_undo(self) -> SheetChange | None:
        """The change of the sheet that Undo returns from; None if a change of the scene comes first."""
        return self.seat.sheet_history.next_undo(len(self.state.history.undo))

    @property
    def sheet_redo(self) -> SheetChange | None:
        """The change of the sheet that Redo makes again; None if a change of the scene comes first."""
        return self.seat.sheet_history.next_redo(len(self.state.history.undo), len(self.state.history.redo))

    def linked_here(self) -> tuple[float, ...] | None:
        """The joint values (n,), rad or m, of a link about the arm that is shown; None without such a link."""
        linked, robot = self.seat.linked, self.state.robot
        fits = linked is not None and linked.robot == robot.name and len(linked.q) == len(self.state.arm.q)
        return linked.q if linked is not None and fits else None

    def handles_moved(self, old: View | None) -> bool:
        """Whether handles may have moved since an older view, or another pointer may hold one."""
        before, now = None if old is None else old.state, self.state
        return before is None or before.problem is not now.problem or before.request.drag is not now.request.drag
