"""A lab in a process of its own that tells of itself: a line of JSON for each line that it is sent.

`python -m tests.benchmarks.watched`: ticks of the shared arm, frames, windows, and, since the line before, the longest
time between two ticks, s.
"""

from __future__ import annotations

import json
import sys

from helicoide.kinematics.library import load_robot
from helicoide.session.lab import Lab


def main() -> None:
    lab = Lab(load_robot("movemaster"), None, None)
    print(f"http://127.0.0.1:{lab.open('127.0.0.1', 0)}", flush=True)
    for _ in sys.stdin:
        display, gap, lab.clock.gap = lab.shared.display, lab.clock.gap, 0.0
        told = {
            "ticks": lab.shared.workcell.ticks,
            "frames": 0 if display is None else display.frames,
            "windows": len(lab.visitors),
            "gap": gap,
            "resting": lab.clock.idle,
        }
        print(json.dumps(told), flush=True)
    lab.close()


if __name__ == "__main__":
    main()
