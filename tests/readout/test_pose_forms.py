"""Quaternions, screws and Euler angles that are shown agree with scipy, on random scenes of all arms."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.spatial.transform import Rotation
from tests.readout.scenes import SCENES, scene

from helicoide import readout
from helicoide.geometry.euler import CONVENTIONS, EXTRINSIC
from helicoide.geometry.rotation import skew


@pytest.mark.parametrize(("name", "seed"), SCENES)
def test_quaternions_and_half_angles(name: str, seed: int) -> None:
    state = scene(name, seed)
    for element in readout.elements(state):
        if element.pose is None:
            continue
        T = element.pose(state)
        forms, peer = readout.forms_of_pose(T, "zyx"), Rotation.from_matrix(T[:3, :3])
        np.testing.assert_allclose(forms.quaternion, _with_sign_of(forms.quaternion, peer), atol=1e-9)
        assert 2 * forms.half_angle == pytest.approx(peer.magnitude(), abs=1e-7)
        assert forms.quaternion[0] == pytest.approx(np.cos(forms.half_angle), abs=1e-12)
        np.testing.assert_allclose(forms.dual_quaternion[:4], forms.quaternion, atol=1e-12)
        w, *t = 2 * _product(forms.dual_quaternion[4:], _conjugate(forms.quaternion))
        assert w == pytest.approx(0.0, abs=1e-9)
        np.testing.assert_allclose(t, T[:3, 3], atol=1e-9)


def _with_sign_of(q: np.ndarray, peer: Rotation) -> np.ndarray:
    other = peer.as_quat(scalar_first=True)
    return np.asarray(other * np.sign(other @ q))


def _conjugate(q: np.ndarray) -> np.ndarray:
    return np.asarray(q * [1, -1, -1, -1])


def _product(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    (a, u), (b, v) = (p[0], p[1:]), (q[0], q[1:])
    return np.concatenate([[a * b - u @ v], a * v + b * u + np.cross(u, v)])


@pytest.mark.parametrize(("name", "seed"), SCENES)
def test_the_screw_is_the_matrix_exponential(name: str, seed: int) -> None:
    """expm of the 4×4 twist of the shown axis, angle and translation is the pose."""
    state = scene(name, seed)
    for element in readout.elements(state):
        if element.pose is None:
            continue
        T = element.pose(state)
        screw = readout.forms_of_pose(T, "zyx").screw
        twist = np.zeros((4, 4))
        twist[:3, :3] = screw.angle * skew(screw.direction)
        twist[:3, 3] = screw.displacement * screw.direction - screw.angle * np.cross(screw.direction, screw.point)
        np.testing.assert_allclose(expm(twist), T, atol=1e-8)


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_euler_angles_of_every_convention(convention: str) -> None:
    """scipy's names: capitals for moving axes. Near a singularity the angles are compared by their rotation."""
    axes = convention.removeprefix(EXTRINSIC)
    name = axes if convention.startswith(EXTRINSIC) else axes.upper()
    for arm, seed in SCENES:
        state = scene(arm, seed)
        T = state.T_world_tool
        forms = readout.forms_of_pose(T, convention)
        again = Rotation.from_euler(name, forms.euler.values)
        assert (again.inv() * Rotation.from_matrix(T[:3, :3])).magnitude() < 1e-7
        if not forms.near_singular:
            theirs = Rotation.from_matrix(T[:3, :3]).as_euler(name)
            np.testing.assert_allclose(np.exp(1j * theirs), np.exp(1j * forms.euler.values), atol=1e-6)


def test_near_a_singularity_a_warning_is_due() -> None:
    T = np.eye(4)
    T[:3, :3] = Rotation.from_euler("ZYX", [0.3, np.radians(86.0), 0.1]).as_matrix()
    assert readout.forms_of_pose(T, "zyx").near_singular
    assert not readout.forms_of_pose(T, "zxz").near_singular
