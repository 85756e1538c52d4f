"""A lab that is killed at any moment loses at most the step that it was saving, and its file stays whole."""

from __future__ import annotations

import random
import signal
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest
from tests.store.samples import TOKEN
from tests.store.saves_until_killed import after

from helicoide.store.database import Store

SCRIPT = [sys.executable, "-m", "tests.store.saves_until_killed"]


@pytest.mark.parametrize("seed", [*range(4), *(pytest.param(seed, marks=pytest.mark.soak) for seed in range(4, 100))])
def test_a_kill_loses_at_most_the_step_that_is_being_saved(tmp_path: Path, seed: int) -> None:
    path, last = tmp_path / "progress.sqlite", random.Random(seed).randrange(1, 60)
    with subprocess.Popen([*SCRIPT, path], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        for line in child.stdout:
            if int(line) == last:
                break
        child.send_signal(signal.SIGKILL)
        said = [last, *map(int, child.stdout.read().split())]
    store = Store(path)
    found = store.load(TOKEN)
    assert found in (after(said[-1]), after(said[-1] + 1))
    store.save(TOKEN, after(600), found)
    assert store.load(TOKEN) == after(600)
    store.close()
    with sqlite3.connect(path) as file:
        assert file.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    file.close()
