"""Every study while somebody presses Stop once a second, and an hour of random use by five windows."""

from __future__ import annotations

import faulthandler
import gc
import logging
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import psutil
import pytest
from tests.pages import Hand
from tests.session.labs import eventually, running, window
from tests.session.turns import counted

from helicoide import studies
from helicoide.session.lab import Lab
from helicoide.view.panels.study import studies_by_source

pytestmark = pytest.mark.soak

LONGEST, HEARD, GAP = 0.1, 0.2, 0.1  # s; the last two by the clock, printed beside what was seen
WINDOWS, SECONDS, SETTLED, GREW = 5, 3600.0, 600.0, 1.05
# What would leave the page, or fill the disk with files.
LEFT_OUT = ("Language", "Save planes", "Save waypoints", "Load")


@pytest.fixture(scope="module")
def lab() -> Iterator[Lab]:
    with running() as lab:
        yield lab


@pytest.mark.parametrize("name", studies.study_names())
def test_no_study_holds_anything_up(lab: Lab, name: str) -> None:
    hand = window(lab)
    (visitor,) = lab.visitors.values()
    hand.do(hand.page.give("Study", dict(studies_by_source())[name].en))
    assert eventually(lambda: visitor.place.study_panel.study == name)

    def begun() -> bool:
        hand.do(hand.page.press("Run"))
        return (
            eventually(lambda: visitor.place.study_panel.progress is not None, 1.0)
            or visitor.place.study_panel.last is not None
        )

    assert eventually(begun)
    heard, lab.clock.gap = [], 0.0
    with counted(lab.loop) as turns:
        while visitor.place.study_panel.progress is not None:
            heard.append(hand.do(hand.page.stop()))
            hand.do(hand.page.press("Play"))
            time.sleep(1.0)
    hand.close()
    assert eventually(lambda: not lab.visitors)
    print(
        f"{name}: stop heard within {max(heard, default=0.0):.3f} s (goal {HEARD}), "
        f"longest gap {lab.clock.gap:.3f} s (goal {GAP}), longest turn {turns.longest:.3f} s of processor time"
    )
    assert visitor.place.study_panel.failure is None
    assert turns.longest < LONGEST, turns.what


def test_studies_of_another_process_hold_nothing_up(lab: Lab) -> None:
    hand = window(lab)
    heard, lab.clock.gap = [], 0.0
    all_of_them = [sys.executable, "-m", "helicoide", "study", "--all", "--short"]
    with counted(lab.loop) as turns, subprocess.Popen(all_of_them, stdout=subprocess.DEVNULL) as studying:
        while studying.poll() is None:
            hand.do(hand.page.press("Play"))
            time.sleep(1.0)
            heard.append(hand.do(hand.page.stop()))
    hand.close()
    assert eventually(lambda: not lab.visitors)
    print(
        f"study --all: stop heard within {max(heard):.3f} s of {len(heard)} (goal {HEARD}), "
        f"longest gap {lab.clock.gap:.3f} s (goal {GAP}), longest turn {turns.longest:.3f} s of processor time"
    )
    assert studying.returncode == 0
    assert turns.longest < LONGEST, turns.what


def test_an_hour_of_random_use_leaves_nothing_behind(lab: Lab, caplog: pytest.LogCaptureFixture) -> None:
    """Memory after an hour is that of the tenth minute, and so are threads and open files; nothing is raised."""
    faulthandler.dump_traceback_later(SECONDS + 900.0, exit=True, file=sys.__stderr__)  # instead of after 15 min
    rng, hands = np.random.default_rng(0), [window(lab) for _ in range(WINDOWS)]
    began, gaps = time.monotonic(), []
    early: tuple[float, int, int] | None = None
    caplog.set_level(logging.ERROR)
    while (at := time.monotonic() - began) < SECONDS:
        number = int(rng.integers(WINDOWS))
        act(rng, hands[number])
        if rng.random() < 0.002:
            seat = hands[number].page.seat
            hands[number].close()
            hands[number] = window(lab, seat=seat)
        if early is None and at > SETTLED:
            early = used(lab)
        gaps.append(lab.clock.gap)
        lab.clock.gap = 0.0
    hands[0].do(hands[0].page.stop())
    late = used(lab)
    assert early is not None
    print(f"longest gap {max(gaps):.3f} s (goal 0.25); MB, threads, files: {early} at ten minutes, {late} at the end")
    for hand in hands:
        hand.close()
    assert [record.getMessage() for record in caplog.records] == []
    assert late[0] <= GREW * early[0]
    assert late[1] <= early[1] + WINDOWS
    assert late[2] <= early[2] + WINDOWS


def used(lab: Lab) -> tuple[float, int, int]:
    """Memory, MB, threads and open files of this process, when nothing is under way and the garbage is out."""
    places, bays = list(lab.seats.places.values()), list(lab.bays)
    assert eventually(lambda: all(place.study_panel.progress is None for place in places), 600)
    assert eventually(lambda: all(bay.workcell.state.workspace.progress is None for bay in bays), 600)
    gc.collect()
    process = psutil.Process()
    return process.memory_info().rss / 1e6, threading.active_count(), process.num_fds()


def act(rng: np.random.Generator, hand: Hand) -> None:
    """Anything that a hand may do: a control with a value that it takes, a drag, a stop."""
    if (what := rng.random()) < 0.05:
        hand.do(hand.page.stop())
    elif what < 0.25:
        hand.do(hand.page.gizmo("DragStart"))
        for _ in range(int(rng.integers(1, 20))):
            x, y, z = map(float, rng.uniform([0.2, -0.5, 0.0], [0.9, 0.5, 0.9]))
            hand.do(hand.page.gizmo("Update", wxyz=(0.0, 1.0, 0.0, 0.0), position=(x, y, z)))
            time.sleep(0.02)
        hand.do(hand.page.gizmo("DragEnd"))
    else:
        labels = [label for label in hand.page.made if label and not label.startswith(LEFT_OUT)]
        label = labels[int(rng.integers(len(labels)))]
        if (value := value_of(rng, hand.page.made[label])) is not None:
            hand.do(hand.page.give(label, value))
    time.sleep(float(rng.uniform(0.02, 0.3)))


def value_of(rng: np.random.Generator, made: dict[str, Any]) -> object:
    """A value that a control takes; None for what takes none."""
    props = made["props"]
    match made["type"]:
        case "GuiSliderMessage":
            return float(rng.uniform(props["min"], props["max"]))
        case "GuiDropdownMessage":
            return str(props["options"][int(rng.integers(len(props["options"])))])
        case "GuiCheckboxMessage":
            return bool(rng.random() < 0.5)
        case "GuiVector3Message":
            return [float(value) for value in rng.uniform(-900.0, 900.0, 3)]
        case "GuiTextMessage":
            return " ".join(f"{value:.0f}" for value in rng.uniform(-900.0, 900.0, int(rng.integers(1, 10))))
        case "GuiButtonMessage":
            return True
        case _:
            return None
