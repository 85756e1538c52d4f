"""Contradictions in the files of a robot: between screws, DH rows, URDF, limits and named postures."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import combinations

import numpy as np
import yourdfpy

from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.kinematics.chain import Joint
from helicoide.kinematics.forward import dh_frames, screw_displacements, tool_by_dh, tool_by_screws
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.urdf_faults import urdf_faults
from helicoide.kinematics.urdf_file import parse_urdf
from helicoide.text import LANGUAGES, Text, untranslated

AGREE = 1e-9
POSTURES = 20
WORST_CONDITION = 50.0
APART = Text(en="{mm:.3g} mm and {deg:.3g}° apart", pt_BR="a {mm:.3g} mm e {deg:.3g}° um do outro")
DH_JOINT = Text(
    en="the DH rows and the screw of joint {name} give different axes: their frames are {apart}",
    pt_BR="as linhas DH e o helicoide da junta {name} dão eixos diferentes: os referenciais ficam {apart}",
)
TOOL = Text(
    en="the end effector differs between the screws and {other}: {apart}",
    pt_BR="o efetuador não é o mesmo por helicoides e por {other}: {apart}",
)
DH = Text(en="the DH rows", pt_BR="linhas DH")
URDF = Text(en="the URDF", pt_BR="URDF")
OUTSIDE = Text(
    en="pose {pose} is outside the limits of: {joints}", pt_BR="a postura {pose} sai dos limites de: {joints}"
)
ALIKE = Text(
    en="the poses {one} and {other} are the same posture or have the same title",
    pt_BR="as posturas {one} e {other} são a mesma ou têm o mesmo título",
)
SINGULAR = Text(
    en="ready is too close to a singular posture: the condition number of the Jacobian is {cond:.0f} (at most "
    "{most:.0f})",
    pt_BR="ready está muito perto de uma singularidade: o número de condição da jacobiana é {cond:.0f} (máximo "
    "{most:.0f})",
)


def remarks_and_faults(robot: Robot) -> tuple[Text, ...]:
    """All remarks on a robot: how its files were read, what is not drawn, and contradictions."""
    return (*robot.all_remarks, *faults(robot))


@lru_cache(maxsize=32)
def faults(robot: Robot) -> tuple[Text, ...]:
    """Every contradiction, in words; none of a robot whose screws, DH rows and URDF are not stated separately.

    Raises HelicoideError when the URDF cannot be read.
    """
    if not robot.stated:
        return ()
    reading = parse_urdf(robot.urdf, robot.parameters).robot
    urdf = yourdfpy.URDF(robot=reading, build_scene_graph=True, load_meshes=False)
    wrong = [*urdf_faults(robot, urdf)]
    return (*_dh(robot), *wrong, *_tools(robot, None if wrong else urdf), *_poses(robot))


def tried_postures(robot: Robot) -> list[Array]:
    """Zero, the named postures and random ones within the limits, each (n,), rad or m."""
    random = np.random.default_rng(0).uniform(robot.lower, robot.upper, (POSTURES, len(robot.lower)))
    return [frozen(np.zeros(len(robot.lower))), *robot.poses.values(), *map(frozen, random)]


def largest_difference(T: Array, other: Array) -> Text | None:
    """The distance and angle between two poses (4, 4), m, as a sentence; None if they agree."""
    if np.abs(T - other).max() <= AGREE:
        return None
    turned = rotation.from_matrix(T[:3, :3].T @ other[:3, :3])
    degrees = np.degrees(2 * np.arctan2(np.linalg.norm(turned[1:]), abs(turned[0])))
    return APART.format(mm=1000 * float(np.linalg.norm(T[:3, 3] - other[:3, 3])), deg=float(degrees))


def _dh(robot: Robot) -> Iterator[Text]:
    """The first joint whose DH frame does not move with its screw: Aᵢ(q) = Hᵢ(q) Aᵢ(0) is violated."""
    at_zero = dh_frames(robot, frozen(np.zeros(len(robot.lower))))
    joints: tuple[Joint | None, ...] = (None, *robot.joints)
    for q in tried_postures(robot):
        moved = zip(joints, dh_frames(robot, q), screw_displacements(robot, q), at_zero, strict=True)
        for joint, frame, H, frame_at_zero in moved:
            if joint is not None and (far := largest_difference(frame, H @ frame_at_zero)) is not None:
                yield DH_JOINT.format(name=joint.name, apart=far)
                return


def _tools(robot: Robot, urdf: yourdfpy.URDF | None) -> Iterator[Text]:
    """Differences of the tool pose by DH rows, and by the URDF if there is one, from that by screws."""
    differ = list[Text]()
    for q in tried_postures(robot):
        tools = [(DH, tool_by_dh(robot, q))]
        if urdf is not None:
            urdf.update_cfg(dict(zip((joint.name for joint in robot.variables), q, strict=True)))
            tools.append((URDF, urdf.get_transform(robot.tool_link)))
        for name, tool in tools:
            if name not in differ and (far := largest_difference(tool_by_screws(robot, q), tool)) is not None:
                differ.append(name)
                yield TOOL.format(other=name, apart=far)


def _poses(robot: Robot) -> Iterator[Text]:
    """Faults of named postures: outside the limits (`home` may be), equal to another, or `ready` singular."""
    for name, q in robot.poses.items():
        out = (q < robot.lower - 1e-12) | (q > robot.upper + 1e-12)
        if out.any() and name != "home":
            joints = ", ".join(joint.name for joint, beyond in zip(robot.variables, out, strict=True) if beyond)
            yield OUTSIDE.format(pose=name, joints=joints)
    for one, other in combinations(robot.poses, 2):
        titles = [robot.pose_titles[name] for name in (one, other)]
        alike = any(titles[0][language].strip() == titles[1][language].strip() for language in LANGUAGES)
        if alike or np.abs(robot.poses[one] - robot.poses[other]).max() <= 1e-6:
            yield ALIKE.format(one=untranslated(one), other=untranslated(other))
    if (cond := _condition(robot)) >= WORST_CONDITION:
        yield SINGULAR.format(cond=cond, most=WORST_CONDITION)


def _condition(robot: Robot) -> float:
    """The condition number of the Jacobian at `ready`, with lengths as parts of the reach.

    By the screws where the arm stands, [sᵢ × (p − pᵢ); sᵢ], or [sᵢ; 0] where joint i slides; without kernels, which
    may not be there yet.
    """
    q, columns = robot.poses["ready"], list[Array]()
    tool = tool_by_screws(robot, q)[:3, 3]
    for joint, H in zip(robot.joints, screw_displacements(robot, q), strict=False):
        s, p = H[:3, :3] @ joint.direction, H[:3, :3] @ joint.point + H[:3, 3]
        columns.append(
            np.append(s, np.zeros(3)) if joint.is_prismatic else np.append(np.cross(s, tool - p) / robot.reach, s)
        )
    return float(np.linalg.cond(np.array(columns).T))
