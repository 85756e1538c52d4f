"""Where the guarded arm comes to rest: ticks like the loop's, run ahead until nothing moves."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.confinement import distances
from helicoide.ik.guarded import guarded_step
from helicoide.ik.task import joint_task, pose_task
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array, Chain
from helicoide.kinematics.forward import carried_points, link_poses

AT_REST = 1e-5


@kernel
def are_clear(
    arm: tuple[Chain, Array, NDArray[np.int64]], postures: Array, planes: tuple[Array, Array, float]
) -> NDArray[np.bool_]:
    """Which postures (p, n), rad, keep every guarded point farther than critical from every plane, (p,)."""
    clear = np.empty(postures.shape[0], dtype=np.bool_)
    for k in range(postures.shape[0]):
        points = carried_points(link_poses(arm[0], postures[k]), arm[1], arm[2])
        clear[k] = (distances(planes[0], planes[1], points) > planes[2]).all()
    return clear


@kernel
def settle_at_pose(
    arm: tuple[Chain, Array, NDArray[np.int64]],
    q: Array,
    tool: tuple[Array, Array, Array, bool, float],
    limits: tuple[Array, Array, Array],
    planes: tuple[Array, Array, float],
    dt: float,
    ticks: int,
) -> tuple[Array, Array]:
    """The joint values (n,) at which guarded ticks towards a tool pose end, from q (n,), rad, and the last multipliers.

    Args: arm, limits, planes as in `guarded_step`; tool as in `pose_task`; dt, s, of a tick; ticks: how many at most.
    """
    q = q.copy()
    poses = link_poses(arm[0], q)
    multipliers = np.zeros(0)
    for _ in range(ticks):
        task = pose_task(poses, arm[0], tool, np.zeros(3), dt)
        before = q
        q, poses, multipliers, _ = guarded_step(arm, q, poses, task, limits, planes, dt)
        if np.max(np.abs(q - before)) < AT_REST:
            break
    return q, multipliers


@kernel
def settle_at_joints(
    arm: tuple[Chain, Array, NDArray[np.int64]],
    q: Array,
    q_target: Array,
    yielding: int,
    limits: tuple[Array, Array, Array],
    planes: tuple[Array, Array, float],
    dt: float,
    ticks: int,
) -> tuple[Array, Array]:
    """The same for ticks towards other joint values q_target (n,), rad; `yielding` as in `joint_task`."""
    q = q.copy()
    poses = link_poses(arm[0], q)
    multipliers = np.zeros(0)
    for _ in range(ticks):
        before = q
        q, poses, multipliers, _ = guarded_step(
            arm, q, poses, joint_task(q, q_target, yielding, dt), limits, planes, dt
        )
        if np.max(np.abs(q - before)) < AT_REST:
            break
    return q, multipliers
