"""Arms by chance: joints that turn, slide or follow another, with axes that are parallel, meet or neither."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np

from helicoide.kinematics.robot import Robot
from helicoide.kinematics.urdf_chain import from_urdf

MOST = 9
AXES = ("1 0 0", "0 1 0", "0 0 1", "0 0 -1")


def random_arm(seed: int) -> Robot:
    """The arm of a seed: the same at every call, and of a size between a hand and a crane."""
    draw = np.random.default_rng(seed)
    count, size = int(draw.integers(1, MOST + 1)), float(10 ** draw.uniform(-1, 1))
    plain = draw.random() < 0.7  # axes along x, y or z, and links along them: what people build
    joints: list[str] = []
    leaders: list[str] = []
    for k in range(count):
        joints.append(_joint(draw, k, size, plain, leaders))
    links = "".join(f'<link name="l{k}"/>' for k in range(count + 2))
    end = f'<parent link="l{count}"/><child link="l{count + 1}"/>{_origin(draw, size, plain)}'
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"arm_{seed}.urdf"
        path.write_text(
            f'<robot name="arm_{seed}">{links}{"".join(joints)}<joint name="end" type="fixed">{end}</joint></robot>',
            "utf-8",
        )
        return from_urdf(path, f"l{count + 1}")


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
