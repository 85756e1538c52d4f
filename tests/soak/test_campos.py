"""The studies of Campos' slides that take long: 20,000 postures of each arm, fine maps, 1,500 arms of each family."""

from __future__ import annotations

from typing import Any

import pytest
from tests.studies.test_campos import NAMES, QUICK, ran

pytestmark = pytest.mark.soak

OPTIONS: dict[str, dict[str, Any]] = {"campos_table": {"arms": 1500}, "campos_projection": {"goals": 5000}}


@pytest.mark.parametrize("name", [name for name in NAMES if name not in QUICK or name in OPTIONS])
def test_whole_forms(name: str) -> None:
    for row in ran(name, short=False, **OPTIONS.get(name, {})).rows:
        print(f"{row.quantity.en}: {row.ours:.6g} ({row.relation} {row.digest}) {row.unit}")
