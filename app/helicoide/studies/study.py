"""What a study is: an experiment of a source that runs by itself, its numbers beside the source's, and its curves."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Any, Literal, Protocol

from helicoide.kinematics.chain import Array
from helicoide.text import Text

FIGURE_ONLY = Text(en="figure only", pt_BR="só em figura")
Progress = Callable[[float], None]


class Verdict(Enum):
    """How a number stands beside that of the digest."""

    AGREES = Text(en="agrees", pt_BR="confere")
    DOUBT = Text(en="differs, as the digest doubts", pt_BR="difere, como a síntese já duvidava")
    ASSUMED = Text(en="differs, by what the source does not give", pt_BR="difere, pelo que a fonte não informa")
    DIFFERS = Text(en="differs", pt_BR="difere")


@dataclass(frozen=True)
class Row:
    """A quantity: the source's value as printed (or `FIGURE_ONLY`), the digest's, and ours.

    relation: how ours must stand to the digest's: "=" to within `tolerance`, "≥" or "≤" up to it; without a digest's
    value ours stands alone. doubt: the number of the digest's doubt, such as "D6"; assumed: what the source does not
    give and had to be chosen. Either excuses a difference.
    """

    quantity: Text
    ours: float
    digest: float | None = None
    tolerance: float = 0.0
    unit: str = ""
    source: str | Text = ""
    relation: Literal["=", "≥", "≤"] = "="
    doubt: str = ""
    assumed: Text | None = None

    @property
    def agrees(self) -> bool:
        """Whether ours stands to the digest's as it must; what is no number never does."""
        if self.ours != self.ours:
            return False
        if self.digest is None:
            return True
        apart = self.ours - self.digest
        match self.relation:
            case "=":
                return abs(apart) <= self.tolerance
            case "≥":
                return apart >= -self.tolerance
            case "≤":
                return apart <= self.tolerance

    @property
    def verdict(self) -> Verdict:
        """How ours stands beside the digest's."""
        if self.agrees:
            return Verdict.AGREES
        if self.doubt:
            return Verdict.DOUBT
        return Verdict.DIFFERS if self.assumed is None else Verdict.ASSUMED


@dataclass(frozen=True, eq=False)
class Line:
    """A curve of a chart: x (k,) and y (k,)."""

    title: Text
    x: Array
    y: Array


@dataclass(frozen=True, eq=False)
class Chart:
    """Curves over a common quantity; `across` and `up` name the axes, with their units."""

    title: Text
    across: Text
    up: Text
    lines: tuple[Line, ...]


@dataclass(frozen=True, eq=False)
class Motion:
    """What the arm did: times (k,), s, and joint values (k, n), rad or m, of a robot by its name.

    parameters: lengths of the robot that were chosen, mm, as `load` takes them.
    """

    robot: str
    times: Array
    q: Array
    parameters: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Result:
    """What a study came to."""

    rows: tuple[Row, ...]
    charts: tuple[Chart, ...] = ()
    motion: Motion | None = None


class Study(Protocol):
    """A module of `studies/`.

    SOURCE: author, year, section. Options: annotated with the settings of `ik.method`, as those of a method are.
    """

    TITLE: Text
    SOURCE: str
    ABOUT: Text
    ROBOT: str

    @property
    def Options(self) -> type:
        """The class of its settings; its defaults are those of the source, or of the digest where that gives none."""

    def run(self, options: Any, short: bool, progress: Progress) -> Result:
        """Run it. short: a coarser or shorter form of a few seconds, whose rows hold with their own tolerances.

        progress: told the share that is done, 0 to 1.
        """
