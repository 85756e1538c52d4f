"""The Python example of the README runs as printed, and gives the results that the README states."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helicoide.kinematics import tool_kernels

ROOT = Path(__file__).parents[1]


@pytest.mark.parametrize("name", ["README.md", "README.pt-BR.md"])
def test_the_script_comes_to_what_is_said(name: str) -> None:
    (script,) = re.findall(r"```python\n(.*?)```", (ROOT / name).read_text("utf-8"), re.DOTALL)
    known: dict[str, Any] = {}
    exec(script, known)
    assert len(known["answer"].branches) == 8
    there = tool_kernels.tool_pose(tool_kernels.arm_array(known["robot"]), known["q"])
    np.testing.assert_allclose(there, known["T"], atol=1e-6)
    assert known["work"].share == 1.0
