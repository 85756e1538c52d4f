"""mink on MuJoCo with DAQP; the planes are a limit of its own kind, all rows at once."""

from __future__ import annotations

from xml.etree import ElementTree

import mujoco
import numpy as np
from mink import SE3, Configuration, ConfigurationLimit, FrameTask, VelocityLimit, solve_ik
from mink.limits import Constraint, Limit
from turns import Numbers, Turn, following, take_turns


def mjcf_of(urdf: str) -> str:
    """The same chain for MuJoCo, which asks for a mass; the tool is a site."""
    root = ElementTree.Element("mujoco")
    ElementTree.SubElement(root, "compiler", angle="radian", eulerseq="XYZ", autolimits="true")
    body = ElementTree.SubElement(root, "worldbody")
    for i, joint in enumerate(ElementTree.fromstring(urdf).iter("joint")):
        origin = joint.find("origin").attrib
        placed = {"pos": origin["xyz"], "euler": origin["rpy"]}
        limit = joint.find("limit")
        if limit is None:
            ElementTree.SubElement(body, "site", name="tool", **placed)
            continue
        body = ElementTree.SubElement(body, "body", name=f"link{i}", **placed)
        ElementTree.SubElement(body, "inertial", pos="0 0 0", mass="1", diaginertia="1 1 1")
        ends = f"{limit.get('lower')} {limit.get('upper')}"
        ElementTree.SubElement(body, "joint", name=f"joint{i}", axis="0 0 1", range=ends)
    return ElementTree.tostring(root, encoding="unicode")


class Dampers(Limit):
    """n·J Δq ≥ −decay · l of every point and plane."""

    def __init__(self, links: list[int], points: Numbers, given: dict) -> None:
        self.carried = list(zip(links, map(np.array, points), strict=True))
        self.normals, self.offsets = np.array(given["normals"]), np.array(given["offsets"])
        self.decay = given["decay"]

    def compute_qp_inequalities(self, configuration: Configuration, dt: float) -> Constraint:
        model, data = configuration.model, configuration.data
        J, points = np.empty((len(self.carried), 3, model.nv)), np.empty((len(self.carried), 3))
        for j, (body, point) in enumerate(self.carried):
            points[j] = data.xmat[body].reshape(3, 3) @ point + data.xpos[body]
            mujoco.mj_jac(model, data, J[j], None, points[j], body)
        near = points @ self.normals.T - self.offsets
        G = -(self.normals @ J).reshape(near.size, -1)
        return Constraint(G=G, h=self.decay * np.maximum(near, 0.0).ravel())


def prepared(urdf: str, start: Numbers, targets: Numbers, links: list[int], points: Numbers, **given) -> Turn:
    model = mujoco.MjModel.from_xml_string(mjcf_of(urdf))
    speeds = {f"joint{i}": speed for i, speed in enumerate(given["speed"])}
    dampers = [Dampers(links, points, given)] if given["normals"] else []
    limits = [ConfigurationLimit(model, gain=1.0), VelocityLimit(model, speeds), *dampers]
    task = FrameTask("tool", "site", position_cost=1.0, orientation_cost=1.0, gain=given["gain"])
    desired, dt, damping = [SE3.from_matrix(np.array(T)) for T in targets], given["dt"], given["damping"]
    configuration = Configuration(model, np.array(start))

    def step(k: int) -> np.ndarray:
        task.set_target(desired[k])
        v = solve_ik(configuration, [task], dt, "daqp", damping, limits=limits)
        configuration.integrate_inplace(v, dt)
        return configuration.q.copy()

    return following(lambda: configuration.update(np.array(start)), step)


take_turns(prepared)
