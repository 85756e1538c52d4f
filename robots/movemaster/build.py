"""The Movemaster RV-M2 drawn in millimetres: `python robots/movemaster/build.py` writes meshes/.

Each part is drawn in the frame of its link, which at q = 0 is parallel to the base and stands on its joint. The arm
keeps within 65 mm of the lines between its joint centres (Cerbaro 2022, section 6.1). Side views are drawn as seen from
the right of the machine, x to the right and z up.
"""

import numpy as np
from trimesh import Trimesh

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, both, merged, painted, write_meshes
from helicoide.solids.lettering import Lettering, on_both_sides, word

SURFACES = {
    "ivory": cad.paint(236, 225, 196, roughness=0.5),
    "dark": cad.paint(64, 66, 70, roughness=0.55),
    "metal": cad.paint(200, 202, 206, roughness=0.35, metallic=0.6),
    "orange": cad.paint(232, 104, 30, roughness=0.6),
}
UPPER_ARM, FOREARM = 250.0, 200.0


# --- base: frame on the bench, under the waist ----------------------------------------------------------------------


def base() -> Parts:
    """Plinth, painted housing, bearing collar, name plate in front, side covers, connectors behind."""
    return merged(SURFACES, base_housing(), base_covers(), base_rear())


def base_housing() -> Parts:
    """The plinth on its feet, the tapered painted housing and the bearing on top."""
    low, high = cad.rectangle(280, 254, corner=32, steps=5), cad.rectangle(262, 240, corner=32, steps=5)
    rim = [(cad.inset(high, 12 * (1 - np.cos(t))), 154 + 12 * np.sin(t)) for t in np.linspace(0, np.pi / 2, 4)]
    seam = cad.inset(low + (high - low) * 0.72, -0.4)
    corners = [(x, y) for x in (-152, 120) for y in (-124, 124)]
    return {
        "ivory": [cad.stacked([(low, 17), *rim], at=(-16, 0, 0))],
        "dark": [
            cad.prism(cad.rectangle(308, 284, corner=26), 13, edge=3, at=(-16, 0, 11.5)),
            cad.prism(seam, 1.6, at=(-16, 0, 117)),
            cad.turned([(111, 164), (111, 172), (108, 175)], sides=40),
            *[cad.cylinder(16, 6, at=(x, y, 3), sides=16) for x, y in corners],
        ],
        "metal": [
            cad.turned([(102, 170), (102, 184)], sides=40),
            cad.bolts([(x, y, 18) for x, y in corners], 8, 7, "z"),
            cad.bolts([(x, y, 165.5) for x in (-128, 96) for y in (-97, 97)], 3.5, 2.5, "z"),
        ],
    }


def base_covers() -> Parts:
    """The side covers with their cooling slots and the name plate in front."""
    panel = cad.raised(cad.rectangle(170, 72, corner=8), 4, edge=1.5, axis="-y", at=(-16, -124, 66))
    screws = cad.bolts([(x, -128, z) for x in (-92, 60) for z in (38, 94)], 3.5, 2, "-y")
    slots = [cad.raised(cad.rectangle(46, 3.6), 0.5, axis="-y", at=(-58, -127.9, z)) for z in (50, 58, 66, 74, 82)]
    plate = cad.raised(cad.rectangle(160, 28, corner=4), 6, edge=1, axis="x", at=(117.5, 0, 88))
    return {
        "ivory": [*both(panel), word("MOVEMASTER", Lettering(9.5, 1), "x", (123.3, 0, 90.5))],
        "dark": [plate, *[half for slot in slots for half in both(slot)]],
        "orange": [cad.raised(cad.rectangle(148, 2.6), 0.8, axis="x", at=(123.3, 0, 79.5))],
        "metal": both(screws),
    }


