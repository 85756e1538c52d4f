"""Whatever a URDF holds, it is a robot or is refused in words."""

from __future__ import annotations

from pathlib import Path

from tests.kinematics.urdf_mutations import judged


def test_a_text_that_chance_has_changed_is_a_robot_or_refused(tmp_path: Path) -> None:
    found, _ = judged(tmp_path, 1, 2000)
    assert min(found["robot"], found["refused"]) > 200
