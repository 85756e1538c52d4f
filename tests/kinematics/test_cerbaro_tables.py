"""The tables and equations of kinematics of Cerbaro 2022: as printed, and with what is put right."""

from __future__ import annotations

from dataclasses import replace
from functools import reduce
from itertools import product

import numpy as np
import pytest

from helicoide.arrays import Array
from helicoide.kinematics.dh import Convention, DhRow, dh_transform
from helicoide.kinematics.forward import screw_transform
from helicoide.kinematics.library import load_robot

TURNING = load_robot("movemaster").joints[0]
MOVEMASTER = np.radians([30, 60, -90, -30, 90])
ORCA = np.radians([20, 90, -110])


def tool(convention: Convention, rows: list[tuple[float, float, float, float]], q: Array) -> Array:
    """The origin of the last DH frame, mm; rows: θ, d, a, α in rad and mm."""
    steps = [dh_transform(convention, DhRow(*row), TURNING, value) for row, value in zip(rows, q, strict=True)]
    return np.asarray(reduce(np.matmul, steps)[:3, 3])


@pytest.mark.parametrize(
    ("lengths", "place"), [((235, 245, 65), (202.03, 310.60)), ((245, 240, 170), (318.140, 309.321))]
)
def test_the_lengths_of_table_5(lengths: tuple[float, ...], place: tuple[float, float]) -> None:
    """Those of table 7 lead to the p′ of eq. 2; those that table 5 prints do not."""
    rows = [(0.0, 0.0, length, 0.0) for length in lengths]
    np.testing.assert_allclose(tool("standard", rows, ORCA)[:2], place, rtol=0, atol=0.01)


@pytest.mark.parametrize(("d1", "z"), [(0.0, -100.0), (400.0, 300.0)])
def test_the_first_offset_of_table_6(d1: float, z: float) -> None:
    """As printed the shoulder is on the bench, and the tool of eq. 5 under it."""
    quarter = np.pi / 2
    rows = [(0, d1, 120, quarter), (0, 0, 250, 0), (0, 0, 200, 0), (quarter, 0, 0, quarter), (0, 250, 0, 0)]
    np.testing.assert_allclose(tool("standard", rows, MOVEMASTER), [470.429, 271.603, z], rtol=0, atol=1e-3)


def test_the_rows_for_the_matrix_of_eq_58() -> None:
    """Modified rows: each α and a belongs to the joint before."""
    quarter = np.pi / 2
    rows = [(0, 400, 0, 0), (0, 0, 120, quarter), (0, 0, 250, 0), (quarter, 0, 200, 0), (0, 250, 0, quarter)]
    np.testing.assert_allclose(tool("modified", rows, MOVEMASTER), [470.429, 271.603, 300], rtol=0, atol=1e-3)
    standard = [(0, 400, 120, quarter), (0, 0, 250, 0), (0, 0, 200, 0), (quarter, 0, 0, quarter), (0, 250, 0, 0)]
    assert np.abs(tool("modified", standard, MOVEMASTER) - [470.429, 271.603, 300]).max() > 100


@pytest.mark.parametrize("signs", [signs for signs in product((1, -1), repeat=3) if signs != (1, 1, 1)])
def test_the_sine_terms_of_eq_61(signs: tuple[int, ...]) -> None:
    """(1,3) has + s_y sin θ, (2,1) + s_z sin θ, (3,2) + s_x sin θ: with another sign it is no rotation."""
    axis = np.array([1.0, 2.0, 2.0]) / 3
    R = screw_transform(replace(TURNING, direction=axis), 1.0)[:3, :3].copy()
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-15)
    for sign, (row, column), component in zip(signs, ((0, 2), (1, 0), (2, 1)), (1, 2, 0), strict=True):
        R[row, column] += (sign - 1) * axis[component] * np.sin(1.0)
    assert np.abs(R @ R.T - np.eye(3)).max() > 0.1
