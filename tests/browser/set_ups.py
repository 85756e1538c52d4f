"""What the pictures of the gallery show: a function for each scene, which sets it up in a studio."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from tests.browser.lab import press, until
from tests.browser.studio import Studio
from tests.browser.test_methods import choose

from helicoide import gate, lesson
from helicoide.command import Replay
from helicoide.geometry import rotation
from helicoide.seat import AxisAngle, Playground, Seat, Selection
from helicoide.session.planning import plan_motion
from helicoide.session.postures import list_postures
from helicoide.sheet import sheet_of_text
from helicoide.state import Update
from helicoide.view import console_rows, plan_rows, posture_rows, recording_rows, signal_rows, term_rows
from helicoide.view.layers import playground, velocity_ellipsoid
from helicoide.view.panels import algebra, charts, robot, study
from helicoide.view.panels import lesson as lessons
from helicoide.view.panels.study import RUN, studies_by_source

CEILING, ABOVE_THE_CEILING = 0, (0.68, 0.06, 0.69)
SHEET = """\
ell = join(elbow, tool)
foot = meet(ell, ceiling)
tip = M_tool >> point(0, 0, 0.1)
distance(tip, ceiling)
arm = join(shoulder, elbow, tip)
"""
STUDY = "cerbaro_orca_circle"


def bent(*degrees: float) -> Update:
    """Bring the joints to angles, degrees."""
    return gate.set_joints(np.radians(degrees))


def away(studio: Studio, x: float, y: float, z: float) -> Update:
    """Set the target at a distance, m, from the end effector, whose orientation is left free."""
    studio.lab.post(gate.keep_orientation(False))
    T = studio.lab.state.T_world_tool
    return gate.set_target(T[:3, 3] + [x, y, z], rotation.from_matrix(T[:3, :3]))


def blocked(studio: Studio) -> None:
    """The target above the ceiling: the arm stops 80 mm below it, and the status line says why."""
    studio.move(gate.set_target(ABOVE_THE_CEILING, [1.0, 0.0, 0.0, 0.0]))
    studio.tab(algebra)
    studio.sit(lambda seat: seat.inspecting(Selection("plane", CEILING)))
    studio.aim((0.65, -1.0, 0.1), np.vstack([studio.arm(), np.add(ABOVE_THE_CEILING, (0.05, 0.0, 0.1))]))


def screw(studio: Studio) -> None:
    """A link, the screw that brought it there, and a coefficient of its motor."""
    studio.move(bent(15, 30, -80, -10, 40))
    studio.tab(algebra)
    studio.sit(lambda seat: replace(seat.inspecting(Selection("link", 3)), coefficient="e1e", transparent=True))
    studio.aim((0.4, -1.0, 0.5))


def why_this_number(studio: Studio) -> None:
    """The terms of a coefficient of the end effector's motor, and the joint of one of them."""
    studio.tab(algebra)
    studio.sit(lambda seat: replace(seat.inspecting(Selection("tool")), coefficient="e1e", term_joint=1))
    studio.unfold(term_rows.TITLE)
    studio.aim((0.4, -1.0, 0.5))


def quaternions(studio: Studio) -> None:
    """Two rotations in the ball of quaternions, slerp and lerp between them, and both products."""
    play = Playground(AxisAngle((0.0, 0.0, 1.0), 2.4), AxisAngle((1.0, 0.0, 0.0), 2.0), 0.6)
    studio.tab(algebra)
    studio.show("playground")
    studio.sit(lambda seat: replace(seat, playground=play))
    studio.unfold(playground.TITLE)
    studio.aim((-0.35, -1.0, 0.3), np.vstack([studio.arm(), (-0.9, 0.0, 0.7)]))


def console(studio: Studio) -> None:
    """A sheet, and its points, lines and planes in the scene."""
    studio.tab(algebra)
    studio.sit(lambda seat: replace(seat, sheet=sheet_of_text(SHEET)))
    studio.unfold(console_rows.TITLE_OF_CONSOLE)
    studio.aim((0.7, -1.0, 0.25), np.vstack([studio.arm(), (0.24, 0.0, 0.68)]))


def ellipsoid(studio: Studio) -> None:
    """How fast the end effector can move in each direction."""
    studio.load("puma560")
    studio.tab(robot)
    studio.show("velocity_ellipsoid")
    studio.unfold(robot.SHOW)
    studio.begin_with(studio.page.get_by_text(velocity_ellipsoid.TITLE[studio.language], exact=True))
    tool = studio.lab.state.T_world_tool[:3, 3]
    studio.aim(points=np.vstack([studio.lab.state.monitored_points, tool - 0.2, tool + 0.2]))


def planned(studio: Studio) -> None:
    """A motion that is planned and shown before the arm makes it."""
    studio.move(bent(-15, 35, -90, -20, 0))
    studio.tab(robot)
    studio.unfold(plan_rows.TITLE)
    title = studio.lab.state.robot.pose_titles["reading_left"]
    studio.lab.post(plan_motion(studio.lab.state, gate.go_to("reading_left"), title))
    until(studio.page, lambda: studio.lab.state.plan is not None)
    studio.aim((0.3, -1.0, 0.3))


