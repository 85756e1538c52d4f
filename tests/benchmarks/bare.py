"""A bare viser that moves as many nodes as an arm has, sixty times a second, as its own examples do.

Run as a module; it prints its address, and answers each line with one of JSON, as `watched` does.
"""

from __future__ import annotations

import contextlib
import io
import json
import sys
from math import cos, sin
from threading import Thread
from time import perf_counter, sleep

import viser

from helicoide.kinematics.library import load_robot
from helicoide.view import shapes

RATE = 60.0


class Nodes:
    """The frames, and what moves them."""

    def __init__(self, server: viser.ViserServer, count: int) -> None:
        self.server, self.drawn, self.gap = server, 0, 0.0
        self.nodes = [server.scene.add_frame(f"/node {k}") for k in range(count)]

    def run(self) -> None:
        """Move all of them at once, again and again."""
        last = perf_counter()
        while True:
            angle = perf_counter()
            with self.server.atomic():
                for k, node in enumerate(self.nodes):
                    node.position = (cos(angle + k), sin(angle + k), 0.1 * k)
                    node.wxyz = (cos(angle), 0.0, 0.0, sin(angle))
            self.server.flush()
            self.drawn += 1
            sleep(max(0.0, last + 1 / RATE - perf_counter()))
            now = perf_counter()
            self.gap, last = max(self.gap, now - last), now


def main() -> None:
    with contextlib.redirect_stdout(io.StringIO()):  # viser prints a banner whatever it is told
        server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    nodes = Nodes(server, len(shapes.load_shapes(load_robot("movemaster"))) + 2)
    Thread(target=nodes.run, daemon=True).start()
    print(f"http://127.0.0.1:{server.get_port()}", flush=True)
    for _ in sys.stdin:
        gap, nodes.gap = nodes.gap, 0.0
        print(json.dumps({"frames": nodes.drawn, "gap": gap}), flush=True)


if __name__ == "__main__":
    main()
