"""States of an arm written to an MCAP file, one record after another; what does not change is written once."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any, BinaryIO

from mcap.writer import Writer
from rosbags.typesys.stores import ros2_humble as ros

from helicoide import __version__
from helicoide.readout import status, target_pose
from helicoide.recorder.markers import cloud_message, obstacle_markers, plane_markers
from helicoide.recorder.recorded_arm import recorded_arm
from helicoide.recorder.ros import definition_text, frame_message, joint_message, message_bytes, stamped_pose
from helicoide.state import State
from helicoide.text import Text

JOINTS, TOOL, TARGET, FRAMES, GOAL = "/joint_states", "/tool", "/target", "/tf", "/goal"
PLANES, OBSTACLES, CLOUDS, GRIPPER = "/planes", "/obstacles", "/clouds", "/gripper"
METHOD, STATUS, NOTICE = "/method", "/status", "/notice"
METADATA, EMPTY = "helicoide", Text(en="", pt_BR="")
WORDS_EVERY = 0.2  # s of the arm's own time between two looks at the status, which takes longer than the rest
Message = tuple[str, Any]


class StateFile:
    """An MCAP file of the states of one arm. began: the time of the first state, ns since 1970.

    A message's time is `began` plus the arm's own time since the first state. Raises OSError as the file does.
    """

    def __init__(self, file: BinaryIO, first: State, began: int) -> None:
        self.began, self.first = began, first
        self._before: State | None = None
        self._words_at = -WORDS_EVERY
        self._said: dict[str, str] = {}
        self._channels: dict[str, int] = {}
        self._kinds: dict[str, int] = {}
        self._writer = Writer(file, use_chunking=False)
        self._writer.start("ros2", f"helicoide {__version__}")
        self._writer.add_metadata(METADATA, {**recorded_arm(first.robot).to_metadata(), "began_s": repr(first.t)})

    def add(self, state: State) -> None:
        """Write a state: the posture, and what has changed since the state before."""
        ns = self.began + round((state.t - self.first.t) * 1e9)
        for topic, message in (*_posture(ns, state), *self._changes(ns, state)):
            self._writer.add_message(self._channel(topic, message.__msgtype__), ns, message_bytes(message), ns)
        self._before = state

    def finish(self) -> None:
        """Write the index and the end of the file."""
        self._writer.finish()

    def _changes(self, ns: int, state: State) -> Iterator[Message]:
        before = self._before
        if before is None or before.problem.planes is not state.problem.planes:
            yield PLANES, plane_markers(ns, state.problem.planes)
        if before is None or before.problem.obstacles is not state.problem.obstacles:
            yield OBSTACLES, obstacle_markers(ns, state.problem.obstacles)
        if before is None or before.arm.gripper != state.arm.gripper:
            yield GRIPPER, ros.std_msgs__msg__Float64(state.arm.gripper)
        goal = state.request.goal
        if goal is not None and (before is None or before.request.goal is not goal):
            yield GOAL, joint_message(ns, _names(state), goal.q, 0 * goal.q)
        for name, cloud in state.clouds.items():
            if before is None or before.clouds.get(name) is not cloud:
                yield f"{CLOUDS}/{name}", cloud_message(ns, cloud.points)
        yield from self._words(state)

    def _words(self, state: State) -> Iterator[Message]:
        """The method, the notice and the status, each when it changes; texts as JSON with both languages."""
        words = {METHOD: state.request.controller.method, NOTICE: _json(state.notice or EMPTY)}
        if abs(state.t - self.first.t - self._words_at) >= WORDS_EVERY:
            self._words_at = state.t - self.first.t
            words[STATUS] = _json(status(state).text)
        for topic, said in words.items():
            if self._said.get(topic) != said:
                self._said[topic] = said
                yield topic, ros.std_msgs__msg__String(said)

    def _channel(self, topic: str, kind: str) -> int:
        """The channel of a topic; its definition is written before its first message."""
        if topic not in self._channels:
            if kind not in self._kinds:
                self._kinds[kind] = self._writer.register_schema(kind, "ros2msg", definition_text(kind))
            self._channels[topic] = self._writer.register_channel(topic, "cdr", self._kinds[kind])
        return self._channels[topic]


def _posture(ns: int, state: State) -> Iterator[Message]:
    arm, T_world_tool = state.arm, state.T_world_tool
    yield JOINTS, joint_message(ns, _names(state), arm.q, arm.velocities)
    yield TOOL, stamped_pose(ns, T_world_tool)
    yield TARGET, stamped_pose(ns, target_pose(state))
    links = ("base", *(joint.link for joint in state.robot.joints))
    frames = [frame_message(ns, name, T) for name, T in zip(links, arm.poses, strict=True)]
    yield FRAMES, ros.tf2_msgs__msg__TFMessage([*frames, frame_message(ns, "tool", T_world_tool)])


def _names(state: State) -> list[str]:
    return [variable.name for variable in state.robot.variables]


def _json(text: Text) -> str:
    return json.dumps({"en": text.en, "pt_BR": text.pt_BR}, ensure_ascii=False)
