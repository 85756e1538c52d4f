"""Rows recovered from screws move as the screws do, and both conventions tell of one arm."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.kinematics.arms import NAMES, arm, postures

from helicoide.arrays import Array, frozen
from helicoide.kinematics import dh
from helicoide.kinematics.chain import Joint, Mimic, chain_array, joint_positions
from helicoide.kinematics.dh import DhRow, DhTable
from helicoide.kinematics.forward import screw_transform
from helicoide.text import untranslated

Joints = tuple[Joint, ...]
RELATIONS = ("skew", "meeting", "parallel", "opposite", "coincident", "close", "nearly", "nearly opposite")
kinds = st.sampled_from(["revolute", "revolute", "prismatic", "follows"])
links = st.tuples(st.sampled_from(RELATIONS), kinds)
seeds = st.integers(0, 2**32 - 1)


def unit(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))


def joint(direction: Array, point: Array, slides: bool = False, mimic: Mimic | None = None) -> Joint:
    return Joint(
        "joint",
        untranslated("joint"),
        "prismatic" if slides else "revolute",
        lower=-3,
        upper=3,
        speed=1,
        link="link",
        direction=frozen(unit(direction)),
        point=frozen(point),
        mimic=mimic,
    )


def next_axis(relation: str, before: Joint, draw: np.random.Generator, sine: float) -> tuple[Array, Array]:
    """Direction and point of an axis that stands in a relation to the one before; nearly: parallel but for a sine."""
    s, point, other = before.direction, before.point, draw.uniform(-1, 1, 3)
    while np.linalg.norm(np.cross(s, unit(other))) < 0.01:  # the common normal of almost parallel axes is far away
        other = draw.uniform(-1, 1, 3)
    on_axis = point + draw.uniform(-1, 1) * s
    match relation:
        case "skew":
            return other, draw.uniform(-1, 1, 3)
        case "meeting":
            return other, on_axis + draw.uniform(-1, 1) * unit(other)
        case "parallel":
            return s, point + other
        case "opposite":
            return -s, point + other
        case "nearly" | "nearly opposite":
            leaning = s + sine * unit(np.cross(s, other))
            return leaning if relation == "nearly" else -leaning, draw.uniform(-1, 1, 3)
        case "coincident":
            return s, on_axis
        case _:
            return s, on_axis + 1e-10 * np.cross(s, unit(other))


def chain(
    relations: list[tuple[str, str]], seed: int, sine: float | None = None
) -> tuple[Joints, Array, np.random.Generator]:
    """Joints whose axes stand in these relations, a tool at q = 0, and the generator for what else is drawn."""
    draw = np.random.default_rng(seed)
    joints = [joint(draw.uniform(-1, 1, 3), draw.uniform(-1, 1, 3))]
    for relation, kind in relations:
        mimic = Mimic(0, draw.uniform(-2, 2), draw.uniform(-1, 1)) if kind == "follows" else None
        leaning = 10 ** draw.uniform(-12, -3) if sine is None else sine
        joints.append(joint(*next_axis(relation, joints[-1], draw, leaning), kind == "prismatic", mimic))
    tool = screw_transform(joint(draw.uniform(-1, 1, 3), draw.uniform(-1, 1, 3)), draw.uniform(-3, 3))
    return tuple(joints), tool, draw


def values(joints: Joints, draw: np.random.Generator) -> Array:
    """Where the joints stand at random variables."""
    return joint_positions(chain_array(joints), draw.uniform(-3, 3, sum(joint.mimic is None for joint in joints)))


def by_screws(joints: Joints, stand: Array, tool: Array) -> Array:
    T = np.eye(4)
    for joint, value in zip(joints, stand, strict=True):
        T = T @ screw_transform(joint, value)
    return np.asarray(T @ tool)


def by_rows(table: DhTable, joints: Joints, stand: Array) -> Array:
    return np.asarray(dh.dh_poses(table, joints, stand)[-1] @ table.T_dh_tool)


@given(st.lists(links, min_size=1, max_size=7), seeds)
def test_recovered_rows_move_as_the_screws(relations: list[tuple[str, str]], seed: int) -> None:
    joints, tool, draw = chain(relations, seed)
    table = dh.dh_from_screws(joints, tool)
    for stand in (np.zeros(len(joints)), values(joints, draw)):
        np.testing.assert_allclose(by_rows(table, joints, stand), by_screws(joints, stand, tool), rtol=0, atol=1e-9)


@given(st.lists(links, min_size=1, max_size=7), seeds)
def test_every_z_axis_lies_along_the_next_joint(relations: list[tuple[str, str]], seed: int) -> None:
    """Frame i - 1 has its z on axis i, from T_world_dh on; the last frame stays on the last axis."""
    joints, tool, _ = chain(relations, seed)
    frames = dh.dh_poses(table := dh.dh_from_screws(joints, tool), joints, np.zeros(len(joints)))
    for frame, carried in zip(frames, (*joints, joints[-1]), strict=True):
        np.testing.assert_allclose(frame[:3, 2], carried.direction, rtol=0, atol=1e-9)
        beside = np.cross(frame[:3, 3] - carried.point, carried.direction)
        np.testing.assert_allclose(beside, 0, atol=1e-9)
    np.testing.assert_allclose(frames[-1] @ table.T_dh_tool, tool, rtol=0, atol=1e-9)
    assert table.rows[-1] == DhRow(0, 0, 0, 0)
    assert min(row.a for row in table.rows) >= -1e-12


@pytest.mark.parametrize("name", NAMES)
def test_the_rows_of_a_robot_can_be_recovered_from_its_screws(name: str) -> None:
    robot = arm(name)
    table = dh.dh_from_screws(robot.joints, robot.T_world_tool_0)
    for q in postures(robot, 5):
        stand = joint_positions(robot.chain, q)
        given_rows = by_rows(robot.dh, robot.joints, stand)
        np.testing.assert_allclose(by_rows(table, robot.joints, stand), given_rows, rtol=0, atol=1e-9)


def modified(table: DhTable) -> DhTable:
    """The same standard rows in the modified convention: every row takes a and α of the one before it."""
    before = (DhRow(0, 0, 0, 0), *table.rows[:-1])
    rows = tuple(
        DhRow(row.theta, row.d, old.a, old.alpha, old.beta) for row, old in zip(table.rows, before, strict=True)
    )
    last = replace(table.rows[-1], theta=0, d=0)
    still = joint(np.array([0, 0, 1]), np.zeros(3))
    T_dh_tool = dh.dh_transform("standard", last, still, 0) @ table.T_dh_tool
    return DhTable("modified", rows, table.T_world_dh, frozen(T_dh_tool))


@given(st.lists(links, min_size=1, max_size=7), seeds)
def test_both_conventions_tell_of_one_arm(relations: list[tuple[str, str]], seed: int) -> None:
    joints, tool, draw = chain(relations, seed)
    table = dh.dh_from_screws(joints, tool)
    stand = values(joints, draw)
    other = by_rows(modified(table), joints, stand)
    np.testing.assert_allclose(other, by_rows(table, joints, stand), rtol=0, atol=1e-9)


def test_the_puma_in_the_other_convention() -> None:
    """Campos 1998, s.19 gives modified rows; these are the standard ones of the same arm, written by hand."""
    robot, right = arm("puma560"), np.pi / 2
    rows = [(0, 0, -right), (0, 0.4318, 0), (0.1244, 0.0203, -right), (0.4318, 0, right), (0, 0, -right), (0, 0, 0)]
    table = DhTable("standard", tuple(DhRow(0, *row) for row in rows), np.eye(4), np.eye(4))
    for q in postures(robot, 20):
        np.testing.assert_allclose(
            by_rows(table, robot.joints, q), by_rows(robot.dh, robot.joints, q), rtol=0, atol=1e-12
        )


@pytest.mark.parametrize("kind", ["revolute", "prismatic"])
@pytest.mark.parametrize("sine", [10.0**-k for k in range(1, 13)])
def test_axes_that_are_nearly_parallel_cost_little_accuracy(sine: float, kind: str) -> None:
    """Rows lose 1e-15/s m where the common normal is taken, which is some 1/s away, and nothing where it is not."""
    expected = 1e-15 / sine if sine >= dh.NEARLY_PARALLEL else 0.0
    for seed in range(10):
        joints, tool, draw = chain([("skew", "revolute"), ("nearly", kind), ("skew", "revolute")], seed, sine)
        assert np.linalg.norm(np.cross(joints[1].direction, joints[2].direction)) == pytest.approx(sine, rel=1e-2)
        table = dh.dh_from_screws(joints, tool)
        for _ in range(5):
            stand = values(joints, draw)
            error = np.abs(by_rows(table, joints, stand) - by_screws(joints, stand, tool)).max()
            assert error < 10 * expected + 2e-14
