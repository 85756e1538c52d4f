"""The Movemaster from home to its target with five tasks, a constant share of the error a step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.convergence import FACTOR, Coming, result
from helicoide.studies.study import Progress, Result, Statement
from helicoide.text import Text, same

TITLE = Text(en="Convergence of the Movemaster", pt_BR="Convergência do Movemaster")
SOURCE = "Cerbaro 2022, §4.4.4, dem. 1, fig. 34"
ROBOT = "movemaster"
ABOUT = Text(
    en="From home the tool is to come to (440, 0, 200) mm, pointing 60° below level. Five joints have five tasks, and "
    "no freedom is left. How many steps it takes is a matter of the share of the error that each goes, which the "
    "source does not give. The posture that is reached lies outside the limit of J3.",
    pt_BR="Da origem o efetuador deve chegar a (440, 0, 200) mm, apontando 60° abaixo da horizontal. Cinco juntas têm "
    "cinco tarefas, e não sobra liberdade. Quantos passos são precisos depende da fração do erro que cada um percorre, "
    "e a fonte não a informa. A postura alcançada fica fora do limite de J3.",
)
TARGET, PITCH = (0.44, 0.0, 0.2), -np.pi / 3


BAND = Text(
    en="with κ = 0.295 it takes 17, but only between 0.288 and 0.302; with the factor of the ORCA, fewer",
    pt_BR="com κ = 0,295 são 17, mas só entre 0,288 e 0,302; com o fator do ORCA, menos",
)


@dataclass(frozen=True)
class Options:
    """factor: κ, which the source does not give; damping: λ of the source."""

    factor: Annotated[float, Quantity(FACTOR.name, 0.1, 1.0)] = FACTOR.value
    damping: Annotated[float, Quantity(Text(en="damping λ", pt_BR="amortecimento λ"), 0.0, 10.0, "mm/rad")] = 0.1


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Damped steps to 1 mm and 0.01 rad; the short form is the whole."""
    movemaster = arms.movemaster()
    aiming = arms.with_pitch_and_roll(movemaster, arms.standing(*TARGET), PITCH)
    coming = Coming(
        movemaster, aiming, Statement(same("17"), "§4.4.4, fig. 34", 17), (0.295, 0.5, 1.0), "fig. 34", BAND
    )
    return result(coming, options.factor, options.damping)
