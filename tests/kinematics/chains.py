"""Arms by chance: joints that turn, slide or follow another, with axes that are parallel, meet or neither."""

from __future__ import annotations

import tempfile
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from helicoide.kinematics.robot import Robot
from helicoide.kinematics.urdf_chain import robot_from_urdf

MOST, TIP = 9, "tip"
AXES = ("1 0 0", "0 1 0", "0 0 1", "0 0 -1")


def random_arm(seed: int, beside: bool = False) -> Robot:
    """The arm of a seed: the same at every call, and of a size between a hand and a crane.

    beside: some joints of it follow one that is not between base and tip, see `led_from_beside`.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"arm_{seed}.urdf"
        path.write_text(led_from_beside(seed) if beside else urdf(seed), "utf-8")
        return robot_from_urdf(path, TIP)


def urdf(seed: int) -> str:
    """The file of the arm of a seed."""
    draw = np.random.default_rng(seed)
    count, size = int(draw.integers(1, MOST + 1)), float(10 ** draw.uniform(-1, 1))
    plain = draw.random() < 0.7  # axes along x, y or z, and links along them: what people build
    joints: list[str] = []
    leaders: list[str] = []
    for k in range(count):
        joints.append(_joint(draw, k, size, plain, leaders))
    links = "".join(f'<link name="l{k}"/>' for k in range(count + 1))
    end = f'<parent link="l{count}"/><child link="{TIP}"/>{_origin(draw, size, plain)}'
    return (
        f'<robot name="arm_{seed}">{links}<link name="{TIP}"/>{"".join(joints)}'
        f'<joint name="end" type="fixed">{end}</joint></robot>'
    )


def led_from_beside(seed: int) -> str:
    """The file of the arm of a seed, with joints beside it that some of its variables follow, at least its first one.

    Where the leaders stand at zero, every follower is inside its own limits.
    """
    draw, root = np.random.default_rng([seed, 1]), ElementTree.fromstring(urdf(seed))
    free = [joint for joint in root.iter("joint") if joint.find("mimic") is None and joint.find("limit") is not None]
    for joint in (joint for i, joint in enumerate(free) if i == 0 or draw.random() < 0.5):
        limit = joint.find("limit")
        assert limit is not None
        ends = float(limit.get("lower", 0)), float(limit.get("upper", 0))
        ratio, shift = draw.choice([-1, 1]) * draw.uniform(0.2, 2), draw.uniform(0.1, 0.9) * np.ptp(ends) + ends[0]
        given = {"joint": f"z{draw.integers(2)}", "multiplier": str(ratio), "offset": str(shift)}
        ElementTree.SubElement(joint, "mimic", given)
    leaders = (
        f'<joint name="z{k}" type="{kind}"><parent link="l0"/><child link="x{k}"/>'
        '<limit lower="-1.5" upper="1.1" velocity="1" effort="1"/></joint>'
        for k, kind in enumerate(("revolute", "prismatic"))
    )
    more = ElementTree.fromstring(f'<more><link name="x0"/><link name="x1"/>{"".join(leaders)}</more>')
    root.extend(more)
    return ElementTree.tostring(root, "unicode")


def _joint(draw: np.random.Generator, k: int, size: float, plain: bool, leaders: list[str]) -> str:
    """One joint of a URDF; leaders: the turning and sliding ones so far, which it may follow."""
    slides = draw.random() < 0.25
    lower, upper = (0.0, size) if slides else np.sort(draw.uniform(-3.1, 3.1, 2))
    follows = ""
    if leaders and draw.random() < 0.15:
        follows = f'<mimic joint="{draw.choice(leaders)}" multiplier="{draw.uniform(-1, 1):.3f}" offset="0"/>'
        lower, upper = -100.0 * size, 100.0 * size  # what it follows has limits
    else:
        leaders.append(f"j{k}")
    axis = draw.choice(AXES) if plain else " ".join(f"{x:.6f}" for x in draw.normal(size=3))
    kind = "prismatic" if slides else "revolute"
    return (
        f'<joint name="j{k}" type="{kind}"><parent link="l{k}"/><child link="l{k + 1}"/>'
        f'{_origin(draw, size, plain)}<axis xyz="{axis}"/>{follows}'
        f'<limit lower="{lower}" upper="{upper}" velocity="1" effort="1"/></joint>'
    )


def _origin(draw: np.random.Generator, size: float, plain: bool) -> str:
    """Where a joint stands on the link before it: a third of the links have no length."""
    place = np.zeros(3)
    if draw.random() > 1 / 3:
        place = size * draw.uniform(-0.5, 0.5, 3)
        if plain:
            place *= np.eye(3)[draw.integers(3)]
    turn = np.zeros(3) if plain else draw.uniform(-np.pi, np.pi, 3)
    return f'<origin xyz="{" ".join(map(str, place))}" rpy="{" ".join(map(str, turn))}"/>'
