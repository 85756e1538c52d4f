"""The rod in the hand of the DIA10, in millimetres: `python robots/dia10_rod/build.py` writes meshes/.

The rest of what the URDF shows are the meshes of robots/dia10. The frame is that of the flange's link, on the wrist.
"""

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, painted, write_meshes

SURFACES = {
    "blue": cad.paint(38, 104, 178, roughness=0.45),
    "dark": cad.paint(58, 61, 66, roughness=0.55),
    "steel": cad.paint(206, 209, 214, roughness=0.25, metallic=0.7),
}
FLANGE, TIP, RADIUS = 210.0, 510.0, 5.0


def rod() -> Parts:
    """Adapter plate, collet, and the slim shaft with a rounded end and a ring every 50 mm."""
    collet = [(30, FLANGE + 8), (22, FLANGE + 12), (20, FLANGE + 34), (11, FLANGE + 46), (11, FLANGE + 52)]
    shaft = [(RADIUS, FLANGE + 40), (RADIUS, TIP - 5), (4.3, TIP - 2.2), (2.4, TIP - 0.6), (0.4, TIP)]
    marks = [(RADIUS, 0), (RADIUS + 0.5, 0.4), (RADIUS + 0.5, 2.6), (RADIUS, 3)]
    return {
        "dark": [
            cad.cylinder(37, 8, edge=1, axis="y", at=(0, FLANGE + 4, 0)),
            *[cad.turned(marks, axis="y", at=(0, TIP - up - 1.5, 0), sides=20) for up in (50, 100, 150, 200)],
        ],
        "blue": [cad.turned(collet, axis="y")],
        "steel": [
            cad.turned(shaft, axis="y", sides=20),
            cad.bolts(cad.ring_of_points(4, 31, "y", (0, FLANGE + 8, 0), phase=0.5), 2.6, 3, "y"),
        ],
    }


DRAWINGS = (rod,)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
