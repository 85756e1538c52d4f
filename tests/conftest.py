"""The arm that most tests drive, fresh at `ready`."""

from __future__ import annotations

import pytest
from hypothesis import settings

from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.state import State, initial

# the first call of a kernel compiles it, which takes longer than any example may
settings.register_profile("kernels", deadline=None)
settings.load_profile("kernels")


@pytest.fixture(scope="session")
def robot() -> Robot:
    return load("movemaster")


@pytest.fixture
def state(robot: Robot) -> State:
    return initial(robot)
