"""Contradictions between the URDF of a robot and its robot.toml: joints, links, limits, axes and positions."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import yourdfpy

from helicoide.kinematics.chain import Joint
from helicoide.kinematics.robot import Robot
from helicoide.text import Text, join_texts, number_text, untranslated

AGREE = 1e-9
NO_JOINT = Text(
    en="the URDF has no joint {name}; its moving joints are: {known}",
    pt_BR="o URDF não tem a junta {name}; as juntas móveis são: {known}",
)
NO_LINK = Text(en="the URDF has no link {name}; it has: {known}", pt_BR="o URDF não tem o elo {name}; há: {known}")
DIFFERS = Text(
    en="the URDF says otherwise of joint {name}: {what}", pt_BR="o URDF diz outra coisa da junta {name}: {what}"
)
CHILD = Text(en="it carries link {theirs}, not {here}", pt_BR="ela move o elo {theirs}, não {here}")
KIND = Text(en="it is {theirs}, not {here}", pt_BR="ela é {theirs}, não {here}")
FOLLOWS = Text(en="it follows joint {other}", pt_BR="ela segue a junta {other}")
LIMITS = Text(
    en="limits and speed {theirs}, not {here} (rad or m)", pt_BR="limites e velocidade {theirs}, não {here} (rad ou m)"
)
AXIS = Text(en="its axis is another one at q = 0", pt_BR="o eixo é outro em q = 0")
PLACE = Text(
    en="its link lies {mm:.3g} mm from the screw's point", pt_BR="o elo fica a {mm:.3g} mm do ponto do helicoide"
)
TURNED = Text(
    en="the frame of its link is not parallel to the base at q = 0",
    pt_BR="o referencial do elo não é paralelo à base em q = 0",
)
MORE = Text(
    en="the URDF moves joints that robot.toml does not name: {names}",
    pt_BR="o URDF move juntas que robot.toml não cita: {names}",
)


def urdf_faults(robot: Robot, urdf: yourdfpy.URDF) -> Iterator[Text]:
    """Every contradiction, in words. urdf: that of the robot, with its scene graph; it is put at zero."""
    urdf.update_cfg(np.zeros(urdf.num_actuated_joints))
    links, moving = [str(link.name) for link in urdf.robot.links], list(urdf.actuated_joint_names)
    for name in dict.fromkeys((*(joint.link for joint in robot.joints), robot.tool_link)):
        if name not in links:
            yield NO_LINK.format(name=name, known=", ".join(links))
    for joint in robot.joints:
        if joint.name not in urdf.joint_map:
            yield NO_JOINT.format(name=joint.name, known=", ".join(moving) or "-")
        elif said := [*_joint(joint, urdf), *(_place(joint, urdf) if joint.link in links else ())]:
            yield DIFFERS.format(name=joint.name, what=join_texts(said))
    if robot.gripper and robot.gripper.joint not in moving:
        yield NO_JOINT.format(name=robot.gripper.joint, known=", ".join(moving) or "-")
    named = {joint.name for joint in robot.joints} | ({robot.gripper.joint} if robot.gripper else set())
    if more := [name for name in moving if name not in named]:
        yield MORE.format(names=", ".join(more))


def _joint(joint: Joint, urdf: yourdfpy.URDF) -> Iterator[Text]:
    other = urdf.joint_map[joint.name]
    if other.child != joint.link:
        yield CHILD.format(theirs=other.child, here=joint.link)
    if other.type != joint.kind:
        yield KIND.format(theirs=other.type, here=joint.kind)
    if other.mimic is not None:
        yield FOLLOWS.format(other=other.mimic.joint)
    here = (joint.lower, joint.upper, joint.speed)
    theirs = () if other.limit is None else (other.limit.lower, other.limit.upper, other.limit.velocity)
    if None in theirs or len(theirs) != len(here) or not np.allclose(theirs, here, rtol=1e-12, atol=0):
        yield LIMITS.format(theirs=_listed(theirs), here=_listed(here))


def _place(joint: Joint, urdf: yourdfpy.URDF) -> Iterator[Text]:
    T_base_link = urdf.get_transform(joint.link)
    if not np.allclose(urdf.joint_map[joint.name].axis, joint.direction, rtol=0, atol=AGREE):
        yield AXIS
    if (away := float(np.linalg.norm(T_base_link[:3, 3] - joint.point))) > AGREE:
        yield PLACE.format(mm=1000 * away)
    if np.abs(T_base_link[:3, :3] - np.eye(3)).max() > AGREE:
        yield TURNED


def _listed(values: tuple[float | None, ...]) -> Text:
    """Numbers with the decimal sign of each language."""
    written = [number_text(value, ".6g") if value is not None else untranslated("-") for value in values]
    return join_texts(written or [untranslated("-")])
