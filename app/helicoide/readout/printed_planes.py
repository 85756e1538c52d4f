"""The planes of a robot's file next to the numbers that its source prints."""

from __future__ import annotations

import re

from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.readout.signal import SUBSCRIPTS
from helicoide.text import Text, rounded_numbers, rounded_text, with_decimal_comma

LINE = Text(
    en="{name} ({title}): n = ({normal}), d = {offset} m; printed {printed}",
    pt_BR="{name} ({title}): n = ({normal}), d = {offset} m; impresso {printed}",
)
WHY_PRINTED_DIFFERS = Text(
    en="The source prints millimetres, the measured normals and its own labels. Here lengths are in metres, every "
    "normal points to the arm, and each wall is named after its side.",
    pt_BR="A fonte imprime milímetros, as normais medidas e rótulos próprios. Aqui os comprimentos estão em metros, "
    "toda normal aponta para o braço, e cada parede tem o nome do seu lado.",
)


def printed_planes(robot: Robot) -> tuple[Text, ...]:
    """A line for each plane of the robot's file that a source prints: its numbers here, m, and the printed ones, mm."""
    return tuple(_line(pane) for pane in robot.panes if pane.as_printed)


def _line(pane: PlanePane) -> Text:
    printed = re.sub(r"(?<=\be)\d", lambda found: found[0].translate(SUBSCRIPTS), pane.as_printed)
    return LINE.format(
        name=pane.name,
        title=pane.title,
        normal=rounded_numbers(pane.normal, 4),
        offset=rounded_text(pane.offset, 4),
        printed=with_decimal_comma(printed.replace("-", "−")),
    )
