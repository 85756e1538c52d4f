"""How Cerbaro 2022, chapter 6, measured the enclosure with a depth camera on the hand.

A plane is fitted to all points near it, or taken through three of them as in the source. Both are compared.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.geometry import rigid
from helicoide.ik.method import Quantity
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.perception.camera import D435, Camera, SimulatedCamera, hand_camera_pose
from helicoide.perception.enclosure_reading import OUTLIERS, PLANE_READINGS, PlaneReading
from helicoide.perception.planes import ANGLE, FoundPlane, find_plane
from helicoide.state import State, initial_state
from helicoide.studies.study import Chart, ChartLine, Motion, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="Measuring the enclosure", pt_BR="A medição do recinto")
SOURCE = "Cerbaro 2022, §5.2.6, 6.1, 6.2.1, eqs. 25–30, figs. 44, 46"
ROBOT = "movemaster"
ABOUT = Text(
    en="In three postures a depth camera on the hand measures the ceiling and two walls. The source searches for a "
    "plane whose normal is within 4° of a reference normal. It then takes the plane through three random points among "
    "those near the plane found. Here a simulated camera measures the planes that the source prints; most of the "
    "numbers are therefore our own. The source does not give the position of its depth camera. Two positions are "
    "compared: the one that we assume, and that of another camera of the source, the T265, which measures its own "
    "motion (odometry).",
    pt_BR="Em três posturas, uma câmera de profundidade na mão mede o teto e duas paredes. A fonte procura um plano "
    "cuja normal esteja a até 4° de uma normal de referência. Depois adota o plano que passa por três pontos "
    "aleatórios entre os que estão próximos do plano encontrado. Aqui uma câmera simulada mede os planos impressos na "
    "fonte; por isso, quase todos os números são nossos. A fonte não informa a posição da sua câmera de profundidade. "
    "Comparam-se duas posições: a que adotamos e a de uma segunda câmera da fonte, a T265, que mede o próprio "
    "movimento (odometria).",
)
# The same camera at the position of the T265 of the source: 37.5 mm behind the tool point and 62.5 mm above its axis.
ON_BRACKET = replace(D435, T_tool_camera=hand_camera_pose(behind=0.0375, above=0.0625))
# Clouds per wall and camera position in a full and in a short run; triples of points drawn from each cloud.
CLOUDS, CLOUDS_SHORT, TRIPLES = 15, 3, 2000
# Largest angles to the reference normal, °, that are tried in the search; a chart shows how many planes each finds.
TRIED = (2, 3, 4, 5, 6, 8, 10, 15, 20, 25)

# The example of eqs. 27 to 30: three points, and the coefficients of their plane for e₁, e₂, e₃ and e.
POINTS = np.array([(1.0, 2.0, 3.0), (2.0, -2.0, 3.0), (-1.0, 1.0, 0.0)])
PLANE = np.array([-0.7845, -0.1961, 0.5883, 0.5883])
ITS_PLANE = Statement(
    Text(en="its plane, to four decimals", pt_BR="o seu plano, com quatro decimais"),
    "§5.2.6, eqs. 27–30",
    0.0,
    "=",
    5e-5,
)


@dataclass(frozen=True)
class Options:
    """Camera parameters that the source does not give."""

    noise: Annotated[float, Quantity(Text(en="noise of the depth", pt_BR="ruído da profundidade"), 0.0, 20.0, "mm")] = (
        2.0
    )


@dataclass(frozen=True, eq=False)
class CloudReadings:
    """Planes found in k clouds of one wall. A tilt is the angle to the true wall.

    tilts (k,), °: of the planes fitted to all points; shares (k,), %: points of the cloud on these planes; of_three
    (t,), °: tilts of all planes through three random points.
    """

    tilts: Array
    shares: Array
    of_three: Array


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Measure each plane in `CLOUDS` simulated clouds for each camera position; in a short run in `CLOUDS_SHORT`."""
    clouds = CLOUDS_SHORT if short else CLOUDS
    jobs = [(camera, reading) for camera in (D435, ON_BRACKET) for reading in PLANE_READINGS]
    read = []
    for i, (camera, reading) in enumerate(jobs):
        read.append(_read(camera, reading, options.noise / 1000, clouds))
        progress((i + 1) / (len(jobs) + 1))
    found = _found(options.noise / 1000)
    progress(1.0)
    here, bracket = read[:3], read[3:]
    rows = (eq_25_row(), *_search(found), *_computed_rows(here, bracket))
    charts = (_tilts(here), _by_angle(found), _places(here, bracket))
    return Result(rows, charts, (_tour(),))


