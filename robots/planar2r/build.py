"""The planar 2R drawn in millimetres: `python robots/planar2r/build.py` writes meshes/.

A demonstration arm of slotted aluminium bars and printed clamps on a wooden plate. Its lengths are parameters: clamps
are drawn as they are; each bar is drawn 1000 mm long, and the URDF stretches it to the length of its link. The second
link lies above the first, in the frame of the source, z = 0, so that the arm folds freely.
"""

import numpy as np
from trimesh import Trimesh

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, painted, write_meshes

SURFACES = {
    "aluminium": cad.paint(206, 209, 212, roughness=0.38, metallic=0.5),
    "teal": cad.paint(0, 128, 122, roughness=0.55),
    "dark": cad.paint(48, 52, 56, roughness=0.55),
    "steel": cad.paint(150, 154, 158, roughness=0.35, metallic=0.6),
    "wood": cad.paint(205, 168, 120, roughness=0.8),
}
FLOOR = -720.0
LOWER, UPPER = -92.0, 0.0  # heights of the middles of the two bars
BARS = (80.0, 60.0)  # their sections
UNIT = 1000.0


def slotted(width: float) -> cad.Array:
    """The section of an aluminium bar: a square with a slot in each side."""
    half, mouth, room = width / 2, 0.07 * width, 0.13 * width
    side = [(half, -half), (half, -mouth), (0.86 * half, -mouth), (0.86 * half, -room), (0.56 * half, -room)]
    side += [(u, -v) for u, v in reversed(side[1:])]
    turns = [np.array([[c, s], [-s, c]]) for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    return np.vstack([np.array(side) @ turn for turn in turns])


def base() -> Parts:
    """A wooden plate with a column of slotted bar, four knees and the shoulder's housing with its motor below."""
    corners = [(x, y, FLOOR + 30) for x in (-250, 250) for y in (-250, 250)]
    knee = cad.prism(cad.rounded([(60, 0), (190, 0), (190, 26), (86, 190), (60, 190)], 6), 40, axis="-y")
    knee.apply_translation((0, 0, FLOOR + 30))
    knees = []
    for _ in range(4):
        knee = knee.copy()
        knee.apply_transform([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        knees.append(knee)
    return {
        "wood": [cad.box((600, 600, 30), corner=24, edge=4, at=(0, 0, FLOOR + 15))],
        "aluminium": [cad.prism(slotted(140), 500, at=(0, 0, FLOOR + 280))],
        "teal": [*knees, cad.prism(cad.rectangle(190, 190, corner=30), 60, 5, 2, at=(0, 0, -205))],
        "dark": [cad.turned([(86, -180), (86, -152), (80, -146)], sides=48)],
        "steel": [
            cad.turned([(64, -150), (64, -132)], sides=48),
            cad.bolts(corners, 14, 10, "z"),
            cad.bolts([(x, y, -175) for x in (-74, 74) for y in (-74, 74)], 8, 6, "z"),
        ],
    }


def clamp(bar: float, middle: float, length: float) -> Trimesh:
    """The printed piece that holds a bar to the joint."""
    outline = cad.hull(cad.circle(0.95 * bar, 48), cad.rectangle(40, 1.5 * bar, corner=10) + np.array([length - 20, 0]))
    return cad.prism(outline, 1.22 * bar, 6, 2, at=(0, 0, middle))


def screws(bar: float, middle: float, length: float) -> Trimesh:
    """The screws that hold the bar in its clamp, on top."""
    rows = [(length - u, v * bar, middle + 0.61 * bar) for u in (24, 64) for v in (-0.42, 0.42)]
    return cad.bolts(rows, 6.5, 5, "z")


def hub(bar: float, middle: float) -> Parts:
    """The clamp at the near end of a link, with the cover of its joint."""
    top = middle + 0.61 * bar
    return {
        "teal": [clamp(bar, middle, 2.3 * bar)],
        "dark": [cad.raised(cad.circle(0.8 * bar, 40), 5, 2, at=(0, 0, top))],
        "steel": [
            screws(bar, middle, 2.3 * bar),
            cad.raised(cad.circle(0.25 * bar, 24), 9, 2, at=(0, 0, top)),
            cad.bolts(cad.ring_of_points(6, 0.58 * bar, "z", (0, 0, top + 5)), 5, 3, "z"),
        ],
    }


def shoulder() -> Parts:
    """The clamp of the first link; it ends below the second."""
    return hub(BARS[0], LOWER)


def elbow_seat() -> Parts:
    """The clamp at the far end of the first link: the motor below, the bearing of the second link above."""
    bar = BARS[0]
    holder = clamp(bar, LOWER, 2.1 * bar)
    holder.apply_transform(np.diag([-1.0, -1, 1, 1]))
    grip = screws(bar, LOWER, 2.1 * bar)
    grip.apply_transform(np.diag([-1.0, -1, 1, 1]))
    return {
        "teal": [holder],
        "dark": [
            cad.box((84, 84, 96), corner=10, edge=4, at=(0, 0, LOWER - 95)),
            cad.box((70, 70, 24), corner=8, edge=3, at=(0, 0, LOWER - 152)),
        ],
        "steel": [grip, cad.turned([(46, LOWER + 46), (46, UPPER - 34)], sides=40)],
    }


def elbow() -> Parts:
    """The clamp of the second link."""
    return hub(BARS[1], UPPER)


def tube1() -> Parts:
    """The bar of the first link at unit length."""
    return {"aluminium": [cad.prism(slotted(BARS[0]), UNIT, axis="x", at=(UNIT / 2, 0, LOWER))]}


def tube2() -> Parts:
    """The bar of the second link at unit length; it ends in a point, the tool."""
    bar, end = BARS[1], 0.84 * UNIT
    cap = cad.rectangle(1.16 * bar, 1.16 * bar, corner=10)
    tip = [(cad.circle(0.24 * bar, 20), 0.92 * UNIT), (cad.circle(0.2 * bar, 20), 0.95 * UNIT)]
    return {
        "aluminium": [cad.prism(slotted(bar), end, axis="x", at=(end / 2, 0, UPPER))],
        "teal": [cad.stacked([(cap, end - 30), (cap, end + 20), (cap * 0.45, 0.93 * UNIT)], axis="x")],
        "steel": [cad.stacked([*tip, (cad.circle(0.5, 20), UNIT)], axis="x")],
    }


DRAWINGS = (base, shoulder, tube1, elbow_seat, elbow, tube2)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