def base_rear() -> Parts:
    """The connector panel, rating plate, switch and the two cables to the controller."""
    sockets = [(-158, y, 96) for y in (-52, 52)]
    nuts = [cad.turned([(17, 0), (17, 5), (14, 6), (14, 14)], axis="-x", at=at, sides=20) for at in sockets]
    plugs = [cad.turned([(12, 10), (12, 30), (7.5, 40)], axis="-x", at=at, sides=16) for at in sockets]
    curve = [(-194, 1, 96), (-226, 1, 87), (-244, 1, 58), (-254, 1, 28), (-280, 1.2, 9), (-330, 1.5, 6)]
    wires = [cad.cable([(x, side * y, z) for x, y, z in curve], 6) for side in (-52, 52)]
    return {
        "dark": [
            cad.raised(cad.rectangle(184, 94, corner=8), 9, edge=2, axis="-x", at=(-149, 0, 78)),
            cad.raised(cad.rectangle(44, 18, corner=5), 5, edge=1, axis="-x", at=(-158, 0, 58)),
            *plugs,
            *wires,
        ],
        "orange": [cad.raised(cad.rectangle(13, 9, corner=1.5), 4, edge=1, axis="-x", at=(-158, -60, 52))],
        "metal": [
            *nuts,
            cad.raised(cad.rectangle(60, 30, corner=2), 0.8, axis="-x", at=(-158, 0, 96)),
            cad.bolts([(-158, y, z) for y in (-84, 84) for z in (40, 116)], 3.5, 2, "-x"),
            cad.bolts([(-158, 60, 52)], 6, 6, "-x"),
        ],
    }


# --- waist: frame 400 mm above the bench on the vertical axis, the shoulder 120 mm in front -------------------------


def waist() -> Parts:
    """Turntable, the core between the shoulder's cheeks and the finned motor behind."""
    core = cad.rounded([(-88, -197), (92, -197), (98, -130), (58, -70), (-34, -52), (-102, -112), (-102, -180)], 12)
    fins = [cad.box((26, 76, 5), corner=2, axis="-x", at=(-112, 0, z)) for z in range(-180, -109, 11)]
    return {
        "ivory": [
            cad.turned([(106, -217), (114, -212), (114, -201), (111, -197), (103, -195)], sides=40),
            cad.prism(core, 104, axis="-y"),
        ],
        "dark": [cad.box((24, 64, 86), corner=6, edge=2, axis="-x", at=(-106, 0, -146)), *fins],
        "metal": [cad.bolts(cad.ring_of_points(12, 104, "z", (0, 0, -196), phase=0.5)[[0, 11, 5, 6]], 3.5, 2.5, "z")],
    }


def shoulder() -> Parts:
    """Two cheeks that carry the upper arm, their belt covers and the bearing covers of the shoulder."""
    foot = cad.rounded([(-66, -198), (66, -198), (104, -150), (-40, -44), (-100, -104), (-100, -166)], 18)
    cheek = cad.hull(cad.circle(70, 36, (120, 0)), foot)
    belt = cad.stadium((120, 0), (-46, -112), 58, 32, sides=28)
    screws = [(-68, -93, -114), (-34, -93, -136), (-46, -93, -88), (70, -93, -62), (56, -93, 4)]
    return {
        "ivory": [
            *both(cad.prism(cheek, 34, edge=8, steps=2, axis="-y", at=(0, -69, 0))),
            *both(cad.raised(belt, 7, edge=3, steps=2, axis="-y", at=(0, -86, 0))),
        ],
        "dark": both(cad.raised(cad.circle(50), 6, edge=2, axis="-y", at=(120, -93, 0))),
        "metal": [
            *both(cad.raised(cad.circle(17, 20), 4, edge=1.5, axis="-y", at=(120, -99, 0))),
            *both(cad.bolts(cad.ring_of_points(8, 40, "-y", (120, -99, 0)), 3.5, 2.5, "-y")),
            *both(cad.bolts(screws, 3.5, 2, "-y")),
            cad.cylinder(26, 112, axis="y", at=(120, 0, 0), sides=24),
        ],
    }


