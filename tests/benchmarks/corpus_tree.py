"""The links of a URDF file, read and moved anew: nothing here comes from Helicoide or from the parser it uses."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]
TURNING, SLIDING = ("revolute", "continuous"), ("prismatic",)


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint: where it is on its parent (4, 4), m, its unit axis (3,), its limits, and what it follows.

    follows: the name of another joint, the ratio and the shift; None for a joint that is free.
    """

    name: str
    kind: str
    parent: str
    child: str
    T_parent_joint: Array
    axis: Array
    lower: float
    upper: float
    follows: tuple[str, float, float] | None

    @property
    def moves(self) -> bool:
        return self.kind in TURNING + SLIDING

    @property
    def free(self) -> bool:
        """Whether something decides where it stands: whoever moves the arm, or the joint that it follows."""
        return self.moves and (self.kind == "continuous" or self.lower < self.upper or self.follows is not None)

    def transform(self, values: Mapping[str, float]) -> Array:
        """From the child to the parent, (4, 4), m, when every joint stands at a value by name, rad or m."""
        T = np.eye(4)
        if self.kind in TURNING:
            T[:3, :3] = Rotation.from_rotvec(values[self.name] * self.axis).as_matrix()
        elif self.kind in SLIDING:
            T[:3, 3] = values[self.name] * self.axis
        return self.T_parent_joint @ T


class Tree:
    """The joints of a file by the links that they carry."""

    @classmethod
    def of(cls, path: Path) -> Tree:
        """The joints of the file at a path."""
        return cls(path.read_text("utf-8-sig", "replace"))

    def __init__(self, text: str) -> None:
        """Reads what a file says, also after a declaration that is not its beginning and with undeclared prefixes."""
        root = ElementTree.fromstring(re.sub(r"((?:</?|\s)\w+):(?=\w)", r"\1-", re.sub(r"<\?xml\b.*?\?>", "", text)))
        joints = [_joint(element) for element in root.findall("joint") if element.find("child") is not None]
        self.above = {joint.child: joint for joint in joints}
        self.links = [link.get("name", "") for link in root.findall("link")]
        self.is_drawn = root.find("link/visual/geometry") is not None
        named = (mesh.get("filename", "") for mesh in root.findall("link/visual/geometry/mesh"))
        self.meshes = tuple(Path(name).name for name in named)

    def way(self, tip: str) -> list[Joint]:
        """The joints from the root to a link."""
        way: list[Joint] = []
        while tip in self.above and self.above[tip] not in way:
            way.insert(0, self.above[tip])
            tip = way[0].parent
        return way

    def tips(self) -> list[str]:
        """The links at the ends that a free joint moves."""
        parents = {joint.parent for joint in self.above.values()}
        ends = [link for link in self.links if link not in parents]
        return [end for end in ends if any(joint.free and not joint.follows for joint in self.way(end))]

    def pose(self, tip: str, values: Mapping[str, float]) -> Array:
        """T_world_tip (4, 4), m, when the free joints stand at values by name, rad or m."""
        T, there = np.eye(4), self.settled(values)
        for joint in self.way(tip):
            T = T @ joint.transform(there)
        return T

    def settled(self, values: Mapping[str, float]) -> dict[str, float]:
        """Where every joint stands: those that follow, whom they follow, and what its limits hold at one value."""
        joints = list(self.above.values())
        there = {joint.name: joint.lower if joint.lower == joint.upper else 0.0 for joint in joints if not joint.free}
        there |= values
        for _ in joints:
            for name, leader, ratio, shift in ((joint.name, *joint.follows) for joint in joints if joint.follows):
                if name in there and leader not in there and ratio:
                    there[leader] = (there[name] - shift) / ratio
                elif leader in there and name not in there:
                    there[name] = ratio * there[leader] + shift
        return there

    def beyond(self, tip: str, values: Mapping[str, float]) -> float:
        """How far the joints on the way to a link are beyond their limits at most, rad or m; 0 within them.

        Limits of a follower that it could keep at no value of its leader count for nothing.
        """
        excess, there = [0.0], self.settled(values)
        for joint in (joint for joint in self.way(tip) if joint.moves and joint.kind != "continuous"):
            least, most = self._led(joint)
            if max(least, joint.lower) < min(most, joint.upper):
                x = there[joint.name]
                excess += [joint.lower - x, x - joint.upper]
        return max(excess)

    def _led(self, joint: Joint) -> tuple[float, float]:
        """Where a joint can stand by the limits of the one that it follows in the end; by its own if it is free."""
        known, ratio, shift = {one.name: one for one in self.above.values()}, 1.0, 0.0
        for _ in known:
            if joint.follows is None or joint.follows[0] not in known:
                break
            name, times, plus = joint.follows
            joint, shift, ratio = known[name], shift + ratio * plus, ratio * times
        least, most = sorted(ratio * end + shift for end in (joint.lower, joint.upper))
        return least, most


def apart(T_a: Array, T_b: Array) -> float:
    """How far two poses are from each other: the greater of the way, m, and the turn, rad."""
    turn = Rotation.from_matrix(T_a[:3, :3].T @ T_b[:3, :3]).magnitude()
    return max(float(np.linalg.norm(T_a[:3, 3] - T_b[:3, 3])), float(turn))


def _joint(element: ElementTree.Element) -> Joint:
    origin, axis = _numbers(element, "origin", "xyz", "0 0 0"), _numbers(element, "axis", "xyz", "1 0 0")
    T = np.eye(4)
    T[:3, :3] = Rotation.from_euler("xyz", _numbers(element, "origin", "rpy", "0 0 0")).as_matrix()
    T[:3, 3] = origin
    lower, upper = (_numbers(element, "limit", end, "nan")[0] for end in ("lower", "upper"))
    mimic = element.find("mimic")
    follows = None
    if mimic is not None:
        ratio, shift = (_numbers(element, "mimic", *given)[0] for given in (("multiplier", "1"), ("offset", "0")))
        follows = (mimic.get("joint", ""), float(ratio), float(shift))
    return Joint(
        name=element.get("name", ""),
        kind=element.get("type", ""),
        parent=_link(element, "parent"),
        child=_link(element, "child"),
        T_parent_joint=T,
        axis=axis / (np.linalg.norm(axis) or 1.0),
        lower=-math.inf if np.isnan(lower) else float(lower),
        upper=math.inf if np.isnan(upper) else float(upper),
        follows=follows,
    )


def _link(element: ElementTree.Element, end: str) -> str:
    found = element.find(end)
    return "" if found is None else found.get("link", "")


def _numbers(element: ElementTree.Element, tag: str, attribute: str, otherwise: str) -> Array:
    found = element.find(tag)
    words = otherwise if found is None else found.get(attribute, otherwise)
    return np.array(list(map(float, words.replace(",", " ").split())))
