"""Forward kinematics joint by joint, as text and as JSON: DH rows or screws, and the frames they give."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import euler
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.stages import SOURCE_ANGLE, STAGES, JointStage, StageKind, in_source_units
from helicoide.text import LANGUAGES, Text, number_text, numbers_text

HEADS: dict[StageKind, Text] = {
    "dh": Text(
        en="{robot}: DH rows ({convention}) and the DH frames in {base}; {units}. The last is not the end-effector "
        "frame.",
        pt_BR="{robot}: linhas DH ({convention}) e referenciais DH em {base}; {units}. O último não é o do efetuador.",
    ),
    "screws": Text(
        en="{robot}: screws at q = 0 and displacements from there, H₁ … Hᵢ, axes of {base}; {units}.",
        pt_BR="{robot}: helicoides em q = 0 e deslocamentos a partir daí, H₁ … Hᵢ, eixos de {base}; {units}.",
    ),
    "products": Text(
        en="{robot}: screws at q = 0, dual quaternions h₁ … hᵢ (1, i, j, k | ε, iε, jε, kε), axes of {base}; {units}.",
        pt_BR="{robot}: helicoides em q = 0, quatérnios duais h₁ … hᵢ (1, i, j, k | ε, iε, jε, kε), eixos de {base}; "
        "{units}.",
    ),
}
CONVENTIONS = {
    "standard": Text(en="standard", pt_BR="padrão"),
    "modified": Text(en="modified", pt_BR="modificada"),
}
ENDS: dict[StageKind, Text] = {
    "dh": Text(
        en="Origin of the last frame: {place}. Roll, Pitch, Yaw (about z, y, x): {turns}.",
        pt_BR="Origem do último referencial: {place}. Roll, Pitch, Yaw (em torno de z, y, x): {turns}.",
    ),
    "screws": Text(
        en="The end effector, at {before} for q = 0, is at {place}. Roll, Pitch, Yaw (about z, y, x): {turns}.",
        pt_BR="O efetuador, em {before} para q = 0, está em {place}. Roll, Pitch, Yaw (em torno de z, y, x): {turns}.",
    ),
}
ENDS["products"] = ENDS["screws"]
SOURCE_UNITS, OWN_UNITS = "mm, °", "m, rad"
DECIMALS = {SOURCE_UNITS: 3, OWN_UNITS: 6}


@dataclass(frozen=True)
class StageTable:
    """A table as text: for each joint its parameters and the rows of a matrix or of eight coefficients."""

    head: Text
    joints: tuple[tuple[Text, tuple[tuple[Text, ...], ...]], ...]
    end: Text


def text_table(robot: Robot, q: Array, kind: StageKind, as_source: bool) -> StageTable:
    """The table of a posture q (n,), rad or m: each joint, then the pose at the end.

    as_source: in mm and degrees, else in m and rad.
    """
    units = SOURCE_UNITS if as_source else OWN_UNITS
    convention = CONVENTIONS[robot.dh.convention]
    places = DECIMALS[units]
    before, place, turns = (_numbers(numbers, places) for numbers in _end(robot, q, kind, as_source))
    return StageTable(
        HEADS[kind].format(robot=robot.name, convention=convention, base=robot.base_link, units=units),
        tuple(
            (_named(stage, places), tuple(_cells(row, places) for row in np.atleast_2d(stage.partial)))
            for stage in _stages(robot, q, kind, as_source)
        ),
        ENDS[kind].format(before=before, place=place, turns=turns),
    )


def stage_lines(robot: Robot, q: Array, kind: StageKind, as_source: bool) -> list[Text]:
    """The table as lines of text, with numbers aligned in columns."""
    found, width = text_table(robot, q, kind, as_source), 7 + DECIMALS[SOURCE_UNITS if as_source else OWN_UNITS]
    rows = [line for named, matrix in found.joints for line in (named, *(_aligned(row, width) for row in matrix))]
    return [found.head, *rows, found.end]


def stages_json(robot: Robot, q: Array, kind: StageKind, as_source: bool) -> dict[str, Any]:
    """The same as JSON, with a sentence that says between which frames each matrix or product transforms."""
    units = SOURCE_UNITS if as_source else OWN_UNITS
    before, place, turns = _end(robot, q, kind, as_source)
    return {
        "kind": kind,
        "units": units,
        "partial": {
            "dh": f"pose of DH frame i in {robot.base_link}; the last is not the end effector frame {robot.tool_link}",
            "screws": f"H_1 … H_i: displacement of link i from q = 0, axes of {robot.base_link}",
            "products": f"h_1 … h_i: the same as coefficients of 1, i, j, k, ε, iε, jε, kε, axes of {robot.base_link}",
        }[kind],
        "convention": robot.dh.convention if kind == "dh" else None,
        "joints": [_described(stage) for stage in _stages(robot, q, kind, as_source)],
        "tool_at_zero": before.tolist(),
        "position": place.tolist(),
        "roll_pitch_yaw": turns.tolist(),
    }


def _stages(robot: Robot, q: Array, kind: StageKind, as_source: bool) -> list[JointStage]:
    stages = STAGES[kind](robot, q)
    return [in_source_units(stage) for stage in stages] if as_source else stages


def _end(robot: Robot, q: Array, kind: StageKind, as_source: bool) -> tuple[Array, Array, Array]:
    """Tool position at q = 0 (3,), position at q (3,), and roll, pitch, yaw (3,) of the last frame or displacement."""
    length, angle = (1000.0, SOURCE_ANGLE) if as_source else (1.0, 1.0)
    last = STAGES["dh" if kind == "dh" else "screws"](robot, q)[-1].partial
    before = robot.T_world_tool_0[:3, 3]
    place = last[:3, 3] if kind == "dh" else last[:3, :3] @ before + last[:3, 3]
    turns = euler.euler_angles(last[:3, :3], euler.ROLL_PITCH_YAW).values
    return length * before, length * place, angle * turns


def _described(stage: JointStage) -> dict[str, Any]:
    lengths = {name: np.asarray(value).tolist() for name, value in stage.lengths.items()}
    direction = {} if stage.direction is None else {"s": stage.direction.tolist()}
    return {"joint": stage.joint, **stage.angles, **lengths, **direction, "partial": stage.partial.tolist()}


def _named(stage: JointStage, decimals: int) -> Text:
    """The name of a joint with its angles, lengths and direction."""
    angles = {name: np.asarray(value) for name, value in stage.angles.items()}
    named = angles | stage.lengths | ({} if stage.direction is None else {"s": stage.direction})
    said = [(name, _in_words(value, decimals)) for name, value in named.items()]
    return Text(
        en=f"{stage.joint}: " + ", ".join(f"{name} = {text.en}" for name, text in said),
        pt_BR=f"{stage.joint}: " + "; ".join(f"{name} = {text.pt_BR}" for name, text in said),
    )


def _numbers(values: Array, decimals: int) -> Text:
    return numbers_text(_rounded(values, decimals), f".{decimals}f")


def _in_words(value: Array, decimals: int) -> Text:
    """A number, or three in brackets."""
    text = _numbers(np.atleast_1d(value), decimals)
    return Text(en=f"({text.en})", pt_BR=f"({text.pt_BR})") if value.ndim else text


def _cells(row: Array, decimals: int) -> tuple[Text, ...]:
    return tuple(number_text(value, f".{decimals}f") for value in _rounded(row, decimals))


def _aligned(row: tuple[Text, ...], width: int) -> Text:
    english, portuguese = ([cell[language].rjust(width) for cell in row] for language in LANGUAGES)
    return Text(en=f"   [{' '.join(english)} ]", pt_BR=f"   [{' '.join(portuguese)} ]")


def _rounded(values: Array, decimals: int) -> Array:
    return np.asarray(np.round(values, decimals) + 0.0)  # + 0.0: no -0
