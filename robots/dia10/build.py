"""The Motoman DIA10 drawn in millimetres: `python robots/dia10/build.py` writes meshes/.

Each part is drawn in the frame of its link, which at q = 0 is parallel to the base and stands on its joint's centre;
the stretched arm lies along +y. A pitch axis runs through a drum: its lower half (z < 0) belongs to the link before,
its upper half to the link after, so that the arm can fold. Front and back look alike, for the source does not say which
way the machine faces. The left arm, which nothing drives, is no drawing of its own: the URDF shows these meshes once
more, fixed to the torso.
"""

import numpy as np
from trimesh import Trimesh

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, merged, painted, write_meshes
from helicoide.solids.lettering import Lettering, word

SURFACES = {
    "blue": cad.paint(38, 104, 178, roughness=0.45),
    "white": cad.paint(232, 234, 236, roughness=0.5),
    "dark": cad.paint(58, 61, 66, roughness=0.55),
    "metal": cad.paint(196, 199, 204, roughness=0.35, metallic=0.6),
}
# Distances between the joint centres (Coutinho 2015, F4.1); where two links turn on each other in between is ours.
SHOULDER_HEIGHT, SHOULDER, UPPER_ARM, FOREARM, HAND = 1037.0, 380.0, 390.0, 330.0, 210.0
SHOULDER_ROLL, UPPER_ROLL, FOREARM_ROLL, HAND_ROLL = 212.0, 185.0, 104.0, 112.0
LOWER, UPPER = -1, 1
FACES: tuple[tuple[cad.Axis, int], ...] = (("x", 1), ("-x", -1))


def half_joint(y: float, radius: float, depth: float, half: int, pipe: float, mouth: float) -> Trimesh:
    """A casting from a round mouth on the arm's line to its half of the drum at y, clear of the other half."""
    drum = cad.cylinder(radius, depth, edge=9, steps=2, at=(0, y, half * depth / 2))
    throat = cad.cylinder(pipe, 12, edge=2, axis="y", at=(0, mouth + 6 * np.sign(y - mouth), 0))
    clearance = cad.cylinder(radius + 2, 2 * depth, at=(0, y, -half * depth), sides=32)
    return cad.cut(cad.wrapped(drum, throat), clearance)


def cap(y: float, radius: float, depth: float, half: int) -> Parts:
    """The cover on the end of a half drum and its screws."""
    axis: cad.Axis = "z" if half == UPPER else "-z"
    cover = cad.raised(cad.circle(0.78 * radius), 7, edge=3, steps=2, axis=axis, at=(0, y, half * depth))
    ring = cad.ring_of_points(6, 0.62 * radius, axis, (0, y, half * (depth + 7)))
    return {
        "white": [cover],
        "dark": [cad.raised(cad.circle(0.3 * radius, 20), 2, edge=1, axis=axis, at=(0, y, half * (depth + 7)))],
        "metal": [cad.bolts(ring, 3.5, 2, axis)],
    }


def seam(y: float, pipe: float) -> Trimesh:
    """The dark ring where one link turns on the other about the arm's line."""
    return cad.cylinder(pipe - 3, 10, axis="y", at=(0, y, 0))


def pivot(y: float, radius: float, depth: float) -> Trimesh:
    """The dark bearing between the two halves of a drum, with a core that closes the view into them."""
    return cad.turned([(radius - 16, -0.5 * depth), (radius - 16, -5), (radius - 4, -5), (radius - 4, 5),
                       (radius - 16, 5), (radius - 16, 0.5 * depth)], at=(0, y, 0))  # fmt: skip


# --- body: frames on the floor, under the waist ----------------------------------------------------------------------


def pedestal() -> Parts:
    """Floor plate with its anchors, painted column with the connectors on its left side, and the waist bearing."""
    corners = [(x, y) for x in (-235, 235) for y in (-235, 235)]
    foot, neck = cad.rectangle(400, 400, corner=110, steps=6), cad.rectangle(300, 300, corner=110, steps=6)
    column = cad.stacked([(foot, 22), (foot, 60), (neck, 150), (neck, 500), (cad.inset(neck, 14), 514)])
    return {
        "white": [column],
        "dark": [
            cad.prism(cad.rectangle(560, 560, corner=40), 24, edge=4, at=(0, 0, 12)),
            cad.raised(cad.rectangle(150, 190, corner=10), 12, edge=3, axis="-y", at=(0, -149, 290)),
            cad.turned([(134, 505), (134, 535)], sides=48),
        ],
        "metal": [
            cad.bolts([(x, y, 24) for x, y in corners], 14, 12, "z"),
            *[cad.cylinder(21, 14, edge=2, axis="y", at=(x, -165, z)) for x in (-36, 36) for z in (250, 330)],
            cad.turned([(142, 514), (142, 524), (139, 528)], sides=48),
        ],
    }


