"""The Movemaster RV-M2 drawn in millimetres: `python robots/movemaster/build.py` writes meshes/.

Each part is drawn in the frame of its link, which at q = 0 is parallel to the base and stands on its joint. The arm keeps
within 65 mm of the lines between its joint centres (Cerbaro 2022, section 6.1). Side views are drawn as seen from the
right of the machine, x to the right and z up.
"""

from pathlib import Path

import numpy as np
from helicoide.solids import (
    Axis,
    bolts,
    box,
    cable,
    circle,
    cut,
    cylinder,
    gear,
    glb,
    hull,
    inset,
    letters,
    mirrored,
    paint,
    prism,
    raised,
    rectangle,
    ring_of_points,
    rounded,
    stacked,
    stadium,
    turned,
)
from trimesh import Trimesh

MESHES = Path(__file__).parent / "meshes"
SURFACES = {
    "ivory": paint(236, 225, 196, roughness=0.5),
    "dark": paint(64, 66, 70, roughness=0.55),
    "metal": paint(200, 202, 206, roughness=0.35, metallic=0.6),
    "orange": paint(232, 104, 30, roughness=0.6),
}
UPPER_ARM, FOREARM = 250.0, 200.0
Parts = dict[str, list[Trimesh]]

# Letters on a grid 4 wide and 6 high, drawn with a square pen.
STROKES = {
    "A": [[(0, 0), (2, 6), (4, 0)], [(0.8, 2), (3.2, 2)]],
    "E": [[(4, 0), (0, 0), (0, 6), (4, 6)], [(0, 3), (3.2, 3)]],
    "M": [[(0, 0), (0, 6), (2, 2.4), (4, 6), (4, 0)]],
    "O": [[(2, 0), (0, 0), (0, 6), (2, 6)], [(2, 6), (4, 6), (4, 0), (2, 0)]],
    "R": [[(0, -0.5), (0, 6.5)], [(0, 6), (4, 6), (4, 3), (0, 3)], [(1.8, 3), (3.8, -0.4)]],
    "S": [[(0, 0), (4, 0), (4, 3), (0, 3), (0, 6), (4, 6)]],
    "T": [[(0, 6), (4, 6)], [(2, 6), (2, -0.5)]],
    "V": [[(0, 6.4), (2, 0), (4, 6.4)]],
    "2": [[(0, 6), (4, 6), (4, 3.2), (0, 2.8), (0, 0), (4, 0)]],
    "-": [[(0.6, 3), (3.4, 3)]],
}


def both(solid: Trimesh) -> list[Trimesh]:
    """The part and its mirror image on the other side of the arm."""
    return [solid, mirrored(solid)]


def word(text: str, height: float, depth: float, axis: Axis, at: tuple[float, float, float]) -> Trimesh:
    """Raised lettering centred on `at`."""
    unit = height / 6
    offset = np.array([-(5.6 * len(text) - 1.6) / 2, -3])
    strokes = [(np.array(s) + offset + (5.6 * i, 0)) * unit for i, c in enumerate(text) for s in STROKES[c]]
    return letters(strokes, unit, depth, axis, at)


# --- base: frame on the bench, under the waist ----------------------------------------------------------------------


def base() -> Parts:
    """Plinth, painted housing, bearing collar, name plate in front, side covers, connectors behind."""
    parts = base_housing()
    for surface, solids in [*base_covers().items(), *base_rear().items()]:
        parts.setdefault(surface, []).extend(solids)
    return parts


def base_housing() -> Parts:
    low, high = rectangle(272, 238, corner=30, steps=6), rectangle(252, 222, corner=30, steps=6)
    rim = [(inset(high, 12 * (1 - np.cos(t))), 154 + 12 * np.sin(t)) for t in np.linspace(0, np.pi / 2, 4)]
    seam = inset(low + (high - low) * 0.72, -0.4)
    corners = [(x, y) for x in (-146, 106) for y in (-110, 110)]
    return {
        "ivory": [stacked([(low, 17), *rim], at=(-20, 0, 0))],
        "dark": [
            prism(rectangle(300, 266, corner=24), 13, edge=3, at=(-20, 0, 11.5)),
            prism(seam, 1.6, at=(-20, 0, 117)),
            turned([(119, 164), (119, 172), (116, 175)], sides=40),
            *[cylinder(16, 6, at=(x, y, 3), sides=16) for x, y in corners],
        ],
        "metal": [
            turned([(108, 170), (108, 182)], sides=40),
            bolts([(x, y, 18) for x, y in corners], 8, 7, "z"),
            bolts(ring_of_points(8, 126, "z", (0, 0, 165.5), phase=0.5)[[0, 3, 4, 7]], 3.5, 2.5, "z"),
        ],
    }


