"""The planes of a robot's file beside what its source prints of them."""

from __future__ import annotations

from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.text import Text

LINE = Text(
    en="{name} ({title}): n = ({normal}), d = {offset} m; printed {printed}",
    pt_BR="{name} ({title}): n = ({normal}), d = {offset} m; impresso {printed}",
)
WHY_PRINTED_DIFFERS = Text(
    en="The source prints millimetres, normals as they were measured, and labels that are its own; here lengths are in "
    "metres, every normal points to the arm, and a wall has the name of the side on which it stands.",
    pt_BR="A fonte imprime milímetros, normais como medidas e rótulos próprios; aqui os comprimentos estão em metros, "
    "toda normal aponta para o braço, e cada parede tem o nome do lado em que está.",
)


def printed_planes(robot: Robot) -> tuple[Text, ...]:
    """A line for each plane of its file that a source prints: ours, in m, and the source's, with its label, in mm."""
    return tuple(_line(pane) for pane in robot.panes if pane.as_printed)


def _line(pane: PlanePane) -> Text:
    numbers = [f"{value:.4f}" for value in (*pane.normal, pane.offset)]
    ours, local = numbers, [number.replace(".", ",") for number in numbers]
    normal = Text(en=", ".join(ours[:3]), pt_BR="; ".join(local[:3]))
    printed = Text(en=pane.as_printed, pt_BR=pane.as_printed.replace(".", ","))
    offset = Text(en=ours[3], pt_BR=local[3])
    return LINE.format(name=pane.name, title=pane.title, normal=normal, offset=offset, printed=printed)
