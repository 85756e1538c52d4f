"""The free body, drawn in millimetres: `python robots/free_body/build.py` writes meshes/.

A box with the faces of a die, so that each can be named: one dot on the face towards x, two towards y, three towards z,
and on opposite faces dots that add up to seven. Faces of one axis have its colour, the one on the negative side paler.
"""

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, painted, write_meshes

SURFACES = {
    "frame": cad.paint(70, 74, 80, roughness=0.6),
    "red": cad.paint(196, 52, 44, roughness=0.5),
    "green": cad.paint(40, 132, 74, roughness=0.5),
    "blue": cad.paint(44, 96, 190, roughness=0.5),
    "pale_red": cad.paint(240, 190, 182, roughness=0.5),
    "pale_green": cad.paint(184, 224, 194, roughness=0.5),
    "pale_blue": cad.paint(186, 208, 240, roughness=0.5),
    "white": cad.paint(250, 250, 248, roughness=0.5),
    "black": cad.paint(28, 30, 34, roughness=0.5),
}
SIZE = (320.0, 240.0, 160.0)
MARGIN, PLATE, DOT = 9.0, 2.0, 15.0  # of the frame around a face, thickness of a face, radius of a dot
CORNERS = [(-1, -1), (1, 1), (-1, 1), (1, -1)]
DOTS = {
    1: [(0, 0)],
    2: CORNERS[:2],
    3: [(0, 0), *CORNERS[:2]],
    4: CORNERS,
    5: [(0, 0), *CORNERS],
    6: [*CORNERS, (-1, 0), (1, 0)],
}
FACES: dict[int, tuple[cad.Axis, str, str]] = {
    1: ("x", "red", "white"),
    2: ("y", "green", "white"),
    3: ("z", "blue", "white"),
    4: ("-z", "pale_blue", "black"),
    5: ("-y", "pale_green", "black"),
    6: ("-x", "pale_red", "black"),
}


def face(number: int) -> Parts:
    """A face with its dots, on the side of the box towards its axis."""
    axis, colour, ink = FACES[number]
    along = "xyz".index(axis[-1])
    first, second = (k for k in range(3) if k != along)
    middle = [0.0, 0.0, 0.0]
    middle[along] = (-1 if axis.startswith("-") else 1) * SIZE[along] / 2
    thickness = [PLATE, PLATE, PLATE]
    for k in (first, second):
        thickness[k] = SIZE[k] - 2 * MARGIN
    x, y, z = thickness
    mx, my, mz = middle
    dots = []
    for u, v in DOTS[number]:
        at = [mx, my, mz]
        at[along] *= 1 + PLATE / SIZE[along]
        at[first] += u * SIZE[first] / 4
        at[second] += v * SIZE[second] / 4
        dots.append(cad.raised(cad.circle(DOT, 32), 1.5, axis=axis, at=at))
    return {colour: [cad.box((x, y, z), at=(mx, my, mz))], ink: dots}


def body() -> Parts:
    """The box and its six faces."""
    parts: Parts = {"frame": [cad.box(SIZE, corner=8, edge=8, steps=2)]}
    for number in FACES:
        for surface, solids in face(number).items():
            parts.setdefault(surface, []).extend(solids)
    return parts


DRAWINGS = (body,)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
