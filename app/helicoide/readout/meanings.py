"""What a coefficient is, in words for readers who know vectors, sines and cosines."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import motor, rigid
from helicoide.geometry.motor import ScrewDisplacement
from helicoide.readout.elements import Nature
from helicoide.readout.roles import Part, Role, role_of
from helicoide.text import Text, rounded_text

AXES = "xyz"
NO_SLIDE = 1e-5  # a translation smaller than this, m, is not mentioned
ZERO = Text(en="always 0 for this kind of object", pt_BR="sempre 0 para este tipo de objeto")
OPPOSITE = Text(
    en="{said} In this notation it has the opposite sign.",
    pt_BR="{said} Nesta notação ele tem o sinal oposto.",
)
INTRODUCTION = Text(
    en="A motor carries the base frame to this frame by one screw motion, like a nut on a bolt: a rotation by an angle "
    "φ about one line, the screw axis, and a translation d along that line. Its numbers use half the angle, φ/2. One "
    "says how far it turns, three which way the axis points, three where the axis is, and one how far it slides.",
    pt_BR="Um motor leva o referencial da base até este referencial por um só movimento helicoidal, como uma porca no "
    "parafuso: uma rotação de um ângulo φ em torno de uma reta, o eixo helicoidal, e uma translação d ao longo dela. "
    "Seus números usam a metade do ângulo, φ/2. Um diz quanto gira, três para onde o eixo aponta, três onde ele está e "
    "um quanto desliza.",
)
_WORDS: dict[Part, Text] = {
    "direction": Text(
        en="{axis} component of the unit vector v along the line.",
        pt_BR="Componente {axis} do vetor unitário v ao longo da reta.",
    ),
    "moment": Text(
        en="{axis} component of the moment u = r × v of the line: lever arm r from the origin to the line, times v. "
        "The length of u is the distance of the line from the origin, {distance} mm.",
        pt_BR="Componente {axis} do momento u = r × v da reta: braço de alavanca r, da origem à reta, vezes v. O "
        "comprimento de u é a distância da reta à origem, {distance} mm.",
    ),
    "normal": Text(
        en="{axis} component of the unit vector n perpendicular to the plane, towards the allowed side.",
        pt_BR="Componente {axis} do vetor unitário n perpendicular ao plano, para o lado permitido.",
    ),
    "offset": Text(
        en="Distance d of the plane from the origin, along its normal: {distance} mm.",
        pt_BR="Distância d do plano à origem, ao longo da normal: {distance} mm.",
    ),
    "weight": Text(
        en="Weight of the point: 1, so that the other coefficients are its coordinates.",
        pt_BR="Peso do ponto: 1, para que os outros coeficientes sejam suas coordenadas.",
    ),
    "coordinate": Text(
        en="Coordinate {axis} of the point: {distance} mm.",
        pt_BR="Coordenada {axis} do ponto: {distance} mm.",
    ),
    "cosine": Text(
        en="Cosine of half the angle of rotation: cos(φ/2) = cos {half}°, so the rotation is φ = {angle}°.",
        pt_BR="Cosseno da metade do ângulo de rotação: cos(φ/2) = cos {half}°; a rotação é φ = {angle}°.",
    ),
    "sine": Text(
        en="{axis} component of the direction of the screw axis, {component}, times the sine of half the angle, "
        "sin {half}° = {sine}.",
        pt_BR="Componente {axis} da direção do eixo helicoidal ({component}) vezes o seno da metade do ângulo: "
        "sen {half}° = {sine}.",
    ),
    "dual": Text(
        en="Says where the axis is. It is the {axis} component of the moment r × v of the axis, {moment} mm, times "
        "sin {half}°, plus half the translation, {slide} mm, times the {axis} component of the direction, {component}, "
        "times cos {half}°: together {value} m. The lever arm r leads from the origin to the axis, the unit vector v "
        "along it.",
        pt_BR="Diz onde está o eixo. É a componente {axis} do momento r × v do eixo ({moment} mm) vezes sen {half}°, "
        "mais metade da translação ({slide} mm) vezes a componente {axis} da direção ({component}) vezes cos {half}°: "
        "ao todo, {value} m. O braço de alavanca r vai da origem até o eixo; o vetor unitário v aponta ao longo dele.",
    ),
    "slide": Text(
        en="Half the translation along the axis, {slide} mm, times the sine of half the angle, sin {half}° = {sine}. "
        "It is 0 if the motion is a rotation alone.",
        pt_BR="Metade da translação ao longo do eixo, {slide} mm, vezes o seno da metade do ângulo, sen {half}° = "
        "{sine}. É 0 se o movimento é só uma rotação.",
    ),
}
ROTATED = Text(
    en="Says where the axis is. It is the {axis} component of the moment r × v of the axis, {moment} mm, times "
    "sin {half}°: {value} m. The lever arm r leads from the origin to the axis, the unit vector v along it.",
    pt_BR="Diz onde está o eixo. É a componente {axis} do momento r × v do eixo ({moment} mm) vezes sen {half}°: "
    "{value} m. O braço de alavanca r vai da origem até o eixo, e o vetor unitário v aponta ao longo dele.",
)
TRANSLATED = Text(
    en="Half the {axis} component of the translation, {way} mm: the motion does not turn.",
    pt_BR="Metade da componente {axis} da translação, {way} mm: o movimento não gira.",
)


def meaning(nature: Nature, values: Array, blade: str | None, sign: float = 1.0) -> Text:
    """What the coefficient of a blade of `CL031` is, with its numbers, in words.

    values: (16,) of `CL031`, m; sign: with which the stored coefficient is displayed.
    """
    role = role_of(nature, blade)
    if role is None:
        return ZERO
    said = _of_motor(motor.screw_from_motor(values), role) if nature == "motor" else _of_element(values, role)
    return OPPOSITE.format(said=said) if has_opposite_sign(role, sign) else said


def has_opposite_sign(role: Role, sign: float) -> bool:
    """Whether a coefficient that is displayed with this sign is the opposite of what its words say."""
    return sign * role.sign * (-1 if role.part == "slide" else 1) < 0


def _of_element(values: Array, role: Role) -> Text:
    match role.part:
        case "moment":
            distance = float(np.linalg.norm(rigid.direction_and_moment(values)[1]))
        case "offset":
            distance = float(rigid.normal_and_offset(values)[1])
        case "coordinate":
            distance = float(rigid.coordinates(values)[role.axis or 0])
        case _:
            distance = 0.0
    axis = "" if role.axis is None else AXES[role.axis]
    return _WORDS[role.part].format(axis=axis, distance=rounded_text(1000 * distance, 1))


def _of_motor(screw: ScrewDisplacement, role: Role) -> Text:
    i = role.axis or 0
    if screw.angle == 0 and role.part == "dual":
        way = 1000 * float((screw.displacement * screw.direction)[i])
        return TRANSLATED.format(axis=AXES[i], way=rounded_text(way, 1))
    half = float(screw.angle) / 2
    rotates = role.part == "dual" and abs(float(screw.displacement)) < NO_SLIDE
    component, moment = float(screw.direction[i]), float(np.cross(screw.point, screw.direction)[i])
    slide = float(screw.displacement) / 2
    return (ROTATED if rotates else _WORDS[role.part]).format(
        axis=AXES[i],
        half=rounded_text(float(np.degrees(half)), 2),
        angle=rounded_text(float(np.degrees(2 * half)), 2),
        sine=rounded_text(float(np.sin(half)), 3),
        component=rounded_text(component, 3),
        moment=rounded_text(1000 * moment, 1),
        slide=rounded_text(1000 * slide, 1),
        value=rounded_text(moment * float(np.sin(half)) + slide * component * float(np.cos(half)), 3),
    )
