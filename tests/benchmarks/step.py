"""One step of a closed loop under joint and speed limits, without planes and with three, beside QP libraries."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from tests.benchmarks.course import DT, STEPS, Course
from tests.benchmarks.ik_turns import faster, in_turn, judged, line, or_left_out, taking_part, turn_of
from tests.benchmarks.peers import Child, Peer

from helicoide.arrays import Array
from helicoide.confinement import signed_distances
from helicoide.kinematics.library import load_robot

PEERS = (
    Peer("pin-pink", "with_pink_ik.py", also=("daqp",)),
    Peer("mink", "with_mink_ik.py", also=("daqp",)),
    Peer("placo", "with_placo_ik.py", pins="peers_placo.txt"),
    Peer("dqrobotics", "with_dqrobotics_ik.py", also=("quadprog",)),
)
# Franka's own posture to start from, for the one that the URDF of the Panda does not name; None is `ready`.
STARTS = {"puma560": None, "panda": np.radians([0.0, -45.0, 0.0, -135.0, 0.0, 90.0, 45.0])}
LENGTH, ROUNDS = 50, 3
# How many times as fast as whom, without planes and with them.
GOALS = {("pin-pink", False): 20.0, ("placo", True): 30.0}
# Theirs may follow another way within the same limits: dqrobotics weighs dual quaternions, not metres and radians.
ALIKE, ROUNDING = 0.05, 1e-9
TITLE = "One step of a closed loop under limits and planes, beside libraries that solve it as a quadratic programme"
HOW = (
    "100 Hz, three laps of a circle; every step takes an eighth of what is missing of the pose, 1 m as much as 1 rad,",
    "with damping 10⁻⁶, under the joint limits and speed limits; planes are velocity dampers (10 / s) on the centre of",
    "every joint and on the tool, z from below and x and y across the circle. Ours is `step(arm, q, T, ahead, dt, …)`",
    "and a copy of q, from Python; theirs is the library's own loop, with planes as one vectorised limit.",
)


@dataclass(frozen=True)
class Way:
    """What a closed loop kept of what it should: distances and excesses, m, rad, rad/s, and how well it followed."""

    nearest: float
    beyond_limits: float
    beyond_speed: float
    rms: float

    @property
    def holds(self) -> bool:
        return self.nearest >= -ROUNDING and max(self.beyond_limits, self.beyond_speed) <= ROUNDING

    def __str__(self) -> str:
        nearest = "" if np.isinf(self.nearest) else f", {1000 * self.nearest:.4f} mm from the planes"
        kept = "limits kept" if max(self.beyond_limits, self.beyond_speed) <= ROUNDING else "LIMITS BROKEN"
        return f"rms {1000 * self.rms:.2f} mm{nearest}, {kept}"


def _way(course: Course, qs: Array) -> Way:
    """What one closed loop, (steps, n), rad, kept."""
    robot, steps = course.robot, np.diff([course.q_start, *qs], axis=0)
    tools = np.array([course.points(q)[-1] for q in qs])
    normals, offsets, _ = course.planes
    nearest = min(
        (signed_distances(normals, offsets, course.points(q)).min(initial=np.inf) for q in qs), default=np.inf
    )
    return Way(
        float(nearest),
        float(max((robot.lower - qs).max(), (qs - robot.upper).max())),
        float((np.abs(steps) / DT - robot.speed).max()),
        float(np.sqrt(np.mean(np.sum((tools - course.targets[:, :3, 3]) ** 2, axis=1)))),
    )


def _compare(course: Course, child: Child) -> None:
    child.ask({"given": course.given()})
    runs = in_turn(course.turn(), turn_of(child), STEPS, LENGTH, ROUNDS)
    qs = [np.array(run.answers[-STEPS:]) for run in runs]
    ways = [_way(course, q) for q in qs]
    for who, run, way in zip(("ours", child.name), runs, ways, strict=True):
        line(who, run, str(way))
    figure = f"{course}, beside {child.name}"
    apart, rms = float(np.abs(qs[0] - qs[1]).max()), ways[1].rms / ways[0].rms
    judged(f"{figure}: both keep limits and planes", all(way.holds for way in ways))
    said = f"joints apart by at most {apart:.1e} rad, their rms is {rms:.3f} of ours"
    judged(f"{figure}: {said}", abs(rms - 1) <= ALIKE)
    faster(figure, *runs, GOALS.get((child.name, course.is_confined)))


def run() -> None:
    print("\n".join(f"  {said}" for said in HOW))
    with taking_part(PEERS) as children:
        for name, start in STARTS.items():
            robot = load_robot(name)
            for is_confined in (False, True):
                course = Course(robot, robot.poses["ready"] if start is None else start, is_confined)
                print(f"  {course}")
                for child in children:
                    with or_left_out(child, str(course)):
                        _compare(course, child)
