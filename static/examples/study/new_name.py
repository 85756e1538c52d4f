"""A new study, to be changed: how far an arm reaches when it is stretched."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import frozen
from helicoide.ik.method import Quantity
from helicoide.kinematics.forward import tool_by_screws
from helicoide.kinematics.library import load_robot
from helicoide.studies.study import Chart, ChartLine, Motion, Progress, Result, Row, printed_statement
from helicoide.text import Text

TITLE = Text(en="New study (new_name)", pt_BR="Estudo novo (new_name)")
SOURCE = "Author 2000, §1; or that it is your own"
ROBOT = "planar3r"
ABOUT = Text(
    en="The last joints bend while the first one stands still. The end effector comes nearer to the base.",
    pt_BR="As últimas juntas dobram e a primeira fica parada. O efetuador se aproxima da base.",
)


@dataclass(frozen=True)
class Options:
    """bend: the largest angle of each joint but the first, °."""

    bend: Annotated[float, Quantity(Text(en="largest angle", pt_BR="maior ângulo"), 10.0, 120.0, "°")] = 90.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The distance from the base along the motion; in short form at fewer instants."""
    robot, times = load_robot(ROBOT), np.linspace(0.0, 5.0, 20 if short else 200)
    angles = np.radians(options.bend) * times / times[-1]
    q = frozen([[0.0, *[angle] * (len(robot.variables) - 1)] for angle in angles])
    far = np.array([np.linalg.norm(tool_by_screws(robot, row)[:3, 3]) for row in q])
    progress(1.0)
    name = Text(en="distance from the base", pt_BR="distância até a base")
    ratio = Text(en="largest distance, as a share of the reach", pt_BR="maior distância, como parte do alcance")
    rows = (
        Row(ratio, float(far.max() / robot.reach), "", printed_statement("1.00", "§1")),
        Row(Text(en="smallest distance", pt_BR="menor distância"), float(far.min()), "m"),
    )
    chart = Chart(
        name, Text(en="time (s)", pt_BR="tempo (s)"), Text(en="distance (m)", pt_BR="distância (m)"),
        (ChartLine(name, times, far),),
    )  # fmt: skip
    return Result(rows, (chart,), (Motion(ROBOT, times, q),))
