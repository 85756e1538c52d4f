"""Coefficients that mean the same but for their axis are explained once."""

from __future__ import annotations

import pytest

from helicoide import readout
from helicoide.kinematics.library import load_robot
from helicoide.seat import Notation, ShownAlgebra
from helicoide.state import initial_state
from helicoide.text import LANGUAGES

NOTATIONS: list[ShownAlgebra] = ["Cl(0,3,1)", "Cl(3,0,1)"]


@pytest.mark.parametrize("algebra", NOTATIONS)
@pytest.mark.parametrize("robot", ["puma560", "scara", "polar_rp"])
def test_every_coefficient_is_explained_once_and_no_two_in_the_same_words(robot: str, algebra: ShownAlgebra) -> None:
    state = initial_state(load_robot(robot))
    for element in readout.elements(state):
        values = element.values(state)
        shown = [
            one for one in readout.coefficients(element.nature, Notation(algebra)) if abs(values[one.place]) > 1e-3
        ]
        found = readout.shared_meanings(element.nature, values, shown)
        assert sorted(one.name for each in found for one in each.coefficients) == sorted(one.name for one in shown)
        for language in LANGUAGES:
            said = [each.text[language] for each in found]
            assert len({*said}) == len(said)
            assert not any("{" in words for words in said)


def test_the_position_of_an_axis_is_said_once_for_three_coefficients() -> None:
    state = initial_state(load_robot("puma560"))
    tool = readout.elements(state)[0]
    found = readout.shared_meanings("motor", tool.values(state), readout.coefficients("motor", Notation()))
    where = [each for each in found if "where the axis is" in each.text.en]
    assert [len(each.coefficients) for each in where] == [3]
    assert where[0].text.pt_BR.startswith("Dizem onde está o eixo: componentes x, y, z do momento")
