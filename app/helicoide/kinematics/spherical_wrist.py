"""Arms with six revolute joints whose last three axes meet in a point: the factors of det J, by kind of singularity."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.kinematics import jacobian
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import Frame
from helicoide.text import Text

# Axes count as meeting below this distance, m, and as parallel below this sine.
MEETING, PARALLEL = 1e-6, 1e-6


class SingularityKind(Enum):
    """The kinds of singularity of such an arm."""

    SHOULDER = Text(
        en="shoulder: the wrist centre is on the first axis",
        pt_BR="ombro: o centro do punho está sobre o primeiro eixo",
    )
    ELBOW = Text(en="elbow: the arm is stretched or folded", pt_BR="cotovelo: o braço está esticado ou dobrado")
    ARM = Text(
        en="arm: the first three joints do not move the wrist centre in every direction",
        pt_BR="braço: as três primeiras juntas não movem o centro do punho em todas as direções",
    )
    WRIST = Text(
        en="wrist: its first and last axes are aligned",
        pt_BR="punho: o primeiro e o último eixo dele estão alinhados",
    )


@dataclass(frozen=True)
class DeterminantFactor:
    """A factor of det J: its kind, its signed value, and the largest absolute value that the arm's lengths allow.

    Units: shoulder m, elbow m², arm m³, wrist none.
    """

    kind: SingularityKind
    value: float
    largest: float

    @property
    def relative(self) -> float:
        """Value divided by the largest absolute value, in [−1, 1]; 0 is singular."""
        return self.value / self.largest

    @property
    def description(self) -> Text:
        """The kind as a sentence, with the relative value in percent."""
        return Text(
            en="{kind} (factor at {part:.1f} % of its largest)", pt_BR="{kind} (fator a {part:.1f} % do máximo)"
        ).format(kind=self.kind.value, part=100 * abs(self.relative))


def spherical_wrist(robot: Robot) -> Frame | None:
    """The frame "wrist" if the last three of six revolute axes meet in its origin; None for other arms."""
    wrist, joints = robot.frames.get("wrist"), robot.joints
    if (
        wrist is None
        or len(joints) != 6
        or wrist.link < 4
        or any(joint.is_prismatic or joint.mimic for joint in joints)
    ):
        return None
    ways = wrist.T_link_frame[:3, 3] + robot.points[wrist.link - 1] - robot.points[3:]
    apart = np.linalg.norm(np.cross(ways, robot.directions[3:]), axis=1)
    return wrist if np.all(apart < MEETING) else None


def determinant_factors(robot: Robot, q: ArrayLike, wrist: Frame) -> tuple[DeterminantFactor, ...]:
    """Factors of the determinant at the wrist centre p: J_G = [J₁₁ 0; J₂₁ J₂₂], det J_G = det J₁₁ det J₂₂.

    −det J₂₂ = s₄·(s₆ × s₅) is the wrist's. If s₂ ∥ s₃, −det J₁₁ = [(s₁ × s₂)·(p − p₁)] [s₂·((p − p₂) × (p − p₃))],
    shoulder and elbow; else −det J₁₁ is one factor. For the Zebra-ZERO: l₁c₂ − l₂s₂₃, l₁l₂ cos q₃ and sin q₅.
    Args: q (6,), rad. Raises HelicoideError for a wrong q. Source: Vargas 2013, §3.2, eqs. 3.8–3.9.
    """
    poses = link_poses(robot.chain, robot.check_joints(q))
    axes = jacobian.joint_axes(poses, robot.chain)
    ways = (poses[wrist.link] @ wrist.T_link_frame)[:3, 3] - poses[1:4, :3, 3]
    parallel = np.linalg.norm(np.cross(axes[1], axes[2])) < PARALLEL
    arm = _shoulder_and_elbow(axes, ways) if parallel else (_arm(axes, ways),)
    return (*arm, _wrist(axes))


def _shoulder_and_elbow(axes: Array, ways: Array) -> tuple[DeterminantFactor, DeterminantFactor]:
    """The two factors of −det J₁₁ for s₂ ∥ s₃, from the axes (6, 3) and the vectors p − pᵢ (3, 3), m."""
    side, across = np.cross(axes[0], axes[1]), axes[1]
    upper, fore = (float(np.linalg.norm(np.cross(across, link))) for link in (ways[1] - ways[2], ways[2]))
    offset, sine = abs(float(side @ (ways[0] - ways[1]))), float(np.linalg.norm(side))
    return (
        DeterminantFactor(SingularityKind.SHOULDER, float(side @ ways[0]), offset + sine * (upper + fore)),
        DeterminantFactor(SingularityKind.ELBOW, float(across @ np.cross(ways[1], ways[2])), upper * fore),
    )


def _arm(axes: Array, ways: Array) -> DeterminantFactor:
    """−det J₁₁ as one factor; its bound is the product of the stretched lengths from the three joints to p."""
    columns = np.cross(axes[:3], ways)
    steps = np.linalg.norm([ways[0] - ways[1], ways[1] - ways[2], ways[2]], axis=1)
    longest = np.prod(np.cumsum(steps[::-1]))
    return DeterminantFactor(SingularityKind.ARM, float(columns[0] @ np.cross(columns[2], columns[1])), float(longest))


def _wrist(axes: Array) -> DeterminantFactor:
    """−det J₂₂ = s₄·(s₆ × s₅); its bound is the product of the sines between neighbouring axes."""
    s4, s5, s6 = axes[3:]
    sines = np.linalg.norm(np.cross(s4, s5)) * np.linalg.norm(np.cross(s5, s6))
    return DeterminantFactor(SingularityKind.WRIST, float(s4 @ np.cross(s6, s5)), float(sines))
