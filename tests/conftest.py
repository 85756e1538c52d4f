"""The arm that most tests drive, fresh at `ready`."""

from __future__ import annotations

import pytest

from helicoide.kinematics.robot import Robot, load
from helicoide.state import State, initial


@pytest.fixture(scope="session")
def robot() -> Robot:
    return load("movemaster")


@pytest.fixture
def state(robot: Robot) -> State:
    return initial(robot)
