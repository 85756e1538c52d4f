"""The messages of Cerbaro's Movemaster (2022, quadros 4 and 5): what was sent to its joints, and what they counted."""

from __future__ import annotations

import re
from functools import cached_property
from typing import Any

import numpy as np

from helicoide.kinematics.actuators import Actuators
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.recorder.joint_log import JointLog

ROBOT = "movemaster"
_NUMBER = re.compile(r"([1-5])\D*$")


class MovemasterLog:
    """The setpoints and the encoder counts in a file, as joint values.

    A setpoint holds the angles of the motors, deg; a status the pulses of one motor. The pitch of the wrist also rolls
    it, so that both are divided into joint angles by the coupling of the robot's file (§3.2, fig. 20; tab. 4).
    """

    def __init__(self) -> None:
        self._pulses = np.full(5, np.nan)

    @cached_property
    def robot(self) -> Robot:
        """The Movemaster, which is loaded for its encoders."""
        return load_robot(ROBOT)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The names of its joints."""
        return tuple(variable.name for variable in self.robot.variables)

    @cached_property
    def setpoints(self) -> JointLog:
        """What was sent."""
        return JointLog(self.names)

    @cached_property
    def read_back(self) -> JointLog:
        """What the encoders counted."""
        return JointLog(self.names)

    @property
    def _actuators(self) -> Actuators:
        actuators = self.robot.actuators
        assert actuators is not None
        return actuators

    def add_setpoint(self, ns: int, message: Any) -> None:
        """Take a setpoint; one that stops the arm or sends it home names no angles."""
        if not message.emergency_stop and message.GoHome == 0:
            sent = np.radians([getattr(message, f"set_{k}") for k in range(1, 6)])
            self.setpoints.add(ns, self._actuators.inverse_coupling @ sent)

    def add_status(self, topic: str, ns: int, message: Any) -> None:
        """Take the status of a joint, which its name or its topic ends with; a sample follows once all are known."""
        number = _NUMBER.search(message.joint) or _NUMBER.search(topic)
        if number is None:
            return
        self._pulses[int(number[1]) - 1] = message.pulse_count
        if np.isfinite(self._pulses).all():
            self.read_back.add(ns, self._actuators.to_joints(self._pulses))
