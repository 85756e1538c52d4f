"""The partial products of the joints' motors, as displacements of the base frame."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.state import State


def partial_displacements(state: State) -> Array:
    """Displacements of the links from their poses at q = 0, m₁ … mᵢ for i = 1 to m, as matrices (m, 4, 4), m.

    They follow from the poses of the links: D = T_world_link · T⁻¹, where T is the pose of the link at q = 0, a
    translation by the point of its joint. `forward.link_motors` gives them as motors, by products.
    """
    displacements = state.arm.poses[1:].copy()
    displacements[:, :3, 3] -= (displacements[:, :3, :3] @ state.robot.points[:, :, None])[:, :, 0]
    return np.asarray(displacements)
