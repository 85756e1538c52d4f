"""Every condition between a wish and the arm: what comes from a browser is checked here, and becomes an Update. Pure.

A wish that cannot be granted leaves the state as it was, but for a notice that says why. Values are judged here and
nowhere else: a browser may send anything.
"""

from helicoide.gate.check import LATCH, PARKED, pose
from helicoide.gate.joints import NO_PARKING, get_ready, go_to, park, set_gripper, set_joint
from helicoide.gate.path import pause, play, scrub
from helicoide.gate.planes import drag_plane, restore_planes
from helicoide.gate.stopping import stop
from helicoide.gate.target import Phase, drag_target, hold_orientation, set_target

__all__ = [
    "LATCH",
    "NO_PARKING",
    "PARKED",
    "Phase",
    "drag_plane",
    "drag_target",
    "get_ready",
    "go_to",
    "hold_orientation",
    "park",
    "pause",
    "play",
    "pose",
    "restore_planes",
    "scrub",
    "set_gripper",
    "set_joint",
    "set_target",
    "stop",
]
