"""What a study is: an experiment of a source that runs by itself, what the source prints of it, and what comes out."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum
from typing import Any, Literal, Protocol

from helicoide.arrays import Array
from helicoide.text import Text

Progress = Callable[[float], None]
THE_RUN = Text(en="the run", pt_BR="a execução")
PUT_IN = Text(en="it was put in", pt_BR="é dado de entrada")
CONSTRUCTED = Text(en="it holds by construction", pt_BR="vale por construção")
Relation = Literal["=", "~", "<", "≤", ">", "≥"]

_NUMBER = re.compile(r"([~≈<≤>≥=])?\s*([-−]?\d+(?:[.,]\d+)?)(?:\s*[×·]\s*10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?")
_LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


class Verdict(Enum):
    """How ours stands to what the source prints."""

    PRINTED = Text(en="as printed", pt_BR="como impresso")
    FITTED = Text(
        en="as printed, with a fitted value or reading", pt_BR="como impresso, com valor ou leitura escolhidos"
    )
    DIFFERS = Text(en="differs", pt_BR="difere")
    ERRATUM = Text(en="a slip in print or in our copy", pt_BR="lapso no impresso ou na nossa cópia")
    FIGURE = Text(en="only in a figure", pt_BR="só em figura")
    OURS = Text(en="ours", pt_BR="nosso")


@dataclass(frozen=True)
class Statement:
    """What a source prints about a quantity.

    words: what it says, in either language; place: such as "fig. 3.11" or "§4.2.1"; value: the number that
    they ask for, in the unit of the row; relation: "=" to `within`, "~" within its power of ten, or a bound.
    """

    words: Text
    place: str
    value: float
    relation: Relation = "="
    within: float = 0.0

    @property
    def is_number(self) -> bool:
        """Whether the words are a number; else they were read as one."""
        return _NUMBER.fullmatch(self.words.en) is not None

    def holds(self, ours: float) -> bool:
        """Whether a number is as it is stated; what is no number never is."""
        match self.relation:
            case "=":
                return abs(ours - self.value) <= self.within
            case "~":
                return self.value <= ours < 10 * self.value
            case "<":
                return ours < self.value
            case "≤":
                return ours <= self.value + self.within
            case ">":
                return ours > self.value
            case "≥":
                return ours >= self.value - self.within


def printed(words: str, place: str) -> Statement:
    """A number as it is printed, such as "< 1,2", "≈ 9" or "8,3 × 10⁻⁴"; it is met to half a unit of its last digit.

    One that is printed as "about" is met to a whole unit. Raises ValueError for words that are no number.
    """
    if not (match := _NUMBER.fullmatch(words.strip())):
        raise ValueError(f"{words!r} is no number with a relation, such as '< 1,2'")
    sign, digits, power = match[1] or "=", match[2].replace(",", ".").replace("−", "-"), match[3]
    scale = 10.0 ** int((power or "0").translate(_LOWERED))
    unit = scale * 10.0 ** -len(digits.partition(".")[2])
    relation: Relation = "=" if sign == "≈" else sign  # type: ignore[assignment]
    within = {"=": 0.5, "≈": 1.0}.get(sign, 0.0) * unit * (1 + 1e-9)
    said = Text(en=words.replace(",", "."), pt_BR=words.replace(".", ","))
    return Statement(said, place, float(digits) * scale, relation, within)


@dataclass(frozen=True)
class Figure:
    """The source shows the quantity in a figure only: its place."""

    place: str


@dataclass(frozen=True)
class Fitted:
    """A value that the source does not give, chosen so that what it prints holds, as it does from `least` to `most`."""

    name: Text
    value: float
    least: float
    most: float
    unit: str = ""


@dataclass(frozen=True)
class Reading:
    """What was taken where the source allows more than one reading, such as the instant at which an error is read.

    otherwise: what comes out by another one.
    """

    name: Text
    otherwise: Text


@dataclass(frozen=True)
class Row:
    """A quantity: what the source has of it, None where it has nothing, and ours.

    fitted: the chosen values and readings by which the statement holds; erratum: the number of the error of the source
    because of which it does not, such as "vargas-2"; why: why ours differs, where that is known; given: why ours is no
    result, such as `PUT_IN`, so that no verdict is due.
    """

    quantity: Text
    ours: float
    unit: str = ""
    source: Statement | Figure | None = None
    fitted: tuple[Fitted | Reading, ...] = ()
    erratum: str = ""
    why: Text | None = None
    given: Text | None = None

    @property
    def verdict(self) -> Verdict:
        """How ours stands to what the source prints; what is no number differs from everything."""
        if self.ours != self.ours:
            return Verdict.DIFFERS
        if self.given is not None:
            return Verdict.OURS
        match self.source:
            case None:
                return Verdict.OURS
            case Figure():
                return Verdict.FIGURE
            case Statement() as statement if statement.holds(self.ours):
                return Verdict.FITTED if self.fitted else Verdict.PRINTED
        return Verdict.ERRATUM if self.erratum else Verdict.DIFFERS


def unstated(rows: tuple[Row, ...]) -> tuple[Row, ...]:
    """The rows of a study with settings that are not those of its source: every number stands alone."""
    return tuple(replace(row, source=None, fitted=(), erratum="", why=None, given=None) for row in rows)


@dataclass(frozen=True, eq=False)
class Line:
    """A curve of a chart: x (k,) and y (k,)."""

    title: Text
    x: Array
    y: Array


@dataclass(frozen=True, eq=False)
class Chart:
    """Curves over a common quantity; `across` and `up` name the axes, with their units.

    figure: that of the source beside which it stands, such as "fig. 3.11"; log: whether up goes by powers of ten.
    """

    title: Text
    across: Text
    up: Text
    lines: tuple[Line, ...]
    figure: str = ""
    log: bool = False


@dataclass(frozen=True, eq=False)
class Motion:
    """What the arm did in one of the runs: times (k,), s, and joint values (k, n), rad or m, of a robot by its name.

    parameters: lengths of the robot that were chosen, mm, as `load` takes them; title: the name of the run.
    """

    robot: str
    times: Array
    q: Array
    parameters: tuple[str, ...] = ()
    title: Text = THE_RUN


@dataclass(frozen=True, eq=False)
class Result:
    """What a study came to: its rows, its curves, and what the arm did in each of its runs."""

    rows: tuple[Row, ...]
    charts: tuple[Chart, ...] = ()
    motions: tuple[Motion, ...] = ()

    @property
    def fitted(self) -> tuple[Fitted | Reading, ...]:
        """All values and readings that were chosen so that printed statements hold."""
        return tuple(dict.fromkeys(value for row in self.rows for value in row.fitted))


class Study(Protocol):
    """A module of `studies/`.

    SOURCE: author, year, section; or that it is your own. Options: annotated with the settings of `ik.method`, as those
    of a method are.
    """

    TITLE: Text
    SOURCE: str
    ABOUT: Text
    ROBOT: str

    @property
    def Options(self) -> type:
        """The class of its settings; its defaults are those of the source, or what was chosen where that gives none."""

    def run(self, options: Any, short: bool, progress: Progress) -> Result:
        """Run it. short: a coarser or shorter form of a few seconds; what it cannot judge is no row of it.

        progress: told the share that is done, 0 to 1.
        """
