"""What a method of inverse kinematics is: what it is asked, what it answers, what it promises, what can be set."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from enum import Enum
from math import isfinite
from types import MappingProxyType
from typing import Annotated, Any, Protocol, TypeVar, get_origin, get_type_hints

from helicoide.arrays import Array
from helicoide.ik import Problem, Reason
from helicoide.text import HelicoideError, Text

Settings = TypeVar("Settings")


@dataclass(frozen=True, eq=False)
class Task:
    """What is asked in one instant: joint rates q̇ with J q̇ = ν, ν = ẋ_d + Λ e.

    q (n,), rad or m; J (r, n); rate: ν (r,), 1/s; dt: how long the answer is applied, s. J and ν have no length in
    them: lengths are divided by the characteristic length ℓ of the problem, and a joint that slides is measured in ℓ.
    """

    q: Array
    J: Array
    rate: Array
    dt: float


@dataclass(frozen=True, eq=False)
class OnDemand(Mapping[str, float]):
    """Figures that cost more than the answer: each is computed when somebody reads it."""

    computed: Mapping[str, Callable[[], float]]

    def __getitem__(self, symbol: str) -> float:
        return self.computed[symbol]()

    def __iter__(self) -> Iterator[str]:
        return iter(self.computed)

    def __len__(self) -> int:
        return len(self.computed)


@dataclass(frozen=True, eq=False)
class Solution:
    """What a method answers: q̇ (n,), rad/s, or ℓ/s where a joint slides.

    figures: numbers of this instant by their symbol, such as the damping; inverse: B (n, r) where q̇ = B ν; reasons:
    what held the answer back.
    """

    rates: Array
    figures: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    inverse: Array | None = None
    reasons: tuple[Reason, ...] = ()


class Promise(Enum):
    """What a method can promise, in words; a contract test holds each method to those that it names."""

    CONVERGES = Text(en="comes to a reachable goal", pt_BR="chega a um objetivo alcançável")
    EXACT = Text(
        en="meets the asked velocity exactly where the arm is not singular",
        pt_BR="cumpre exatamente a velocidade pedida onde o braço não é singular",
    )
    BOUNDED = Text(
        en="joint rates stay below a hundred times what is asked, also at singular postures",
        pt_BR="as velocidades de junta ficam abaixo de cem vezes o que se pede, também em posturas singulares",
    )
    KEEPS_LIMITS = Text(
        en="keeps joint limits, speeds and distances by itself",
        pt_BR="respeita sozinho limites de junta, velocidades e distâncias",
    )
    LEAVES_SINGULAR = Text(en="leaves a singular start", pt_BR="sai de uma postura inicial singular")
    STAYS_SINGULAR = Text(
        en="never leaves an exactly singular start along the lost direction",
        pt_BR="nunca sai, pela direção perdida, de uma postura inicial exatamente singular",
    )


@dataclass(frozen=True)
class Quantity:
    """A setting that is a number: a slider from lower to upper.

    unit: as written on the screen. lengths: the power of the length in that unit, so that what is shown in mm, mm² or
    mm³ is the stored number times ℓ, ℓ² or ℓ³. decades: the slider runs through powers of ten.
    """

    title: Text
    lower: float
    upper: float
    unit: str = ""
    lengths: int = 0
    decades: bool = False


@dataclass(frozen=True)
class OneOf:
    """A setting that is one of several words; each with what is shown for it."""

    title: Text
    choices: Mapping[str, Text]


@dataclass(frozen=True)
class YesNo:
    """A setting that is on or off."""

    title: Text


Setting = Quantity | OneOf | YesNo


def settings(options: type) -> dict[str, Setting]:
    """The settings of an options class by the name of their field: its annotations hold them."""
    hints = get_type_hints(options, include_extras=True)
    return {
        one.name: next(part for part in hints[one.name].__metadata__ if isinstance(part, Quantity | OneOf | YesNo))
        for one in fields(options)
        if get_origin(hints[one.name]) is Annotated
    }


def changed(options: Settings, name: str, value: object) -> Settings:
    """The same options with one setting changed; raises HelicoideError, which names what is valid."""
    known = settings(type(options))
    if name not in known:
        raise HelicoideError(
            Text(
                en="There is no setting {name}; there is: {known}.", pt_BR="Não há ajuste {name}; há: {known}."
            ).format(name=name, known=", ".join(known) or "–")
        )
    if not _is_valid(known[name], value):
        raise HelicoideError(_valid(known[name]).format(title=known[name].title, value=repr(value)))
    return replace(options, **{name: value})  # type: ignore[type-var]


def _is_valid(setting: Setting, value: object) -> bool:
    match setting:
        case Quantity(_, lower, upper):
            is_number = isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value)
            return is_number and lower <= float(value) <= upper  # type: ignore[arg-type]
        case OneOf(_, choices):
            return value in choices
        case YesNo():
            return isinstance(value, bool)


def _valid(setting: Setting) -> Text:
    match setting:
        case Quantity(_, lower, upper):
            takes = f"{lower:g} … {upper:g}"
        case OneOf(_, choices):
            takes = ", ".join(choices)
        case YesNo():
            takes = "True, False"
    return Text(en="{title} takes " + takes + ", not {value}.", pt_BR="{title} aceita " + takes + ", não {value}.")


class Method(Protocol):
    """A module of `ik/methods/`.

    SOURCE may be yourself. EQUATION: in TeX. PROMISES: where it is empty, the module has NO_PROMISES, a Text that says
    why. REMEMBERS: what its memory holds from one instant to the next, None for nothing. FIGURES: titles of the figures
    of its solutions by symbol.
    """

    TITLE: Text
    SOURCE: str
    EQUATION: str
    REMEMBERS: Text | None
    PROMISES: frozenset[Promise]
    FIGURES: Mapping[str, Text]

    @property
    def Options(self) -> type:
        """The class of its settings."""

    def applies(self, task: Task) -> Text | None:
        """Why the method does not apply to a task of this shape; None where it does."""

    def start(self, task: Task, options: Any) -> Any:
        """The memory before the first step."""

    def step(self, problem: Problem, task: Task, memory: Any, options: Any) -> tuple[Solution, Any]:
        """The answer to one task, and the memory for the next."""
