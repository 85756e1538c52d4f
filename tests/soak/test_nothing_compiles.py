"""After the preparation nothing is compiled, whatever is pressed, with any arm."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.session.test_nothing_compiles import pressed

from helicoide import content

pytestmark = pytest.mark.soak


def test_nothing_is_compiled_with_any_arm(tmp_path: Path) -> None:
    pressed(tmp_path, *content.content_folders("robots"))
