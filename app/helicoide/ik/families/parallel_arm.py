"""Six turning joints of which the second, third and fourth are parallel, as in the UR family: the arm at q = 0."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from helicoide.ik.postures.solvability import meeting_point
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.robot import Robot

# Axes are parallel below this sine: files round them, and what is found is polished. Links have a length above this, m.
PARALLEL, NO_LINK = 1e-5, 1e-6
# Rows of `base` and of `tool`.
WAIST, ALONG, AHEAD, FOOT = range(4)
FIFTH, SIXTH, ALONG_TOOL, AHEAD_TOOL, CENTRE = range(5)
# Places in `links`.
SHOULDER, UPPER, FORE, HAND = range(4)


@dataclass(frozen=True, eq=False)
class ParallelArm:
    """Such an arm. h lies along the parallel axes, x ahead of the waist, across it and h; W is where axes 5 and 6 meet.

    base (4, 3): ŝ₁, h, x and a point of the waist, m, in the base; tool (5, 3): ŝ₅, ŝ₆, h, x and W, m, in the tool.
    links (4,), complex, m, in the plane of x and h × x: from the waist to the shoulder, upper arm, forearm, and from
    the fourth axis to W; signs (2,): ±1, the axes 3 and 4 against h. aside: h · (W − p₁), m.
    """

    base: Array
    tool: Array
    links: NDArray[np.complex128]
    signs: Array
    aside: float


@lru_cache(maxsize=64)
def parallel_arm(robot: Robot) -> ParallelArm | None:
    """The robot as such an arm, or None."""
    if len(robot.joints) != 6 or any(joint.slides or joint.mimic for joint in robot.joints):
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
    links = np.diff(places @ x + 1j * (places @ np.cross(h, x)))
    if np.abs(links[[UPPER, FORE]]).min() < NO_LINK:
        return None
    seen = np.array([s[4], s[5], h, x, centre - T[:3, 3]]) @ T[:3, :3]
    links.setflags(write=False)
    return ParallelArm(
        base=frozen([s[0], h, x, p[0]]),
        tool=frozen(seen),
        links=links,
        signs=frozen(np.sign(s[2:4] @ h)),
        aside=float(h @ (centre - p[0])),
    )