def base_covers() -> Parts:
    panel = raised(rectangle(170, 72, corner=8), 4, edge=1.5, axis="-y", at=(-20, -116, 66))
    screws = bolts([(x, -120, z) for x in (-96, 56) for z in (38, 94)], 3.5, 2, "-y")
    slots = [box((46, 3, 3.6), corner=1.7, axis="-y", at=(-62, -119.2, z)) for z in (50, 58, 66, 74, 82)]
    plate = raised(rectangle(150, 26, corner=4), 3, edge=1, axis="x", at=(110, 0, 88))
    return {
        "ivory": [*both(panel), word("MOVEMASTER", 9, 1.6, "x", (113, 0, 90))],
        "dark": [plate, *[half for slot in slots for half in both(slot)]],
        "orange": [box((1.6, 142, 2.4), at=(113, 0, 79.5))],
        "metal": both(screws),
    }


def base_rear() -> Parts:
    sockets = [(-158, y, 96) for y in (-52, 52)]
    nuts = [turned([(17, 0), (17, 5), (14, 6), (14, 14)], axis="-x", at=at, sides=20) for at in sockets]
    plugs = [turned([(12, 10), (12, 30), (7.5, 40)], axis="-x", at=at, sides=16) for at in sockets]
    wires = [
        cable([(-194, y, 96), (-226, y, 87), (-244, y, 58), (-254, y * 1.1, 28), (-280, y * 1.3, 9), (-330, y * 1.6, 6)], 6)
        for y in (-52, 52)
    ]
    return {
        "dark": [
            raised(rectangle(184, 94, corner=8), 9, edge=2, axis="-x", at=(-149, 0, 78)),
            raised(rectangle(44, 18, corner=5), 5, edge=1, axis="-x", at=(-158, 0, 58)),
            *plugs,
            *wires,
        ],
        "orange": [raised(rectangle(13, 9, corner=1.5), 4, edge=1, axis="-x", at=(-158, -60, 52))],
        "metal": [
            *nuts,
            raised(rectangle(60, 30, corner=2), 0.8, axis="-x", at=(-158, 0, 96)),
            bolts([(-158, y, z) for y in (-84, 84) for z in (40, 116)], 3.5, 2, "-x"),
            bolts([(-158, 60, 52)], 6, 6, "-x"),
        ],
    }


# --- waist: frame 400 mm above the bench on the vertical axis, the shoulder 120 mm in front -------------------------


def waist() -> Parts:
    """Turntable, the core between the shoulder's cheeks and the finned motor behind."""
    core = rounded([(-88, -197), (92, -197), (98, -130), (58, -70), (-34, -52), (-102, -112), (-102, -180)], 12)
    fins = [box((26, 76, 5), corner=2, axis="-x", at=(-112, 0, z)) for z in range(-180, -109, 11)]
    return {
        "ivory": [turned([(112, -217), (119, -212), (119, -201), (116, -197), (108, -195)], sides=40), prism(core, 104, axis="-y")],
        "dark": [box((24, 64, 86), corner=6, edge=2, axis="-x", at=(-106, 0, -146)), *fins],
        "metal": [bolts(ring_of_points(12, 110, "z", (0, 0, -196), phase=0.5)[[0, 11, 5, 6]], 3.5, 2.5, "z")],
        "orange": [],
    }


