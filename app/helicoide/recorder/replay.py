"""A recording replayed on an arm, under the limits and planes that hold there."""

from __future__ import annotations

from helicoide import gate
from helicoide.gate.check import checked
from helicoide.recorder.recorded_arm import columns_for
from helicoide.recorder.recording import Recording
from helicoide.state import State, Update
from helicoide.text import Text

REPLAYED = Text(en="Replaying {title}", pt_BR="Reproduzindo {title}")


def replay_recording(recording: Recording) -> Update:
    """Replay a recording; a recording of another arm is refused.

    The motion is a spline through at most 1500 samples (`gate.replay_motion`), so that of a long recording only every
    so many are passed exactly.
    """

    def change(state: State) -> State:
        columns = columns_for(recording.arm, state.robot, recording.title)
        samples = recording.samples
        title = REPLAYED.format(title=recording.title)
        return gate.replay_motion(samples.times, samples.q[:, columns], title)(state)

    return checked(change)