# --- arm: frames on the shoulder, the elbow and the wrist -----------------------------------------------------------


def upper_arm() -> Parts:
    """A tapered box that forks around the elbow; name strips on its sides, bearing covers at its end."""
    side = cad.stadium((0, 0), (UPPER_ARM, 0), 50, 45)
    slot = cad.prism(cad.rounded([(138, -80), (202, 10), (202, 80), (330, 80), (330, -80)], 5), 64, axis="-y")
    elbow = (UPPER_ARM, -46, 0)
    strip = cad.rounded([(78, -27), (206, -24), (206, 24), (78, 27)], 5)
    return {
        "ivory": [
            cad.cut(cad.prism(side, 92, edge=8, steps=2, axis="-y"), slot),
            *on_both_sides("RV-M2", Lettering(16, 1.2), (140, -49.3, 4)),
        ],
        "dark": [
            *both(cad.raised(strip, 3.5, edge=1.2, axis="-y", at=(0, -46, 0))),
            *both(cad.raised(cad.circle(35), 5, edge=2, axis="-y", at=elbow)),
            *[
                cad.prism(cad.rectangle(92.6, 2 * (50.3 - 0.02 * x), corner=8), 1.4, axis="x", at=(x, 0, 0))
                for x in (71,)
            ],
        ],
        "orange": both(cad.raised(cad.rectangle(112, 4), 1, axis="-y", at=(142, -49.3, -14))),
        "metal": [
            *both(cad.raised(cad.circle(11, 16), 2.5, edge=1, axis="-y", at=(UPPER_ARM, -51, 0))),
            *both(cad.bolts(cad.ring_of_points(6, 27, "-y", (UPPER_ARM, -51, 0)), 3, 2, "-y")),
            cad.bolts([(x, y, 49.5 - 0.02 * x) for x in (82, 148) for y in (-28, 28)], 3, 2, "z"),
            cad.cylinder(24, 66, axis="y", at=(UPPER_ARM, 0, 0), sides=20),
        ],
    }


def forearm() -> Parts:
    """A tongue in the elbow, the belt housing behind it, and the fork of the wrist."""
    tongue = cad.stadium((0, 0), (110, 0), 41, 35)
    side = cad.hull(cad.rounded([(84, -36), (58, 38), (100, 38), (120, -36)], 5), cad.circle(29, 28, (FOREARM, 0)))
    slot = cad.box((120, 50, 80), at=(FOREARM + 18, 0, 0))
    belt = cad.stadium((100, 0), (FOREARM, 0), 24, 21, sides=24)
    return {
        "ivory": [
            cad.prism(tongue, 58, edge=4, steps=2, axis="-y"),
            cad.cut(cad.prism(side, 80, edge=6, steps=2, axis="-y"), slot),
        ],
        "dark": [
            *both(cad.raised(belt, 5, edge=1.5, axis="-y", at=(0, -40, 0))),
            cad.cable([(50, 16, 37.5), (60, 16, 40), (100, 16, 39), (132, 16, 37), (148, 16, 32)], 2.8, sides=7),
            *[cad.box((10, 11, 10), corner=2, edge=2, axis="x", at=(x, 16, z)) for x, z in ((48, 37), (148, 33))],
        ],
        "orange": both(cad.raised(cad.rectangle(52, 3), 0.8, axis="-y", at=(142, -45, 0))),
        "metal": [
            *both(cad.raised(cad.circle(12, 16), 3, edge=1, axis="-y", at=(FOREARM, -45, 0))),
            *both(cad.bolts([(x, -45, z) for x in (92, 172) for z in (-13, 13)], 2.6, 1.8, "-y")),
            cad.box((5, 11, 8), corner=1, edge=1, at=(102, 16, 39)),
        ],
    }


