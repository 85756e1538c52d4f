"""What cannot be read, pressed, named or reached on a page, as `readable.js` finds it."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import Page

FINDINGS = Path(__file__).with_suffix(".js").read_text("utf-8")


def remaining(page: Page, touch: bool) -> list[str]:
    """What is found once the page has fitted its formulas and named its controls, which it does with a delay."""
    for _ in range(10):
        page.wait_for_timeout(300)
        if not (findings := page.evaluate(FINDINGS, touch)):
            break
    return list(findings)
