"""The table [actuators] of a robot file: how the motors move the joints, in pulses, millimetres and degrees."""

from __future__ import annotations

import math
from collections.abc import Sequence

import msgspec
import numpy as np

from helicoide.arrays import frozen
from helicoide.kinematics.actuators import Actuators, BallScrew, Gear
from helicoide.text import HelicoideError, Text


class GearFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True, tag_field="kind", tag="gear"):
    """A motor behind gears; zero_deg: the driven angle at zero pulses."""

    pulses_per_deg: float
    zero_deg: float = 0

    def in_si(self) -> Gear:
        """The gear in rad."""
        return Gear(math.degrees(self.pulses_per_deg), math.radians(self.zero_deg))

    def check(self, name: str) -> None:
        """Raise HelicoideError if pulses do not move the joint."""
        if self.pulses_per_deg == 0:
            raise _error(
                "pulses_per_deg of actuator {name} is zero; it may be positive or negative",
                "pulses_per_deg do atuador {name} é zero; pode ser positivo ou negativo",
                name=name,
            )


class BallScrewFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True, tag_field="kind", tag="ball_screw"):
    """A ball screw in a triangle of two fixed sides; zero_deg: the driven angle where the triangle is folded flat."""

    sides_mm: tuple[float, float]
    pulses_per_mm: float
    length_at_zero_mm: float
    zero_deg: float

    def in_si(self) -> BallScrew:
        """The ball screw in m and rad."""
        a, b = self.sides_mm
        return BallScrew(
            (a / 1000, b / 1000), self.pulses_per_mm * 1000, self.length_at_zero_mm / 1000, math.radians(self.zero_deg)
        )

    def check(self, name: str) -> None:
        """Raise HelicoideError unless the screw moves and closes its triangle at zero pulses."""
        a, b = self.sides_mm
        if self.pulses_per_mm == 0:
            raise _error(
                "pulses_per_mm of actuator {name} is zero; it may be positive or negative",
                "pulses_per_mm do atuador {name} é zero; pode ser positivo ou negativo",
                name=name,
            )
        if not (a > 0 and b > 0):
            raise _error(
                "sides_mm of actuator {name} must be positive, not {a:g} and {b:g}",
                "sides_mm do atuador {name} devem ser maiores que zero, não {a:g} e {b:g}",
                name=name,
                a=a,
                b=b,
            )
        if not abs(a - b) < self.length_at_zero_mm < a + b:
            raise _error(
                "length_at_zero_mm of actuator {name} is {given:g}, which closes no triangle with sides of {a:g} and "
                "{b:g}: it must lie between {least:g} and {most:g}",
                "length_at_zero_mm do atuador {name} é {given:g}, que não fecha triângulo com lados de {a:g} e {b:g}: "
                "deve ficar entre {least:g} e {most:g}",
                name=name,
                given=self.length_at_zero_mm,
                a=a,
                b=b,
                least=abs(a - b),
                most=a + b,
            )


class ActuatorsFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The table [actuators]: a drive for each joint, and the coupling C where drives move sums of joint angles."""

    drives: tuple[GearFile | BallScrewFile, ...]
    coupling: tuple[tuple[int, ...], ...] | None = None

    def check(self, joints: Sequence[str]) -> None:
        """Raise HelicoideError unless every joint has a drive and the coupling is invertible."""
        n = len(joints)
        if len(self.drives) != n:
            raise _error(
                "actuators has {given} drives for {n} joints: {joints}",
                "actuators tem {given} drives para {n} juntas: {joints}",
                given=len(self.drives),
                n=n,
                joints=", ".join(joints),
            )
        for i, drive in enumerate(self.drives):
            drive.check(f"A{i + 1}")
        if self.coupling is None:
            return
        if [len(row) for row in self.coupling] != [n] * n:
            raise _error(
                "coupling of actuators must have {n} rows of {n} whole numbers for {n} joints",
                "coupling de actuators deve ter {n} linhas de {n} números inteiros para {n} juntas",
                n=n,
            )
        if np.linalg.matrix_rank(frozen(self.coupling)) < n:
            raise _error(
                "coupling of actuators is singular: no row may be a sum of multiples of the others",
                "coupling de actuators é singular: nenhuma linha pode ser soma de múltiplos das outras",
            )

    def actuators(self, joints: Sequence[str]) -> Actuators:
        """The actuators of an arm with these joints, in SI units."""
        coupling = np.eye(len(joints)) if self.coupling is None else self.coupling
        return Actuators(tuple(joints), frozen(coupling), tuple(drive.in_si() for drive in self.drives))


def _error(en: str, pt_BR: str, **fields: object) -> HelicoideError:
    return HelicoideError(Text(en=en, pt_BR=pt_BR).format(**fields))
