"""The planar 3R drawn in millimetres: `python robots/planar3r/build.py` writes meshes/.

Its lengths are parameters. Hubs are drawn as they are; each tube is drawn 1000 mm long, and the URDF stretches it to
the length of its link. The links lie one above the other, so that the arm folds freely; the frame of the source, z = 0,
lies in the last.
"""

from trimesh import Trimesh

from helicoide import solids as cad
from helicoide.solids.drawing import Parts, painted, write_meshes

SURFACES = {
    "white": cad.paint(226, 230, 234, roughness=0.45),
    "dark": cad.paint(52, 58, 66, roughness=0.5),
    "metal": cad.paint(196, 200, 204, roughness=0.35, metallic=0.6),
    "blue": cad.paint(38, 104, 172, roughness=0.45),
}
FLOOR = -950.0
LEVELS = ((-262.0, -152.0), (-137.0, -47.0), (-35.0, 35.0))  # lower and upper side of each link
WIDTHS = (150.0, 116.0, 84.0)
UNIT = 1000.0


def disc(radius: float, low: float, high: float, edge: float = 8.0) -> Trimesh:
    """A round housing between two heights with chamfered rims."""
    return cad.cylinder(radius, high - low, edge, 2, at=(0, 0, (low + high) / 2), sides=48)


def base() -> Parts:
    """A round foot on the floor and a column that narrows to the bearing of the shoulder."""
    foot = cad.ring_of_points(8, 370, "z", (0, 0, FLOOR + 40))
    column = [(280, FLOOR + 36), (276, FLOOR + 44), (206, FLOOR + 190), (190, -310), (182, -300)]
    return {
        "dark": [disc(430, FLOOR, FLOOR + 40, 12), cad.turned([(192, -560), (192, -536)], sides=48)],
        "white": [cad.turned(column, sides=48)],
        "blue": [cad.turned([(193.5, -420), (193.5, -396)], sides=48)],
        "metal": [cad.turned([(150, -302), (150, -266)], sides=48), cad.bolts(foot, 20, 16, "z")],
    }


def hub(level: int, radius: float) -> Parts:
    """The near end of a link: its housing around the joint, with a bolted cover on top."""
    low, high = LEVELS[level][0] - 6, LEVELS[level][1] + 6
    return {
        "dark": [disc(radius, low, high)],
        "white": [cad.turned([(radius + 1.2, (low + high) / 2 - 9), (radius + 1.2, (low + high) / 2 + 9)], sides=48)],
        "metal": [
            cad.raised(cad.circle(0.62 * radius, 40), 4, 1.5, at=(0, 0, high)),
            cad.bolts(cad.ring_of_points(8, 0.8 * radius, "z", (0, 0, high)), 6, 4, "z"),
        ],
    }


def seat(level: int, radius: float) -> Parts:
    """The far end of a link: its housing and the bearing that carries the next link."""
    low, high = LEVELS[level][0] - 6, LEVELS[level][1] + 6
    return {
        "dark": [disc(radius, low, high)],
        "metal": [cad.turned([(0.72 * radius, high - 2), (0.72 * radius, LEVELS[level + 1][0])], sides=48)],
    }


def shoulder() -> Parts:
    """The hub of the first link."""
    return hub(0, 172)


def elbow_seat() -> Parts:
    """The far end of the first link with the motor of the elbow below."""
    fins = [cad.turned([(88, z), (88, z + 7)], sides=48) for z in range(-384, -290, 16)]
    end = seat(0, 132)
    end["dark"] += [cad.turned([(70, -412), (80, -402), (80, -262)], sides=48), *fins]
    end["metal"] += [cad.bolts(cad.ring_of_points(6, 112, "-z", (0, 0, -268)), 6, 5, "-z")]
    return end


def elbow() -> Parts:
    """The hub of the second link."""
    return hub(1, 120)


def wrist_seat() -> Parts:
    """The far end of the second link."""
    return seat(1, 98)


def wrist() -> Parts:
    """The hub of the third link."""
    return hub(2, 86)


def tube(level: int, end: float = UNIT) -> Parts:
    """A rounded box section with a white strip on both sides, from the joint to `end`."""
    low, high = LEVELS[level]
    width, middle = WIDTHS[level], (low + high) / 2
    strip = cad.box((end, width + 3, 0.16 * (high - low)), at=(end / 2, 0, middle))
    return {
        "blue": [cad.box((end, width, high - low), corner=22, axis="x", at=(end / 2, 0, middle))],
        "white": [strip],
    }


def tube1() -> Parts:
    """The first link at unit length."""
    return tube(0)


def tube2() -> Parts:
    """The second link at unit length."""
    return tube(1)


def tube3() -> Parts:
    """The third link at unit length; it ends in a point, the tool."""
    section, end = cad.rectangle(WIDTHS[2], 70, corner=22), 0.86 * UNIT
    point = [(section * scale, x) for scale, x in ((1.08, end - 14), (1.08, end), (0.42, 0.93 * UNIT), (0.02, UNIT))]
    link = tube(2, end)
    link["metal"] = [cad.stacked([(section * 0.42, 0.92 * UNIT), *point[2:]], axis="x")]
    link["dark"] = [cad.stacked([*point[:2], (section * 0.42, 0.93 * UNIT)], axis="x")]
    return link


DRAWINGS = (base, shoulder, tube1, elbow_seat, elbow, tube2, wrist_seat, wrist, tube3)


def files() -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    return painted(DRAWINGS, SURFACES)


if __name__ == "__main__":
    write_meshes(__file__, files())
