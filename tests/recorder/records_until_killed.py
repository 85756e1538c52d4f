"""A program that records an arm in real time until it is killed; it prints the arm's time of what it has queued."""

from __future__ import annotations

import sys
import time
from itertools import count
from pathlib import Path

from tests.recorder.recordings import moved

from helicoide.recorder.recorder import Recorder


def main() -> None:
    states = moved(seconds=60.0)
    recorder = Recorder(Path(sys.argv[1]), states[0])
    for k in count(1):
        recorder.take(states[k])
        sys.stdout.write(f"{states[k].t}\n")
        sys.stdout.flush()
        time.sleep(0.01)


if __name__ == "__main__":
    main()