def posed_state(pose: str) -> State:
    """The state of the arm in a named posture, between the planes that the source prints."""
    state = initial_state(load_robot(ROBOT))
    q = state.robot.poses[pose]
    return replace(state, arm=replace(state.arm, q=q, poses=frozen(link_poses(state.robot.chain, q))))


def wall_of(reading: PlaneReading) -> PlanePane:
    """The wall that a reading measures, as the source prints it."""
    return next(pane for pane in load_robot(ROBOT).panes if pane.name == reading.name)


def detected_plane(
    camera: Camera, reading: PlaneReading, noise: float, angle: float, seed: int
) -> tuple[Array, FoundPlane | None]:
    """Simulate a cloud of a wall and find the plane in it. Returns the points (k, 3), m, and the plane or None.

    noise: standard deviation of the depth, m; angle: largest one between normal and reference normal, rad.
    """
    state = posed_state(reading.pose)
    points = SimulatedCamera(camera, noise=noise, outliers=OUTLIERS, seed=seed).cloud(state).points
    found = find_plane(points, reading.normal, state.T_world_tool[:3, 3], angle=angle, seed=seed)
    return points, found if isinstance(found, FoundPlane) else None


def tilt(normal: Array, other: Array) -> Array:
    """Angles, °, from 0 to 90, between unit normals (..., 3) and another one (3,), whatever their signs."""
    return np.asarray(np.degrees(np.arccos(np.minimum(1.0, np.abs(normal @ other)))))


def three_point_normals(points: Array, seed: int) -> Array:
    """Unit normals (n, 3) of planes through three random points of a cloud (k, 3), m, eqs. 25–26; n ≤ `TRIPLES`.

    Three points on a line, or with a repeated point, define no plane and are left out.
    """
    triples = points[np.random.default_rng(seed).integers(len(points), size=(TRIPLES, 3))]
    planes = rigid.plane_through(*np.moveaxis(rigid.point(triples), 1, 0))
    return np.asarray(rigid.normal_and_offset(planes[planes.any(axis=1)])[0])


def _read(camera: Camera, reading: PlaneReading, noise: float, clouds: int) -> CloudReadings:
    wall, tilts, shares, of_three = wall_of(reading).normal, [], [], []
    for seed in range(clouds):
        points, found = detected_plane(camera, reading, noise, ANGLE, seed)
        if found is not None:
            tilts.append(float(tilt(found.plane.normal, wall)))
            shares.append(100 * found.share)
            of_three.append(tilt(three_point_normals(points[found.on_plane], seed), wall))
    return CloudReadings(np.array(tilts), np.array(shares), np.concatenate(of_three))


def _found(noise: float) -> Array:
    """How many of the three planes are found with each search angle of `TRIED`, (a,). noise: σ of the depth, m."""
    return np.array(
        [
            sum(detected_plane(D435, reading, noise, angle, 0)[1] is not None for reading in PLANE_READINGS)
            for angle in np.radians(TRIED)
        ]
    )


def eq_25_row() -> Row:
    """The plane by eqs. 25 and 26, compared with the one printed in the example of the source."""
    normal, offset = rigid.normal_and_offset(rigid.plane_through(*rigid.point(POINTS)))
    quantity = Text(
        en="plane through the three points of eq. 27: largest difference of a coefficient",
        pt_BR="plano pelos três pontos da eq. 27: maior diferença de um coeficiente",
    )
    return Row(quantity, float(np.abs(np.append(normal, offset) - PLANE).max()), "", ITS_PLANE)


def _search(found: Array) -> list[Row]:
    """Rows with the tilt of each plane that the source prints, and the number of planes found within 4° and 10°."""
    printed_tilt = Text(
        en="printed plane, {wall}: tilt from the reference normal",
        pt_BR="plano impresso, {wall}: inclinação em relação à normal de referência",
    )
    within = Text(
        en="planes found within {angle}° of the reference normal",
        pt_BR="planos achados a até {angle}° da normal de referência",
    )
    counts = dict(zip(TRIED, found, strict=True))
    return [
        *(
            Row(printed_tilt.format(wall=reading.title), float(tilt(wall_of(reading).normal, reading.normal)), "°")
            for reading in PLANE_READINGS
        ),
        *(Row(within.format(angle=angle), int(counts[angle])) for angle in (4, 10)),
    ]


