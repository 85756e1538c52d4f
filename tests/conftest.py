"""The arm of most tests, at `ready`; and options for which tests run, and on how many examples."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, is_hypothesis_test, settings
from hypothesis.internal.conjecture import providers
from tests.sample import sampled

from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.state import State, initial_state
from helicoide.view.news import tell_once

# No time limits: the first call of a kernel compiles it, which takes longer than any limit of an example.
CLOCKLESS = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow], print_blob=True)
settings.register_profile("test", CLOCKLESS, derandomize=True, database=None)
settings.register_profile("search", CLOCKLESS, derandomize=False)
settings.load_profile("test")
SEARCHED = 50  # times as many examples as a test asks for

BROWSER = Path(__file__).parent / "browser"
SAMPLE = pytest.StashKey[tuple[int, int]]()


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--sample", type=int, metavar="N", help="of each file at most N tests, evenly spaced")


@pytest.hookimpl(trylast=True)
def pytest_configure() -> None:
    """Turn off numbers from imported modules, which Hypothesis also tries: examples would depend on other tests."""
    if settings().derandomize:
        providers._get_local_constants = lambda: providers._local_constants


def pytest_itemcollected(item: pytest.Item) -> None:
    if item.path.is_relative_to(BROWSER):
        item.add_marker("browser")
    if settings.get_current_profile_name() == "search" and is_hypothesis_test(getattr(item, "obj", None)):
        item.extra_keyword_matches.add("search")


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Keep a sample of the tests, or give them more examples. Files that take long come first: no processor waits."""
    in_file = Counter(item.path for item in items)
    items.sort(key=lambda item: (item.get_closest_marker("compiles") is None, -in_file[item.path], item.path))
    if most := config.getoption("sample"):
        kept = sampled(items, most)
        config.stash[SAMPLE] = len(kept), len(items)
        items[:] = kept
    if settings.get_current_profile_name() == "search":
        for test in {item.obj for item in items if is_hypothesis_test(item.obj)}:
            own = test._hypothesis_internal_use_settings
            test._hypothesis_internal_use_settings = settings(own, max_examples=SEARCHED * own.max_examples)


def pytest_runtest_setup() -> None:
    """Log failures again that an earlier test has logged already."""
    tell_once()


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Send the size of the sample from a process of pytest-xdist to the one that started it."""
    if hasattr(session.config, "workeroutput") and SAMPLE in session.config.stash:
        session.config.workeroutput["sample"] = session.config.stash[SAMPLE]


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    if told := getattr(node, "workeroutput", {}).get("sample"):
        node.config.stash[SAMPLE] = told


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    if SAMPLE in config.stash:
        terminalreporter.write_line("check: {} of {} tests".format(*config.stash[SAMPLE]))


@pytest.fixture(scope="session")
def robot() -> Robot:
    return load_robot("movemaster")


@pytest.fixture
def state(robot: Robot) -> State:
    return initial_state(robot)
