"""The Robotics Toolbox by its fastest way, an ETS: the chain in its own C++, poses as bare arrays."""

from xml.etree import ElementTree

import numpy as np
from answer import Rows, Task, answer
from roboticstoolbox import ET, ETS
from spatialmath import SE3


def chain_of(urdf: str) -> ETS:
    """The joints of a URDF whose axes are all z; its joints stand in the order of the chain."""
    transforms = []
    for joint in ElementTree.fromstring(urdf).iter("joint"):
        origin = joint.find("origin").attrib
        xyz, rpy = ([float(word) for word in origin[key].split()] for key in ("xyz", "rpy"))
        transforms.append(ET.SE3(SE3(xyz) * SE3.RPY(rpy, order="zyx")))
        if joint.get("type") != "fixed":
            transforms.append(ET.Rz())
    return ETS(transforms).compile()


def tasks_of(urdf: str, tool: str, postures: Rows) -> list[Task]:
    qs = np.array(postures)
    names = {"ets": chain_of(urdf), "qs": qs, "q": qs[0]}
    return [
        Task("pose", "ets.eval(q)", "ets.eval(q)", names),
        Task("Jacobian", "ets.jacob0(q)", "[ets.jacob0(q) for q in qs[:100]]", names),
        Task("10,000 poses", "ets.eval(qs)", "ets.eval(qs)", names),
    ]


answer(tasks_of)
