"""The Yaskawa Motoman L-3 drawn in millimetres: `python robots/motoman_l3/build.py` writes meshes/.

Each part is drawn in the frame of its link, which at q = 0 is parallel to the base and stands on its joint's centre;
the stretched arm lies along +x and the hand points up. The screws and rods that push the joints of the real machine are
fixed to the links that carry them, and end at discs about the joints, so that they look joined at any angle.
"""

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, both, merged, painted, write_meshes
from helicoide.solids.lettering import Lettering, on_both_sides

SURFACES = {
    "orange": cad.paint(233, 138, 36, roughness=0.5),
    "dark": cad.paint(52, 56, 62, roughness=0.55),
    "bellows": cad.paint(34, 36, 40, roughness=0.8),
    "metal": cad.paint(198, 201, 206, roughness=0.35, metallic=0.6),
}
FLOOR, WAIST, UPPER_ARM, FOREARM = -600.0, -310.0, 400.0, 500.0


def hub(x: float, y: float, radius: float) -> Parts:
    """A bearing cover on both sides of a pitch axis: dark disc, bright hub, screws."""
    return {
        "dark": both(cad.raised(cad.circle(radius), 6, edge=2, axis="-y", at=(x, -y, 0))),
        "metal": [
            *both(cad.raised(cad.circle(0.36 * radius, 20), 4, edge=1.5, axis="-y", at=(x, -y - 6, 0))),
            *both(cad.bolts(cad.ring_of_points(6, 0.72 * radius, "-y", (x, -y - 6, 0)), 3, 2, "-y")),
        ],
    }


# --- base and waist: frames at the height of the shoulder, on the vertical axis ---------------------------------------


def base() -> Parts:
    """Floor plate, tapered column, connector box behind it and the waist bearing."""
    corners = [(x, y) for x in (-165, 165) for y in (-165, 165)]
    low, high = cad.rectangle(330, 330, corner=60, steps=5), cad.rectangle(270, 270, corner=100, steps=5)
    sockets = [(-212, y, FLOOR + 120) for y in (-40, 40)]
    return {
        "orange": [cad.stacked([(low, FLOOR + 22), (low, FLOOR + 50), (high, FLOOR + 90), (high, WAIST - 30)])],
        "dark": [
            cad.prism(cad.rectangle(400, 400, corner=30), 24, edge=4, at=(0, 0, FLOOR + 12)),
            cad.box((90, 170, 120), corner=10, edge=5, axis="-x", at=(-166, 0, FLOOR + 120)),
            cad.turned([(122, WAIST - 34), (122, WAIST - 4)], sides=48),
            *[cad.cable([(-222, y, FLOOR + 120), (-262, y, FLOOR + 108), (-286, 1.1 * y, FLOOR + 50),
                         (-330, 1.3 * y, FLOOR + 12), (-400, 1.5 * y, FLOOR + 9)], 9) for y in (-40, 40)],
        ],
        "metal": [
            cad.bolts([(x, y, FLOOR + 24) for x, y in corners], 11, 10, "z"),
            *[cad.cylinder(18, 22, edge=2, axis="x", at=at, sides=20) for at in sockets],
            cad.turned([(130, WAIST - 30), (130, WAIST - 22), (127, WAIST - 18)], sides=48),
        ],
    }  # fmt: skip


def waist() -> Parts:
    """Turntable, two cheeks up to the shoulder, and behind them the screws of the shoulder and of the elbow."""
    foot = cad.rounded([(-150, WAIST + 34), (92, WAIST + 34), (92, WAIST + 110), (-150, WAIST + 110)], 20)
    cheek = cad.hull(cad.circle(58, 32), foot)
    neck = cad.rounded([(-140, WAIST + 20), (100, WAIST + 20), (84, WAIST + 110), (-140, WAIST + 130)], 16)
    housing = {
        "orange": [
            cad.turned([(128, WAIST - 4), (138, WAIST), (138, WAIST + 26), (128, WAIST + 36)], sides=48),
            cad.prism(neck, 162, edge=6, steps=2, axis="-y"),
            *both(cad.prism(cheek, 24, edge=6, steps=2, axis="-y", at=(0, -92, 0))),
        ],
        "metal": [cad.cylinder(14, 262, axis="y", sides=24)],
    }
    return merged(SURFACES, housing, hub(0, 104, 46), *[ball_screw(side) for side in (-1, 1)])


