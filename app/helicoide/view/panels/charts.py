"""Live signals as charts, the control loop as a diagram, and the matrices of the arm."""

from __future__ import annotations

from viser import Icon

from helicoide.kinematics.robot import Robot
from helicoide.text import Text
from helicoide.view.loop_rows import loop_rows
from helicoide.view.matrix_rows import matrix_rows
from helicoide.view.rows import Row
from helicoide.view.signal_rows import signal_rows

TITLE = Text(en="Charts", pt_BR="Gráficos")
ORDER = 5
ICON = Icon.CHART_LINE


def rows(robot: Robot) -> list[Row]:
    """The panel; it is the same for all robots."""
    return [*signal_rows(), loop_rows(), matrix_rows()]
