"""The recorded results of a quick run of every study: `python -m tests.studies.record NAME …`.

A number that changes unasked is noticed; one that changes on purpose is recorded anew.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from helicoide import studies
from helicoide.studies.study import Result

FOLDER = Path(__file__).parent / "recorded"


def numbers(result: Result) -> dict[str, float]:
    """Our number of each row, by its quantity and what the source has of it."""
    return {f"{row.quantity.en} | {row.unit}": row.computed for row in result.rows}


def recorded(name: str) -> dict[str, float]:
    """The numbers that were recorded."""
    found: dict[str, float] = json.loads((FOLDER / f"{name}.json").read_text("utf-8"))
    return found


if __name__ == "__main__":
    for name in sys.argv[1:] or studies.study_names():
        study = studies.study_named(name)
        found = numbers(study.run(study.Options(), True, lambda share: None))
        (FOLDER / f"{name}.json").write_text(json.dumps(found, indent=1, ensure_ascii=False) + "\n", "utf-8")
