"""A recording as a table of numbers: CSV with a header line, SI units, one line for each sample."""

from __future__ import annotations

import csv
import io

from helicoide.recorder.recording import Recording, holding_at

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
    for k, time in enumerate(samples.times.tolist()):
        numbers = [*samples.q[k], *samples.velocities[k], *(value for _, rows in poses for value in rows[k])]
        values = ("" if value != value else repr(float(value)) for value in numbers)
        status = recording.status_at(time)
        words = holding_at(recording.methods, time) or "", "" if status is None else status.en
        writer.writerow([repr(time), *values, *words])
    return out.getvalue().encode()
