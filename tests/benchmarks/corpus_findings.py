"""What is written down of one URDF file, and the kinds of what is wrong in files."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from helicoide.text import HelicoideError


@dataclass
class Findings:
    """What comes of a file.

    arms: the links where arms end; refused: why not, by tip, "" for the file without one; worst: of forward kinematics,
    and where; asked: poses; missed and false: what was answered to those that were not reached, and to those that were
    said to be, by tip and posture; faults: exceptions that are none of ours; picture: how many shapes, None where it is
    refused; unseen: why; meshes: the files of meshes that it names; late: what was done when the time was over.
    """

    arms: list[str] = field(default_factory=list)
    refused: dict[str, str] = field(default_factory=dict)
    worst: tuple[float, str] = (0.0, "")
    asked: int = 0
    missed: list[str] = field(default_factory=list)
    false: list[str] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)
    picture: int | None = None
    unseen: str = ""
    is_drawn: bool = False
    meshes: tuple[str, ...] = ()
    late: str = ""
    seconds: float = 0.0

    @property
    def refusal(self) -> str:
        """Why the file has no arm; empty where it has one."""
        if self.arms or not self.refused:
            return ""
        return next((words for tip, words in self.refused.items() if tip), self.refused[""])


def words_of(error: HelicoideError) -> str:
    """What is wrong, without the path of the file."""
    return error.text.en.rpartition("cannot be used: ")[2]


def reason_of(words: str) -> str:
    """What is wrong, without what is of one file: names in quotes, numbers, lists."""
    words = re.sub(r"limits of joint '[^']*' are (\S+) to \1;", "limits of a joint are equal;", words)
    words = re.sub(r"(of type )'(\w*)'", r"\1\2", words)
    words = re.sub(r"'[^']*'(, '[^']*')*|\"[^\"]*\"", "…", words)
    words = re.sub(r"(roots|mesh for link …|parents of link …|there is|the ends are|circle): .*", r"\1: …", words)
    return re.sub(r"-?\b\d[\d.]*(e[+-]?\d+)?\b", "#", words)[:150]
