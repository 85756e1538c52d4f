"""The Zebra-ZERO drawn in millimetres: `python robots/zebra_zero/build.py` writes meshes/.

Each part is drawn in the frame of its link, which at q = 0 is parallel to the base and stands on its joint: the upper
arm points along x, the forearm stands upright. The forearm and the hand are narrow enough to pass between the two
plates of the upper arm. Side views are drawn as seen from the right (axis -y), x to the right and z up.
"""

import numpy as np
from trimesh import Trimesh

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, both, painted, write_meshes
from helicoide.solids.lettering import Lettering, on_both_sides, word

SURFACES = {
    "black": cad.paint(50, 52, 56, roughness=0.55),
    "grey": cad.paint(112, 116, 122, roughness=0.5),
    "white": cad.paint(226, 226, 222, roughness=0.6),
    "red": cad.paint(190, 36, 30, roughness=0.55),
    "metal": cad.paint(198, 201, 206, roughness=0.35, metallic=0.6),
}
UPPER_ARM, TOOL = 279.4, 165.0
FLOOR = -280.0
PEN = 1.15  # width of the lines of the lettering


def stripes(count: int, height: float, axis: cad.Axis, at: tuple[float, float, float]) -> list[Trimesh]:
    """A band of slanted stripes centred on `at`, like the animal's."""
    slant = np.array([(-4, -0.5), (3, -0.5), (6, 0.5), (-1, 0.5)]) * [1, height]
    places = 14 * (np.arange(count) - (count - 1) / 2)
    return [cad.raised(slant + np.array([u, 0]), 0.8, axis=axis, at=at) for u in places]


# --- base and turret: frames where the axes of waist and shoulder meet ------------------------------------------------


def base() -> Parts:
    """A box on four feet, its name and stripes in front, plugs behind, the bearing of the waist on top."""
    feet = [(x, y, FLOOR + 4) for x in (-84, 84) for y in (-84, 84)]
    plugs = [cad.turned([(13, 0), (13, 5), (10, 6), (10, 24)], axis="-x", at=(-108, y, FLOOR + 50)) for y in (-40, 0)]
    run = [(-128, -40, 50), (-150, -41, 46), (-166, -44, 22), (-190, -50, 7), (-250, -60, 5)]
    return {
        "black": [
            cad.prism(cad.rectangle(212, 208, corner=14), 92, edge=6, steps=2, at=(0, 0, FLOOR + 53)),
            *[cad.cylinder(12, 8, at=foot, sides=20) for foot in feet],
            *plugs,
            cad.cable([(x, y, FLOOR + z) for x, y, z in run], 5),
        ],
        "grey": [
            cad.prism(cad.rectangle(180, 176, corner=10), 4, edge=1.5, at=(0, 0, FLOOR + 100)),
            cad.raised(cad.rectangle(150, 60, corner=5), 2, edge=1, axis="-x", at=(-106, 0, FLOOR + 52)),
        ],
        "white": [
            *stripes(11, 10, "x", (106, 0, FLOOR + 34)),
            word("ZEBRA-ZERO", Lettering(16, 0.6, PEN), "x", (106, 0, FLOOR + 62)),
        ],
        "red": [cad.turned([(9, 0), (9, 7), (7, 9)], axis="-x", at=(-108, 50, FLOOR + 50), sides=20)],
        "metal": [
            cad.turned([(72, FLOOR + 102), (72, FLOOR + 112), (68, FLOOR + 114)], sides=48),
            cad.bolts(cad.ring_of_points(4, 112, "z", (0, 0, FLOOR + 102), phase=0.5), 3.5, 2.5, "z"),
        ],
    }


def turret() -> Parts:
    """What turns on the base: a box with the motor of the waist, and two cheeks that hold the shoulder."""
    cheek = cad.hull(cad.circle(46, 40), [(-52, -112), (52, -112)])
    hub: tuple[float, float, float] = (0, -54, 0)
    return {
        "black": [
            cad.turned([(66, -168), (66, -158)], sides=48),
            cad.box((104, 108, 50), corner=6, edge=3, axis="z", at=(0, 0, -134)),
            *both(cad.prism(cheek, 12, edge=2.5, axis="-y", at=(0, -48, 0))),
        ],
        "grey": [
            *both(cad.raised(cad.circle(32), 4, edge=1.5, axis="-y", at=hub)),
            cad.box((30, 62, 40), corner=5, edge=3, axis="-x", at=(-64, 0, -134)),
        ],
        "white": stripes(5, 12, "x", (52, 0, -136)),
        "metal": [
            *both(cad.bolts(cad.ring_of_points(6, 24, "-y", (0, -58, 0)), 2.8, 2, "-y")),
            *both(cad.bolts([(x, -54, -96) for x in (-38, 38)], 3, 2, "-y")),
            cad.cylinder(15, 98, axis="y", sides=24),
        ],
    }


# --- arm: frames on the shoulder and the elbow ------------------------------------------------------------------------


