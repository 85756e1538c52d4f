"""Which arm a recording is of: its name, lengths and joints, and a digest of its chain, to compare with another arm."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from helicoide import __version__
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

DIGITS = 9  # decimals of the numbers that the digest compares
OTHER_ARM = Text(
    en="The recording {title} is of the arm {recorded}, and this is {here}. Load that arm to replay it.",
    pt_BR="A gravação {title} é do braço {recorded}, e este é {here}. Carregue aquele braço para reproduzi-la.",
)
OTHER_LENGTHS = Text(
    en="The recording {title} was made with the lengths {recorded}, and this arm has {here}.",
    pt_BR="A gravação {title} foi feita com os comprimentos {recorded}, e este braço tem {here}.",
)
OTHER_FILES = Text(
    en="The files of {here} have changed since {title} was recorded (Helicoide {version}): equal joints give other "
    "poses.",
    pt_BR="Os arquivos de {here} mudaram desde a gravação {title} (Helicoide {version}): as juntas dão outras poses.",
)
OTHER_JOINTS = Text(
    en="The recording {title} has the joints {recorded}. This arm has {here}.",
    pt_BR="A gravação {title} tem as juntas {recorded}. Este braço tem {here}.",
)


@dataclass(frozen=True)
class RecordedArm:
    """The arm of a recording. name and digest are empty if the file of another program does not state them.

    lengths: its parameters, m; joints: names of the joint values, in their order; version: of Helicoide.
    """

    joints: tuple[str, ...]
    name: str = ""
    lengths: tuple[tuple[str, float], ...] = ()
    digest: str = ""
    version: str = ""

    def to_metadata(self) -> dict[str, str]:
        """The arm as pairs of words, as an MCAP file carries it."""
        lengths, joints = json.dumps(dict(self.lengths)), json.dumps(self.joints)
        words = {"robot": self.name, "lengths_m": lengths, "joints": joints}
        return {**words, "digest": self.digest, "helicoide": self.version}


def recorded_arm(robot: Robot) -> RecordedArm:
    """The arm of a robot."""
    names = tuple(variable.name for variable in robot.variables)
    return RecordedArm(names, robot.name, tuple(robot.parameters.items()), chain_digest(robot), __version__)


def from_metadata(words: Mapping[str, str]) -> RecordedArm:
    """The arm that the pairs of words of a file name. Raises KeyError or ValueError if they do not name one."""
    lengths, joints = json.loads(words["lengths_m"]), json.loads(words["joints"])
    known = tuple((str(name), float(length)) for name, length in lengths.items())
    return RecordedArm(tuple(map(str, joints)), words["robot"], known, words["digest"], words.get("helicoide", ""))


def chain_digest(robot: Robot) -> str:
    """A digest of the joint axes, their couplings and the tool: equal digests mean equal poses at equal joints."""
    chain = robot.chain
    numbers = [chain[name].astype(np.float64).ravel() for name in chain.dtype.names or ()]
    rounded = np.round(np.concatenate([*numbers, robot.T_world_tool_0.ravel()]), DIGITS) + 0.0
    return hashlib.sha256(rounded.astype("<f8").tobytes()).hexdigest()[:16]


def columns_for(arm: RecordedArm, robot: Robot, title: str) -> NDArray[np.intp]:
    """Which column of the recorded joint values each variable of the robot takes, (n,).

    A file that names other joints, but as many, gives them in the order of the arm. Raises HelicoideError, which says
    what differs, if the recording is of another arm.
    """
    here, names = recorded_arm(robot), [variable.name for variable in robot.variables]
    if arm.name and arm.name != here.name:
        raise HelicoideError(OTHER_ARM.format(title=title, recorded=arm.name, here=robot.title))
    if arm.digest and arm.lengths != here.lengths:
        raise HelicoideError(
            OTHER_LENGTHS.format(title=title, recorded=_lengths(arm.lengths), here=_lengths(here.lengths))
        )
    if arm.digest and arm.digest != here.digest:
        raise HelicoideError(OTHER_FILES.format(title=title, here=robot.title, version=arm.version))
    if set(names) <= set(arm.joints):
        return np.array([arm.joints.index(name) for name in names])
    if len(arm.joints) != len(names) or set(names) & set(arm.joints):
        recorded, known = ", ".join(arm.joints), ", ".join(names)
        raise HelicoideError(OTHER_JOINTS.format(title=title, recorded=recorded, here=known))
    return np.arange(len(names))


def _lengths(lengths: tuple[tuple[str, float], ...]) -> str:
    return ", ".join(f"{name} = {1000 * length:g} mm" for name, length in lengths) or "–"
