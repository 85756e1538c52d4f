"""The studies of Cerbaro 2022 but for chapter 6, whole as the command runs them: which of their rows differ."""

from __future__ import annotations

import pytest

from helicoide import studies
from helicoide.studies.study import Verdict

pytestmark = pytest.mark.soak

NAMES = (
    "cerbaro_forward",
    "cerbaro_redundancy",
    "cerbaro_orca_convergence",
    "cerbaro_orca_circle",
    "cerbaro_orca_secondary",
    "cerbaro_movemaster_convergence",
    "cerbaro_movemaster_ellipse",
    "cerbaro_movemaster_secondary",
    "cerbaro_algorithm_1",
)
DIFFERS = {"cerbaro_forward": 1, "cerbaro_movemaster_ellipse": 2, "cerbaro_algorithm_1": 1}


@pytest.mark.parametrize("name", NAMES)
def test_a_whole_study_says_what_it_says(name: str) -> None:
    study = studies.study_named(name)
    rows = study.run(study.Options(), False, lambda share: None).rows
    differing = [row for row in rows if row.verdict is Verdict.DIFFERS]
    assert all(row.why for row in differing)
    assert len(differing) == DIFFERS.get(name, 0)
