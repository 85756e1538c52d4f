"""A lesson in a running lab: what a step shows, the camera, an arm of one's own, answers, checked lines, leaving."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.pages import Hand
from tests.session.labs import eventually, running, state, window

from helicoide import content, lesson
from helicoide.lines import WrongTerm
from helicoide.seat import LessonProgress
from helicoide.session.lab import Lab
from helicoide.session.visitor import Visitor
from helicoide.text import LANGUAGES

LESSON = """
from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Estimate, Mark, Order, Shown, Step, Value
from helicoide.lines import GivenName, LineExercise
from helicoide.text import Text, untranslated

TITLE = untranslated("Tour")
ROBOT = "{robot}"
OWN_ARM = {own}
THETA = GivenName("theta", "angle", untranslated("theta"))
ROTOR = LineExercise("motor", (THETA,), "cos(theta/2) + sin(theta/2)*e1e2")
VALUES = {{"far": Value(lambda state, seat: state.T_world_tool[0, 3], "mm")}}


def bent(state, seat):
    return bool(abs(state.arm.q[1] - 0.3) < 0.01) and not state.arm.moving


def bent_back(state, seat):
    return bool(state.arm.q[1] < -0.1)


STEPS = (
    Step("bend", gate.get_ready(), bent, ((gate.set_joint(1, 0.3), 3.0),), prediction=Choice(1),
         diagnoses=(Diagnosis("back", bent_back, ((gate.set_joint(1, -0.3), 3.0),)),),
         shown=Shown(layers=("twist",), camera="top")),
    Step("line", gate.get_ready(), line=ROTOR),
    Step("order", gate.get_ready(), prediction=Order((1, 0))),
    Step("mark", gate.get_ready(), prediction=Mark(lambda state, seat: state.T_world_tool[:3, 3], reveal="now")),
    Step("estimate", gate.get_ready(), prediction=Estimate(lambda state, seat: 0.5, "mm", 1.0)),
    Step("free", gate.get_ready(), is_open=True),
)
"""
PAGE = """\
## bend: Bend

Far {far}.

? Up?
- a
- b

! B.

> Bend it as you are told.

> back: Other way.

## line: A line

Type it.

> The half of the angle is needed here.

## order: Order

? Order?
- a
- b

! So.

> Move the options with the arrows.

## mark: Mark

? Where?

! There.

> Where the end effector is at present.

## estimate: Estimate

? How many?

! So many.

> A number, such as five hundred of them.

## free: Free

Do.

