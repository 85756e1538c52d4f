"""Many more URDF texts that chance has changed, and none takes long."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.kinematics.urdf_mutations import judged


@pytest.mark.soak
@pytest.mark.parametrize("seed", range(2, 8))
def test_ten_thousand_texts_are_robots_or_refused(tmp_path: Path, seed: int) -> None:
    found, slowest = judged(tmp_path, seed, 10_000)
    assert found["robot"] + found["refused"] == 10_000
    assert slowest < 5
