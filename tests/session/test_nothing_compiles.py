"""After the preparation nothing is compiled, whatever is pressed; and the preparation reaches every kernel."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.compiles

ROOT = Path(__file__).parents[2]
PRESS = """
import asyncio
import sys

import viser
from numba.core import event

from helicoide import kernels
from helicoide.commands import serve
from helicoide.jobs.process import ProcessJob
from helicoide.kinematics.library import load_robot
from helicoide.session.preparing import compiled, prepare
from tests.pressing import everything


class Listener(event.Listener):
    def on_start(self, event):
        pass

    def on_end(self, event):
        kernel = event.data["dispatcher"]
        if isinstance(kernel, kernels.Kernel):
            print("compiled:", kernel.py_func.__qualname__, *event.data["args"])


if __name__ == "__main__":
    with event.install_listener("numba:compile", Listener()):
        asyncio.run(prepare(load_robot("movemaster"), ProcessJob(compiled), lambda text: None, lambda alive: None))
        print("left out:", *[name for name in kernels.KERNELS if not kernels.is_cached(name)])
        server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
        for name in sys.argv[1:]:
            everything(name, server)
        server.stop()
    print("pressed:", *sys.argv[1:])
"""


def pressed(folder: Path, *robots: str) -> None:
    """Prepare with an empty folder, as the lab does, and press everything with these arms."""
    script = folder / "press.py"
    script.write_text(PRESS)
    environment = {
        **os.environ,
        "NUMBA_CACHE_DIR": str(folder / "cache"),
        "PYTHONPATH": os.pathsep.join([str(ROOT / "app"), str(ROOT)]),
    }
    done = subprocess.run(
        [sys.executable, str(script), *robots], env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    found = [line for line in done.stdout.splitlines() if line.startswith(("left out:", "compiled:", "pressed:"))]
    assert found == ["left out:", f"pressed: {' '.join(robots)}"]


def test_nothing_is_compiled_after_the_preparation(tmp_path: Path) -> None:
    """A kernel that is left out is one that `exercise` should call."""
    pressed(tmp_path, "movemaster", "dia10_rod", "polar_rp")
