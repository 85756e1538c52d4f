"""DQ Robotics' quadratic controller with quadprog; limits and planes are put together by hand, as it asks."""

from __future__ import annotations

import numpy as np
from dqrobotics import DQ, E_, haminus8, translation, vec3, vec8
from dqrobotics.robot_control import ControlObjective, DQ_ClassicQPController
from dqrobotics.robot_modeling import DQ_SerialManipulatorDH
from dqrobotics.solvers import DQ_QuadprogSolver
from turns import Numbers, Turn, following, take_turns

# The controller keeps no reference to it.
SOLVER = DQ_QuadprogSolver()


def quaternion(R: np.ndarray) -> DQ:
    """The unit quaternion of a rotation, from its largest component (Bar-Itzhack 2000)."""
    antisymmetric = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    K = np.block([[np.trace(R), antisymmetric], [antisymmetric[:, None], R + R.T - np.trace(R) * np.eye(3)]])
    return DQ(np.linalg.eigh(K)[1][:, -1])


def pose(T: np.ndarray) -> DQ:
    r = quaternion(T[:3, :3])
    return r + E_ * 0.5 * DQ([0.0, *T[:3, 3]]) * r


def arm_of(dh: dict) -> DQ_SerialManipulatorDH:
    arm = DQ_SerialManipulatorDH(np.array([[*row, 0.0] for row in dh["rows"]]).T)
    arm.set_reference_frame(pose(np.array(dh["start"])))
    arm.set_effector(pose(np.array(dh["tool"])))
    return arm


def controller_of(arm: DQ_SerialManipulatorDH, gain: float, damping: float, dt: float) -> DQ_ClassicQPController:
    controller = DQ_ClassicQPController(arm, SOLVER)
    controller.set_control_objective(ControlObjective.Pose)
    controller.set_gain(gain / dt)
    controller.set_damping(damping)
    return controller


class Bounds:
    """Rows A q̇ ≤ b: the limits, then n·J q̇ ≥ −(decay / dt) l of every point and plane."""

    def __init__(self, arm: DQ_SerialManipulatorDH, dh: dict, links: list[int], given: dict) -> None:
        self.arm, self.dt, n = arm, given["dt"], len(dh["rows"])
        self.lower, self.upper, self.speed = (np.array(given[name]) for name in ("lower", "upper", "speed"))
        self.normals, self.offsets = np.array(given["normals"]).reshape(-1, 3), np.array(given["offsets"])
        self.across, self.share = np.insert(self.normals, 0, 0.0, axis=1), given["decay"] / self.dt
        self.carried = []
        for link, point in zip(links, dh["points"], strict=True) if len(self.offsets) else ():
            # Of the last link the library gives the tool's frame.
            frame = np.array(dh["tool"]) if link == n else np.eye(4)
            shift = 1 + E_ * 0.5 * DQ([0.0, *np.linalg.solve(frame, [*point, 1.0])[:3]])
            self.carried.append((link - 1, shift, haminus8(shift)))
        self.A = np.vstack([np.eye(n), -np.eye(n), np.zeros((len(self.carried) * len(self.offsets), n))])
        self.b = np.empty(len(self.A))

    def update(self, q: np.ndarray) -> None:
        n, many = len(q), len(self.offsets)
        self.b[:n] = np.minimum(self.speed, (self.upper - q) / self.dt)
        self.b[n : 2 * n] = np.minimum(self.speed, (q - self.lower) / self.dt)
        for j, (link, shift, shifted) in enumerate(self.carried):
            rows = slice(2 * n + j * many, 2 * n + (j + 1) * many)
            x = self.arm.fkm(q, link) * shift
            J = self.arm.translation_jacobian(shifted @ self.arm.pose_jacobian(q, link), x)
            self.A[rows, : link + 1] = -self.across @ J
            self.b[rows] = self.share * np.maximum(self.normals @ vec3(translation(x)) - self.offsets, 0.0)


def prepared(dh: dict, start: Numbers, targets: Numbers, links: list[int], **given) -> Turn:
    arm, dt = arm_of(dh), given["dt"]
    controller, bounds = controller_of(arm, given["gain"], given["damping"], dt), Bounds(arm, dh, links, given)
    q, desired = np.array(start), [vec8(pose(np.array(T))) for T in targets]
    if desired[0] @ vec8(arm.fkm(q)) < 0:
        desired = [-x for x in desired]

    def begin() -> None:
        nonlocal q
        q = np.array(start)

    def step(k: int) -> np.ndarray:
        nonlocal q
        bounds.update(q)
        controller.set_inequality_constraint(bounds.A, bounds.b)
        q = q + dt * controller.compute_setpoint_control_signal(q, desired[k])
        return q

    return following(begin, step)


take_turns(prepared)