def wrist() -> Parts:
    """The differential: two bevel wheels on the pitch axis drive a third on the roll axis."""
    wheel, small = cad.gear(25, 16, 3.4), cad.gear(24, 16, 3.4)
    return {
        "metal": [
            *both(cad.stacked([(wheel * 0.72, 11), (wheel, 20)], axis="-y")),
            cad.stacked([(small * 0.72, 22), (small, 31)], axis="x"),
            cad.cylinder(9, 49, axis="y", sides=16),
            cad.cylinder(22, 10, axis="x", at=(35, 0, 0), sides=24),
        ],
        "dark": [
            cad.prism(cad.stadium((0, 0), (38, 0), 15, 13, sides=20), 20, edge=2, axis="-y"),
            cad.cylinder(31, 16, edge=2.5, steps=2, axis="x", at=(46, 0, 0)),
        ],
    }


# --- gripper: printed, frame on the wrist, tool point 250 mm in front ------------------------------------------------


def gripper() -> Parts:
    """Flange, printed body with its servo, and the two rods on which the fingers slide."""
    body = cad.box((54, 58, 48), corner=8, axis="x", at=(111, 0, 0))
    return {
        "metal": [
            cad.cylinder(29, 6, edge=1, axis="x", at=(57.5, 0, 0)),
            cad.bolts(cad.ring_of_points(4, 24, "x", (61, 0, 0), phase=0.5), 2.6, 4, "x"),
            *[cad.cylinder(3.5, 112, axis="y", at=(160, 0, z), sides=12) for z in (-8, 8)],
            *both(cad.bolts([(160, -60, z) for z in (-8, 8)], 3, 2, "-y")),
            *both(cad.bolts([(x, -29, z) for x in (94, 128) for z in (-14, 14)], 2.6, 1.6, "-y")),
            cad.bolts([(x, 0, 35.5) for x in (88.5, 135.5)], 2.2, 1.4, "z"),
        ],
        "orange": [cad.raised(cad.rectangle(26, 12, corner=1), 0.5, at=(113, 0, 41))],
        "dark": [
            cad.wrapped(cad.cylinder(28, 5, axis="x", at=(63.5, 0, 0), sides=24), body),
            cad.box((12, 120, 34), corner=4, edge=1.5, axis="x", at=(144, 0, 0)),
            *both(cad.box((30, 7, 30), corner=3, edge=1, axis="-y", at=(159, -56.5, 0))),
            *servo(),
        ],
    }


def servo() -> list[Trimesh]:
    """The hobby servo on the printed body, with its cable."""
    return [
        cad.box((40, 20, 18), corner=1.5, edge=1, at=(112, 0, 32)),
        cad.box((54, 18, 3), corner=1.5, at=(112, 0, 34)),
        cad.cable([(92, 0, 32), (84, 0, 36), (74, 6, 34), (66, 10, 27)], 2, sides=6, samples=10),
    ]


def finger() -> Parts:
    """The left finger, closed, on its rods; turned half around x it is the right one."""
    side = cad.rounded(
        [(-9, 0.3), (12, 0.3), (14, 6), (62, 6), (66, 3), (98, 3), (98, 9), (60, 18), (12, 23), (-9, 23)], 1
    )
    window = cad.prism(cad.rounded([(22, 10), (54, 9.5), (56, 13), (22, 18)], 1.4), 40)
    ribs = [cad.box((3.6, 2.2, 18), edge=0.4, at=(x, 1.4, 0)) for x in (70, 76, 82, 88, 94)]
    return {
        "orange": [
            cad.cut(cad.prism(side, 22, edge=1), window),
            cad.box((20, 22, 29), corner=2, edge=1, at=(1.5, 11.5, 0)),
        ],
        "dark": [cad.box((31, 1.6, 19), at=(82, 2.4, 0)), *ribs],
    }


DRAWINGS = (base, waist, shoulder, upper_arm, forearm, wrist, gripper, finger)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