def ball_screw(side: int) -> Parts:
    """A motor at the foot, the screw in its bellows, and the nut's fork on the disc of the joint that it pushes."""
    y, x = side * 126.0, -118.0
    folds = [(13 if i % 2 else 19, WAIST + 118 + 7 * i) for i in range(25)]
    link = cad.stadium((x, 0), (0, 0), 13, 11, sides=20)
    return {
        "dark": [
            cad.box((66, 40, 66), corner=10, edge=4, at=(x, y, WAIST + 66)),
            cad.cylinder(24, 20, edge=3, at=(x, y, WAIST + 108)),
            cad.cylinder(24, 46, edge=4, at=(x, y, WAIST + 22)),
        ],
        "bellows": [cad.turned(folds, at=(x, y, 0), sides=14)],
        "metal": [
            cad.cylinder(8, 150, at=(x, y, 20), sides=16),
            cad.box((34, 34, 26), corner=5, edge=3, at=(x, y, 0)),
            cad.prism(link, 10, edge=2, axis="-y", at=(0, y, 0)),
            cad.cylinder(9, 34, axis="y", at=(x, y, 0), sides=16),
        ],
        "orange": [cad.box((86, 40, 26), corner=6, edge=3, at=(x + 12, side * 102, WAIST + 98))],
    }


# --- arm: frames on the shoulder, the elbow and the wrist -------------------------------------------------------------


def upper_arm() -> Parts:
    """A box beam with a window, the rod behind it between two discs, and the fork of the elbow."""
    side = cad.stadium((0, 0), (UPPER_ARM, 0), 54, 42)
    window = cad.prism(cad.stadium((226, 0), (292, 0), 22, 20), 200, axis="-y")
    slot = cad.prism(cad.rounded([(330, -90), (330, 90), (470, 90), (470, -90)], 6), 66, axis="-y")
    plates = cad.cut(cad.prism(side, 104, edge=8, steps=2, axis="-y"), slot, window)
    rod = cad.cylinder(9, UPPER_ARM, axis="x", at=(UPPER_ARM / 2, -66, 48), sides=16)
    ends = [cad.box((44, 22, 26), corner=5, edge=3, axis="-y", at=(x, -66, 48)) for x in (14, UPPER_ARM - 14)]
    body: Parts = {
        "orange": [plates],
        "metal": [
            *both(rod),
            *on_both_sides("L-3", Lettering(26, 1.5), (128, -52, 0)),
            cad.cylinder(20, 72, axis="y", at=(UPPER_ARM, 0, 0)),
        ],
        "dark": [solid for end in ends for solid in both(end)]
        + [solid for x in (0.0, UPPER_ARM) for solid in both(cad.cylinder(58, 9, edge=2, axis="y", at=(x, -57, 0)))],
    }
    return merged(SURFACES, body, hub(UPPER_ARM, 61.5, 30))


def forearm() -> Parts:
    """A tongue in the elbow, the tapered beam, the chain case of the wrist on it, and the fork of the wrist."""
    tongue = cad.hull(cad.circle(40, 32), cad.circle(34, 28, (120, 0)))
    side = cad.hull(cad.circle(36, 28, (110, 0)), cad.circle(27, 28, (FOREARM, 0)))
    slot = cad.prism(
        cad.rounded([(FOREARM - 46, -60), (FOREARM - 46, 60), (FOREARM + 90, 60), (FOREARM + 90, -60)], 6),
        46,
        axis="-y",
    )
    case = cad.stadium((150, 0), (FOREARM, 0), 22, 20, sides=24)
    body: Parts = {
        "orange": [
            cad.prism(tongue, 60, edge=4, steps=2, axis="-y"),
            cad.cut(cad.prism(side, 76, edge=7, steps=2, axis="-y"), slot),
        ],
        "dark": both(cad.raised(case, 6, edge=2, axis="-y", at=(0, -38, 0))),
        "metal": [
            *both(cad.bolts([(x, -44, 0) for x in (152, 440)], 3, 2, "-y")),
            *on_both_sides("MOTOMAN", Lettering(15, 1.5), (290, -44, 0)),
        ],
    }  # fmt: skip
    return merged(SURFACES, body, hub(FOREARM, 44, 15))


def wrist() -> Parts:
    """The block that bends: it runs from its axis along the hand's line, which at q = 0 points up."""
    block = cad.hull(cad.circle(27, 28), [(-24, 34), (24, 34), (24, 46), (-24, 46)])
    return {
        "dark": [cad.prism(block, 42, edge=4, axis="-y"), cad.turned([(23, 44), (29, 48), (29, 64), (26, 66)])],
        "metal": [cad.cylinder(11, 50, axis="y", sides=20)],
    }


def flange() -> Parts:
    """The disc that turns about the hand's line, with its bolt circle and a pin that shows the turn."""
    return {
        "metal": [
            cad.turned([(20, 64), (20, 70), (31, 71), (31, 81), (29, 82)]),
            cad.bolts(cad.ring_of_points(6, 22, "z", (0, 0, 82), phase=0.5), 3, 2.5, "z"),
        ],
        "orange": [cad.cylinder(4, 14, edge=1, at=(22, 0, 88), sides=12)],
        "dark": [cad.raised(cad.circle(10, 20), 0.6, at=(0, 0, 82))],
    }


DRAWINGS = (base, waist, upper_arm, forearm, wrist, flange)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
