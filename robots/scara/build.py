"""The SCARA drawn in millimetres: `python robots/scara/build.py` writes meshes/.

Each part is drawn in the frame of its link, which at q = 0 is parallel to the base and stands on its joint, 340 mm
above the table. The hose runs from the first axis to the second, so that it turns with the inner arm alone.
"""

import numpy as np

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, both, painted, write_meshes
from helicoide.solids.lettering import Lettering, on_both_sides

SURFACES = {
    "white": cad.paint(240, 241, 240, roughness=0.45),
    "dark": cad.paint(58, 62, 68, roughness=0.55),
    "metal": cad.paint(200, 203, 207, roughness=0.3, metallic=0.6),
    "yellow": cad.paint(246, 190, 26, roughness=0.55),
    "table": cad.paint(176, 182, 188, roughness=0.5, metallic=0.3),
}
INNER, OUTER, TOOL = 325.0, 225.0, -110.0


def base() -> Parts:
    """The table plate with its grooves, the foot and the column; connectors behind."""
    low, high = cad.rectangle(216, 168, corner=36, steps=6), cad.rectangle(190, 156, corner=60, steps=6)
    sockets = [(-126, y, 96) for y in (-36, 36)]
    return {
        "table": [cad.box((960, 1080, 25), corner=20, edge=4, at=(200, 0, -12.5))],
        "white": [cad.stacked([(low, 16), (high, 200), (cad.inset(high, 4), 207)], at=(-12, 0, 0))],
        "dark": [
            *[cad.raised(cad.rectangle(900, 6), 0.5, at=(200, y, 0)) for y in range(-480, 481, 120)],
            cad.box((260, 220, 18), corner=22, edge=4, at=(-12, 0, 9)),
            cad.turned([(66, 205), (66, 226)], sides=48),
            cad.box((40, 120, 104), corner=8, edge=3, axis="x", at=(-106, 0, 96)),
            *[cad.turned([(13, 8), (13, 30), (8, 38)], axis="-x", at=at, sides=16) for at in sockets],
            *[
                cad.cable([(-162, y, 96), (-178, y, 88), (-188, y, 50), (-204, 1.1 * y, 14), (-270, 1.3 * y, 6)], 6)
                for y in (-36, 36)
            ],
        ],
        "yellow": [*both(cad.raised(cad.rectangle(110, 6), 3, axis="-y", at=(-12, -77.5, 150)))],
        "metal": [
            cad.bolts([(x, y, 18) for x in (-122, 98) for y in (-90, 90)], 9, 8, "z"),
            *[cad.turned([(17, 0), (17, 6), (14, 8)], axis="-x", at=at, sides=20) for at in sockets],
        ],
    }


def inner_arm() -> Parts:
    """The cast arm between the first two axes, with the hose above it."""
    body = cad.stadium((0, 0), (INNER, 0), 80, 64, sides=56)
    recess = cad.stadium((88, 0), (INNER - 76, 0), 44, 38)
    hose = [
        (0, 0, -44),
        (0, 0, 60),
        (14, 0, 176),
        (92, 0, 262),
        (200, 0, 268),
        (284, 0, 222),
        (INNER, 0, 150),
        (INNER, 0, 104),
    ]
    return {
        "white": [cad.prism(body, 58, 9, 3, at=(0, 0, -72))],
        "dark": [
            cad.cable(hose, 15, sides=16, samples=40),
            cad.turned([(30, -44), (30, -24), (24, -14), (17, -10)]),
            cad.raised(recess, 2, 1, at=(0, 0, -43)),
            cad.raised(cad.circle(46, 40), 5, 2, axis="-z", at=(INNER, 0, -101)),
        ],
        "yellow": [cad.turned([(15.6, 40), (15.6, 52)])],
        "metal": [
            cad.turned([(60, -118), (60, -98)], sides=48),
            cad.turned([(50, -44), (50, -32)], sides=48, at=(INNER, 0, 0)),
            cad.bolts(cad.ring_of_points(8, 54, "z", (0, 0, -43)), 5, 4, "z"),
            cad.bolts([(x, y, -41) for x in (96, 242) for y in (-26, 26)], 3.5, 2.5, "z"),
        ],
    }


def outer_arm() -> Parts:
    """The arm beyond the elbow: cast tray, motor cover, and the bearing of the quill."""
    tray = cad.stadium((0, 0), (OUTER, 0), 64, 46, sides=48)
    cover = cad.stadium((0, 0), (128, 0), 50, sides=40)
    rim = [(cad.inset(cover, 14 * (1 - np.cos(t))), 88 + 14 * np.sin(t)) for t in np.linspace(0, np.pi / 2, 4)]
    return {
        "white": [
            cad.prism(tray, 58, 7, 2, at=(0, 0, -6)),
            cad.stacked([(cover, 20), *rim]),
        ],
        "dark": [
            *on_both_sides("SCARA", Lettering(18, 1.5), (64, -49.5, 58)),
            cad.turned([(34, 22), (34, 58), (28, 64)], at=(OUTER, 0, 0), sides=40),
            cad.turned([(28, -35), (28, -42), (24, -45)][::-1], at=(OUTER, 0, 0), sides=40),
            cad.turned([(24, 100), (24, 112), (17, 118)], sides=32),
        ],
        "yellow": [cad.prism(cad.inset(tray, -0.6), 5, at=(0, 0, 8))],
        "metal": [
            cad.turned([(18, 60), (18, 70)], at=(OUTER, 0, 0), sides=32),
            cad.bolts(cad.ring_of_points(6, 28, "z", (OUTER, 0, 60)), 3, 2.5, "z"),
            cad.bolts([(x, y, 23) for x in (156, 190) for y in (-38, 38)], 3.5, 3, "z"),
        ],
    }


def quill() -> Parts:
    """What slides without turning: the head of the quill, which stops above the bearing at full stroke."""
    return {
        "dark": [cad.turned([(20, 278), (20, 306), (14, 312)], sides=32)],
        "metal": [cad.turned([(15, 272), (15, 280)], sides=32), cad.turned([(7, 310), (7, 318)], sides=6)],
        "yellow": [cad.turned([(20.6, 288), (20.6, 296)], sides=32)],
    }


def spindle() -> Parts:
    """The shaft that slides and turns, the flange and the suction cup, whose rim is the tool point."""
    cup = [(12, TOOL), (6, TOOL + 10), (6, TOOL + 14), (8, TOOL + 16), (8, TOOL + 26)]
    return {
        "metal": [
            cad.turned([(10, TOOL + 32), (10, 274)], sides=32),
            cad.box((8, 6, 20), edge=1, at=(26, 0, TOOL + 37)),
        ],
        "dark": [cad.turned(cup, sides=28)],
        "white": [cad.prism(cad.stadium((0, 0), (34, 0), 20, 10), 14, 2, at=(0, 0, TOOL + 31))],
        "yellow": [cad.raised(cad.circle(5, 20), 2, at=(34, 0, TOOL + 38))],
    }


DRAWINGS = (base, inner_arm, outer_arm, quill, spindle)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
