"""The closed forms of the constrained Jacobian, where the printed ones are otherwise."""

from __future__ import annotations

from math import cos, sin

import numpy as np
import pytest
from tests.ik.rcm.runs import START

from helicoide.ik.rcm import wrists
from helicoide.ik.rcm.constrained import constrained
from helicoide.ik.rcm.passage import through
from helicoide.studies._coutinho_runs import LINK, dia10, entry_on, problem_without_planes, zx_wrist


def test_entry_3_4_of_the_trocar_is_l8_c8_s7() -> None:
    """Eq. 3.28 prints l₈ c₇ c₈ there; at θ₈ = 0.7 that is 0.22 m too much. The other entries are as printed."""
    q = np.array([*START[:7], 0.7])
    J = constrained(problem_without_planes(dia10()), through(dia10(), LINK), q, entry_on(dia10(), q, 0.15), "source").J
    corrected = wrists.zy_trocar(0.15, 0.18, 0.21, q[6], q[7])
    np.testing.assert_allclose(J, corrected, atol=3e-15)
    as_printed = corrected.copy()
    as_printed[2, 3] = 0.21 * cos(q[6]) * cos(q[7])
    assert np.abs(J - as_printed).max() == pytest.approx(0.22, abs=5e-3)


def test_the_zx_wrist_turns_with_its_last_joint() -> None:
    """Eq. 3.29 in one frame: undone by Rot(x, θ₈), it is the wrist without its last turn, with l₈ turned by it."""
    q = np.array([*START[:7], 0.7])
    robot = zx_wrist()
    J = constrained(problem_without_planes(robot), through(robot, LINK), q, entry_on(robot, q, 0.15), "source").J
    np.testing.assert_allclose(J, wrists.zx_trocar(0.15, 0.18, 0.21, q[6], q[7]), atol=1e-14)
    R = np.array([[1, 0, 0], [0, cos(q[7]), -sin(q[7])], [0, sin(q[7]), cos(q[7])]])
    unbent = wrists.zx_trocar(0.15, 0.18, 0.21, q[6], 0.0)
    np.testing.assert_allclose(R @ J[3:], unbent[3:], atol=1e-14)


def test_manipulability_of_the_slit_is_the_root_of_the_printed() -> None:
    """Eq. 3.40 prints w_r²: 2.93 in place of 1.7124 at l_a = 0.15, l_b = 0.18, θ₇ = −0.6164."""
    J = wrists.zy_slit(0.15, 0.18, 0.21, -0.6164, 0.3)
    printed = (0.18 / 0.15) ** 2 * ((0.33 * sin(-0.6164)) ** 2 + 2)
    assert np.linalg.det(J @ J.T) == pytest.approx(printed, rel=1e-9)
    assert wrists.w_zy_slit(0.15, 0.18, -0.6164) == pytest.approx(np.sqrt(printed), rel=1e-12)
    assert printed == pytest.approx(2.93, abs=5e-3)
