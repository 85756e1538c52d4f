"""Slerp against scipy; the chord of lerp, and both speeds against finite differences."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

from helicoide.arrays import Array
from helicoide.geometry.quaternion_paths import lerp, lerp_speed, slerp, slerp_speed


@pytest.fixture(params=range(6))
def pair(request: pytest.FixtureRequest) -> tuple[Array, Array]:
    p, q = np.random.default_rng(request.param).normal(size=(2, 4))
    return p / np.linalg.norm(p), q / np.linalg.norm(q)


def test_slerp_is_that_of_scipy_where_it_takes_the_shorter_way(pair: tuple[Array, Array]) -> None:
    p, q = pair
    q = q if p @ q > 0 else -q
    t = np.linspace(0, 1, 11)
    peer = Slerp([0, 1], Rotation.from_quat([p, q], scalar_first=True))(t).as_quat(scalar_first=True)
    found = slerp(p, q, t)
    np.testing.assert_allclose(found, peer * np.sign(np.sum(found * peer, axis=1))[:, None], atol=1e-12)


def test_slerp_goes_from_p_to_q_on_the_sphere_and_lerp_on_the_chord(pair: tuple[Array, Array]) -> None:
    p, q = pair
    t = np.linspace(0, 1, 11)
    arc, chord = slerp(p, q, t), lerp(p, q, t)
    for way in (arc, chord):
        np.testing.assert_allclose(way[[0, -1]], [p, q], atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(arc, axis=1), 1.0)
    assert np.linalg.norm(chord[5]) < 1.0
    np.testing.assert_allclose(np.diff(chord, axis=0), np.broadcast_to((q - p) / 10, (10, 4)), atol=1e-12)


def test_the_speeds_are_those_of_the_rotations(pair: tuple[Array, Array]) -> None:
    p, q = pair
    step = 1e-6
    for t in (0.1, 0.5, 0.8):
        for way, speed in ((slerp, slerp_speed(p, q)), (lerp, lerp_speed(p, q, t))):
            before, after = (Rotation.from_quat(way(p, q, t + d), scalar_first=True) for d in (-step, step))
            assert (before.inv() * after).magnitude() / (2 * step) == pytest.approx(speed, rel=1e-5)


def test_equal_and_opposite_quaternions_stay_where_they_are() -> None:
    p = np.array([0.6, 0.0, 0.8, 0.0])
    np.testing.assert_allclose(slerp(p, p, np.array([0.0, 0.5, 1.0])), [p, p, p])
    np.testing.assert_allclose(slerp(p, -p, 0.5), p)
    assert slerp_speed(p, p) == 0.0
    assert lerp_speed(p, -p, 0.5) == np.inf
