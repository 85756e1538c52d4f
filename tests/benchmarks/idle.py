"""What a lab costs that is left open while its arm rests."""

from __future__ import annotations

from time import sleep

from tests.benchmarks.load import child, lab
from tests.benchmarks.report import verdict

TITLE = "A lab at rest"
SECONDS, RESTED, GOAL = 20.0, 6.0, 0.5


def run() -> None:
    with lab() as (server, port):
        for windows in (0, 1):
            with child("tests.benchmarks.crowd", port) as crowd:
                if windows:
                    crowd.ask("join", windows, 0)
                while not server.ask("tell")["resting"]:
                    sleep(0.5)
                sleep(RESTED)
                used = server.processor()
                sleep(SECONDS)
                verdict(f"processor with {windows} windows", 100 * (server.processor() - used) / SECONDS, GOAL, " %")
                crowd.ask("leave")
