"""While the kernels are not there, a window opens without the numbers that need them, and compiles nothing itself."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

APP = Path(__file__).parents[2] / "app"
FURNISH = """
from dataclasses import replace
from types import SimpleNamespace as Thing
import viser
from numba.core import event
from helicoide.kinematics.library import load_robot
from helicoide.kernels import KERNELS
from helicoide.seat import Seat, Selection
from helicoide.state import initial_state
from helicoide.view import layers, panels
from helicoide.view.placed_rows import place_rows
from helicoide.view.window_view import View

compiled = []

class Listener(event.Listener):
    def on_start(self, event):
        compiled.append(event.data["dispatcher"].py_func.__qualname__)
    def on_end(self, event):
        pass

robot = load_robot("movemaster")
server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
shows = {layer.NAME: layer.SHOWN for layer in layers.optional()}
seat = replace(Seat("", "en"), visible_layers=shows, selected=Selection("plane"))
view = View(initial_state(robot), seat, ready=False)
with event.install_listener("numba:compile", Listener()):
    placed = [row for panel in panels.all_panels() for row in place_rows(server.gui, panel.rows(robot), view, print)]
    print("=", len(placed), compiled)
    for row in placed:
        row.refresh(replace(view, ready=True))
    print("=", bool(compiled))
server.stop()
"""


def test_a_window_compiles_nothing_before_the_kernels_are_there(tmp_path: Path) -> None:
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path), "PYTHONPATH": str(APP)}
    done = subprocess.run(
        [sys.executable, "-c", FURNISH], env=environment, capture_output=True, text=True, timeout=900, check=False
    )
    assert done.returncode == 0, done.stderr
    waiting, ready = (line.split(" ", 2)[1:] for line in done.stdout.splitlines() if line.startswith("= "))
    assert int(waiting[0]) > 20
    assert waiting[1] == "[]"
    assert ready == ["True"]
