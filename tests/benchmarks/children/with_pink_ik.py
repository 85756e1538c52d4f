"""Pink on Pinocchio with DAQP; the planes are a limit of its own kind, all rows at once."""

from __future__ import annotations

import numpy as np
import pinocchio
from pink import Configuration, solve_ik
from pink.limits import ConfigurationLimit, Limit, VelocityLimit
from pink.tasks import FrameTask
from turns import Numbers, Turn, following, take_turns


class Dampers(Limit):
    """n·J Δq ≥ −decay · l of every point and plane."""

    def __init__(self, model: pinocchio.Model, links: list[int], points: Numbers, given: dict) -> None:
        names = ["base" if link == 0 else f"link{link - 1}" for link in links]
        self.frames = []
        for j, (name, point) in enumerate(zip(names, points, strict=True)):
            carrier = model.frames[model.getFrameId(name)]
            placed = carrier.placement * pinocchio.SE3(np.eye(3), np.array(point))
            frame = pinocchio.Frame(f"point{j}", carrier.parentJoint, placed, pinocchio.FrameType.OP_FRAME)
            self.frames.append(model.addFrame(frame))
        self.normals, self.offsets = np.array(given["normals"]), np.array(given["offsets"])
        self.decay = given["decay"]

    def compute_qp_inequalities(self, configuration: Configuration, dt: float) -> tuple[np.ndarray, np.ndarray]:
        model, data, world = configuration.model, configuration.data, pinocchio.LOCAL_WORLD_ALIGNED
        J = [pinocchio.getFrameJacobian(model, data, frame, world)[:3] for frame in self.frames]
        points = np.array([data.oMf[frame].translation for frame in self.frames])
        near = points @ self.normals.T - self.offsets
        return -(self.normals @ np.array(J)).reshape(near.size, -1), self.decay * np.maximum(near, 0.0).ravel()


def prepared(urdf: str, start: Numbers, targets: Numbers, links: list[int], points: Numbers, **given) -> Turn:
    model = pinocchio.buildModelFromXML(urdf)
    dampers = [Dampers(model, links, points, given)] if given["normals"] else []
    limits = [ConfigurationLimit(model, config_limit_gain=1.0), VelocityLimit(model), *dampers]
    task = FrameTask("tool", position_cost=1.0, orientation_cost=1.0, gain=given["gain"])
    desired, dt, damping = [pinocchio.SE3(np.array(T)) for T in targets], given["dt"], given["damping"]
    configuration = Configuration(model, model.createData(), np.array(start))

    def step(k: int) -> np.ndarray:
        task.set_target(desired[k])
        v = solve_ik(configuration, [task], dt, "daqp", damping, limits, safety_break=False)
        configuration.integrate_inplace(v, dt)
        return configuration.q

    return following(lambda: configuration.update(np.array(start)), step)


take_turns(prepared)