def shoulder() -> Parts:
    """Two cheeks that carry the upper arm, their belt covers and the bearing covers of the shoulder."""
    foot = rounded([(-80, -198), (84, -198), (104, -150), (-40, -44), (-100, -104), (-100, -166)], 18)
    cheek = hull(circle(70, 36, (120, 0)), foot)
    belt = stadium((120, 0), (-46, -112), 58, 32, sides=28)
    screws = [(-68, -93, -114), (-34, -93, -136), (-46, -93, -88), (70, -93, -62), (56, -93, 4)]
    return {
        "ivory": [
            *both(prism(cheek, 34, edge=8, steps=3, axis="-y", at=(0, -69, 0))),
            *both(raised(belt, 7, edge=3, steps=2, axis="-y", at=(0, -86, 0))),
        ],
        "dark": both(raised(circle(50), 6, edge=2, axis="-y", at=(120, -93, 0))),
        "metal": [
            *both(raised(circle(17, 20), 4, edge=1.5, axis="-y", at=(120, -99, 0))),
            *both(bolts(ring_of_points(8, 40, "-y", (120, -99, 0)), 3.5, 2.5, "-y")),
            *both(bolts(screws, 3.5, 2, "-y")),
            cylinder(26, 112, axis="y", at=(120, 0, 0), sides=24),
        ],
    }


# --- arm: frames on the shoulder, the elbow and the wrist -----------------------------------------------------------


def upper_arm() -> Parts:
    """A tapered box that forks around the elbow; name strips on its sides, bearing covers at its end."""
    side = stadium((0, 0), (UPPER_ARM, 0), 50, 45)
    slot = prism(rounded([(168, -80), (202, 0), (202, 80), (330, 80), (330, -80)], 5), 64, axis="-y")
    elbow = (UPPER_ARM, -46, 0)
    strip = rounded([(78, -27), (206, -24), (206, 24), (78, 27)], 5)
    return {
        "ivory": [
            cut(prism(side, 92, edge=8, steps=3, axis="-y"), slot),
            word("RV-M2", 17, 1.2, "-y", (140, -49.3, 4)),
            word("RV-M2", 17, 1.2, "y", (140, 49.3, 4)),
        ],
        "dark": [
            *both(raised(strip, 3.5, edge=1.2, axis="-y", at=(0, -46, 0))),
            *both(raised(circle(35), 5, edge=2, axis="-y", at=elbow)),
            *[prism(rectangle(92.6, 2 * (50.3 - 0.02 * x), corner=8), 1.4, axis="x", at=(x, 0, 0)) for x in (71,)],
        ],
        "orange": both(raised(rectangle(112, 4), 1, axis="-y", at=(142, -49.3, -14))),
        "metal": [
            *both(raised(circle(11, 16), 2.5, edge=1, axis="-y", at=(UPPER_ARM, -51, 0))),
            *both(bolts(ring_of_points(6, 27, "-y", (UPPER_ARM, -51, 0)), 3, 2, "-y")),
            bolts([(x, y, 49.5 - 0.02 * x) for x in (82, 148) for y in (-28, 28)], 3, 2, "z"),
            cylinder(24, 66, axis="y", at=(UPPER_ARM, 0, 0), sides=20),
        ],
    }


def forearm() -> Parts:
    """A tongue in the elbow, the belt housing behind it, and the fork of the wrist."""
    tongue = stadium((0, 0), (110, 0), 41, 35)
    side = hull(rounded([(84, -36), (58, 38), (100, 38), (120, -36)], 5), circle(29, 28, (FOREARM, 0)))
    slot = box((120, 50, 80), at=(FOREARM + 18, 0, 0))
    belt = stadium((100, 0), (FOREARM, 0), 24, 21, sides=24)
    return {
        "ivory": [prism(tongue, 58, edge=4, steps=2, axis="-y"), cut(prism(side, 80, edge=6, steps=3, axis="-y"), slot)],
        "dark": [
            *both(raised(belt, 5, edge=1.5, axis="-y", at=(0, -40, 0))),
            cable([(42, 16, 35), (58, 16, 41.5), (100, 16, 40.3), (138, 16, 36.5), (152, 16, 27)], 3.5, sides=7),
        ],
        "orange": both(raised(rectangle(52, 3), 0.8, axis="-y", at=(142, -45, 0))),
        "metal": [
            *both(raised(circle(12, 16), 3, edge=1, axis="-y", at=(FOREARM, -45, 0))),
            *both(bolts([(x, -45, z) for x in (92, 172) for z in (-13, 13)], 2.6, 1.8, "-y")),
            *[box((5, 14, 12), corner=1, edge=1, at=(x, 16, 38.5 - (x - 90) * 0.07)) for x in (90, 128)],
        ],
    }


