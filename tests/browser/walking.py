"""Walk a lesson through the page from its first step to its summary, and take a picture of each step.

What a reader does with controls of the step is done with these controls; other motions, such as drags in the scene, are
asked for without the page, since `test_drive.py` tests those.
"""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import count

import numpy as np
from PIL import Image
from playwright.sync_api import Locator, Page, expect
from tests.browser.lab import Lab, tab, until
from tests.browser.pictures import FAILURES, flaws
from tests.browser.readable import remaining

from helicoide.command import MoveToJoints
from helicoide.lesson import AtSeat, Choice, Estimate, Lesson, Mark, Order, Step, right_answer
from helicoide.lines import LineExercise
from helicoide.session.visitor import Visitor
from helicoide.state import State, Update
from helicoide.text import Language
from helicoide.view.lesson_rows import NEXT, TRIED
from helicoide.view.panels.lesson import TITLE
from helicoide.view.prediction_rows import ANSWER, MARKED

HEADING, DONE, SUMMARY = ".helicoide-lesson h3", ".helicoide-verdict.done", ".helicoide-summary"
SCENE = (0.30, 0.15, 0.62, 0.85)  # the middle of the page: left, upper, right, lower, as shares
LEAST_COLOURS = 40
COLUMNS, CELL = 3, 640  # of a contact sheet; px
MOST_STOPS = 300
FOCUSED = "element => element === document.activeElement"

Reach = Callable[[Page, Locator], None]


def by_mouse(page: Page, control: Locator) -> None:
    control.click()


def by_touch(page: Page, control: Locator) -> None:
    control.tap()


def by_keyboard(page: Page, control: Locator) -> None:
    """Press Tab until the control has the focus; then Enter, if it is a button."""
    for _ in range(MOST_STOPS):
        if control.evaluate(FOCUSED):
            if control.evaluate("element => element.matches('button')"):
                page.keyboard.press("Enter")
            return
        page.keyboard.press("Tab")
    raise AssertionError(f"the Tab key does not lead to {control}")


