"""The file of taught waypoints: readable TOML that keeps every number exactly."""

from __future__ import annotations

import json

import msgspec

from helicoide.files import text_file, toml
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text, untranslated
from helicoide.trajectory.waypoints import WaypointList, waypoint, with_waypoint

FORMAT = "helicoide waypoints 1"
MOST_BYTES = 1_000_000  # of thousands of waypoints
HEAD = """\
# Waypoints taught to a robot arm, in the order in which it visits them.
# q: joint values, rad, or m where a joint slides; way: joints, line or screw; dwell: how long it stays, s; gripper:
# open or closed from there on.
"""


class WaypointFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """One waypoint."""

    name: str
    q: tuple[float, ...]
    way: str = "joints"
    dwell: float = 0.0
    gripper: str = ""


class TaughtFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The whole file: the names of the robot and its joints, and the waypoints."""

    format: str
    robot: str
    joints: tuple[str, ...]
    waypoint: tuple[WaypointFile, ...] = ()


def encode_waypoints(taught: WaypointList) -> bytes:
    """The file of a list of waypoints."""
    lines = [
        f"format = {_quoted(FORMAT)}",
        f"robot = {_quoted(taught.robot.name)}",
        f"joints = [{', '.join(map(_quoted, _joints(taught.robot)))}]",
    ]
    for each in taught.waypoints:
        lines += [
            "",
            "[[waypoint]]",
            f"name = {_quoted(each.name)}",
            f"q = [{', '.join(repr(float(value)) for value in each.q)}]",
            f"way = {_quoted(each.move_type)}",
            f"dwell = {float(each.dwell)!r}",
            *([f"gripper = {_quoted(each.gripper)}"] if each.gripper else []),
        ]
    return (HEAD + "\n".join(lines) + "\n").encode()


def _quoted(words: str) -> str:
    """A TOML string: as in JSON, with DEL escaped as well."""
    return json.dumps(words, ensure_ascii=False).replace("\x7f", "\\u007f")


def _joints(robot: Robot) -> tuple[str, ...]:
    return tuple(joint.name for joint in robot.variables)


def decode_waypoints(content: bytes, robot: Robot) -> WaypointList:
    """The list of waypoints in a file for an arm; raises HelicoideError for an invalid file or another robot's."""
    file = _read(content)
    if file.robot != robot.name:
        raise HelicoideError(
            Text(
                en="These waypoints were taught to {other}, and this robot is {robot}.",
                pt_BR="Estes pontos foram ensinados ao robô {other}, e este é o {robot}.",
            ).format(other=file.robot, robot=robot.name)
        )
    if file.joints != _joints(robot):
        raise HelicoideError(
            Text(
                en="These waypoints were taught to a {robot} with the joints {theirs}; this one has {ours}.",
                pt_BR="Estes pontos foram ensinados a um {robot} com as juntas {theirs}; este tem {ours}.",
            ).format(robot=robot.name, theirs=", ".join(file.joints), ours=", ".join(_joints(robot)))
        )
    taught = WaypointList(robot)
    for each in file.waypoint:
        new = waypoint(robot, each.name, each.q, each.way, each.dwell, each.gripper)
        taught = with_waypoint(taught, len(taught.waypoints), new)
    return taught


def _read(content: bytes) -> TaughtFile:
    try:
        table = toml.parse_toml(text_file.decode_utf8(content, MOST_BYTES))
        if table.get("format") != FORMAT:
            raise HelicoideError(
                Text(
                    en="its format must be {format!r}, not {found}", pt_BR="o format deve ser {format!r}, não {found}"
                ).format(format=FORMAT, found=_shown(table.get("format")))
            )
        return toml.table_to_struct(table, TaughtFile)
    except HelicoideError as error:
        raise HelicoideError(
            Text(
                en="This is not a waypoint file. A waypoint file has format, robot and joints, and one [[waypoint]] "
                "with name and q per waypoint: {reason}.",
                pt_BR="Este não é um arquivo de pontos. Um arquivo de pontos tem format, robot e joints, e um "
                "[[waypoint]] com name e q por ponto: {reason}.",
            ).format(reason=error.text)
        ) from error


def _shown(found: object) -> Text:
    if isinstance(found, str):
        return untranslated(repr(found))
    return Text(en="something else or nothing", pt_BR="outra coisa, ou nada")
