"""The link at the entry point: where its shaft is, and which arms are refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.ik.rcm.runs import START
from tests.kinematics.arms import MIXED, NAMES, arm

from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm.constrained import constrained
from helicoide.ik.rcm.follow import RcmControl, RcmState, rcm_loop
from helicoide.ik.rcm.passage import SLIT, TROCAR, insertion, passage_refusal, through
from helicoide.ik.rcm.paths import PATHS
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.studies._coutinho_runs import LINK, dia10, entry_on, problem_without_planes, seven_joints
from helicoide.text import HelicoideError


def test_the_restricted_link_of_the_source() -> None:
    """Fig. 4.1, tab. 4.2: 0.33 m along y, 0.15 m outside, 0.18 m inside, at the entry point of the robot's file."""
    robot = dia10()
    passage, rcm = through(robot, LINK), robot.frames["rcm"]
    np.testing.assert_allclose(passage.T_link_shaft, np.eye(4), atol=1e-12)
    assert passage.length == pytest.approx(0.33, abs=1e-12)
    T = link_poses(robot.chain, START)[LINK]
    entry = (T @ rcm.T_link_frame)[:3, 3]
    np.testing.assert_allclose(entry, [-0.054064, 0.757776, 1.049720], atol=6e-7)
    place = insertion(passage, T, entry)
    assert (place.outside, place.inside) == (pytest.approx(0.15), pytest.approx(0.18))
    np.testing.assert_allclose(place.lateral, 0.0, atol=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_shafts_run_from_joint_to_joint(name: str) -> None:
    """y of F_i points from a joint to the next one or to the tool, for every link of every arm that has a length."""
    robot = arm(name)
    ends = [*robot.points, robot.T_world_tool_0[:3, 3]]
    for link in range(1, len(robot.joints) + 1):
        way = ends[link] - ends[link - 1]
        if not np.linalg.norm(way):
            with pytest.raises(HelicoideError, match="no length"):
                through(robot, link)
            continue
        passage = through(robot, link)
        R = passage.T_link_shaft[:3, :3]
        np.testing.assert_allclose(passage.length * R[:, 1], way, atol=1e-12)
        np.testing.assert_allclose(R.T @ R, np.eye(3), atol=1e-12)
        assert np.linalg.det(R) == pytest.approx(1.0)


def test_an_entry_point_beside_the_shaft() -> None:
    """The lateral error is the way from the shaft to the entry point along x and z of F_i."""
    robot = dia10()
    T = link_poses(robot.chain, START)[LINK]
    entry = entry_on(robot, START, 0.15) + T[:3, :3] @ [0.003, 0.0, -0.004]
    np.testing.assert_allclose(insertion(through(robot, LINK), T, entry).lateral, [0.003, -0.004], atol=1e-12)
    np.testing.assert_allclose(insertion(through(robot, LINK, SLIT), T, entry).lateral, [0.003], atol=1e-12)


@pytest.mark.parametrize("link", [0, 9])
def test_a_link_that_is_not_there(link: int) -> None:
    with pytest.raises(HelicoideError, match="1 to 8"):
        through(dia10(), link)


@pytest.mark.parametrize(
    ("robot", "across", "rank"),
    [(dia10, TROCAR, 6), (dia10, SLIT, 6), (seven_joints, TROCAR, 5), (seven_joints, SLIT, 6)],
)
def test_n_minus_r_decides_on_the_rank(robot, across, rank: int) -> None:
    """§1.4, §5.1: eight joints reach all six ways, seven behind a trocar five: n − r ≥ 6."""
    passage = through(robot(), LINK, across)
    q = START[: len(robot().joints)]
    at = constrained(problem_without_planes(robot()), passage, q, entry_on(robot(), q, 0.15))
    assert at.of_tool.rank == rank
    assert (passage_refusal(robot(), passage) is None) == (rank == 6)


def test_seven_joints_are_refused_in_words() -> None:
    robot, passage = seven_joints(), through(seven_joints(), LINK)
    said = passage_refusal(robot, passage)
    assert said is not None
    assert "7 joints" in said.en
    assert "n − r = 5" in said.en
    assert "7 juntas" in said.pt_BR
    assert "n − r = 5" in said.pt_BR
    q = START[:7]
    reference = PATHS["S2"].task(tool_at(robot, q))
    steps = rcm_loop(
        problem_without_planes(robot), passage, RcmControl(), reference, RcmState(q, entry_on(robot, q, 0.15)), 0.02
    )
    with pytest.raises(HelicoideError, match="at least 8 joints"):
        next(steps)


def test_the_rod_arm_is_refused_too() -> None:
    robot = load_robot("dia10_rod")
    said = passage_refusal(robot, through(robot, 7))
    assert said is not None
    assert "n − r = 5" in said.en


@pytest.mark.parametrize("link", [2, 4])
def test_an_entry_point_too_near_the_base_is_refused(link: int) -> None:
    """Four joints cannot give their link every velocity that the entry point leaves free."""
    said = passage_refusal(dia10(), through(dia10(), link))
    assert said is not None
    assert f"link {link}" in said.en
    assert "from 6 to 6" in said.en
    assert f"elo {link}" in said.pt_BR


def test_an_entry_point_beyond_the_wrist_is_refused() -> None:
    said = passage_refusal(dia10(), through(dia10(), 8, SLIT))
    assert said is not None
    assert "8 joints before it and 0 beyond" in said.en
    assert passage_refusal(dia10(), replace(through(dia10(), LINK, SLIT), link=7)) is None


def test_joints_that_follow_others_are_refused() -> None:
    said = passage_refusal(arm(MIXED), through(arm(MIXED), 2))
    assert said is not None
    assert "coupled joints" in said.en
    assert "juntas acopladas" in said.pt_BR
