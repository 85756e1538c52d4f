"""The lab in a cell: requests are checked as on its page, two labs do not meet, and a closed one is closed."""

from __future__ import annotations

import subprocess
import sys
import urllib.error
import urllib.request
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from tests.session.labs import eventually

import helicoide
from helicoide.state import State
from helicoide.teaching.cell import CLOSED, LabCell
from helicoide.text import HelicoideError


@pytest.fixture(scope="module")
def lab() -> Iterator[LabCell]:
    lab = helicoide.lab("movemaster")
    yield lab
    lab.close()


def test_the_arm_goes_where_it_is_asked(lab: LabCell) -> None:
    q = lab.q.copy()
    q[0] += 0.3
    lab.q = q
    assert eventually(lambda: bool(np.abs(lab.q - q).max() < 1e-3))
    T = lab.target.copy()
    T[2, 3] -= 0.03
    lab.target = helicoide.motor(T)
    assert eventually(lambda: bool(np.abs(lab.target - T).max() < 2e-3))
    lab.stop()
    assert eventually(lambda: not lab.state.arm.moving)


@pytest.mark.parametrize("q", [[1.0] * 5, [np.nan] * 5, [0.0] * 4, "home"])
def test_joint_values_are_refused_as_on_the_page(lab: LabCell, q: object) -> None:
    before = lab.q
    with pytest.raises(HelicoideError):
        lab.q = q
    np.testing.assert_array_equal(lab.q, before)


def test_a_refusal_is_raised_also_while_the_arm_moves(lab: LabCell, monkeypatch: pytest.MonkeyPatch) -> None:
    """The clock replaces the request at every tick, also between two looks at the state."""

    def ticking(cell: LabCell) -> State:
        state = cell._lab.shared.workcell.state
        return replace(state, request=replace(state.request))

    monkeypatch.setattr(LabCell, "state", property(ticking))
    with pytest.raises(HelicoideError):
        lab.q = [1.0] * 5


def test_a_target_is_refused_as_on_the_page(lab: LabCell) -> None:
    T = np.eye(4)
    T[0, 3] = 1e6
    for bad in (T, np.full((4, 4), np.nan), helicoide.point(0, 0, 0)):
        with pytest.raises(HelicoideError):
            lab.target = bad


def test_its_page_may_be_framed_by_this_computer_alone(lab: LabCell) -> None:
    assert lab.url in lab._repr_html_()
    with urllib.request.urlopen(lab.url) as page:
        policy = page.headers["Content-Security-Policy"]
    assert policy.endswith("frame-ancestors http://127.0.0.1:* http://localhost:*")


def test_a_second_lab_is_another_one(lab: LabCell) -> None:
    arm = helicoide.robot("puma560")
    other = helicoide.lab(arm, "pt_BR")
    try:
        assert other.url != lab.url
        assert (other.state.robot.name, lab.state.robot.name) == ("puma560", "movemaster")
    finally:
        other.close()
    other.close()
    with pytest.raises(HelicoideError):
        other.q = arm.postures["ready"]
    with pytest.raises(urllib.error.URLError):
        urllib.request.urlopen(other.url)
    assert "iframe" not in other._repr_html_()
    assert repr(other) == CLOSED.pt_BR
    with urllib.request.urlopen(lab.url) as page:
        assert page.status == 200


def test_a_kernel_that_ends_takes_the_lab_with_it() -> None:
    script = "import helicoide; lab = helicoide.lab(); print(lab.url, flush=True)"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120, check=True)
    with pytest.raises(urllib.error.URLError):
        urllib.request.urlopen(done.stdout.split()[0])