> There is nothing that could go wrong.
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A user's folder with two lessons: `tour` on planar3r with an arm of one's own, `walk` on the shared arm."""
    home = tmp_path_factory.mktemp("user")
    for name, robot, own in (("tour", "planar3r", True), ("walk", "planar2r", False)):
        where = home / "lessons" / name
        where.mkdir(parents=True)
        (where / "lesson.py").write_text(LESSON.format(robot=robot, own=own), encoding="utf-8")
        for language in LANGUAGES:
            (where / f"{language}.md").write_text(PAGE, encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(content, "user_folder", lambda: home)
        yield home
    lesson.load_lesson.cache_clear()


@pytest.fixture(scope="module")
def lab(folder: Path) -> Iterator[Lab]:
    with running("planar2r") as lab:
        yield lab


@pytest.fixture
def hand(lab: Lab) -> Iterator[Hand]:
    hand = window(lab)
    yield hand
    hand.close()


@pytest.fixture
def visitor(lab: Lab, hand: Hand) -> Visitor:
    (visitor,) = lab.visitors.values()
    assert eventually(lambda: visitor.settled and visitor.window.layers is not None)
    return visitor


def now(visitor: Visitor) -> LessonProgress:
    assert visitor.place.seat.lesson_progress is not None
    return visitor.place.seat.lesson_progress


def judged(visitor: Visitor, step: str) -> bool | None:
    """Whether the answer of a step is right; None before it is given and judged."""
    answer = now(visitor).answers.get(step)
    return None if answer is None else answer.right


def go(hand: Hand, target: object) -> None:
    hand.do(hand.page.say("HelicoideFollow", target=target))


def press(hand: Hand, label: str, then: Callable[[], bool]) -> None:
    """Press the newest button of this label, again and again until what should come of it comes true.

    The page keeps buttons of earlier steps, and presses buttons that are not shown yet.
    """

    def tried() -> bool:
        uuids = [uuid for uuid, said in hand.page.labels.items() if said == label]
        if not then() and uuids:
            hand.do(hand.page.say("GuiUpdateMessage", uuid=uuids[-1], updates={"value": True}))
        return eventually_soon(then)

    assert eventually(tried)


def eventually_soon(then: Callable[[], bool]) -> bool:
    """Whether something comes true within half a second."""
    end = time.monotonic() + 0.5
    while not then() and time.monotonic() < end:
        time.sleep(0.01)
    return then()


def arrived(visitor: Visitor) -> bool:
    cell = visitor.bay.workcell.state
    return visitor.setup is not None and visitor.setup.is_applied and not visitor.setup.is_under_way(cell)


def test_a_lesson_shows_judges_and_is_undone(lab: Lab, hand: Hand, visitor: Visitor) -> None:
    before = visitor.place.seat
    go(hand, "lesson:walk")
    assert eventually(lambda: visitor.place.seat.visible_layers.get("twist") is True and arrived(visitor))
    assert eventually(lambda: visitor.outlook is not None)
    go(hand, "answer:0")
    assert eventually(lambda: judged(visitor, "bend") is False)
    hand.do(hand.page.give("2 elbow", -30.0))
    assert eventually(lambda: visitor.place.seat.mistake == "back")
    assert now(visitor).done == set()
    hand.do(hand.page.give("2 elbow", 17.2))
    assert eventually(lambda: now(visitor).done == {"bend"})
    assert visitor.place.seat.mistake is None
    press(hand, "Reset step", lambda: abs(state(lab).arm.q[1] - state(lab).robot.poses["ready"][1]) < 1e-3)
    press(hand, "Begin again", lambda: now(visitor) == LessonProgress("walk"))
    assert eventually(lambda: arrived(visitor))
    assert now(visitor).done == set()
    press(hand, "Leave lesson", lambda: visitor.place.seat.lesson is None)
    assert eventually(lambda: visitor.place.seat.visible_layers == before.visible_layers)
    assert eventually(lambda: visitor.outlook is None)


def test_a_step_that_is_begun_again_is_not_done_by_where_the_arm_still_is(
    lab: Lab, hand: Hand, visitor: Visitor
) -> None:
    go(hand, "lesson:walk")
    assert eventually(lambda: arrived(visitor))
    for degrees in (17.0, 17.2, 17.4):
        hand.do(hand.page.give("2 elbow", degrees))
        assert eventually(lambda: now(visitor).done == {"bend"})
        press(hand, "Begin again", lambda: now(visitor) == LessonProgress("walk") and arrived(visitor))
        assert abs(state(lab).arm.q[1] - state(lab).robot.poses["ready"][1]) < 1e-3
        assert now(visitor).done == set()
    press(hand, "Leave lesson", lambda: visitor.place.seat.lesson is None)


def written(visitor: Visitor, step: int) -> bool:
    """Whether the rows of a step are on the page."""
    return now(visitor).step == step and visitor.window.docked.key[3:4] == (step,)


def test_all_kinds_of_steps_by_the_page_alone(lab: Lab, hand: Hand, visitor: Visitor) -> None:
    go(hand, "lesson:walk")
    assert eventually(lambda: arrived(visitor))
    press(hand, "Skip step", lambda: now(visitor).step == 1)
    assert eventually(lambda: written(visitor, 1) and "Your line" in hand.page.made)
    hand.do(hand.page.give("Your line", "cos(theta) + sin(theta)*e1e2"))
    press(hand, "Check line", lambda: visitor.place.line_check is not None)
    assert visitor.place.line_check is not None
    assert isinstance(visitor.place.line_check.verdict, WrongTerm)
    hand.do(hand.page.give("Your line", "cos(0.5*theta) + e1e2*sin(theta/2)"))
    press(hand, "Check line", lambda: now(visitor).done == {"line"})
    press(hand, "Next step", lambda: now(visitor).step == 2)
    assert eventually(lambda: written(visitor, 2))
    go(hand, "down:0")
    assert eventually(lambda: visitor.place.seat.draft == (1.0, 0.0))
    press(hand, "Answer", lambda: judged(visitor, "order") is True and "order" in now(visitor).done)
    press(hand, "Next step", lambda: now(visitor).step == 3)
    assert eventually(lambda: written(visitor, 3) and arrived(visitor) and "Marked point [mm]" in hand.page.made)
    x, y, z = (1e3 * visitor.bay.workcell.state.T_world_tool[:3, 3]).tolist()
    hand.do(hand.page.give("Marked point [mm]", (x, y, z)))
    assert eventually(lambda: visitor.place.seat.draft is not None)
    press(hand, "Answer", lambda: judged(visitor, "mark") is True)
    press(hand, "Next step", lambda: now(visitor).step == 4)
    assert eventually(lambda: written(visitor, 4) and "Your estimate [mm]" in hand.page.made)
    hand.do(hand.page.give("Your estimate [mm]", "500,5"))
    press(hand, "Answer", lambda: judged(visitor, "estimate") is True)
    assert now(visitor).answers["estimate"].given == (500.5,)
    press(hand, "Next step", lambda: now(visitor).step == 5)
    assert eventually(lambda: written(visitor, 5))
    press(hand, "I have tried it", lambda: "free" in now(visitor).done)
    press(hand, "Next step", lambda: now(visitor).finished)
    assert now(visitor).skipped == {"bend"}
    press(hand, "Leave lesson", lambda: visitor.place.seat.lesson is None)


def test_a_lesson_with_its_own_arm_leaves_the_shared_arm_alone(lab: Lab, hand: Hand, visitor: Visitor) -> None:
    shared = lab.shared.workcell.state
    go(hand, "lesson:tour")
    assert eventually(lambda: visitor.bay is not lab.shared and visitor.bay.workcell.state.robot.name == "planar3r")
    assert eventually(lambda: arrived(visitor) and visitor.place.seat.lesson == "tour")
    assert lab.shared.workcell.state.robot is shared.robot
    press(hand, "Leave lesson", lambda: visitor.bay is lab.shared)
    assert visitor.place.seat.lesson is None


@pytest.mark.parametrize("target", ["", "lesson:nowhere", "answer:99", "answer:x", "up:-1", 5, "x" * 1000, None])
def test_a_button_that_no_page_has_changes_nothing(lab: Lab, hand: Hand, visitor: Visitor, target: object) -> None:
    before = visitor.place.seat
    go(hand, target)
    go(hand, "layer:twist")
    assert eventually(lambda: visitor.place.seat.visible_layers["twist"])
    assert (visitor.place.seat.lesson, visitor.place.seat.progress) == (None, before.progress)
