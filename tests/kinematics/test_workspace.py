"""Maps of workspaces: areas in closed form, symmetry, and that they are the same whoever counts them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.kinematics.arms import MIXED, NAMES, arm, postures

from helicoide.arrays import Array, frozen
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.postures.workspace import dexterous
from helicoide.kernels import python_function
from helicoide.kinematics import workspace
from helicoide.kinematics.grid import WorkspaceGrid, cell_index
from helicoide.kinematics.manipulability import analyse_jacobian, position_manipulability
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import MapKind, WorkspaceMap
from helicoide.kinematics.workspace_kernels import orientation_bin, row_volume
from helicoide.studies._campos_arms import planar_with_lengths
from helicoide.text import HelicoideError


def mapped(robot: Robot, kind: MapKind, samples: int, seed: int = 0) -> WorkspaceMap:
    plan = workspace.plan_map(robot, kind, samples, seed)
    return workspace.collect_map(plan, workspace.count_chunks(plan), lambda share: None)


def turning_whole(robot: Robot) -> Robot:
    """The same arm whose first joint turns from −180° to 180°."""
    return replace(robot, joints=(replace(robot.joints[0], lower=-np.pi, upper=np.pi), *robot.joints[1:]))


def radii(found: WorkspaceMap) -> Array:
    return np.asarray(np.hypot(*found.cells.centres[:, :2].T))


@pytest.mark.parametrize(("l1", "l2"), [(1.0, 0.7), (0.7, 1.0), (1.0, 1.0), (2.0, 0.3)])
def test_the_annulus_of_two_links(l1: float, l2: float) -> None:
    """Campos 1998, s.8–10: area π((l₁ + l₂)² − (l₁ − l₂)²) = 4π l₁ l₂; none of its cells lies outside."""
    found = mapped(planar_with_lengths("planar2r", l1, l2), "reachable", 600_000)
    assert found.measure == pytest.approx(4 * np.pi * l1 * l2, rel=0.01)
    slack = found.cells.size / np.sqrt(2)
    r = radii(found)
    assert r[found.reached].max() <= l1 + l2 + slack
    assert r[found.reached].min() >= abs(l1 - l2) - slack
    assert found.reached[(r > abs(l1 - l2) + slack) & (r < l1 + l2 - slack)].all()


def test_half_the_elbow_reaches_as_far() -> None:
    """Campos 1998, s.12: with θ₂ in [0, 180]° the same points."""
    robot = planar_with_lengths("planar2r", 1.0, 0.7)
    joints = (robot.joints[0], replace(robot.joints[1], lower=0.0, upper=np.pi))
    found = mapped(replace(robot, joints=joints), "reachable", 600_000)
    assert found.measure == pytest.approx(4 * np.pi * 0.7, rel=0.01)


def test_the_ring_of_the_polar_arm() -> None:
    """Campos 1998, s.31–34: P = (x, y, 0) with ρ in the stroke, 0.3 to 0.8 m: π(0.8² − 0.3²) m²."""
    found = mapped(arm("polar_rp"), "reachable", 600_000)
    assert found.cells.axes.shape == (2, 3)
    assert found.measure == pytest.approx(np.pi * (0.8**2 - 0.3**2), rel=0.01)


def test_the_shell_of_an_arm_in_space() -> None:
    """The L-3 with its tool on the wrist and joints that turn whole: a ball of 0.9 m without one of 0.1 m."""
    robot = arm("motoman_l3")
    robot = replace(robot, joints=tuple(replace(joint, lower=-np.pi, upper=np.pi) for joint in robot.joints))
    found = mapped(robot, "reachable", 2_000_000)
    assert found.cells.axes.shape == (3, 3)
    assert found.measure == pytest.approx(4 / 3 * np.pi * (0.9**3 - 0.1**3), rel=0.03)


@pytest.mark.parametrize("name", NAMES)
def test_every_posture_hits_a_cell(name: str) -> None:
    """The grid holds all that the arm reaches, also with slides and joints that follow others; in its own plane."""
    plan = workspace.plan_map(arm(name), "reachable", 3_000)
    part = workspace.count_chunk(plan, 0)
    assert part.hits.sum() == 3_000
    centres = plan.cells.centres
    rng = np.random.default_rng([0, 0]).uniform(plan.lower, plan.upper, (3_000, len(plan.lower)))
    for q in rng[:50]:
        p = tool_at(arm(name), q)[:3, 3]
        nearest = np.argmin(np.linalg.norm(centres - p, axis=1))
        assert part.hits[nearest] > 0
        aside = p - centres[nearest]
        inside = plan.cells.axes @ aside
        assert np.abs(inside).max() <= plan.cells.size / 2 * (1 + 1e-9)
        if len(inside) == 2:
            assert np.linalg.norm(aside - plan.cells.axes.T @ inside) < 1e-12


@pytest.mark.parametrize("kind", workspace.MAP_KINDS)
def test_a_map_is_symmetric_about_the_first_axis(kind: MapKind) -> None:
    """Turned by 90° about a first joint that turns whole, it is the same within what chance leaves."""
    found = mapped(turning_whole(planar_with_lengths("planar3r", 1.0, 0.7, 0.2)), kind, 1_000_000)
    shape = found.cells.shape
    hits, values = found.hits.reshape(shape), found.values.reshape(shape)
    quarters = np.array([part.sum() for half in np.array_split(hits, 2) for part in np.array_split(half, 2, axis=1)])
    assert np.abs(quarters - 250_000).max() < 5 * np.sqrt(250_000 * 0.75)
    assert np.mean((hits > 0) != (np.rot90(hits) > 0)) < 0.003
    both = (hits > 0) & (np.rot90(hits) > 0)
    assert np.abs(values - np.rot90(values))[both].mean() < 0.02


def test_a_map_in_space_is_symmetric_about_the_first_axis() -> None:
    found = mapped(turning_whole(arm("motoman_l3")), "reachable", 1_000_000)
    hits = found.hits.reshape(found.cells.shape)
    quarters = np.array([part.sum() for half in np.array_split(hits, 2) for part in np.array_split(half, 2, axis=1)])
    assert np.abs(quarters - 250_000).max() < 5 * np.sqrt(250_000 * 0.75)
    assert found.measure == pytest.approx(_turned(found), rel=0.01)


def _turned(found: WorkspaceMap) -> float:
    return found.cells.measure(np.rot90(found.reached.reshape(found.cells.shape)).ravel())


def test_the_dexterous_ring_of_three_links() -> None:
    """Campos 1998, s.6–10: with L = (1, 0.7, 0.2) every orientation from 0.5 to 1.5 m, and not beyond."""
    found = mapped(planar_with_lengths("planar3r", 1.0, 0.7, 0.2), "dexterous", 1_500_000)
    ((inner, outer),) = dexterous(np.array([1.0, 0.7, 0.2]))
    r, slack = radii(found), found.cells.size
    assert found.values[(r > inner + slack) & (r < outer - slack)].min() > 0.95
    assert found.values[(r < inner - slack) | (r > outer + slack)].max() < 1
    edge = (r > 1.6) & (r < 1.75)
    assert np.all(found.values[edge] <= share_at(r[edge] - slack / np.sqrt(2)) + 2 / 64)
    assert np.mean(found.values[edge] - share_at(r[edge])) > 0


def share_at(r: Array) -> Array:
    """Beyond 1.5 m the wrist must stay within 1.7 m: cos φ ≥ (r² + 0.2² − 1.7²) / 0.4 r."""
    return np.asarray(np.arccos(np.clip((r**2 + 0.2**2 - 1.7**2) / (0.4 * r), -1, 1)) / np.pi)


def test_the_orientation_of_two_links_is_all_but_fixed() -> None:
    """Two postures for a point, each with its orientation: of 64 turns a cell sees few."""
    found = mapped(planar_with_lengths("planar2r", 1.0, 0.7), "dexterous", 1_000_000)
    assert np.median(found.values[found.reached]) < 0.15


def test_a_map_of_manipulability_holds_the_best_of_each_cell() -> None:
    """Two links: w = l₁ l₂ |sin θ₂|, which the distance from the first axis gives."""
    found = mapped(planar_with_lengths("planar2r", 1.0, 0.7), "manipulability", 1_000_000)
    r = radii(found)
    inside = (r > 0.4) & (r < 1.6)
    c2 = (r**2 - 1 - 0.49) / 1.4
    w = 0.7 * np.sqrt(np.clip(1 - c2**2, 0, 1))
    assert np.all(found.values <= 0.7 + 1e-12)
    assert np.abs(found.values - w)[inside].max() < 2 * found.cells.size
    assert found.values.max() == pytest.approx(0.7, abs=1e-4)


@pytest.mark.parametrize("name", ["puma560", "movemaster", "scara", "dia10", "planar2r", "polar_rp", MIXED])
def test_manipulability_is_that_of_the_jacobian(name: str) -> None:
    for q in postures(arm(name), 20):
        analysis = position_manipulability(arm(name), q)
        assert row_volume(np.ascontiguousarray(analysis.J)) == pytest.approx(analysis.w, rel=1e-9, abs=1e-12)


def test_manipulability_of_a_singular_jacobian_is_zero() -> None:
    assert row_volume(np.zeros((3, 4))) == 0.0
    assert row_volume(np.array([[1.0, 2, 3], [2, 4, 6]])) == pytest.approx(0, abs=1e-12)
    J = np.random.default_rng(0).normal(size=(3, 2))
    assert row_volume(J) == pytest.approx(analyse_jacobian(J).w)


def test_random_orientations_fall_evenly_into_their_kinds() -> None:
    """A random rotation is as likely in each of the 128 kinds: χ² within five of its deviations."""
    rng, axes = np.random.default_rng(1), np.eye(3)
    kinds = np.zeros(128)
    for wxyz in rng.normal(size=(128 * 60, 4)):
        w, x, y, z = wxyz / np.linalg.norm(wxyz)
        R = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )
        kinds[orientation_bin(R, axes)] += 1
    chi2 = float(np.sum((kinds - 60) ** 2 / 60))
    assert abs(chi2 - 127) < 5 * np.sqrt(2 * 127)


def test_a_cell_knows_its_points() -> None:
    cells = WorkspaceGrid(frozen([-1.0, 0.5, 0.0]), frozen([[1.0, 0, 0], [0, 0, 1]]), 0.25, (4, 8))
    for number, centre in enumerate(cells.centres):
        for one in (cell_index, python_function(cell_index)):
            assert one(centre + np.array([0.12, 7.0, -0.12]), cells.packed) == number
    for outside in ([-1.01, 0, 0.1], [0.01, 0, 0.1], [-0.5, 0, -0.01], [-0.5, 0, 2.01]):
        assert cell_index(np.array(outside), cells.packed) == -1


def test_areas_do_not_depend_on_the_way_the_border_runs() -> None:
    """A disc, and a square turned by some angles, to a few thousandths at 200 cells across."""
    cells = WorkspaceGrid(frozen([-1.0, -1.0, 0.0]), frozen(np.eye(3)[:2]), 0.01, (200, 200))
    corners = np.array([[x, y, 0] for x in (-0.005, 0.005) for y in (-0.005, 0.005)])
    touched = (cells.centres[:, None] + corners)[:, :, :2]
    disc = (np.abs(cells.centres[:, :2]).clip(min=0.005) - 0.005) ** 2
    assert cells.measure(disc.sum(axis=1) < 0.8**2) == pytest.approx(np.pi * 0.64, rel=2e-3)
    for angle in (0.1, 0.5, np.pi / 4):
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        inside = (np.abs(touched @ turn) < 0.5).all(axis=2).any(axis=1)
        assert cells.measure(inside) == pytest.approx(1.0, rel=6e-3)


@pytest.mark.parametrize("kind", workspace.MAP_KINDS)
def test_the_order_of_the_parts_does_not_matter(kind: MapKind) -> None:
    plan = workspace.plan_map(arm("puma560"), kind, 3 * workspace.CHUNK + 7)
    parts = list(workspace.count_chunks(plan))
    assert len(parts) == 4
    assert parts[-1].hits.sum() == 7
    shares: list[float] = []
    one, other = (workspace.collect_map(plan, iter(some), shares.append) for some in (parts, parts[::-1]))
    np.testing.assert_array_equal(one.hits, other.hits)
    np.testing.assert_array_equal(one.values, other.values)
    assert shares == [0.25, 0.5, 0.75, 1.0] * 2
    again = workspace.count_chunk(plan, 2)
    np.testing.assert_array_equal(again.hits, parts[2].hits)
    assert not np.array_equal(parts[0].hits, parts[1].hits)


def test_what_an_arm_can_is_in_its_key() -> None:
    robot = planar_with_lengths("planar2r", 1.0, 0.7)
    plan = workspace.plan_map(robot, "reachable", 1000)
    shorter = replace(robot.joints[1], upper=1.0)
    others = [
        workspace.plan_map(planar_with_lengths("planar2r", 1.0, 0.701), "reachable", 1000),
        workspace.plan_map(replace(robot, joints=(robot.joints[0], shorter)), "reachable", 1000),
        workspace.plan_map(robot, "manipulability", 1000),
        workspace.plan_map(robot, "reachable", 1001),
        workspace.plan_map(robot, "reachable", 1000, seed=1),
    ]
    assert len({plan.key, *(other.key for other in others)}) == 6
    assert workspace.plan_map(planar_with_lengths("planar2r", 1.0, 0.7), "reachable", 1000).key == plan.key


@pytest.mark.parametrize("samples", [0, -5])
def test_no_posture_is_refused(samples: int) -> None:
    with pytest.raises(HelicoideError, match="at least one posture"):
        workspace.plan_map(arm("puma560"), "reachable", samples)


def test_another_kind_is_refused_with_those_there_are() -> None:
    with pytest.raises(HelicoideError, match="reachable, dexterous, manipulability"):
        workspace.plan_map(arm("puma560"), "pretty", 10)  # type: ignore[arg-type]


def test_one_posture_makes_a_map() -> None:
    found = mapped(arm("puma560"), "manipulability", 1)
    assert found.hits.sum() == 1
    assert found.reached.sum() == 1