def torso() -> Parts:
    """Waist collar, white body that widens to the shoulders, and the sockets of both arms."""
    outline = [(252, 252, 540), (256, 262, 600), (230, 270, 740), (220, 330, 900), (220, 372, 970), (220, 376, 1090)]
    body = [(cad.rectangle(x, y, corner=90, steps=6), z) for x, y, z in outline]
    crown = [(cad.inset(body[-1][0], 60 * (1 - np.cos(t))), 1090 + 60 * np.sin(t)) for t in (0.4, 0.8, 1.2, np.pi / 2)]
    shell: Parts = {
        "white": [cad.stacked([*body, *crown])],
        "blue": [
            cad.turned([(136, 528), (142, 531), (142, 539), (139, 542)], sides=48),
            *[cad.cylinder(96, 60, edge=6, steps=2, axis="y", at=(0, y, SHOULDER_HEIGHT)) for y in (-176, 176)],
        ],
        "dark": [cad.cylinder(86, 12, axis="y", at=(0, y, SHOULDER_HEIGHT)) for y in (-209, 209)],
    }
    return merged(SURFACES, shell, *[torso_face(axis, side) for axis, side in FACES])


def torso_face(axis: cad.Axis, side: int) -> Parts:
    """The blue plate with the name and the vents below it, on the front or the back."""
    plate = cad.rounded([(-92, 920), (-120, 1000), (-120, 1085), (120, 1085), (120, 1000), (92, 920)], 16)
    slot = cad.rectangle(120, 8, corner=3)
    return {
        "blue": [cad.raised(plate, 8, edge=3, steps=2, axis=axis, at=(side * 107, 0, 0))],
        "dark": [cad.raised(slot, 2, axis=axis, at=(side * (137.5 - z / 32), 0, z)) for z in range(750, 841, 18)],
        "metal": [word("MOTOMAN", Lettering(24, 1.2), axis, (side * 114.5, 0, SHOULDER_HEIGHT))],
    }


# --- arm: frames on the joint centres ---------------------------------------------------------------------------------


def shoulder() -> Parts:
    """From the socket in the torso to the lower half of the shoulder drum; its frame is on the torso's axis."""
    casting = half_joint(SHOULDER, 86, 92, LOWER, 90, SHOULDER_ROLL)
    return merged(SURFACES, cap(SHOULDER, 86, 92, LOWER), {"blue": [casting], "dark": [pivot(SHOULDER, 86, 92)]})


def upper_arm() -> Parts:
    """The upper half of the shoulder drum and the first part of the upper arm."""
    casting = half_joint(0, 86, 92, UPPER, 70, UPPER_ROLL - 4)
    return merged(SURFACES, cap(0, 86, 92, UPPER), {"blue": [casting], "dark": [seam(UPPER_ROLL, 70)]})


def upper_arm_roll() -> Parts:
    """The part of the upper arm that turns about its own line, to the lower half of the elbow."""
    casting = half_joint(UPPER_ARM, 72, 78, LOWER, 70, UPPER_ROLL + 4)
    collar = cad.turned([(71, 189), (74, 192), (74, 208), (71, 211)], axis="y")
    return merged(
        SURFACES,
        cap(UPPER_ARM, 72, 78, LOWER),
        {"blue": [casting], "white": [collar], "dark": [pivot(UPPER_ARM, 72, 78)]},
    )


def elbow() -> Parts:
    """The upper half of the elbow, up to where the forearm turns."""
    casting = half_joint(0, 72, 78, UPPER, 56, FOREARM_ROLL - 4)
    return merged(SURFACES, cap(0, 72, 78, UPPER), {"blue": [casting], "dark": [seam(FOREARM_ROLL, 56)]})


def forearm() -> Parts:
    """The restricted link: a slim tube that slides through the entry point, and the lower half of the wrist."""
    tube = cad.turned([(56, 108), (56, 120), (46, 132), (46, 250)], axis="y")
    casting = half_joint(FOREARM, 54, 58, LOWER, 48, 236)
    dark = [pivot(FOREARM, 54, 58), word("DIA10", Lettering(11, 1.2), "x", (44.8, 180, 0))]
    return merged(SURFACES, cap(FOREARM, 54, 58, LOWER), {"white": [tube], "blue": [casting], "dark": dark})


def wrist() -> Parts:
    """The upper half of the wrist, up to where the flange turns."""
    casting = half_joint(0, 54, 58, UPPER, 44, HAND_ROLL - 4)
    return merged(SURFACES, cap(0, 54, 58, UPPER), {"blue": [casting], "dark": [seam(HAND_ROLL, 44)]})


def flange() -> Parts:
    """The last roll and the flange with its bolt circle; its face is where the tool frame stands."""
    ring = cad.ring_of_points(8, 24, "y", (0, HAND, 0))
    return {
        "blue": [cad.turned([(41, 116), (44, 119), (44, 160), (38, 176)], axis="y")],
        "metal": [
            cad.turned([(30, 170), (30, 194), (38, 196), (38, 207), (36, HAND - 0.5)], axis="y"),
            cad.bolts([(22, 160, 22)], 3, 2, "z"),
        ],
        "dark": [
            cad.raised(cad.circle(11, 20), 0.6, axis="y", at=(0, HAND - 0.6, 0)),
            *[cad.raised(cad.circle(3, 10), 0.6, axis="y", at=point - (0, 0.6, 0)) for point in ring],
            cad.box((5, 26, 3), at=(0, 138, 44)),
        ],
    }


DRAWINGS = (pedestal, torso, shoulder, upper_arm, upper_arm_roll, elbow, forearm, wrist, flange)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
