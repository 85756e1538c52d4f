"""Pinocchio, called from Python: its SE3 object, for a script that goes on with Pinocchio, and the new array of it."""

import numpy as np
import pinocchio
from answer import Rows, Task, answer

REFERENCE = "forwardKinematics(model, data, q); updateFramePlacement(model, data, frame)"
POSE = f"{REFERENCE}.homogeneous"
JACOBIAN = "computeFrameJacobian(model, data, q, frame, LOCAL_WORLD_ALIGNED)"


def tasks_of(urdf: str, tool: str, postures: Rows) -> list[Task]:
    model = pinocchio.buildModelFromXML(urdf)
    data, frame = model.createData(), model.getFrameId(tool)
    qs = [np.array(q) for q in postures]
    q = qs[0]

    def pose(q: np.ndarray) -> np.ndarray:
        pinocchio.forwardKinematics(model, data, q)
        return pinocchio.updateFramePlacement(model, data, frame).homogeneous

    names = vars(pinocchio) | locals()
    return [
        Task("pose, no new array", REFERENCE, "pose(q)", names),
        Task("pose", POSE, "pose(q)", names),
        Task("Jacobian", JACOBIAN, f"[{JACOBIAN} for q in qs[:100]]", names),
        Task("10,000 poses", f"for q in qs: {POSE}", "[pose(q) for q in qs]", names),
    ]


answer(tasks_of)