def _computed_rows(here: list[CloudReadings], bracket: list[CloudReadings]) -> list[Row]:
    kinds = (
        (Text(en="fit to all points, median tilt", pt_BR="ajuste a todos os pontos, inclinação mediana"), 50, "tilts"),
        (Text(en="three random points, median tilt", pt_BR="três pontos ao acaso, inclinação mediana"), 50, "of_three"),
        (Text(en="three random points, 95 % below", pt_BR="três pontos ao acaso, 95 % abaixo de"), 95, "of_three"),
    )
    rows = [
        Row(OF_WALL.format(wall=reading.title, what=what), float(np.percentile(getattr(read, which), share)), "°")
        for what, share, which in kinds
        for reading, read in zip(PLANE_READINGS, here, strict=True)
    ]
    for read, place in ((here, BEHIND), (bracket, AT_T265)):
        left = PLANE_READINGS[1].title
        share = Text(en="points on it, {place}", pt_BR="pontos nela, {place}").format(place=place)
        turned = Text(en="median tilt, {place}", pt_BR="inclinação mediana, {place}").format(place=place)
        rows.append(Row(OF_WALL.format(wall=left, what=share), float(np.median(read[1].shares)), "%"))
        rows.append(Row(OF_WALL.format(wall=left, what=turned), float(np.median(read[1].tilts)), "°"))
    return rows


OF_WALL = Text(en="{wall}: {what}", pt_BR="{wall}: {what}")
BEHIND = Text(en="camera 200 mm behind the end effector", pt_BR="câmera 200 mm atrás do efetuador")
AT_T265 = Text(en="camera where the T265 is", pt_BR="câmera no lugar da T265")
SHARE_OF_DRAWS = Text(en="share of the draws (%)", pt_BR="fração dos sorteios (%)")
TILTED = Text(en="tilt from the wall (°)", pt_BR="inclinação em relação à parede (°)")


def _spread(title: Text, tilts: Array) -> ChartLine:
    """The percentile curve of tilts, °: the tilt below which 1 %, 2 %, ..., 99 % of them lie."""
    shares = np.linspace(1, 99, 99)
    return ChartLine(title, shares, np.asarray(np.percentile(tilts, shares)))


def _tilts(here: list[CloudReadings]) -> Chart:
    three = Text(en="{wall}, three points", pt_BR="{wall}, três pontos")
    fit = Text(en="{wall}, fit to all", pt_BR="{wall}, ajuste a todos")
    named = list(zip(PLANE_READINGS, here, strict=True))
    lines = [_spread(three.format(wall=reading.title), read.of_three) for reading, read in named]
    lines += [_spread(fit.format(wall=reading.title), read.tilts) for reading, read in named]
    title = Text(en="How far measured planes tilt", pt_BR="Quanto se inclinam os planos medidos")
    return Chart(title, SHARE_OF_DRAWS, TILTED, tuple(lines), log=True)


def _by_angle(found: Array) -> Chart:
    line = ChartLine(Text(en="planes found", pt_BR="planos achados"), np.array(TRIED, dtype=float), found.astype(float))
    title = Text(en="Planes found, of three", pt_BR="Planos achados, de três")
    across = Text(en="largest angle to the reference normal (°)", pt_BR="maior ângulo com a normal de referência (°)")
    return Chart(title, across, Text(en="planes", pt_BR="planos"), (line,))


def _places(here: list[CloudReadings], bracket: list[CloudReadings]) -> Chart:
    lines = (_spread(BEHIND, here[1].tilts), _spread(AT_T265, bracket[1].tilts))
    title = Text(en="The left wall from two places of the camera", pt_BR="A parede esquerda de dois lugares da câmera")
    return Chart(title, SHARE_OF_DRAWS, TILTED, lines)


def _tour() -> Motion:
    """A motion from `ready` through the three reading postures and back, three seconds from each to the next."""
    poses = load_robot(ROBOT).poses
    stops = np.array([poses[name] for name in ("ready", *(reading.pose for reading in PLANE_READINGS), "ready")])
    times = np.linspace(0.0, 3.0 * (len(stops) - 1), 121)
    q = np.stack([np.interp(times, 3.0 * np.arange(len(stops)), joint) for joint in stops.T], axis=1)
    title = Text(en="the three readings", pt_BR="as três leituras")
    return Motion(ROBOT, times, q, title=title)


__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]
