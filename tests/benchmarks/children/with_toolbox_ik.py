"""The Robotics Toolbox's search in C++: Levenberg-Marquardt after Chan, restarted from random postures."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
from roboticstoolbox import ET, ETS
from spatialmath import SE3
from turns import Numbers, Turn, take_turns, timed

ITERATIONS, SEARCHES = 30, 100


def chain_of(urdf: str, lower: Numbers, upper: Numbers) -> ETS:
    """The joints of a URDF whose axes are all z; its joints stand in the order of the chain."""
    transforms, limits = [], list(zip(lower, upper, strict=True))[::-1]
    for joint in ElementTree.fromstring(urdf).iter("joint"):
        origin = joint.find("origin").attrib
        xyz, rpy = ([float(word) for word in origin[key].split()] for key in ("xyz", "rpy"))
        transforms.append(ET.SE3(SE3(xyz) * SE3.RPY(rpy, order="zyx")))
        if joint.get("type") != "fixed":
            transforms.append(ET.Rz(qlim=limits.pop()))
    return ETS(transforms).compile()


def prepared(urdf: str, lower: Numbers, upper: Numbers, poses: Numbers, start: Numbers, tolerance: float) -> Turn:
    chain, targets, q0 = chain_of(urdf, lower, upper), np.array(poses), np.array(start)
    residual = tolerance**2 / 2

    def solve(k: int) -> object:
        return chain.ik_LM(targets[k], q0, ITERATIONS, SEARCHES, residual, None, True, 1.0, "chan")

    def turn(first: int, beyond: int) -> tuple[list[float], Numbers]:
        seconds, found = timed(solve, range(first, beyond))
        return seconds, [(answer.q, answer.searches) for answer in found]

    return turn


take_turns(prepared)
