"""The link to a view or a sheet, as the fragment of the page's address: named parts for arm, camera, sheet and others.

The parts are those of a query: `v=1&robot=movemaster&q=0.1,-0.5&camera=1,2,1,0,0,0&tab=algebra&end=1`. q: rad or m;
camera: position and the point that it looks at, m. The last part shows that nothing was cut off. A sheet that is not
empty is the part `sheet` before it. The link to a sheet alone is `sheet=eJx…`: the packed sheet shows by itself whether
it is whole. Browsers send the fragment to no server; our page sends it on its own channel. A link only asks: no arm
moves when it is opened.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from urllib.parse import parse_qsl, urlencode

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kinematics.library import robot_titles
from helicoide.seat import LinkedPosture
from helicoide.sheet import LONGEST_PACKED, Sheet, packed_sheet, unpacked_sheet
from helicoide.text import HelicoideError, Text
from helicoide.view import panels

LONGEST_LINK = LONGEST_PACKED + 4000
MOST_PARTS, MOST_JOINTS, LARGEST_NUMBER = 20, 40, 1e4
PARTS = ("v", "robot", "q", "camera", "tab", "end")
SHEET = "sheet"
PARTS_WITH_SHEET = (*PARTS[:-1], SHEET, PARTS[-1])
CUT = Text(
    en="The link is incomplete or was changed on the way: copy it again. Its parts are {parts}; or {sheet} alone.",
    pt_BR="O link está incompleto ou foi alterado no caminho: copie-o de novo. As partes dele são {parts}; ou só "
    "{sheet}.",
).format(parts=", ".join(PARTS_WITH_SHEET), sheet=SHEET)
TOO_LONG = Text(
    en="The link is too long: it has at most {most} characters.",
    pt_BR="O link é longo demais: ele tem no máximo {most} caracteres.",
).format(most=LONGEST_LINK)
BAD_NUMBERS = Text(
    en="The link is damaged: its part “{part}” must be {count} finite numbers, separated by commas.",
    pt_BR="O link está danificado: a parte “{part}” deve ter {count} números finitos, separados por vírgulas.",
)
NO_ARM = Text(
    en="The link is about an arm that is not here. Arms: {known}.",
    pt_BR="O link trata de um braço que não existe aqui. Braços: {known}.",
)
NO_TAB = Text(
    en="The link is about a tab that does not exist. Tabs: {known}.",
    pt_BR="O link trata de uma aba que não existe. Abas: {known}.",
)


@dataclass(frozen=True, eq=False)
class SharedView:
    """What a link shows. posture: of an arm; camera: position and target, (3,) m each; tab: number of the tab.

    sheet: an empty one does not count.
    """

    posture: LinkedPosture
    camera: tuple[Array, Array]
    tab: int
    sheet: Sheet = field(default=Sheet())


def encode_link(shared: SharedView | Sheet) -> str:
    """The fragment of the address: of a view, or of a sheet alone."""
    if isinstance(shared, Sheet):
        return urlencode({SHEET: packed_sheet(shared)})
    parts = {
        "v": "1",
        "robot": shared.posture.robot,
        "q": _numbers(shared.posture.q),
        "camera": _numbers([*shared.camera[0], *shared.camera[1]]),
        "tab": panels.panel_names()[shared.tab],
        **({SHEET: packed_sheet(shared.sheet)} if shared.sheet != Sheet() else {}),
        "end": "1",
    }
    return urlencode(parts, safe=",")


def decode_link(text: str) -> SharedView | Sheet:
    """The view of a fragment, or its sheet if that is alone.

    Raises HelicoideError for a link that is cut, changed or about something unknown.
    """
    parts = _parts(text)
    if tuple(parts) == (SHEET,):
        return unpacked_sheet(parts[SHEET])
    if tuple(parts) not in (PARTS, PARTS_WITH_SHEET) or (parts["v"], parts["end"]) != ("1", "1"):
        raise HelicoideError(CUT)
    if parts["robot"] not in robot_titles():
        raise HelicoideError(NO_ARM.format(known=", ".join(robot_titles())))
    if parts["tab"] not in panels.panel_names():
        raise HelicoideError(NO_TAB.format(known=", ".join(panels.panel_names())))
    q, camera = _read("q", parts["q"]), _read("camera", parts["camera"], 6)
    if np.linalg.norm(camera[:3] - camera[3:]) < 1e-6:
        raise HelicoideError(BAD_NUMBERS.format(part="camera", count=6))
    posture = LinkedPosture(parts["robot"], tuple(q.tolist()))
    sheet = unpacked_sheet(parts[SHEET]) if SHEET in parts else Sheet()
    return SharedView(posture, (camera[:3], camera[3:]), panels.panel_names().index(parts["tab"]), sheet)


def console_tab() -> int:
    """The number of the tab that has the console."""
    return panels.panel_names().index("algebra")


def _parts(text: str) -> dict[str, str]:
    """The parts of a fragment by their names, in their order. Raises HelicoideError if it has none, or one twice."""
    if len(text) > LONGEST_LINK:
        raise HelicoideError(TOO_LONG)
    try:
        pairs = parse_qsl(text, keep_blank_values=True, strict_parsing=True, max_num_fields=MOST_PARTS)
    except ValueError as error:
        raise HelicoideError(CUT) from error
    parts = dict(pairs)
    if len(parts) != len(pairs):
        raise HelicoideError(CUT)
    return parts


def _numbers(values: Sequence[float]) -> str:
    return ",".join(f"{value:.6g}" for value in values)


def _read(part: str, text: str, count: int | None = None) -> Array:
    """The numbers of a part; as many as `count`, or 1 to `MOST_JOINTS`."""
    words = text.split(",")
    fits = len(words) == count if count is not None else len(words) <= MOST_JOINTS
    try:
        values = np.array([float(word) for word in words]) if fits and text.isascii() else np.array([np.nan])
    except ValueError:
        values = np.array([np.nan])
    if not (np.isfinite(values).all() and np.abs(values).max() <= LARGEST_NUMBER):
        raise HelicoideError(BAD_NUMBERS.format(part=part, count=count or f"1–{MOST_JOINTS}"))
    return frozen(values)
