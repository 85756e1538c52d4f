"""The simulations of Vargas 2013 at their full length and step. Run with `make soak`."""

from __future__ import annotations

import pytest
from tests.studies.test_vargas import QUICK, STUDIES, is_done, off

from helicoide.studies import named

pytestmark = pytest.mark.soak

# Rows that differ from the digest's number, and ours: the error of the inverse in Sim. 3 is that of Euler's rule for q.
EXCUSED = {"vargas_03": [("largest error of position after 3 s: inverse", pytest.approx(3e-4, abs=6e-5))]}


@pytest.mark.parametrize("name", [name for name in STUDIES if name not in QUICK])
def test_the_whole_form(name: str) -> None:
    study, told = named(name), list[float]()
    result = study.run(study.Options(), False, told.append)
    for row in result.rows:
        print(f"{row.quantity.en}: {row.ours:.5g} for {row.digest}")
    assert [(row.quantity.en, row.ours) for row in off(result)] == EXCUSED.get(name, [])
    assert sum(row.digest is not None for row in result.rows) >= 4
    assert is_done(told)
