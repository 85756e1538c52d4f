"""The PUMA 560 drawn in millimetres: `python robots/puma560/build.py` writes meshes/.

Each part is drawn in the frame of its link, which at q = 0 is parallel to the base and stands on its joint: the upper
arm points along x, the forearm hangs along -z. As on the machine the upper arm runs outside (y) of the forearm, in
whose plane the source puts joints 2 to 6. Side views are drawn as seen from the arm's outer side (axis y), so that u
is -x, unless they say otherwise.
"""

import numpy as np
from trimesh import Trimesh

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, painted, write_meshes
from helicoide.solids.lettering import Lettering, word

SURFACES = {
    "white": cad.paint(188, 189, 185, roughness=0.5),
    "grey": cad.paint(104, 108, 114, roughness=0.5),
    "black": cad.paint(44, 46, 50, roughness=0.55),
    "blue": cad.paint(24, 62, 138, roughness=0.5),
    "metal": cad.paint(196, 199, 204, roughness=0.35, metallic=0.6),
}
UPPER_ARM, JOG = 431.8, 20.3
FLOOR = -672.0
SIDE = 93.4  # the middle of the upper arm lies so far outside of the forearm's
PEN = 1.15  # width of the lines of the lettering


# --- trunk: frame at the shoulder, on the axis of the waist ----------------------------------------------------------


def base() -> Parts:
    """The bolted foot, the flare into the column, the waist motor behind, the connector box."""
    foot, flare = cad.rectangle(300, 300, corner=24, steps=5), cad.rectangle(226, 226, corner=60, steps=5)
    neck = cad.rectangle(172, 172, corner=85.9, steps=5)
    corners = [(x, y, FLOOR + 26) for x in (-126, 126) for y in (-126, 126)]
    blend = [(neck + (flare - neck) * (1 - s) ** 2, FLOOR + 26 + 150 * s) for s in np.linspace(0, 1, 6)]
    return {
        "white": [
            cad.prism(foot, 26, edge=4, at=(0, 0, FLOOR + 13)),
            cad.stacked(blend),
            cad.turned([(86, FLOOR + 170), (82, FLOOR + 196), (78, -176)], sides=48),
        ],
        "grey": [
            cad.turned([(79.5, -180), (84, -174), (84, -156), (79, -150)], sides=48),
            cad.box((96, 130, 150), corner=12, edge=6, steps=2, axis="-x", at=(-118, 0, FLOOR + 120)),
        ],
        "black": [
            *base_motor(),
            *base_plugs(),
            cad.prism(cad.rectangle(40, 190, corner=6), 16, edge=1.5, axis="x", at=(76, 0, -340)),
        ],
        "metal": [
            cad.bolts(corners, 9, 8, "z"),
            word("PUMA 560", Lettering(21, 0.8, PEN), "x", (84, 0, -340), upright=False),
            cad.bolts(cad.ring_of_points(12, 81.5, "z", (0, 0, -174)), 2.6, 4, "z"),
        ],
    }


def base_motor() -> list[Trimesh]:
    """The motor of the waist, upright on the connector box, close to the column."""
    return [
        cad.cylinder(40, 130, edge=5, at=(-118, 0, FLOOR + 260)),
        cad.box((60, 50, 50), corner=6, at=(-84, 0, FLOOR + 225)),
        cad.turned([(34, FLOOR + 325), (34, FLOOR + 345), (28, FLOOR + 350)], at=(-118, 0, 0)),
    ]


def base_plugs() -> list[Trimesh]:
    """The two plugs on the connector box and their cables to the controller."""
    sides = (-32, 32)
    plugs = [cad.turned([(22, 0), (22, 8), (17, 10), (17, 34)], axis="-x", at=(-165, y, FLOOR + 120)) for y in sides]
    run = [(-190, 1, 120), (-226, 1, 116), (-252, 1, 76), (-262, 1.2, 30), (-292, 1.5, 10), (-350, 2, 8)]
    return [*plugs, *[cad.cable([(x, y * s, FLOOR + z) for x, s, z in run], 8) for y in sides]]


def shoulder() -> Parts:
    """What turns on the column: a neck, and across it the drum that carries the upper arm."""
    drum = [(74, -118), (88, -112), (95, -98), (96, -80), (96, 88), (92, 94), (80, 97)]
    return {
        "white": [
            cad.turned([(77, -150), (78, -142), (78, 0)], sides=48),
            cad.turned(drum, axis="y", sides=48),
        ],
        "grey": [cad.turned([(82, 94), (82, 126)], axis="y", sides=48)],
        "black": [
            cad.turned([(78.6, -140), (78.6, -134)], sides=48),
            cad.turned([(58, 116), (58, 121), (55, 124)], axis="-y"),
        ],
        "blue": [word("UNIMATION", Lettering(12, 0.8, PEN), "x", (95.4, 0, 0))],
        "metal": [
            cad.bolts(cad.ring_of_points(8, 67, "-y", (0, -116, 0), phase=0.5), 3.5, 5, "-y"),
            cad.bolts(cad.ring_of_points(6, 46, "-y", (0, -124, 0)), 3, 2.5, "-y"),
        ],
    }


# --- arm: frames at the shoulder and the elbow, both in the plane of the forearm --------------------------------------


