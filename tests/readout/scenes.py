"""Random scenes of every arm, with a target, planes and an entry point where there is one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from tests.driving import with_joints
from tests.kinematics.arms import NAMES, arm

from helicoide import gate
from helicoide.geometry import rotation
from helicoide.state import State, initial_state

SCENES = [(name, seed) for name in NAMES for seed in range(3)]


def scene(name: str, seed: int) -> State:
    """The arm at random joint values within its limits, with three more planes, and a target elsewhere."""
    rng, state = np.random.default_rng(seed), initial_state(arm(name))
    robot = state.robot
    lower, upper = np.maximum(robot.lower, -np.pi), np.minimum(robot.upper, np.pi)
    state = with_joints(state, rng.uniform(lower, upper))
    for _ in range(3):
        normal = rng.normal(size=3)
        state = gate.add_plane([*normal / np.linalg.norm(normal), -3 * robot.reach])(state)
    if "rcm" in robot.frames:
        state = gate.enforce_entry(True)(state)
    turned = rotation.from_rotation_vector(rng.uniform(-2, 2, 3))
    state = gate.set_target(rng.uniform(-1, 1, 3) * robot.reach / 2, turned)(state)
    return replace(state, notice=None)
