"""The polar RP arm drawn in millimetres: `python robots/polar_rp/build.py` writes meshes/.

A turret on a column carries a housing through which the ram slides; the ram's point is the tool. At q = 0 the slide
points along y, and the ram's frame, with the tool, is on the axis of the turret. Side views are drawn as seen along x.
"""

import numpy as np
from trimesh import Trimesh

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, painted, write_meshes

SURFACES = {
    "sand": cad.paint(226, 218, 200, roughness=0.5),
    "green": cad.paint(46, 110, 70, roughness=0.5),
    "dark": cad.paint(54, 58, 60, roughness=0.55),
    "metal": cad.paint(200, 203, 206, roughness=0.3, metallic=0.6),
}
FLOOR = -560.0
FRONT, REAR = 215.0, -215.0  # ends of the housing along the slide
RAM = 690.0


def base() -> Parts:
    """The foot, the column and the bearing of the turret."""
    column = [(150, FLOOR + 24), (140, FLOOR + 40), (122, -210), (122, -172), (114, -164)]
    return {
        "dark": [
            cad.box((420, 420, 26), corner=30, edge=5, at=(0, 0, FLOOR + 13)),
            cad.raised(cad.rectangle(120, 150, corner=12), 40, 6, 2, axis="-y", at=(0, -112, -380)),
        ],
        "sand": [cad.turned(column, sides=48)],
        "green": [cad.turned([(127, -240), (126, -228)], sides=48)],
        "metal": [
            cad.turned([(98, -166), (98, -146)], sides=48),
            cad.bolts([(x, y, FLOOR + 26) for x in (-175, 175) for y in (-175, 175)], 14, 10, "z"),
            cad.cylinder(9, 22, axis="-y", at=(-30, -158, -420), sides=16),
            cad.cylinder(9, 22, axis="-y", at=(30, -158, -420), sides=16),
        ],
    }


def channel(width: float, height: float) -> Trimesh:
    """The space that the ram needs in the housing."""
    return cad.box((width, 600, height), corner=6, axis="y")


def turret() -> Parts:
    """Turntable, cradle, the housing of the slide with its motor, and the rings at its two mouths."""
    side = cad.rounded([(-120, -142), (120, -142), (120, -118), (96, -66), (-96, -66), (-120, -118)], 8)
    housing = cad.box((150, FRONT - REAR, 150), corner=26, edge=10, steps=2, axis="y")
    mouth = cad.box((112, 24, 112), corner=18, edge=5, axis="y", at=(0, FRONT + 8, 0))
    rear = cad.box((112, 24, 112), corner=18, edge=5, axis="y", at=(0, REAR - 8, 0))
    panel = cad.raised(cad.rectangle(250, 84, corner=10), 5, 2, axis="x", at=(75, 0, 0))
    stripe = cad.raised(cad.rectangle(226, 9), 1.2, axis="x", at=(80, 0, 20))
    corners = [(80, y, z) for y in (-114, 114) for z in (-32, 32)]
    return {
        "sand": [cad.prism(side, 150, 8, 2, axis="x"), cad.cut(housing, channel(74, 74))],
        "green": [*sides(panel)],
        "dark": [
            cad.turned([(118, -148), (124, -144), (124, -132), (116, -126)], sides=48),
            cad.cut(mouth, channel(72, 72)),
            cad.cut(rear, channel(72, 72)),
            cad.box((70, 120, 58), corner=10, edge=4, axis="y", at=(0, -118, 100)),
            cad.box((62, 20, 50), corner=8, edge=3, axis="y", at=(0, -186, 100)),
            cad.cable(
                [(0, -194, 100), (22, -222, 97), (62, -236, 66), (70, -232, 0), (66, -196, -88), (52, -104, -126)], 7
            ),
        ],
        "metal": [
            *sides(stripe),
            *sides(cad.bolts(corners, 5, 3, "x")),
            cad.bolts([(x, FRONT + 20, z) for x in (-44, 44) for z in (-44, 44)], 5, 4, "y"),
            cad.bolts(cad.ring_of_points(8, 106, "z", (0, 0, -130), phase=0.5), 5, 3, "z"),
        ],
    }


def sides(solid: Trimesh) -> list[Trimesh]:
    """The part and its like on the other side of the slide, turned about the vertical."""
    other = solid.copy()
    other.apply_transform(np.diag([-1.0, -1, 1, 1]))
    return [solid, other]


def ram() -> Parts:
    """The sliding bar with its toothed rack and end stop; its point is the tool, on the frame's origin."""
    bar = cad.box((60, RAM - 150, 60), corner=7, axis="y", at=(0, -150 - (RAM - 150) / 2, 0))
    teeth = [(8 * i + u, v) for i in range(64) for u, v in ((0, 0), (1.5, 6), (5, 6), (6.5, 0))]
    rack = np.array([*teeth, (520, 0), (520, -5), (-8, -5), (-8, 0)])[::-1] - (670, -28)
    flange = [(42, -158), (42, -146), (38, -142)]
    point = [(24, -146), (24, -84), (18, -70), (8, -40), (0.4, 0)]
    return {
        "metal": [bar, cad.turned(point, axis="y"), cad.prism(rack, 22, axis="x")],
        "dark": [
            cad.turned(flange, axis="y"),
            cad.box((66, 14, 68), corner=6, edge=3, axis="y", at=(0, -RAM, 0)),
        ],
        "green": [cad.turned([(25.5, -118), (25.5, -104)], axis="y")],
    }


DRAWINGS = (base, turret, ram)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
