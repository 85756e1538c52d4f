"""Reading a robot file: its text, sums of its parameters, and errors."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from helicoide.files import text_file, toml
from helicoide.kinematics import robot_check
from helicoide.kinematics.robot_file import RobotFile
from helicoide.text import HelicoideError, Text, number_text

MOST_BYTES = 1_000_000
# Largest number allowed in the file, in mm, degrees or pulses; products of larger ones could overflow.
MAX_NUMBER = 1e9


def read_robot_file(path: Path, parameters: Mapping[str, float] | None = None) -> RobotFile:
    """Read a robot file, with some of its parameters (mm) changed; raises HelicoideError with place and reason."""
    try:
        table = toml.parse_toml(text_file.read_text(path, MOST_BYTES), _number)
        file = toml.table_to_struct(_with_parameters(table, parameters or {}), RobotFile)
        robot_check.check_robot_file(file)
    except HelicoideError as error:
        raise HelicoideError(
            Text(
                en="{path} is not a valid robot: {reason}. The robots that come with Helicoide are examples.",
                pt_BR="{path} não é um robô válido: {reason}. Os robôs que vêm com o Helicoide servem de exemplo.",
            ).format(path=path, reason=error.text)
        ) from error
    return file


def _number(words: str) -> float:
    if not abs(value := float(words)) <= MAX_NUMBER:
        raise HelicoideError(NO_NUMBER.format(number=words[:20], most=MAX_NUMBER))
    return value


def _with_parameters(table: dict[str, Any], changed: Mapping[str, float]) -> dict[str, Any]:
    """The table with each sum of parameters replaced by its value."""
    known = table.get("parameters", {})
    if not isinstance(known, dict) or not all(isinstance(value, int | float) for value in known.values()):
        return table
    for name in changed:
        if name not in known:
            raise HelicoideError(NO_PARAMETER.format(name=name, known=", ".join(known) or NONE))
    known = {**known, **changed}
    for name, value in known.items():
        if not 0 < value <= MAX_NUMBER:
            raise HelicoideError(
                NO_LENGTH.format(name=name, value=number_text(value, ".6g") if abs(value) < MAX_NUMBER else "?")
            )
    return {**_summed(table, known), "parameters": known}


def _summed(part: Any, known: Mapping[str, float]) -> Any:
    """A part of the file with each "l1 + l2" of known names replaced by its value."""
    match part:
        case dict():
            return {key: _summed(value, known) for key, value in part.items()}
        case list():
            return [_summed(value, known) for value in part]
        case int() if abs(part) > MAX_NUMBER:
            raise HelicoideError(NO_NUMBER.format(number=f"{part:#x}"[:20], most=MAX_NUMBER))
        case str() if known and all(name.strip() in known for name in part.split("+")):
            return sum(known[name.strip()] for name in part.split("+"))
        case _:
            return part


NO_NUMBER = Text(
    en="{number} is not a finite number up to {most:g}", pt_BR="{number} não é um número finito de até {most:g}"
)
NONE = Text(en="none", pt_BR="nenhum")
NO_PARAMETER = Text(
    en="there is no parameter {name}; parameters: {known}", pt_BR="não há parâmetro {name}; parâmetros: {known}"
)
NO_LENGTH = Text(
    en="parameter {name} must be a positive number of millimetres, not {value}",
    pt_BR="o parâmetro {name} deve ser um número positivo de milímetros, não {value}",
)
