"""A recording as a table of numbers: CSV with a header line, SI units, one line for each sample."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence

import numpy as np

from helicoide.arrays import Array
from helicoide.recorder.recording import Recording

POSE = ("x [m]", "y [m]", "z [m]", "qw", "qx", "qy", "qz")


def encode_recording(recording: Recording) -> bytes:
    """The samples as CSV in UTF-8: time, joint values and velocities, poses of tool and target, method and status.

    Numbers are written with all their digits; a value that the file did not give is empty.
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    joints, samples = recording.arm.joints, recording.samples
    poses = [
        (name, rows) for name, rows in (("tool", recording.tool), ("target", recording.target)) if rows is not None
    ]
    titles = [f"{name} {part}" for name, _ in poses for part in POSE]
    writer.writerow(
        [
            "t [s]",
            *(f"q {joint}" for joint in joints),
            *(f"dq {joint}" for joint in joints),
            *titles,
            "method",
            "status",
        ]
    )
    methods = _held(recording.methods, samples.times)
    statuses = _held([(at, text.en) for at, text in recording.statuses], samples.times)
    for k, time in enumerate(samples.times.tolist()):
        numbers = [*samples.q[k], *samples.velocities[k], *(value for _, rows in poses for value in rows[k])]
        values = ("" if value != value else repr(float(value)) for value in numbers)
        writer.writerow([repr(time), *values, methods[k], statuses[k]])
    return out.getvalue().encode()


def _held(words: Sequence[tuple[float, str]], times: Array) -> list[str]:
    """The words that hold at each time: the last that were said before or at it."""
    since = np.searchsorted([at for at, _ in words], times, side="right") - 1
    return [words[k][1] if k >= 0 else "" for k in since]
