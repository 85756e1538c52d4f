"""What the messages of a file contain: JointState, those of Cerbaro's Movemaster, and those of our own recordings."""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array, frozen
from helicoide.confinement import Planes
from helicoide.geometry import rotation
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.recorder import mcap_file, movemaster
from helicoide.recorder.joint_log import MOST_SAMPLES, TOO_MANY, JointLog
from helicoide.recorder.movemaster import MovemasterLog
from helicoide.recorder.recorded_arm import RecordedArm, from_metadata
from helicoide.recorder.recording import JointSamples, Recording
from helicoide.recorder.ros import JOINT_STATE, SETPOINT, STATUS
from helicoide.text import HelicoideError, Text, untranslated

KINDS = {JOINT_STATE, SETPOINT, STATUS}
OWN_TOPICS = {
    mcap_file.TOOL,
    mcap_file.TARGET,
    mcap_file.PLANES,
    mcap_file.GRIPPER,
    mcap_file.METHOD,
    mcap_file.STATUS,
}
MOST_PLANES, FARTHEST_PLANE = 200, 1e4  # m
NOTHING = Text(
    en="there are no two samples of joints in it; read are sensor_msgs/JointState, movemaster_msg/setpoint and "
    "movemaster_msg/status",
    pt_BR="não há nele duas amostras de juntas; são lidas as mensagens sensor_msgs/JointState, movemaster_msg/setpoint "
    "e movemaster_msg/status",
)
UNMOVED = Text(en="the arm did not move while it was recorded", pt_BR="o braço não se moveu enquanto era gravado")
LEFT_OUT = Text(
    en="Left out, without usable joint values or with the time of another: {n} of {all} samples.",
    pt_BR="Descartadas, sem valores úteis de junta ou com o instante de outra: {n} de {all} amostras.",
)


class Gathering:
    """The content of a file. title: the name of the file; own: the arm that one of our own recordings names."""

    def __init__(self, title: str) -> None:
        self.title = title
        self.own: RecordedArm | None = None
        self._joints: dict[tuple[str, tuple[str, ...]], JointLog] = {}
        self._movemaster = MovemasterLog()
        self._others = defaultdict[str, list[tuple[int, Any]]](list)

    def describe(self, metadata: Mapping[str, str]) -> None:
        """Take the metadata of one of our own recordings."""
        self.own = from_metadata(metadata)

    def wants(self, topic: str, kind: str) -> bool:
        """Whether `add` takes the messages of a topic."""
        return kind in KINDS or (self.own is not None and topic in OWN_TOPICS)

    def add(self, topic: str, kind: str, ns: int, message: Any) -> None:
        """Take a message and its time, ns. Raises HelicoideError if there are too many."""
        if kind == JOINT_STATE:
            names = tuple(message.name)
            log = self._joints.setdefault((topic, names), JointLog(names))
            log.add(ns, message.position, message.velocity)
        elif kind == SETPOINT:
            self._movemaster.add_setpoint(ns, message)
        elif kind == STATUS:
            self._movemaster.add_status(topic, ns, message)
        else:
            others = self._others[topic]
            if len(others) >= MOST_SAMPLES:
                raise HelicoideError(TOO_MANY)
            others.append((ns, _content(topic, message)))

    def recording(self, *notes: Text) -> Recording:
        """The recording. Raises HelicoideError if there are fewer than two samples of joints."""
        arm, log, setpoints = self._measured()
        kept = log.kept()
        if len(kept) < 2:
            raise HelicoideError(NOTHING if self.own is None else UNMOVED)
        ns = np.array(log.ns, dtype=np.int64)[kept]
        start, left_out = int(ns[0]), len(log.ns) - len(kept)
        if left_out:
            notes = (*notes, LEFT_OUT.format(n=left_out, all=len(log.ns)))

        def since(topic: str) -> tuple[tuple[float, Any], ...]:
            return tuple(((at - start) / 1e9, content) for at, content in self._others[topic])

        return Recording(
            self.title,
            arm,
            log.samples(start),
            None if setpoints is None else _sent(setpoints, start),
            _aligned(self._others[mcap_file.TOOL], ns),
            _aligned(self._others[mcap_file.TARGET], ns),
            since(mcap_file.PLANES),
            since(mcap_file.GRIPPER),
            since(mcap_file.METHOD),
            since(mcap_file.STATUS),
            notes,
        )

    def _measured(self) -> tuple[RecordedArm, JointLog, JointLog | None]:
        """The arm, its joint values and its setpoints: of the topic with the most samples, else of the Movemaster.

        Setpoints alone stand for the joint values.
        """
        if self.own is not None and (own := self._joints.get((mcap_file.JOINTS, self.own.joints))) is not None:
            return self.own, own, None
        if self._joints:
            log = max(self._joints.values(), key=lambda log: len(log.ns))
            return RecordedArm(log.names), log, None
        counted, sent = self._movemaster.read_back, self._movemaster.setpoints
        arm = RecordedArm(self._movemaster.names, movemaster.ROBOT)
        return (arm, counted, sent) if len(counted.ns) > 1 else (arm, sent, None)


def _sent(setpoints: JointLog, start: int) -> JointSamples | None:
    samples = setpoints.samples(start)
    return samples if len(samples.times) else None


def _content(topic: str, message: Any) -> Any:
    """What is kept of a message of our own recordings."""
    if topic in (mcap_file.TOOL, mcap_file.TARGET):
        p, q = message.pose.position, message.pose.orientation
        return [p.x, p.y, p.z, q.w, q.x, q.y, q.z]
    if topic == mcap_file.PLANES:
        return _planes(message)
    if topic == mcap_file.GRIPPER:
        return min(max(float(message.data), 0.0), 1.0)
    if topic == mcap_file.STATUS:
        said = json.loads(message.data)
        return Text(en=str(said["en"]), pt_BR=str(said["pt_BR"]))
    return str(message.data)


def _planes(message: Any) -> Planes:
    """The planes of a message: of each marker that is drawn, its z axis, its position and its extent.

    Raises ValueError for planes that cannot be drawn: too many, or not of finite numbers.
    """
    drawn = [marker for marker in message.markers if marker.action == type(marker).ADD]
    centres = frozen([[m.pose.position.x, m.pose.position.y, m.pose.position.z] for m in drawn]).reshape(-1, 3)
    turns = [[getattr(m.pose.orientation, part) for part in "wxyz"] for m in drawn]
    normals = frozen([rotation.to_matrix(np.array(turn))[:, 2] for turn in turns]).reshape(-1, 3)
    sizes = np.array([[m.scale.x, m.scale.y] for m in drawn]).reshape(-1, 2)
    lengths = np.linalg.norm(normals, axis=1)
    near = (np.abs(np.hstack([centres, sizes])) < FARTHEST_PLANE).all()  # not NaN either
    if len(drawn) > MOST_PLANES or not near or not (np.abs(lengths - 1) < 1e-6).all():
        raise ValueError("no planes")
    panes = tuple(
        PlanePane(m.ns, untranslated(m.ns), normal, float(normal @ centre), centre, (m.scale.x, m.scale.y), False)
        for m, normal, centre in zip(drawn, normals, centres, strict=True)
    )
    return Planes(normals, centres, panes)


def _aligned(poses: list[tuple[int, Any]], ns: NDArray[np.int64]) -> Array | None:
    """The poses at the times of the samples, (k, 7); NaN where a sample has none, None if no sample has one."""
    if not poses:
        return None
    known = dict(poses)
    return frozen([known.get(int(at), [np.nan] * 7) for at in ns])
