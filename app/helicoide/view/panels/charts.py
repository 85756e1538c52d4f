"""Live signals as charts, recordings of the arm, the control loop as a diagram, and the matrices of the arm."""

from __future__ import annotations

from viser import Icon

from helicoide.kinematics.robot import Robot
from helicoide.text import Text
from helicoide.view.loop_rows import loop_rows
from helicoide.view.matrix_rows import matrix_rows
from helicoide.view.recording_rows import recording_rows
from helicoide.view.rows import Row
from helicoide.view.signal_rows import signal_rows

TITLE = Text(en="Charts", pt_BR="Gráficos")
ORDER = 5
ICON = Icon.CHART_LINE


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot."""
    return [*signal_rows(), recording_rows(robot), loop_rows(), matrix_rows()]
