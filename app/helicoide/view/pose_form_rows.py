"""The inspected frame in its other forms: screw, quaternion, dual quaternion, matrix and Euler angles."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from markupsafe import Markup

from helicoide import readout
from helicoide.arrays import Array
from helicoide.geometry.motor import ScrewDisplacement
from helicoide.readout import PoseForms
from helicoide.text import Language, Text, rounded_numbers, rounded_text
from helicoide.view import html
from helicoide.view.inspector_rows import inspected
from helicoide.view.notation_rows import convention_title, euler_row
from helicoide.view.rows import Folder, HtmlRow
from helicoide.view.window_view import View

TITLE = Text(en="Screw, quaternion, matrix", pt_BR="Helicoide, quatérnio, matriz")
ONLY_FRAMES = Text(
    en="Planes and points have no orientation: choose the end effector, the target, a link, a frame or a joint axis.",
    pt_BR="Planos e pontos não têm orientação: escolha o efetuador, o alvo, um elo, um referencial ou o eixo de uma "
    "junta.",
)
SCREW = Text(en="Screw", pt_BR="Helicoide")
TURNING = Text(
    en="Rotation by φ = {angle}° about the axis through ({point}) mm in the direction ({direction}), translation "
    "d = {slide} mm along it. Pitch: {pitch}.",
    pt_BR="Rotação de φ = {angle}° em torno do eixo que passa por ({point}) mm na direção ({direction}), translação "
    "d = {slide} mm ao longo dele. Passo: {pitch}.",
)
SLIDING = Text(
    en="Translation by {slide} mm in the direction ({direction}), without rotation. Pitch: infinite.",
    pt_BR="Translação de {slide} mm na direção ({direction}), sem rotação. Passo: infinito.",
)
STILL = Text(en="No motion: the frame coincides with the base.", pt_BR="Sem movimento: coincide com a base.")
STILL_JOINT = Text(en="The joint is at its zero.", pt_BR="A junta está em seu zero.")
PITCH = Text(en="{h} mm per radian, {lead} mm per turn", pt_BR="{h} mm por radiano, {lead} mm por volta")
QUATERNION = Text(en="Quaternion", pt_BR="Quatérnio")
HALVES = Text(
    en="w = cos(φ/2) = cos {half}°; the vector part is the unit axis times sin(φ/2) = sin {half}° = {sine}. −q is the "
    "same rotation.",
    pt_BR="w = cos(φ/2) = cos {half}°; a parte vetorial é o eixo unitário vezes sen(φ/2) = sen {half}° = {sine}. −q é "
    "a mesma rotação.",
)
DUAL = Text(en="Dual quaternion: rows 1 and ε [m]", pt_BR="Quatérnio dual: linhas 1 e ε [m]")
MATRIX = Text(en="4×4 matrix, positions in mm", pt_BR="Matriz 4×4, posições em mm")
EULER = Text(en="Euler angles {convention}: {angles}", pt_BR="Ângulos de Euler {convention}: {angles}")
WARNING = Text(
    en="Near a singularity: {margin}° away. The first and last angle change fast there; at the singularity only their "
    "sum or difference is determined.",
    pt_BR="Perto de uma singularidade: a {margin}°. Ali o primeiro e o último ângulo mudam depressa; na singularidade "
    "só a soma ou a diferença deles é determinada.",
)


def pose_form_rows() -> Folder:
    """The forms of the inspected frame, and the convention of its Euler angles."""
    return Folder(TITLE, [HtmlRow(_forms, computed=True), euler_row()], open=False)


def _forms(view: View) -> Markup:
    element, language = inspected(view), view.seat.language
    if element is None:
        return html.note(ONLY_FRAMES[language])
    if element.pose is not None:
        forms = readout.forms_of_pose(element.pose(view.state), view.seat.notation.euler)
        return _written(forms, view.seat.notation.euler, language)
    drawn = readout.drawn_screw(view.state, element)
    if drawn is None:
        return html.note(ONLY_FRAMES[language])
    return _screw(drawn.screw, language, STILL_JOINT)


def _written(forms: PoseForms, convention: str, language: Language) -> Markup:
    q, half = forms.quaternion, forms.half_angle
    halves = HALVES.format(half=rounded_text(np.degrees(half), 2), sine=rounded_text(np.sin(half), 4))
    parts = [
        _screw(forms.screw, language, STILL),
        Markup("<p><b>{}</b> q = {}</p><p>{}</p>").format(
            QUATERNION[language], quaternion_words(q, language), halves[language]
        ),
        _table(DUAL, forms.dual_quaternion.reshape(2, 4), 4, language),
        _table(MATRIX, _in_mm(forms.matrix), 3, language),
        _euler(forms, convention, language),
    ]
    return Markup("<div class='helicoide-note helicoide-forms'>{}</div>").format(Markup("").join(parts))


def _in_mm(T: Array) -> Array:
    """A pose (4, 4), m, with its position in mm."""
    shown = T.copy()
    shown[:3, 3] *= 1000
    return shown


def quaternion_words(q: Array, language: Language) -> str:
    """A quaternion wxyz as w + x i + y j + z k, with four decimals; a line can break only between its terms."""
    w, *vector = (f"{value:+.4f}" for value in q + 0.0)
    words = w.removeprefix("+") + "".join(
        f" {x[0]}\u00a0{x[1:]}\u00a0{unit}" for x, unit in zip(vector, "ijk", strict=True)
    )
    return (words.replace(".", ",") if language == "pt_BR" else words).replace("-", "−")


def _screw(screw: ScrewDisplacement, language: Language, still: Text) -> Markup:
    slide, angle = 1000 * float(screw.displacement), float(np.degrees(screw.angle))
    said = {
        "slide": rounded_text(slide, 1),
        "direction": rounded_numbers(screw.direction, 3),
        "angle": rounded_text(angle, 2),
        "point": rounded_numbers(1000 * screw.point, 1),
    }
    if angle:
        h = 1000 * float(screw.pitch)
        words = TURNING.format(**said, pitch=PITCH.format(h=rounded_text(h, 1), lead=rounded_text(2 * np.pi * h, 1)))
    else:
        words = SLIDING.format(**said) if slide else still
    return Markup("<p><b>{}</b> {}</p>").format(SCREW[language], words[language])


def _euler(forms: PoseForms, convention: str, language: Language) -> Markup:
    angles = [f"{value}°" for value in _each(np.degrees(forms.euler.values), 2, language)]
    said = EULER.format(convention=convention_title(convention), angles="; ".join(angles))[language]
    words = Markup("<p>{}</p>").format(said)
    if not forms.near_singular:
        return words
    margin = rounded_text(float(np.degrees(forms.euler.singularity_margin)), 2)
    return words + Markup("<p class='helicoide-warning'>⚠ {}</p>").format(WARNING.format(margin=margin)[language])


def _table(title: Text, rows: Array, decimals: int, language: Language) -> Markup:
    cells = (
        Markup("<tr>{}</tr>").format(
            Markup("").join(Markup("<td>{}</td>").format(cell) for cell in _each(row, decimals, language))
        )
        for row in rows
    )
    table = Markup("<p><b>{}</b></p><div class='helicoide-stage'><table>{}</table></div>")
    return table.format(title[language], Markup("").join(cells))


def _each(values: Iterable[float], decimals: int, language: Language) -> list[str]:
    return [rounded_text(value, decimals)[language] for value in values]
