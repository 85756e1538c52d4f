"""Many more URDF texts that chance has changed, and none takes long."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.kinematics.urdf_mutations import judged


@pytest.mark.soak
def test_sixty_thousand_texts_are_robots_or_refused(tmp_path: Path) -> None:
    found, slowest = judged(tmp_path, 2, 60_000)
    assert found["robot"] + found["refused"] == 60_000
    assert slowest < 5
