"""Checks of a robot file beyond its types: references, counts, axes, sizes and limits."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from helicoide.kinematics.robot_file import CapsuleFile, FrameFile, JointFile, Matrix, PointFile, RobotFile
from helicoide.text import HelicoideError, Text, numbers_text

# Shorter directions count as zero. Matrices that differ more from a rotation are refused; the tolerance allows for
# entries written with a few digits.
LEAST_NORM, ROTATION_TOLERANCE = 1e-6, 1e-3


def check_robot_file(file: RobotFile) -> None:
    """Raise HelicoideError, with the reason alone, for an impossible robot."""
    names = [joint.name for joint in file.joints]
    if not names:
        raise HelicoideError(
            Text(en="it has no joints, and needs one or more", pt_BR="não há juntas; é preciso ao menos uma")
        )
    _differ("joint", names)
    for joint in file.joints:
        _check_joint(joint)
    _check_parts(file, names)
    _check_capsules(file)
    _check_sizes(file)
    if file.actuators:
        if sliding := [joint.name for joint in file.joints if joint.kind == "prismatic"]:
            raise _error(
                "actuators are for joints that turn, and these slide: {names}",
                "actuators são para juntas que giram, e estas deslizam: {names}",
                names=", ".join(sliding),
            )
        file.actuators.check(names)
    _check_poses(file, len(names))


def _check_parts(file: RobotFile, names: Sequence[str]) -> None:
    """Check that each part names a known joint, or none, and that each matrix is a rotation."""
    parts: list[PointFile | FrameFile | CapsuleFile] = [*file.guarded_points, *_given(file), *file.capsules]
    for carrier in [part.joint for part in parts]:
        if carrier not in ("", *names):
            raise _error(
                "{name!r} is no joint; there is: {known}",
                "{name!r} não é uma junta; há: {known}",
                name=carrier,
                known=", ".join(names),
            )
    if file.guarded_points and not any(
        point.joint == names[-1] and point.point_mm == file.tool.position_mm for point in file.guarded_points
    ):
        raise _error(
            "no monitored point of joint {name} lies at the end effector, {at} mm",
            "nenhum ponto vigiado da junta {name} fica no efetuador, {at} mm",
            name=names[-1],
            at=file.tool.position_mm,
        )
    for place, matrix in _rotations(file):
        R = np.array(matrix)
        if np.abs(R).max() > 2 or np.abs(R @ R.T - np.eye(3)).max() > ROTATION_TOLERANCE or np.linalg.det(R) < 0:
            raise _error(
                "{place} is no rotation: its rows must be perpendicular unit vectors of a right-handed frame",
                "{place} não é uma rotação: as linhas devem ser vetores unitários, perpendiculares e em ordem direta",
                place=place,
            )


def _rotations(file: RobotFile) -> Iterator[tuple[str, Matrix]]:
    yield "tool.R_dh_tool", file.tool.R_dh_tool
    yield "tool.R_world_tool", file.tool.R_world_tool
    yield from (("R_world_frame", frame.R_world_frame) for frame in _given(file))


def _given(file: RobotFile) -> list[FrameFile]:
    frames = file.frames
    return [frame for frame in (frames.station, frames.wrist, frames.rcm) if frame is not None]


def _check_poses(file: RobotFile, n: int) -> None:
    for name, pose in file.poses.items():
        if len(pose.joints) != n:
            raise _error(
                "pose {name} has {given} values for {n} joints",
                "a postura {name} tem {given} valores para {n} juntas",
                name=name,
                given=len(pose.joints),
                n=n,
            )
    if "ready" not in file.poses:
        raise _error("pose ready is missing", "falta a postura ready")
    if file.planes and "home" not in file.poses:
        raise _error(
            "pose home is missing: with planes, the arm parks there",
            "falta a postura home: com planos, é nela que o braço estaciona",
        )


def _check_sizes(file: RobotFile) -> None:
    for plane in file.planes:
        if math.hypot(*plane.normal) < LEAST_NORM:
            raise _error("the normal of plane {name} is zero", "a normal do plano {name} é zero", name=plane.name)
        _positive(plane.size_mm, "size_mm of plane {name}", "size_mm do plano {name}", plane.name)
    _differ("plane", [plane.name for plane in file.planes])
    if file.gripper:
        _positive((file.gripper.opening_mm,), "opening_mm of gripper {name}", "opening_mm da garra {name}", "gripper")
    if file.camera and math.dist(file.camera.position_mm, file.camera.look_at_mm) < LEAST_NORM:
        raise _error(
            "the camera stands where it looks at: position_mm and look_at_mm must differ",
            "a câmera está no ponto para onde olha: position_mm e look_at_mm devem diferir",
        )


def _check_capsules(file: RobotFile) -> None:
    names = [capsule.name for capsule in file.capsules]
    _differ("capsule", names)
    for capsule in file.capsules:
        _positive(
            (capsule.radius_mm,), "the radius_mm of capsule {name}", "o radius_mm da cápsula {name}", capsule.name
        )
    for pair in file.self_collision:
        if missing := [name for name in pair if name not in names]:
            raise _error(
                "{name!r} is no capsule; there is: {known}",
                "{name!r} não é uma cápsula; há: {known}",
                name=missing[0],
                known=", ".join(names) or "-",
            )
        if pair[0] == pair[1]:
            raise _error(
                "self_collision pairs {name} with itself", "self_collision põe {name} em par consigo", name=pair[0]
            )


def _check_joint(joint: JointFile) -> None:
    if math.hypot(*joint.screw.direction) < LEAST_NORM:
        raise _error("the axis of joint {name} is zero", "o eixo da junta {name} é zero", name=joint.name)
    limits, speed = limits_of(joint)
    if not limits[0] < limits[1] or not speed > 0:
        raise _error(
            "joint {name} needs limits in rising order and a positive speed",
            "a junta {name} precisa de limites em ordem crescente e de uma velocidade positiva",
            name=joint.name,
        )
    if not acceleration_of(joint) > 0:
        raise _error(
            "joint {name} needs a positive acceleration",
            "a junta {name} precisa de uma aceleração positiva",
            name=joint.name,
        )


def limits_of(joint: JointFile) -> tuple[tuple[float, float], float]:
    """Limits and speed of a joint, in deg or mm by its kind; raises HelicoideError if they are missing or mixed."""
    turning, sliding = (joint.limits_deg, joint.speed_deg_s), (joint.limits_mm, joint.speed_mm_s)
    (limits, speed), other, unit = (turning, sliding, "deg") if joint.kind == "revolute" else (sliding, turning, "mm")
    if limits is None or speed is None or other != (None, None):
        raise _error(
            "joint {name} is {kind} and needs limits_{unit} and speed_{unit}_s, in no other unit",
            "a junta {name} é {kind} e precisa de limits_{unit} e speed_{unit}_s, em nenhuma outra unidade",
            name=joint.name,
            kind=joint.kind,
            unit=unit,
        )
    return limits, speed


def acceleration_of(joint: JointFile) -> float:
    """Acceleration limit, in deg/s² or mm/s² by the joint's kind; infinite if there is none. Raises as `limits_of`."""
    given, other, unit = joint.acceleration_deg_s2, joint.acceleration_mm_s2, "deg"
    if joint.kind == "prismatic":
        given, other, unit = other, given, "mm"
    if other is not None:
        raise _error(
            "joint {name} is {kind} and takes acceleration_{unit}_s2",
            "a junta {name} é {kind} e usa acceleration_{unit}_s2",
            name=joint.name,
            kind=joint.kind,
            unit=unit,
        )
    return math.inf if given is None else given


def _positive(values: Sequence[float], en: str, pt_BR: str, name: str) -> None:
    if not all(value > 0 for value in values):
        what = Text(en=en, pt_BR=pt_BR).format(name=name)
        raise _error(
            "{what} must be positive, not {given}",
            "{what} deve ser maior que zero, não {given}",
            what=what,
            given=numbers_text(values),
        )


def _differ(kind: str, names: Sequence[str]) -> None:
    if doubled := [name for name in names if names.count(name) > 1]:
        raise _error(
            "two are called {kind} {name!r}; each needs a name of its own",
            "há dois {kind} de nome {name!r}; cada um precisa de um nome próprio",
            kind=kind,
            name=doubled[0],
        )


def _error(en: str, pt_BR: str, **fields: object) -> HelicoideError:
    return HelicoideError(Text(en=en, pt_BR=pt_BR).format(**fields))
