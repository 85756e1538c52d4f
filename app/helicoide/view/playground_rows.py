"""The quaternion playground: two rotations, their quaternions, the ways between them, and the order of composition."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from markupsafe import Markup

from helicoide.geometry import rotation
from helicoide.geometry.quaternion_paths import lerp, lerp_speed, slerp, slerp_speed
from helicoide.seat import AxisAngle, Playground
from helicoide.text import Text, number_text
from helicoide.view.layers import playground as layer
from helicoide.view.pose_form_rows import quaternion_words
from helicoide.view.requests import ForSeat, PageRequest
from helicoide.view.rows import Checkbox, Folder, HtmlRow, Row, Slider, VectorRow
from helicoide.view.window_view import View

SHOW = Text(en="Show beside the arm", pt_BR="Mostrar ao lado do braço")
ABOUT = Text(
    en="q = cos(φ/2) + sin(φ/2) n turns the frame by φ about the unit axis n. The ball shows the vector part of q: its "
    "direction is n, its distance from the centre sin(φ/2). −q is the opposite point and the same rotation.",
    pt_BR="q = cos(φ/2) + sen(φ/2) n gira o referencial de φ em torno do eixo unitário n. A bola mostra a parte "
    "vetorial de q: sua direção é n e sua distância ao centro, sen(φ/2). −q é o ponto oposto e a mesma rotação.",
)
AXIS = Text(en="Axis of {q}", pt_BR="Eixo de {q}")
ANGLE = Text(en="Angle of {q} [°]", pt_BR="Ângulo de {q} [°]")
OPPOSITE = Text(en="Write −q₁ instead of q₁", pt_BR="Escrever −q₁ em vez de q₁")
WAY = Text(en="Way from q₁ to q₂, t", pt_BR="Caminho de q₁ a q₂, t")
WAYS = Text(
    en="Slerp (blue) follows the sphere at constant speed, {slerp}° per unit of t. Lerp (orange) takes the straight "
    "chord and must be stretched to length 1: its length here is {length}, and it turns at {lerp}° per unit of t, slow "
    "at the ends and fast in the middle. The dots are at equal steps of t, those of "
    "lerp stretched to length 1.",
    pt_BR="O slerp (azul) segue a esfera com velocidade constante, {slerp}° por unidade de t. O lerp (laranja) vai "
    "pela corda e precisa ser esticado até o comprimento 1: aqui mede {length} e gira a {lerp}° por unidade de t, "
    "devagar nas pontas e depressa no meio. As marcas estão em passos iguais de t, "
    "as do lerp esticadas até o comprimento 1.",
)
LONG_WAY = Text(
    en="q₁·q₂ is negative: this is the longer way. Write −q₁ for the shorter one.",
    pt_BR="q₁·q₂ é negativo: este é o caminho mais longo. Escreva −q₁ para o mais curto.",
)
ORDER = Text(
    en="Order matters: q₁q₂ turns by q₂ first, q₂q₁ by q₁ first. The two results differ by {angle}°.",
    pt_BR="A ordem importa: q₁q₂ gira primeiro por q₂, q₂q₁ primeiro por q₁. Os dois resultados diferem de {angle}°.",
)


def playground_rows() -> Folder:
    """The two rotations by axis and angle, and what is to be seen of them."""
    rows: list[Row] = [
        Checkbox(
            SHOW,
            lambda view: view.seat.visible_layers[layer.NAME],
            lambda on: ForSeat(lambda seat: seat.with_layer(layer.NAME, on)),
        ),
        HtmlRow(lambda view: Markup("<p class='helicoide-note'>{}</p>").format(ABOUT[view.seat.language])),
        *_rotation_rows("q₁", lambda view: view.seat.playground.first, _first),
        Checkbox(
            OPPOSITE,
            lambda view: view.seat.playground.opposite,
            lambda on: _changed(lambda play: replace(play, opposite=bool(on))),
        ),
        *_rotation_rows("q₂", lambda view: view.seat.playground.second, _second),
        Slider(WAY, 0.0, 1.0, 0.01, lambda view: view.seat.playground.t, lambda t: _changed(lambda play: play.at(t))),
        HtmlRow(_words),
    ]
    return Folder(layer.TITLE, rows, open=False)


def _changed(change: Callable[[Playground], Playground]) -> PageRequest:
    return ForSeat(lambda seat: replace(seat, playground=change(seat.playground)))


Change = Callable[[Callable[[AxisAngle], AxisAngle]], PageRequest]


def _first(change: Callable[[AxisAngle], AxisAngle]) -> PageRequest:
    return _changed(lambda play: replace(play, first=change(play.first)))


def _second(change: Callable[[AxisAngle], AxisAngle]) -> PageRequest:
    return _changed(lambda play: replace(play, second=change(play.second)))


def _rotation_rows(name: str, of: Callable[[View], AxisAngle], change: Change) -> list[Row]:
    def axis(view: View) -> tuple[float, float, float]:
        x, y, z = (round(value, 3) for value in of(view).axis)
        return x, y, z

    return [
        VectorRow(AXIS.format(q=name), 0.1, axis, lambda _, given: change(lambda one: one.about(given))),
        Slider(
            ANGLE.format(q=name),
            -360.0,
            360.0,
            1.0,
            lambda view: float(np.degrees(of(view).angle)),
            lambda degrees: change(lambda one: one.turned_by(math.pi / 180 * degrees)),
        ),
    ]


def _words(view: View) -> Markup:
    play, language = view.seat.playground, view.seat.language
    p, q = play.quaternions
    middle, turning = lerp(p, q, play.t), math.degrees(lerp_speed(p, q, play.t))
    ways = WAYS.format(
        slerp=number_text(float(np.degrees(slerp_speed(p, q))), ".0f"),
        lerp=number_text(turning, ".0f") if math.isfinite(turning) else "∞",
        length=number_text(float(np.linalg.norm(middle)), ".3f"),
    )
    first, second = rotation.multiply(np.array([p, q]), np.array([q, p]))
    between = np.degrees(2 * np.arccos(min(1.0, abs(float(first @ second)))))
    named = {"q₁": p, "q₂": q, "slerp(t)": slerp(p, q, play.t), "q₁q₂": first, "q₂q₁": second}
    row = Markup("<tr><td>{}\u00a0=</td><td>{}</td></tr>")
    rows = (row.format(name, quaternion_words(value, language)) for name, value in named.items())
    table = Markup("<div class='helicoide-note helicoide-quaternions'><table>{}</table></div>").format(
        Markup("").join(rows)
    )
    said = [ways, *([LONG_WAY] if p @ q < 0 else []), ORDER.format(angle=number_text(float(between), ".1f"))]
    return table + Markup("").join(Markup("<p class='helicoide-note'>{}</p>").format(one[language]) for one in said)
