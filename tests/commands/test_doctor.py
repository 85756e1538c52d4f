"""The doctor counts what this installation can load, and says where it lies."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

APP = Path(__file__).parents[2] / "app"
COMPILE = "from helicoide.ik.guard.qp import inner_product; import numpy as np; inner_product(np.ones(3), np.ones(3))"
BY_ANOTHER_PYTHON = 'from helicoide.kernels import cache; cache.VERSIONS = ("cpython-399", "0.1"); '
DOCTOR = "from helicoide.commands import doctor; doctor.run()"


def said(code: str, cache: Path) -> str:
    """What a fresh process prints that keeps its kernels in a folder."""
    environment = {**os.environ, "PYTHONPATH": str(APP), "NUMBA_CACHE_DIR": str(cache), "LC_ALL": "C.UTF-8"}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_kernels_counted_are_those_that_this_python_would_load(tmp_path: Path) -> None:
    cache = tmp_path / "Área de trabalho"
    said(BY_ANOTHER_PYTHON + COMPILE, cache)
    (theirs,) = cache.rglob("*.kernel")
    (older := cache / "older").mkdir()
    (older / theirs.name).write_bytes(theirs.read_bytes())
    counted = []
    for _ in range(2):
        found = re.search(r"kernels: (\d+) of (\d+) compiled in (.*)", said(DOCTOR, cache))
        assert found is not None
        assert Path(found[3]) == theirs.parent
        assert int(found[2]) > 50
        counted.append(int(found[1]))
        said(COMPILE, cache)
    assert counted == [0, 1]
