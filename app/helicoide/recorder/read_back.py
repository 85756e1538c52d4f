"""A recording on an arm: the path of its tool and the distances to the planes, computed from the recorded joints.

This is the evaluation of Cerbaro 2022, figs. 50 to 52: what the encoders counted goes through the forward kinematics.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.goal import pose_of_tool
from helicoide.kernels import python_function
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.readout.distances import distances_of
from helicoide.readout.signals.distances import LEAST, SAFETY, WARNING
from helicoide.recorder.recorded_arm import chain_digest, columns_for
from helicoide.recorder.recording import JointSamples, Recording
from helicoide.state import State, points_on
from helicoide.studies.study import Chart, ChartLine
from helicoide.text import Text, untranslated

POINTS = 400
TIME, DISTANCE = Text(en="time [s]", pt_BR="tempo [s]"), Text(en="distance [mm]", pt_BR="distância [mm]")


@dataclass(frozen=True, eq=False)
class ReadBack:
    """A recording on an arm with the same joints. samples, setpoints: with the joints in the order of the arm.

    digest: of the arm's chain; trail, sent_trail: positions of the tool, (m, 3), m, read back and sent; chart: the
    distances to the planes, None without planes.
    """

    recording: Recording
    digest: str
    samples: JointSamples
    trail: Array
    sent_trail: Array | None
    chart: Chart | None

    def fits(self, robot: Robot) -> bool:
        """Whether a robot has the same chain."""
        return digest_of(robot) == self.digest


@lru_cache(maxsize=8)
def digest_of(robot: Robot) -> str:
    """`chain_digest`, computed once for each robot."""
    return chain_digest(robot)


def read_back(recording: Recording, state: State) -> ReadBack:
    """The recording on the arm of a state, beside its own planes or, if it has none, those of the state.

    Raises HelicoideError if the recording is of another arm.
    """
    robot = state.robot
    columns = columns_for(recording.arm, robot, recording.title)
    samples = recording.samples.taken(columns)
    sent = recording.setpoints and recording.setpoints.taken(columns)
    times, poses = _thinned(robot, samples)
    return ReadBack(
        recording,
        digest_of(robot),
        samples,
        _trail(state, poses),
        None if sent is None else _trail(state, _thinned(robot, sent)[1]),
        _distances(recording, state, times, poses),
    )


def poses_at(robot: Robot, samples: JointSamples, time: float) -> Array:
    """The link poses (m + 1, 4, 4), m, at a time, s."""
    return np.asarray(python_function(link_poses)(robot.chain, samples.q_at(time)))


def _thinned(robot: Robot, samples: JointSamples) -> tuple[Array, Array]:
    """Times (k,), s, and link poses (k, m + 1, 4, 4), m, of at most `POINTS` samples, evenly spaced."""
    count = len(samples.times)
    kept = np.unique(np.linspace(0, count - 1, min(count, POINTS)).round().astype(int))
    return samples.times[kept], np.array([python_function(link_poses)(robot.chain, q) for q in samples.q[kept]])


def _trail(state: State, poses: Array) -> Array:
    return frozen([pose_of_tool(state.problem, one)[:3, 3] for one in poses])


def _distances(recording: Recording, state: State, times: Array, poses: Array) -> Chart | None:
    """The distance of each plane from the nearest monitored point over time, mm, with both distances of the zones."""
    nearest = dict[str, Array]()
    for row, (time, at) in enumerate(zip(times, poses, strict=True)):
        planes = recording.planes_at(time) or state.problem.planes
        around = replace(state, problem=replace(state.problem, planes=planes))
        for pane, distance in zip(
            planes.panes, distances_of(around, points_on(state.robot, at)).min(axis=0), strict=True
        ):
            nearest.setdefault(pane.name, np.full(len(times), np.nan))[row] = 1000 * distance
    if not nearest:
        return None
    titles = {pane.name: pane.title for pane in (*state.problem.planes.panes, *state.robot.panes)}
    zones = state.problem.zones
    lines = [ChartLine(titles.get(name, untranslated(name)), times, values) for name, values in nearest.items()]
    for title, distance in ((SAFETY, zones.critical), (WARNING, zones.warning)):
        lines.append(ChartLine(title, times[[0, -1]], np.full(2, 1000 * distance)))
    return Chart(LEAST, TIME, DISTANCE, tuple(lines))
