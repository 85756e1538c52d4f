"""Where the guarded arm comes to rest: ticks like the loop's, run ahead until nothing moves."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.ik.guard.collision import clearances
from helicoide.ik.guard.guarded import ONE_LEVEL, guarded_tick
from helicoide.ik.guard.rows import Guard
from helicoide.ik.task import joint_task, pose_task
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array
from helicoide.kinematics.forward import link_poses

AT_REST = 1e-5


@kernel
def are_clear(guard: Guard, postures: Array) -> NDArray[np.bool_]:
    """Which postures (p, n), rad, keep their distance from planes, obstacles and the arm itself, (p,)."""
    clear = np.empty(postures.shape[0], dtype=np.bool_)
    for k in range(postures.shape[0]):
        left, _, _ = clearances(link_poses(guard[0][0], postures[k]), guard[0], guard[2], guard[3])
        clear[k] = (left > 0.0).all()
    return clear


@kernel
def settle(
    guard: Guard,
    q: Array,
    tool: tuple[Array, Array, Array, bool, float],
    joints: tuple[bool, Array, int],
    dt: float,
    ticks: int,
) -> tuple[Array, Array]:
    """The joint values (n,) at which guarded ticks end, from q (n,), rad, and the last multipliers.

    Args: guard as in `guarded_tick`, without limits of acceleration; tool: the pose to go to, as in `pose_task`;
    joints: whether to go to joint values instead, those (n,), rad, and `yielding` as in `joint_task`; dt, s, of a tick;
    ticks: how many at most.
    """
    q, chain = q.copy(), guard[0][0]
    poses, still, ahead = link_poses(chain, q), np.zeros(q.shape[0]), np.zeros(3)
    multipliers = np.zeros(0)
    for _ in range(ticks):
        before = q
        task = joint_task(q, joints[1], joints[2], dt) if joints[0] else pose_task(poses, chain, tool, ahead, dt)
        q, poses, multipliers, _ = guarded_tick(guard, q, still, poses, task, ONE_LEVEL, dt)
        if np.max(np.abs(q - before)) < AT_REST:
            break
    return q, multipliers