def wrist() -> Parts:
    """The differential: two bevel wheels on the pitch axis drive a third on the roll axis."""
    wheel, small = gear(25, 18, 3.2), gear(24, 18, 3.2)
    return {
        "metal": [
            *both(stacked([(wheel * 0.72, 11), (wheel, 20)], axis="-y")),
            stacked([(small * 0.72, 22), (small, 31)], axis="x"),
            cylinder(9, 49, axis="y", sides=16),
            cylinder(24, 10, axis="x", at=(34, 0, 0), sides=24),
        ],
        "dark": [
            prism(stadium((0, 0), (38, 0), 15, 13, sides=20), 20, edge=2, axis="-y"),
            cylinder(31, 16, edge=2.5, steps=2, axis="x", at=(46, 0, 0)),
        ],
    }


# --- gripper: printed, frame on the wrist, tool point 250 mm in front ------------------------------------------------


def gripper() -> Parts:
    """Flange, printed body with its servo, and the two rods on which the fingers slide."""
    taper = [(circle(28, 20), 61), (circle(28, 20), 66), (rectangle(58, 48, corner=8), 82), (rectangle(58, 48, corner=8), 138)]
    return {
        "metal": [
            cylinder(29, 6, edge=1, axis="x", at=(57.5, 0, 0)),
            bolts(ring_of_points(4, 24, "x", (61, 0, 0), phase=0.5), 2.6, 4, "x"),
            *[cylinder(3.5, 112, axis="y", at=(160, 0, z), sides=12) for z in (-8, 8)],
            *both(bolts([(160, -60, z) for z in (-8, 8)], 3, 2, "-y")),
        ],
        "dark": [
            stacked(taper, axis="x"),
            box((12, 120, 34), corner=4, edge=1.5, axis="x", at=(144, 0, 0)),
            *both(box((30, 7, 30), corner=3, edge=1, axis="-y", at=(159, -56.5, 0))),
            *servo(),
        ],
    }


def servo() -> list[Trimesh]:
    return [
        box((40, 20, 18), corner=1.5, edge=1, at=(112, 0, 32)),
        box((54, 18, 3), corner=1.5, at=(112, 0, 34)),
        cable([(92, 0, 32), (84, 0, 36), (74, 6, 34), (66, 10, 27)], 2, sides=6, samples=10),
    ]


def finger() -> Parts:
    """The left finger, closed, on its rods; turned half around x it is the right one."""
    side = rounded([(-9, 0.3), (12, 0.3), (14, 6), (62, 6), (66, 3), (98, 3), (98, 9), (60, 18), (12, 23), (-9, 23)], 1)
    window = prism(rounded([(22, 10), (54, 9.5), (56, 13), (22, 18)], 1.4), 40)
    ribs = [box((3.6, 2.2, 18), edge=0.4, at=(x, 1.4, 0)) for x in (70, 76, 82, 88, 94)]
    return {
        "orange": [cut(prism(side, 22, edge=1), window), box((20, 22, 29), corner=2, edge=1, at=(1.5, 11.5, 0))],
        "dark": [box((31, 1.6, 19), at=(82, 2.4, 0)), *ribs],
    }


DRAWINGS = (base, waist, shoulder, upper_arm, forearm, wrist, gripper, finger)


def main() -> None:
    """Write one GLB for each drawing."""
    MESHES.mkdir(exist_ok=True)
    for drawing in DRAWINGS:
        parts = {surface: (SURFACES[surface], solids) for surface, solids in drawing().items() if solids}
        (MESHES / f"{drawing.__name__}.glb").write_bytes(glb(parts, unit=0.001))


if __name__ == "__main__":
    main()
