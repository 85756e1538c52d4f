"""How the enclosure of chapter 6 was measured: planes in clouds of a camera on the hand, by all points or by three."""

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
    en="From three postures a depth camera on the hand reads ceiling and walls. A plane is sought whose normal is "
    "within 4° of a reference, and the source then takes the plane through three random points of those near it. Here "
    "the scene holds the planes that it prints, and a simulated camera reads them, so that most of what is counted is "
    "ours. Where its camera sat the source does not say: two places are compared, ours and "
    "that of its other camera, the T265, which tells how far it has moved itself (odometry).",
    pt_BR="De três posturas, uma câmera de profundidade na mão lê teto e paredes. Procura-se um plano cuja normal "
    "fique a até 4° de uma de referência, e a fonte o faz passar depois por três pontos aleatórios dos que estão perto "
    "dele. Aqui a cena tem os planos que ela imprime, lidos por uma câmera simulada, e por isso quase tudo o que se "
    "conta é nosso. Onde ficava a câmera a fonte não diz: comparam-se dois lugares, o nosso e o "
    "da outra câmera da fonte, a T265, que mede o próprio movimento (odometria).",
)
# The camera where the source has the T265, which tells how far it moved: 37.5 mm behind the tool, 62.5 mm above it.
ON_BRACKET = replace(D435, T_tool_camera=hand_camera_pose(behind=0.0375, above=0.0625))
CLOUDS, CLOUDS_SHORT, TRIPLES = 15, 3, 2000
# Largest angles to the reference normal, °, that are tried in the search; a chart shows how many planes each finds.
TRIED = (2, 3, 4, 5, 6, 8, 10, 15, 20, 25)

# Eqs. 27 to 30: three points, and the coefficients of e₁, e₂, e₃ and e of their plane.
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
    """Camera values that the source omits."""

    noise: Annotated[float, Quantity(Text(en="noise of the depth", pt_BR="ruído da profundidade"), 0.0, 20.0, "mm")] = (
        2.0
    )


@dataclass(frozen=True, eq=False)
class CloudReadings:
    """Measurements of a wall: tilts, °, of fits (k,) and of triples of points; shares of points on the fits, %."""

    tilts: Array
    shares: Array
    of_three: Array


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Measure each plane in `CLOUDS` simulated clouds from each place of the camera; short: in `CLOUDS_SHORT`."""
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
    """The arm in a named posture, with the printed planes around it."""
    state = initial_state(load_robot(ROBOT))
    q = state.robot.poses[pose]
    return replace(state, arm=replace(state.arm, q=q, poses=frozen(link_poses(state.robot.chain, q))))


def wall_of(reading: PlaneReading) -> PlanePane:
    """The wall of the scene that a reading measures."""
    return next(pane for pane in load_robot(ROBOT).panes if pane.name == reading.name)


def detected_plane(
    camera: Camera, reading: PlaneReading, noise: float, angle: float, seed: int
) -> tuple[Array, FoundPlane | None]:
    """A cloud of the wall, (k, 3), m, and the plane within an angle, rad, of the reference normal. noise: σ, m."""
    state = posed_state(reading.pose)
    points = SimulatedCamera(camera, noise=noise, outliers=OUTLIERS, seed=seed).cloud(state).points
    found = find_plane(points, reading.normal, state.T_world_tool[:3, 3], angle=angle, seed=seed)
    return points, found if isinstance(found, FoundPlane) else None


def tilt(normal: Array, other: Array) -> Array:
    """Angles, °, between normals (..., 3) and another (3,), regardless of sign."""
    return np.asarray(np.degrees(np.arccos(np.minimum(1.0, np.abs(normal @ other)))))


def three_point_normals(points: Array, seed: int) -> Array:
    """Normals, (n, 3), of planes through three random points of a cloud, eqs. 25–26; n ≤ `TRIPLES`.

    Triples on a line, or with a repeated point, have no plane and are left out.
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
    """The number of the three planes found within each search angle, (a,)."""
    return np.array(
        [
            sum(detected_plane(D435, reading, noise, angle, 0)[1] is not None for reading in PLANE_READINGS)
            for angle in np.radians(TRIED)
        ]
    )


def eq_25_row() -> Row:
    """Eqs. 25 and 26 on the example of the source."""
    normal, offset = rigid.normal_and_offset(rigid.plane_through(*rigid.point(POINTS)))
    quantity = Text(
        en="plane through the three points of eq. 27: largest difference of a coefficient",
        pt_BR="plano pelos três pontos da eq. 27: maior diferença de um coeficiente",
    )
    return Row(quantity, float(np.abs(np.append(normal, offset) - PLANE).max()), "", ITS_PLANE)


def _search(found: Array) -> list[Row]:
    """How the printed planes lie, and how many of three a search finds in a scene that is made of them."""
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
    """Tilts in order, over the share that lies below each."""
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
    """From one reading posture to the next, three seconds each."""
    poses = load_robot(ROBOT).poses
    stops = np.array([poses[name] for name in ("ready", *(reading.pose for reading in PLANE_READINGS), "ready")])
    times = np.linspace(0.0, 3.0 * (len(stops) - 1), 121)
    q = np.stack([np.interp(times, 3.0 * np.arange(len(stops)), joint) for joint in stops.T], axis=1)
    title = Text(en="the three readings", pt_BR="as três leituras")
    return Motion(ROBOT, times, q, title=title)


__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]
