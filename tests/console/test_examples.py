"""The example sheets give what Cerbaro 2022 prints in chapter 5 and appendix F; mm of the source are metres here."""

from __future__ import annotations

import pytest

from helicoide.console import example_sheets, sheet_results, value_terms
from helicoide.kinematics.robot import Robot
from helicoide.sheet import sheet_of_text, sheet_text
from helicoide.state import initial_state

Printed = dict[str, float]

# What is printed for a name, by its blades; blades that are not listed are zero. The last number is half a unit of the
# last printed digit. The dual quaternions of six digits and p*q are recomputed from the equations.
PRINTED: dict[str, dict[str, tuple[Printed, float]]] = {
    "quaternion_product": {
        "ii": ({"1": -1}, 1e-12),  # App. F
        "ijk": ({"1": -1}, 1e-12),
        "ij": ({"k": 1}, 1e-12),
        "pq": ({"1": 13, "i": -10, "j": 9, "k": 10}, 1e-12),  # eqs. 76-77
        "qp": ({"1": 13, "i": 16, "j": 5}, 1e-12),
        "p_star": ({"1": 1, "i": -2, "j": -3, "k": -4}, 1e-12),  # eq. 78
        "size": ({"1": 30**0.5}, 1e-12),  # eq. 80
        "one": ({"1": 1}, 1e-12),  # eq. 81
    },
    "quaternion_rotation": {
        "turned": ({"i": -2, "j": 1, "k": 3}, 1e-12),  # eq. 89
        "error_q": ({"1": 0.955336, "k": 0.295520}, 5e-7),  # eq. 91
        "sine": ({"1": 0.295520}, 5e-7),  # eq. 92
    },
    "hodge_star": {
        "star_e1": ({"e2e3e": 1}, 0),
        "star_e": ({"e1e2e3": -1}, 0),
        "star_e2e3e": ({"e1": -1}, 0),
        "star_e1e2e3": ({"e": 1}, 0),
        "star_e1e2": ({"e3e": 1}, 0),
        "star_e3e1": ({"e2e": 1}, 0),
        "star_e1e": ({"e2e3": 1}, 0),
        "volume": ({"e1e2e3e": 1}, 0),
    },
    "plane_distance": {
        "wall": ({"e3": -1, "e": -4}, 0),  # eq. 22
        "p": ({"e1e2e3": 1, "e2e3e": 3, "e3e1e": 2, "e1e2e": 2}, 0),  # eq. 23, whose -2 e1e3e is +2 e3e1e
        "difference": ({"e1e2e3e": 4}, 1e-12),  # eq. 24
        "l": ({"1": 2}, 1e-12),
        "l_again": ({"1": 2}, 1e-12),
    },
    "plane_through_points": {
        "sigma": ({"e1e2e3": 54, "e2e3e": 72, "e3e1e": 18, "e1e2e": -54}, 1e-9),
        "radicand": ({"1": 8424}, 1e-9),
        "wall": ({"e1": -0.7845, "e2": -0.1961, "e3": 0.5883, "e": 0.5883}, 5.1e-5),  # eq. 30
        "l1": ({}, 0),
        "l2": ({}, 0),
        "l3": ({}, 0),
        "wall_again": ({"e1": -0.7845, "e2": -0.1961, "e3": 0.5883, "e": 0.5883}, 5.1e-5),
    },
    "station_frame": {
        "S": ({"1": 0.866025, "e1e2": 0.5, "e1e": 0.216506, "e2e": -0.125}, 5e-7),  # 60°, then 0.5 m along x; ours
    },
    "rigid_motion": {
        "h": ({"1": 0.7071, "e1e2": 0.7071, "e1e": 0.0353553, "e2e": -0.0353553}, 1.1e-5),  # eq. 100
        "unit_size": ({"1": 1}, 1e-12),  # eq. 97
        "wall_moved": ({"e2": 1, "e": 0.05}, 1e-12),  # eq. 95
        "p_moved": ({"e1e2e3": 1, "e2e3e": 0.09, "e3e1e": 0.05, "e1e2e": 0.005}, 1e-12),
        "L_moved": ({"e1e2": 1, "e1e": 0.05, "e2e": -0.09}, 1e-12),
    },
    "orca_forward": {
        "tip": ({"e1e2e3": 1, "e2e3e": 0.318140, "e3e1e": 0.309321}, 5e-7),  # eqs. 1-3
        "pose": ({"1": 1, "e1e": 0.159069929, "e2e": 0.154660582}, 5e-10),
    },
    "movemaster_forward": {
        "tip": ({"e1e2e3": 1, "e2e3e": 0.470429, "e3e1e": 0.271602, "e1e2e": 0.3}, 6e-7),  # eqs. 4-6, 8
        "h": (
            {"1": 0.683013, "e2e3": 0.5, "e3e1": 0.5, "e1e2": -0.183013, "e1e2e3e": -0.010341380, "e1e": -0.319233938,
             "e2e": 0.385836478, "e3e": 0.220556080}, 5.1e-7,
        ),
        "pose": (
            {"1": 0.683013, "e2e3": 0.5, "e3e1": 0.5, "e1e2": -0.183013, "e1e2e3e": 0.158056080, "e1e": 0.060801270,
             "e2e": 0.210801270, "e3e": 0.152158620}, 5.1e-7,
        ),
        "elbow_joint": ({"e1e2e3": 1, "e2e3e": 0.212176, "e3e1e": 0.1225, "e1e2e": 0.616506}, 5.1e-7),
    },
}  # fmt: skip


def test_there_is_a_sheet_for_each_worked_example() -> None:
    assert example_sheets().keys() == PRINTED.keys()
    assert len(PRINTED) == 9  # eight worked examples of the source, and the station of a lesson


@pytest.mark.parametrize("name", PRINTED)
def test_a_sheet_gives_what_its_source_prints(name: str) -> None:
    sheet = example_sheets()[name].sheet
    results = sheet_results(sheet, None)
    assert [result.error for result in results if result.error is not None] == []
    found = {result.name: result.value for result in results}
    for line, (printed, tolerance) in PRINTED[name].items():
        value = found[line]
        assert value is not None
        terms = {unit: number for number, unit in value_terms(value)}
        assert terms == pytest.approx(printed, abs=tolerance), line


@pytest.mark.parametrize("name", PRINTED)
def test_a_sheet_has_titles_and_is_written_as_it_is_read(name: str, robot: Robot) -> None:
    example = example_sheets()[name]
    assert example.title.en
    assert example.title.pt_BR
    assert example.title.en != example.title.pt_BR
    assert not example.title.pt_BR.startswith("#")
    assert sheet_of_text(sheet_text(example.sheet)) == example.sheet
    results = sheet_results(example.sheet, initial_state(robot))
    assert all(result.error is None for result in results)
