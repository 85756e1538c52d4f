"""The part of the tests that `make check` runs."""

from __future__ import annotations

from itertools import groupby

import pytest


def sampled(items: list[pytest.Item], most: int) -> list[pytest.Item]:
    """At most `most` tests of each file, evenly spaced."""
    files = [list(tests) for _, tests in groupby(items, key=lambda item: item.path)]
    return [tests[place] for tests in files for place in sorted({k * len(tests) // most for k in range(most)})]