def upper_arm() -> Parts:
    """A long tapered box outside of the forearm, its motors behind the shoulder, an inner hub at each end."""
    tail = [(158, 62), (158, -62), (120, -92), (120, 92)]
    side = cad.hull(cad.circle(100, 48), tail, cad.circle(66, 40, (-UPPER_ARM, 0)))
    outside = SIDE + 46
    lid = cad.inset(side, 20)
    screws = [(x, outside + 5, z) for x, z in ((-132, 44), (-132, -44), (0, 74), (0, -74), (200, 59), (200, -59))]
    return {
        "white": [
            cad.prism(side, 92, edge=12, steps=3, axis="y", at=(0, SIDE, 0)),
            cad.raised(lid, 5, edge=2, axis="y", at=(0, outside, 0)),
            cad.turned([(90, 4), (93, 8), (93, 50)], axis="y", sides=48),
        ],
        "grey": [cad.turned([(58, 38), (58, 52)], axis="y", at=(UPPER_ARM, 0, 0), sides=40)],
        "black": [
            cad.turned([(84, 1), (84, 6)], axis="y", sides=48),
            cad.raised(cad.circle(34), 3, edge=1.5, axis="y", at=(UPPER_ARM, outside + 5, 0)),
            *[cad.cylinder(33, 22, edge=4, axis="-x", at=(-165, SIDE, z)) for z in (-34, 34)],
        ],
        "blue": [
            cad.raised(cad.rectangle(236, 5), 0.8, axis="y", at=(188, outside + 5, -26)),
            word("UNIMATION", Lettering(30, 0.8, PEN), "y", (188, outside + 5, 6)),
        ],
        "metal": [
            cad.bolts(screws, 4, 2.5, "y"),
            cad.bolts(cad.ring_of_points(6, 25, "y", (UPPER_ARM, outside + 8, 0)), 3, 2, "y"),
        ],
    }


def forearm() -> Parts:
    """A box that tapers down to the wrist; the motors of the wrist stand out above the elbow."""
    side = cad.hull(
        cad.circle(64, 40),
        [(58, 112), (-58, 112)],
        cad.circle(42, 32, (-JOG, -298)),
        [(-JOG - 40, -336), (-JOG + 40, -336)],
    )
    motors = [(x, y, 108) for x, y in ((-30, -2), (30, -18), (30, 18))]
    return {
        "white": [
            cad.prism(side, 82, edge=10, steps=3, axis="y"),
            cad.turned([(41, -330), (40, -340), (36, -345)], at=(JOG, 0, 0), sides=40),
        ],
        "grey": [cad.turned([(50, 36), (50, 46)], axis="y", sides=40)],
        "black": [cad.turned([(19, 0), (19, 26), (15, 30)], at=at, sides=24) for at in motors],
        "blue": [word("PUMA", Lettering(22, 0.8, PEN), "-y", (8, -41, -120), upright=False)],
        "metal": [
            cad.turned([(34, -344), (34, -352)], at=(JOG, 0, 0), sides=40),
            cad.raised(cad.circle(30), 4, edge=1.5, axis="-y", at=(0, -41, 0)),
            cad.bolts(cad.ring_of_points(6, 22, "-y", (0, -45, 0)), 2.8, 2, "-y"),
        ],
    }


# --- wrist: three frames where its axes meet; at q = 0 the flange looks down ------------------------------------------


def wrist() -> Parts:
    """The roll housing and its fork around the axis of the bend."""
    cheek = cad.hull(cad.circle(30, 32), [(-30, 56), (30, 56)])
    return {
        "white": [
            cad.turned([(36, 82), (38, 78), (38, 50), (34, 45)], sides=40),
            *[cad.prism(cheek, 11, edge=2.5, steps=2, axis="y", at=(0, y, 0)) for y in (-33, 33)],
        ],
        "black": [
            cad.turned([(38.5, 66), (38.5, 69)], sides=40),
            cad.raised(cad.circle(20), 3, edge=1, axis="y", at=(0, 38.5, 0)),
            cad.raised(cad.circle(20), 3, edge=1, axis="-y", at=(0, -38.5, 0)),
        ],
        "metal": [cad.cylinder(9, 84, axis="y", sides=20)],
    }


def hand() -> Parts:
    """The body between the cheeks, bent by joint 5."""
    return {
        "grey": [cad.cylinder(25, 53, edge=3, axis="y"), cad.cylinder(23, 40, at=(0, 0, -22))],
        "metal": [cad.turned([(26, -43), (26, -37)])],
    }


def flange() -> Parts:
    """The mounting flange and a pointed tool; the box on its side shows how far it has turned."""
    return {
        "metal": [
            cad.turned([(31, -56), (32, -55), (32, -44), (31, -43)], sides=40),
            cad.turned([(1.5, -170), (6, -152), (6, -126)], sides=24),
            cad.bolts(cad.ring_of_points(4, 25, "-z", (0, 0, -56), phase=0.5), 3, 3, "-z"),
        ],
        "black": [cad.turned([(9, -132), (17, -120), (19, -116), (19, -62), (22, -56)], sides=32)],
        "blue": [cad.box((16, 22, 44), corner=3, edge=2, at=(25, 0, -88))],
    }


DRAWINGS = (base, shoulder, upper_arm, forearm, wrist, hand, flange)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
