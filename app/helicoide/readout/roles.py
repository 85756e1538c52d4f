"""The part that each coefficient has in a motor, a line, a plane or a point."""

from __future__ import annotations

from typing import Literal, NamedTuple

from helicoide.readout.elements import Nature

Part = Literal["cosine", "sine", "dual", "slide", "direction", "moment", "normal", "offset", "weight", "coordinate"]


class Role(NamedTuple):
    """What a coefficient is: its part, and the axis 0, 1, 2 for x, y, z of a component, else None.

    letter: its symbol in TeX, "" for one that is always 1; sign: the symbol is sign · (the stored coefficient).
    """

    part: Part
    axis: int | None
    letter: str
    sign: int = 1


def _components(part: Part, blades: str, letters: str) -> dict[str, Role]:
    """Three components. A blade with e1e3 has the opposite sign of the component, which belongs to e3e1."""
    named = zip(blades.split(), letters.split(), strict=True)
    return {blade: Role(part, i, letter, -1 if "e1e3" in blade else 1) for i, (blade, letter) in enumerate(named)}


_ROLES: dict[Nature, dict[str, Role]] = {
    "motor": {
        "1": Role("cosine", None, "w"),
        **_components("sine", "e2e3 e1e3 e1e2", "x y z"),
        **_components("dual", "e1e e2e e3e", "x' y' z'"),
        "e1e2e3e": Role("slide", None, "w'", -1),
    },
    "line": {
        **_components("direction", "e2e3 e1e3 e1e2", "v_x v_y v_z"),
        **_components("moment", "e1e e2e e3e", "u_x u_y u_z"),
    },
    "plane": {**_components("normal", "e1 e2 e3", "n_x n_y n_z"), "e": Role("offset", None, "d")},
    "point": {
        "e1e2e3": Role("weight", None, ""),
        **_components("coordinate", "e2e3e e1e3e e1e2e", "x y z"),
    },
}


def role_of(nature: Nature, blade: str | None) -> Role | None:
    """The part of the coefficient of a blade of `CL031`; None if it is zero in every element of this nature."""
    return None if blade is None else _ROLES[nature].get(blade)
