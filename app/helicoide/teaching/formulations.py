"""Forward kinematics by each formulation, side by side in a notebook."""

from __future__ import annotations

from dataclasses import dataclass

from markupsafe import Markup

from helicoide.arrays import Array
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.kinematics.forward import formulation_difference, tool_by_dh, tool_by_screws, tool_motor
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.stages import STAGES, JointStage, StageKind
from helicoide.teaching import tables
from helicoide.text import Language, Text

TITLES: dict[StageKind, Text] = {
    "dh": Text(en="DH rows: T₀ A₁ … Aᵢ", pt_BR="Linhas DH: T₀ A₁ … Aᵢ"),
    "screws": Text(en="successive screws: H₁ … Hᵢ", pt_BR="helicoides sucessivos: H₁ … Hᵢ"),
    "products": Text(en="products of motors: m₁ … mᵢ", pt_BR="produtos de motores: m₁ … mᵢ"),
}
JOINT, TOOL = Text(en="joint", pt_BR="junta"), Text(en="end effector", pt_BR="efetuador")
DIFFERENCE = Text(en="largest difference: {value:.1e}", pt_BR="maior diferença: {value:.1e}")


@dataclass(frozen=True, eq=False)
class Formulations:
    """The pose of the end effector at q (n,), worked out in three ways that share nothing but linear algebra.

    Source: Cerbaro 2022, eq. 59 (DH rows), App. D (screws), §5.1 (motors).
    """

    robot: Robot
    q: Array
    language: Language

    @property
    def dh(self) -> Array:
        """By DH rows: T = T₀ A₁ … Aₘ · T_dh_tool, (4, 4), m."""
        return tool_by_dh(self.robot, self.q)

    @property
    def screws(self) -> Array:
        """By successive screws: T = H₁ … Hₘ T₀, (4, 4), m."""
        return tool_by_screws(self.robot, self.q)

    @property
    def motor(self) -> Multivector:
        """By products of motors, which are dual quaternions: M = m₁ … mₘ M₀."""
        return Multivector(rigid.canonical(tool_motor(self.robot, self.q)), CL031)

    @property
    def difference(self) -> float:
        """The largest difference between entries of the three poses, positions in m."""
        return formulation_difference(self.robot, self.q)

    def stages(self, kind: StageKind) -> list[JointStage]:
        """Joint by joint: "dh", "screws" or "products", each with its parameters and the product up to it."""
        return STAGES[kind](self.robot, self.q)

    def __repr__(self) -> str:
        return f"{self.dh}\n{self.screws}\n{self.motor}\n{DIFFERENCE.format(value=self.difference)[self.language]}"

    def _repr_html_(self) -> Markup:
        """A column for each formulation, a row for each joint, and the end effector in the last row."""
        columns = zip(*(self.stages(kind) for kind in TITLES), strict=True)
        rows = [(dh.joint, *map(self._shown, (dh, screw, product))) for dh, screw, product in columns]
        poses = [tables.matrix(T, self.language) for T in (self.dh, self.screws)]
        heads = [JOINT[self.language], *(title[self.language] for title in TITLES.values())]
        end = (TOOL[self.language], *poses, self.motor._repr_html_())
        said = DIFFERENCE.format(value=self.difference)[self.language]
        return tables.table(heads, [*rows, end]) + Markup("<p>{}</p>").format(said)

    def _shown(self, stage: JointStage) -> Markup:
        if stage.partial.ndim == 2:
            return tables.matrix(stage.partial, self.language)
        return Multivector(rigid.motor_from_dual_quaternion(stage.partial), CL031)._repr_html_()
