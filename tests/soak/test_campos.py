"""The studies of Campos' slides that take long: 20,000 postures of each arm, fine maps, 1,500 arms of each row."""

from __future__ import annotations

from typing import Any

import pytest
from tests.studies.test_campos import NAMES, QUICK, held, ran

from helicoide.studies import campos_families, campos_table
from helicoide.studies.study import Verdict

pytestmark = pytest.mark.soak


@pytest.mark.parametrize("name", [name for name in NAMES if name not in QUICK])
def test_what_the_slides_print_holds_in_the_whole_form(name: str) -> None:
    held(name, ran(name, short=False))


@pytest.mark.parametrize(
    ("name", "options", "most"),
    [("campos_table", {"arms": 1500}, campos_table.ROWS[-1][1]), ("campos_families", {"goals": 5000}, None)],
)
def test_many_arms_and_many_goals(name: str, options: dict[str, Any], most: int | None) -> None:
    result = ran(name, short=False, **options)
    for row in result.rows:
        print(f"{row.quantity.en}: {row.computed:.6g} {row.unit}")
        assert row.verdict is Verdict.OURS
        if most is not None and row.quantity.en.startswith(("most postures", "postures of the PUMA")):
            assert row.computed <= most
        if row.quantity.en.startswith("PUMA") and row.quantity.en.endswith("postures for each goal"):
            assert row.computed == 8 or campos_families.SEARCH.en in row.quantity.en