@dataclass
class Walk:
    """One walk through a lesson. pictures: of the page, one for each step; faults: what is wrong with them."""

    lab: Lab
    page: Page
    lesson: Lesson
    language: Language
    reach: Reach = by_mouse
    pictures: list[Image.Image] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)
    without_page: list[str] = field(default_factory=list)  # steps whose motion was asked for without the page

    @property
    def visitor(self) -> Visitor:
        return list(self.lab.session.visitors.values())[-1]

    def go(self) -> None:
        """Begin the lesson on the course map, do every step, and read the summary."""
        tab(self.page, TITLE[self.language])
        self.reach(self.page, self.page.locator(f'[data-go="lesson:{self.lesson.id}"]').first)
        for number, step in enumerate(self.lesson.steps, 1):
            title = f"{number}. {self.lesson.prose[step.id].title[self.language]}"
            expect(self.page.locator(HEADING)).to_have_text(title)
            self._do(step)
            self._look(title)
            self.press(NEXT[self.language])
        expect(self.page.locator(SUMMARY)).to_contain_text(str(len(self.lesson.steps)))
        self._look("summary")

    def press(self, name: str) -> None:
        self.reach(self.page, self.page.get_by_role("button", name=name, exact=True))

    def type(self, field: Locator, text: str) -> None:
        self.reach(self.page, field)
        expect(field).to_be_focused()
        self.page.keyboard.press("Control+A")
        self.page.keyboard.type(text)
        self.page.keyboard.press("Enter")

    def _do(self, step: Step) -> None:
        until(self.page, lambda: self.visitor.setup is None or not self.visitor.setup.is_under_way(self._state))
        until(self.page, lambda: not self._state.arm.moving)
        if step.prediction is not None:
            self._predict(step)
        if step.line is not None:
            self._type_lines(step.line)
        for act, seconds in step.solution:
            end = self._state.t + seconds
            if isinstance(act, AtSeat):
                self.lab.session.loop.call_soon_threadsafe(self.visitor.reseat, act.update)
            elif not self._moved_by_boxes(step, act):
                self.without_page.append(step.id)
                self.visitor.bay.workcell.tell(act)
            until(self.page, lambda end=end: self._state.t >= end or self.visitor.bay.workcell.resting)
        if step.by_reader:
            self.press(TRIED[self.language])
        expect(self.page.locator(DONE)).to_be_visible()

    @property
    def _state(self) -> State:
        return self.visitor.bay.workcell.state

    def _predict(self, step: Step) -> None:
        docked, prediction = self._docked(), step.prediction
        match prediction:
            case Choice(right):
                self.reach(self.page, docked.locator(f'[data-go="answer:{right}"]'))
            case Order(right):
                self._arrange(right)
            case Estimate():
                (right,) = right_answer(prediction, self._state, self.visitor.place.seat)
                self.type(docked.get_by_role("textbox").first, f"{right:.4f}")
            case Mark():
                point = right_answer(prediction, self._state, self.visitor.place.seat)
                for axis, coordinate in zip("xyz", point, strict=True):
                    label = f"{MARKED[self.language]}: {axis}"
                    self.type(self.page.locator(f'input[aria-label="{label}"]:visible'), f"{1e3 * coordinate:.0f}")
                self.press(ANSWER[self.language])
        until(self.page, lambda: self._answered(step))
        expect(docked.get_by_role("button", name=ANSWER[self.language], exact=True)).to_have_count(0)
        expect(docked.locator('[data-go^="answer:"], [data-go^="up:"]')).to_have_count(0)

    def _answered(self, step: Step) -> bool:
        progress = self.visitor.place.seat.lesson_progress
        return progress is not None and step.id in progress.answers

    def _arrange(self, right: tuple[int, ...]) -> None:
        """Move the options up until they are in the right order."""

        def order() -> list[int]:
            buttons = self._docked().locator('[data-go^="up:"]')
            return [int(name.removeprefix("up:")) for name in buttons.evaluate_all("all => all.map(b => b.dataset.go)")]

        for place, option in enumerate(right):
            while (before := order()).index(option) > place:
                self.reach(self.page, self._docked().locator(f'[data-go="up:{option}"]'))
                until(self.page, lambda before=before: order() != before)
        self.press(ANSWER[self.language])

    def _type_lines(self, exercise: LineExercise) -> None:
        for number, line in enumerate(exercise.lines()):
            self.type(self._docked().get_by_role("textbox").last, line.expected)
            expect(self.page.locator(".helicoide-accepted")).to_have_count(number + 1)

    def _moved_by_boxes(self, step: Step, act: Update) -> bool:
        """Type the joint values that are asked for into the boxes of the step; False if it has not all of them."""
        state, before, asked = self._state, self._state.request.command, act(self._state).request.command
        if not isinstance(asked, MoveToJoints) or asked is before:
            return False
        q = before.q if isinstance(before, MoveToJoints) else state.arm.q
        changed = [int(joint) for joint in np.flatnonzero(asked.q != q)]
        if not set(changed) <= set(step.joints):
            return False
        for joint in changed:
            variable = state.robot.variables[joint]
            label = f"{joint + 1} {variable.title[self.language]}"
            boxes = self.page.locator(f'input.mantine-NumberInput-input[aria-label^="{label}"]:visible')
            scale = 1000.0 if variable.is_prismatic else 180 / np.pi
            self.type(boxes.first, f"{scale * asked.q[joint]:.1f}")
        until(self.page, lambda: self._state.request.command is not before)  # else the arm seems to have arrived
        return True

    def _docked(self) -> Locator:
        """The panel of the lesson."""
        return self.page.locator(".mantine-Paper-root").filter(has=self.page.locator(HEADING)).last

    def _look(self, title: str) -> None:
        """Take a picture, and note what is wrong on the page."""
        width = self.page.viewport_size["width"] if self.page.viewport_size else 0
        found = [*flaws(self.page, FAILURES), *remaining(self.page, width < 400)]
        picture = Image.open(io.BytesIO(self.page.screenshot())).convert("RGB")
        left, upper, right, lower = (share * side for share, side in zip(SCENE, 2 * picture.size, strict=True))
        if len(picture.crop((int(left), int(upper), int(right), int(lower))).getcolors(10**6) or ()) < LEAST_COLOURS:
            found.append("the scene is empty")
        self.pictures.append(picture)
        self.faults += [f"{title}: {fault}" for fault in found]


def contact_sheet(pictures: list[Image.Image]) -> Image.Image:
    """All pictures, in rows."""
    height = round(CELL * pictures[0].height / pictures[0].width)
    rows = -(-len(pictures) // COLUMNS)
    sheet = Image.new("RGB", (COLUMNS * CELL, rows * height), "white")
    for place, picture in zip(count(), pictures, strict=False):
        sheet.paste(picture.resize((CELL, height)), (place % COLUMNS * CELL, place // COLUMNS * height))
    return sheet