def distances(studio: Studio) -> None:
    """The distances to the planes and to a sphere, and how one of them is computed."""
    studio.move(away(studio, -0.05, 0.1, 0.1))
    studio.lab.post(gate.add_obstacle())
    studio.tab(algebra)
    studio.show("distances")
    studio.begin_with(studio.heading(algebra.DISTANCE))
    studio.aim((0.5, -1.0, 0.3))


def dh_frames(studio: Studio) -> None:
    """The Denavit-Hartenberg frames of the Puma and their parameters."""
    studio.load("puma560")
    studio.tab(robot)
    studio.show("dh")
    studio.sit(lambda seat: replace(seat, transparent=True))
    studio.aim(share=0.8)


def entry_point(studio: Studio) -> None:
    """A rod that pivots at an entry point, as in surgery, and where its shaft has been."""
    studio.load("dia10_rod")
    studio.tab(robot)
    studio.show("shaft")
    studio.move(gate.enforce_entry(True))
    for x, y in ((0.06, 0.0), (-0.06, 0.06), (-0.06, -0.06), (0.06, -0.06)):
        studio.move(away(studio, x, y, 0.0))
    studio.aim(
        (1.35, 0.54, 0.57), np.vstack([studio.lab.state.monitored_points[-3:], studio.lab.state.T_world_tool[:3, 3]])
    )


def branches(studio: Studio) -> None:
    """Every posture that brings the end effector to the target."""
    studio.load("puma560")
    studio.tab(robot)
    studio.show("postures")
    studio.lab.post(list_postures(studio.lab.state))
    until(studio.page, lambda: studio.lab.state.postures.listing is not None)
    studio.unfold(posture_rows.TITLE)
    studio.aim()


def signals(studio: Studio) -> None:
    """The distances over time, with the bands in which the arm is slowed and stopped."""
    studio.tab(charts)
    studio.sit(lambda seat: signal_rows.with_group(seat, "distances"))
    for y, z in ((-0.2, 0.0), (0.1, 0.25), (0.3, -0.15)):
        studio.move(away(studio, 0.0, y, z))
    studio.begin_with(studio.page.locator("figcaption").first)
    studio.aim()


def loop(studio: Studio) -> None:
    """The control loop, with the values on its arrows."""
    studio.tab(charts)
    studio.sit(lambda seat: signal_rows.with_charts(seat, loop=True))
    diagram = studio.page.locator(".helicoide-loop")
    diagram.wait_for()
    studio.begin_with(diagram)
    studio.move(away(studio, 0.0, 0.1, 0.1))
    studio.aim()


def recording(studio: Studio) -> None:
    """A recording: an outline moves through it while the arm stands still."""
    language, recordings = studio.language, studio.visitor.place
    studio.tab(charts)
    press(studio.page, recording_rows.RECORD[language])
    until(studio.page, lambda: studio.lab.cell.recorder is not None and studio.lab.cell.recorder.running)
    for joints in ((20, 30, -75, -15, 0), (-15, 45, -95, -15, 0)):
        studio.move(bent(*joints))
    press(studio.page, recording_rows.STOP[language])
    until(studio.page, lambda: len(recordings.recordings.files) > 0)
    name = recordings.recordings.files[0].name
    studio.page.get_by_role("combobox", name=recording_rows.LIST[language], exact=True).click()
    studio.page.get_by_role("option", name=name).click()
    until(studio.page, lambda: recordings.recordings.shown is not None)
    thumb = studio.page.get_by_role("slider").locator("visible=true").first
    thumb.focus()
    thumb.press("Home")
    for _ in range(40):
        thumb.press("ArrowRight")
    thumb.blur()
    studio.begin_with(studio.page.get_by_role("combobox", name=recording_rows.LIST[language], exact=True))
    studio.aim()


def study_of_a_source(studio: Studio) -> None:
    """An experiment of a source: its curves, what the source prints, and its motion on the arm."""
    language, place = studio.language, studio.visitor.place
    studio.tab(study)
    choose(studio.page, study.TITLE[language], dict(studies_by_source())[STUDY][language])
    press(studio.page, RUN[language])
    until(studio.page, lambda: place.study_panel.last is not None, 300)
    last = place.study_panel.last
    assert last is not None
    press(studio.page, last.result.motions[0].title[language])
    until(studio.page, lambda: isinstance(studio.lab.state.request.command, Replay), 300)
    until(studio.page, lambda: not isinstance(studio.lab.state.request.command, Replay), 300)
    studio.begin_with(studio.page.locator(".helicoide-counted"))
    studio.aim((0.3, -1.0, 0.9))


def second_step(seat: Seat) -> Seat:
    """The seat at the second step of the first lesson."""
    found = lesson.load_lesson("drive_the_arm")
    return lesson.turned_to(found, lesson.entered(seat, found.id), 1)


def first_lesson(studio: Studio) -> None:
    """The second step of the first lesson."""
    studio.tab(lessons)
    studio.sit(second_step)
    text = studio.page.locator(".helicoide-lesson h3")
    text.wait_for()
    studio.begin_with(text)
    studio.aim()
