"""What happens over time: recordings of the arm."""

from __future__ import annotations

from viser import Icon

from helicoide.kinematics.robot import Robot
from helicoide.text import Text
from helicoide.view.recording_rows import recording_rows
from helicoide.view.rows import Row

TITLE = Text(en="Charts", pt_BR="Gráficos")
ORDER = 5
ICON = Icon.CHART_LINE


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot."""
    return [recording_rows(robot)]
