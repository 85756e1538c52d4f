"""The ORCA drawn in millimetres: `python robots/orca/build.py` writes meshes/.

Each part is drawn in the frame of its link, which at q = 0 is parallel to the base and stands on its joint. The links
lie one above the other, the gripper in the frame of the source, z = 0; the unit stands on a plate instead of its rail.
"""

import numpy as np

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, both, painted, write_meshes
from helicoide.solids.lettering import Lettering, on_both_sides, word

SURFACES = {
    "cream": cad.paint(231, 226, 211, roughness=0.5),
    "dark": cad.paint(62, 64, 68, roughness=0.55),
    "metal": cad.paint(198, 201, 205, roughness=0.32, metallic=0.6),
    "blue": cad.paint(36, 88, 150, roughness=0.5),
}
FLOOR = -420.0
UPPER_ARM, FOREARM = 245.0, 240.0


def base() -> Parts:
    """The plate, the shoulder's tower with its vents, and the connectors behind."""
    low, high = cad.rectangle(176, 164, corner=30, steps=5), cad.rectangle(152, 148, corner=44, steps=5)
    rim = [(cad.inset(high, 9 * (1 - np.cos(t))), -186 + 9 * np.sin(t)) for t in np.linspace(0, np.pi / 2, 4)]
    vents = [cad.raised(cad.rectangle(70, 4), 0.8, axis="-y", at=(-10, -80.6, z)) for z in range(-340, -291, 12)]
    return {
        "cream": [cad.stacked([(low, FLOOR + 30), *rim])],
        "dark": [
            cad.prism(cad.rectangle(196, 184, corner=34), 22, 4, at=(0, 0, FLOOR + 25)),
            *[half for vent in vents for half in both(vent)],
            cad.box((36, 96, 76), corner=6, edge=3, axis="x", at=(-78, 0, -346)),
            *[
                cad.cable(
                    [(-90, y, -356), (-126, y, -362), (-150, y, -392), (-190, 1.2 * y, -412), (-240, 1.5 * y, -414)], 6
                )
                for y in (-24, 24)
            ],
        ],
        "blue": [
            cad.turned([(58, -180), (58, -170)], sides=40),
            cad.box((8, 104, 4), at=(77.4, 0, -262)),
            word("ORCA", Lettering(24, 2.4, 0.96), "x", (77.6, 0, -236)),
        ],
        "metal": [
            cad.box((320, 280, 16), corner=18, edge=3, at=(0, 0, FLOOR + 8)),
            cad.bolts([(x, y, FLOOR + 16) for x in (-138, 138) for y in (-118, 118)], 9, 8, "z"),
            cad.turned([(48, -172), (48, -152)], sides=40),
        ],
    }


def upper_arm() -> Parts:
    """The thick link over the tower, with the drive of the elbow in its far end."""
    side = cad.stadium((0, 0), (UPPER_ARM, 0), 47, sides=48)
    strip = cad.raised(cad.rectangle(150, 30, corner=5), 3.5, 1, axis="-y", at=(122, -47, -120))
    return {
        "cream": [
            cad.prism(side, 66, 8, 3, at=(0, 0, -122)),
            *on_both_sides("ORCA", Lettering(14, 2.4, 0.96), (122, -49, -120)),
        ],
        "dark": [
            *both(strip),
            cad.raised(cad.circle(40, 40), 5, 2, at=(0, 0, -89)),
            cad.raised(cad.circle(32, 36), 8, 3, axis="-z", at=(UPPER_ARM, 0, -155)),
            cad.prism(cad.inset(side, -0.5), 1.6, at=(0, 0, -142)),
        ],
        "metal": [
            cad.turned([(30, -91), (30, -78)], at=(UPPER_ARM, 0, 0), sides=40),
            cad.raised(cad.circle(12, 20), 8, 2, at=(0, 0, -89)),
            cad.bolts(cad.ring_of_points(6, 30, "z", (0, 0, -84)), 3.5, 2.5, "z"),
            cad.bolts([(x, y, -89) for x in (90, 170) for y in (-30, 30)], 3, 2, "z"),
        ],
    }


def forearm() -> Parts:
    """The slimmer link, with the cable to the wrist on its side."""
    side = cad.stadium((0, 0), (FOREARM, 0), 40, 29, sides=44)
    lead = [(20, 38, -52), (60, 41, -50), (120, 37, -50), (180, 34, -50), (216, 26, -48)]
    return {
        "cream": [cad.prism(side, 50, 7, 3, at=(0, 0, -54))],
        "dark": [
            cad.cable(lead, 3.5),
            cad.raised(cad.circle(30, 36), 4, 1.5, at=(0, 0, -29)),
            cad.raised(cad.circle(20, 30), 6, 2, axis="-z", at=(FOREARM, 0, -79)),
            cad.prism(cad.inset(side, -0.5), 1.4, at=(0, 0, -68)),
        ],
        "blue": [cad.raised(cad.rectangle(110, 3), 0.8, at=(120, 0, -29))],
        "metal": [
            cad.turned([(20, -31), (20, -17)], at=(FOREARM, 0, 0), sides=32),
            cad.raised(cad.circle(9, 16), 6, 1.5, at=(0, 0, -29)),
            cad.bolts(cad.ring_of_points(6, 23, "z", (0, 0, -25)), 2.6, 2, "z"),
        ],
    }


def gripper() -> Parts:
    """The wrist's housing, the motor of the gripper and the rods on which its fingers slide."""
    body = cad.hull(cad.circle(26, 36), cad.rectangle(24, 48, corner=6) + np.array([58, 0]))
    return {
        "cream": [cad.prism(body, 40, 5, 2)],
        "dark": [
            cad.raised(cad.circle(19, 32), 4, 1.5, at=(0, 0, 20)),
            cad.box((16, 78, 30), corner=5, edge=2, axis="x", at=(72, 0, 0)),
            cad.box((34, 26, 12), corner=3, edge=2, at=(44, 0, 24)),
        ],
        "blue": [cad.raised(cad.rectangle(24, 3), 0.8, at=(44, 0, 30))],
        "metal": [
            *[cad.cylinder(2.6, 76, axis="y", at=(83, 0, z), sides=12) for z in (-7, 7)],
            *both(cad.box((10, 4, 26), corner=1, at=(82, -37, 0))),
            cad.raised(cad.circle(7, 16), 6, 1.5, at=(0, 0, 20)),
            cad.bolts([(58, y, 20) for y in (-17, 17)], 2.4, 1.6, "z"),
        ],
    }


def finger() -> Parts:
    """The left finger, closed; turned half around x it is the right one. The tool point is 90 mm along it."""
    blade = cad.rounded([(-3, 0.4), (98, 0.4), (98, 3.4), (52, 5), (14, 14), (-3, 14)], 0.8)
    return {
        "metal": [cad.prism(blade, 16)],
        "dark": [
            cad.box((12, 14, 24), corner=2, edge=1, at=(3, 7.6, 0)),
            cad.box((24, 1.4, 17), at=(85, 0.9, 0)),
        ],
    }


DRAWINGS = (base, upper_arm, forearm, gripper, finger)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