def upper_arm() -> Parts:
    """Two plates with the drive between them at the shoulder, open around the elbow; the motors hang out behind."""
    plate = cad.stadium((0, 0), (UPPER_ARM, 0), 40, 31, sides=40)
    window = cad.prism(cad.stadium((170, 0), (214, 0), 15, 14), 40, axis="-y", at=(0, -36, 0))
    elbow = (UPPER_ARM, -39.5, 0)
    return {
        "grey": both(cad.cut(cad.prism(plate, 7, edge=1.5, axis="-y", at=(0, -36, 0)), window)),
        "black": [
            cad.box((176, 66, 56), corner=6, edge=4, axis="x", at=(62, 0, 0)),
            cad.cylinder(36, 66, axis="y"),
            *[cad.cylinder(15, 52, edge=3, axis="x", at=(-50, y, 0), sides=28) for y in (-16, 16)],
            *both(cad.raised(cad.circle(23), 4, edge=1.5, axis="-y", at=elbow)),
        ],
        "white": [
            *on_both_sides("ZEBRA", Lettering(16, 0.6, PEN), (92, -39.5, 0)),
            *stripes(6, 40, "z", (86, 0, 28)),
        ],
        "metal": [
            cad.cylinder(10, 86, axis="y", at=(UPPER_ARM, 0, 0), sides=24),
            *both(cad.bolts(cad.ring_of_points(6, 17, "-y", (UPPER_ARM, -43.5, 0)), 2.2, 1.8, "-y")),
            *both(cad.bolts([(x, -39.5, z) for x in (48, 142) for z in (-22, 22)], 2.6, 1.8, "-y")),
        ],
    }


def forearm() -> Parts:
    """A slim box from the elbow to the roll of the wrist, its motors behind the elbow."""
    side = cad.hull(cad.circle(29, 32), cad.rounded([(-25, 40), (25, 40), (22, 152), (-22, 152)], 3))
    return {
        "black": [
            cad.prism(side, 54, edge=4, steps=2, axis="-y"),
            cad.box((44, 46, 36), corner=5, edge=3, at=(0, 0, -34)),
            *[cad.cylinder(10, 20, edge=2, at=(x, 0, -60), sides=24) for x in (-11, 11)],
        ],
        "grey": [
            *both(cad.turned([(25, 26), (25, 32)], axis="-y")),
            cad.turned([(23, 150), (25, 154), (25, 160), (23, 163)], sides=36),
            *both(cad.raised(cad.rectangle(28, 78, corner=4), 1.6, edge=0.8, axis="-y", at=(0, -27, 96))),
        ],
        "white": [*stripes(3, 22, "x", (24.2, 0, 66)), *stripes(3, 22, "-x", (-24.2, 0, 66))],
        "metal": both(cad.bolts([(x, -28.6, z) for x in (-10, 10) for z in (62, 130)], 2, 1.4, "-y")),
    }


# --- wrist: three frames where its axes meet --------------------------------------------------------------------------


def wrist() -> Parts:
    """The roll shaft and the long fork around the axis of the bend."""
    cheek = cad.hull(cad.circle(18, 28), [(-17, -56), (17, -56)])
    return {
        "metal": [cad.turned([(19, -67), (19, -52)]), cad.cylinder(6, 56, axis="y", sides=20)],
        "grey": [
            cad.turned([(22, -64), (24, -62), (24, -50), (22, -46)], sides=36),
            *both(cad.prism(cheek, 6, edge=1.5, axis="-y", at=(0, -22, 0))),
        ],
        "black": both(cad.raised(cad.circle(12, 24), 2.5, edge=1, axis="-y", at=(0, -25, 0))),
    }


def hand() -> Parts:
    """The body between the cheeks, bent by joint 5."""
    return {
        "black": [cad.prism(cad.stadium((0, 0), (0, 52), 16, 14), 36, edge=3, axis="-y")],
        "metal": [cad.turned([(15, 60), (15, 70)])],
    }


def gripper() -> Parts:
    """The force sensor and a small gripper; the tool frame lies between the finger tips."""
    jaw = [(4, 120), (16, 120), (16, 132), (8, 146), (8, TOOL + 6), (2.5, TOOL + 6), (2.5, 146), (4, 138)]
    jaws = [cad.prism(np.array(jaw), 16, axis="-y"), cad.prism(np.array(jaw)[::-1] * [-1, 1], 16, axis="-y")]
    return {
        "metal": [
            cad.turned([(26, 70), (28, 72), (28, 78)], sides=40),
            cad.turned([(28, 88), (28, 93), (26, 95)], sides=40),
            *jaws,
        ],
        "red": [cad.turned([(27, 78), (27, 88)], sides=40)],
        "black": [
            cad.box((46, 32, 26), corner=4, edge=2.5, axis="z", at=(0, 0, 107)),
            *[cad.box((2, 14, 20), edge=0.5, at=(s * 2.2, 0, TOOL - 6)) for s in (-1, 1)],
            cad.box((8, 8, 8), corner=2, at=(0, 29, 83)),
        ],
    }


DRAWINGS = (base, turret, upper_arm, forearm, wrist, hand, gripper)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
