"""How multivectors and orientations are written: the algebra, the names of its blades, the Euler angles."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from helicoide.geometry.euler import CONVENTIONS, EXTRINSIC
from helicoide.geometry.notation import BladeNaming
from helicoide.seat import Notation, Seat, ShownAlgebra
from helicoide.text import Text, untranslated
from helicoide.view.requests import ForSeat, PageRequest
from helicoide.view.rows import Dropdown, Folder, Row

TITLE = Text(en="Notation", pt_BR="Notação")
ALGEBRAS: dict[ShownAlgebra, Text] = {
    "Cl(0,3,1)": Text(en="Cl(0,3,1), as in the sources", pt_BR="Cl(0,3,1), como nas fontes"),
    "Cl(3,0,1)": Text(en="Cl(3,0,1), as in modern texts", pt_BR="Cl(3,0,1), como nos textos modernos"),
}
NAMINGS: dict[BladeNaming, Text] = {
    "factors": Text(en="products: e₂e₃, e₁e", pt_BR="produtos: e₂e₃, e₁e"),
    "compact": Text(en="indices: e₂₃, e₀₁", pt_BR="índices: e₂₃, e₀₁"),
}
FIXED_AXES = Text(en="{axes}, fixed axes", pt_BR="{axes}, eixos fixos")
MOVING_AXES = Text(en="{axes}, moving axes", pt_BR="{axes}, eixos móveis")


def notation_rows() -> Folder:
    """The choice of algebra and of the names of its blades."""
    rows: list[Row] = [
        Dropdown(
            Text(en="Algebra", pt_BR="Álgebra"),
            list(ALGEBRAS.items()),
            lambda view: view.seat.notation.algebra,
            _changed(lambda notation, algebra: replace(notation, algebra=algebra)),
        ),
        Dropdown(
            Text(en="Blades", pt_BR="Lâminas"),
            list(NAMINGS.items()),
            lambda view: view.seat.notation.naming,
            _changed(lambda notation, naming: replace(notation, naming=naming)),
        ),
    ]
    return Folder(TITLE, rows)


def euler_row() -> Dropdown:
    """The choice of the convention of Euler angles."""
    return Dropdown(
        Text(en="Euler angles", pt_BR="Ângulos de Euler"),
        [(convention, convention_title(convention)) for convention in CONVENTIONS],
        lambda view: view.seat.notation.euler,
        _changed(lambda notation, euler: replace(notation, euler=euler)),
    )


def convention_title(convention: str) -> Text:
    """A convention of Euler angles in words."""
    axes = untranslated(convention.removeprefix(EXTRINSIC))
    return (FIXED_AXES if convention.startswith(EXTRINSIC) else MOVING_AXES).format(axes=axes)


def _changed(change: Callable[[Notation, Any], Notation]) -> Callable[[Any], PageRequest]:
    def request(value: Any) -> PageRequest:
        def update(seat: Seat) -> Seat:
            return replace(seat, notation=change(seat.notation, value))

        return ForSeat(update)

    return request
