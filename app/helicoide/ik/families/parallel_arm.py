"""Arms with six revolute joints and parallel axes 2, 3 and 4, as in the UR family: their geometry at q = 0."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.polish import polisher
from helicoide.ik.families.two_links import two_links
from helicoide.ik.postures.packed import WIDTH
from helicoide.ik.postures.solvability import meeting_point
from helicoide.kernels import kernel_into
from helicoide.kinematics.robot import Robot

# Axes are parallel below this sine: files round them, and postures are polished. Links are longer than this, m.
PARALLEL, NO_LINK = 1e-5, 1e-6
# Rows of the packed arm. h is the direction of the parallel axes, x is along h × ŝ₁, and W is the point where axes 5
# and 6 meet. In the base: ŝ₁, h, x and a point of the waist axis, m. In the tool: ŝ₅, ŝ₆, h, x and W, m. Complex
# numbers, m, in the plane of x and h × x: from the waist to the shoulder, and from the fourth axis to W; then upper arm
# and forearm as `TwoLinks`. Then the setting, and from POLISHER on the table of `polisher`.
WAIST, ALONG, AHEAD, FOOT, FIFTH, SIXTH, ALONG_TOOL, AHEAD_TOOL, CENTRE, ENDS, LINKS, SETTING, POLISHER = range(13)
# Columns of the ends; of the setting: h · (W − p₁), m, and ±1, the senses of axes 3 and 4 along h.
SHOULDER, HAND = 0, 2
ASIDE, THIRD, FOURTH = range(3)


@lru_cache(maxsize=64)
def parallel_arm(robot: Robot) -> Array | None:
    """The robot packed as an arm of this kind, (k, 12), or None."""
    if len(robot.joints) != 6 or any(joint.is_prismatic or joint.mimic for joint in robot.joints):
        return None
    s, p, T = robot.directions, robot.points, robot.T_world_tool_0
    h = s[1]
    centre = meeting_point(robot, (4, 5))
    if centre is None or np.linalg.norm(np.cross(h, s[2:4]), axis=1).max() > PARALLEL:
        return None
    if min(np.linalg.norm(np.cross(a, b)) for a, b in ((s[0], h), (h, s[4]), (s[4], s[5]))) < NO_LINK:
        return None
    x = np.cross(h, s[0])
    x /= np.linalg.norm(x)
    places = np.array([p[0], p[1], p[2], p[3], centre])
    shoulder, upper, fore, hand = np.diff(places @ x + 1j * (places @ np.cross(h, x))).tolist()
    if min(abs(upper), abs(fore)) < NO_LINK:
        return None
    arm = np.zeros((POLISHER, WIDTH))
    arm[WAIST:FIFTH, :3] = s[0], h, x, p[0]
    arm[FIFTH:ENDS, :3] = np.array([s[4], s[5], h, x, centre - T[:3, 3]]) @ T[:3, :3]
    arm[ENDS, :4] = shoulder.real, shoulder.imag, hand.real, hand.imag
    arm[LINKS, :4] = two_links(upper, fore)
    arm[SETTING, :3] = h @ (centre - p[0]), *np.sign(s[2:4] @ h)
    return np.concatenate([arm, polisher(robot)])


@kernel_into
def ending(arm: Array, which: int) -> complex:
    """The complex number from the waist to the shoulder, or from the fourth axis to W, m."""
    return complex(arm[ENDS, which], arm[ENDS, which + 1])
