"""The contact sheet of the README: every arm at `ready`, from the running app. Tests use its layout too."""

from __future__ import annotations

import base64
import io
import shutil
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont
from playwright.sync_api import Page, sync_playwright
from tests.browser.conftest import CHROMIUMS, FLAGS
from tests.browser.lab import Lab, opened, until

from helicoide import content
from helicoide.arrays import Array
from helicoide.kinematics.library import robot_titles
from helicoide.state import State
from helicoide.view.scene import outlook
from helicoide.view.shapes import Shape

PICTURE = content.STATIC / "pictures" / "robots.png"
COLUMNS, CELL, LABEL = 4, 250, 26
NEAR, TITLE_SIZE = 1.0, 15
COLOURS = 256
SETTLING_MS = 2_500  # software rendering draws a few frames a second
THERE = "(name) => Boolean(window.__viserMutable.nodeRefFromName[name])"
SCENE = "() => window.__viserMutable.canvas.toDataURL('image/png')"


def names() -> list[str]:
    """The arms in the order of the sheet."""
    return sorted(content.content_folders("robots"))


def corner(index: int) -> tuple[int, int]:
    """Left and upper edge of the cell of an arm, px."""
    return (index % COLUMNS) * CELL, (index // COLUMNS) * (CELL + LABEL)


def close_up(lab: Lab) -> tuple[Array, Array]:
    """Camera position and look-at point, (3,) m each: as `outlook`, but centred and near, so the arm fills a cell."""
    position, look_at = outlook(lab.state.robot)
    edges = [placed(lab.state, shape) for shape in lab.shapes if len(shape.edges)]
    points = np.concatenate(edges)
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    away = (position - look_at) / np.linalg.norm(position - look_at)
    return centre + NEAR * float(np.linalg.norm(np.ptp(points, axis=0))) * away, centre


def placed(state: State, shape: Shape) -> Array:
    """The end points of the edges of a shape in the world, (2e, 3), m."""
    T = state.arm.poses[shape.link] @ shape.T_link_shape
    return np.asarray(shape.edges.reshape(-1, 3) @ T[:3, :3].T + T[:3, 3])


def picture(lab: Lab, page: Page, name: str) -> Image.Image:
    """The picture of one arm, alone in its scene."""
    session = lab.session

    def arrange() -> None:
        (window,) = lab.windows
        window.clear()  # only the window's own layers, such as handles; the arm is in the shared scene
        window.client.camera.position, window.client.camera.look_at = close_up(lab)
        window.client.flush()

    lab.change(name)
    until(page, lambda: lab.state.robot.name == name)
    until(page, lambda: bool(page.evaluate(THERE, f"/arm/{lab.shapes[-1].name}")))
    page.wait_for_timeout(SETTLING_MS)
    session.loop.call_soon_threadsafe(arrange)
    page.wait_for_timeout(SETTLING_MS)
    data = base64.b64decode(page.evaluate(SCENE).partition(",")[2])
    flat = Image.new("RGB", (CELL, CELL), "white")
    scene = Image.open(io.BytesIO(data)).convert("RGBA").resize((CELL, CELL))
    flat.paste(scene, mask=scene)
    return flat


def sheet(pictures: dict[str, Image.Image]) -> Image.Image:
    """All pictures in rows, each with the title of its arm below."""
    width, height = COLUMNS * CELL, corner(len(pictures) - 1)[1] + CELL + LABEL
    page = Image.new("RGB", (width, height), "white")
    for index, (name, shown) in enumerate(pictures.items()):
        x, y = corner(index)
        page.paste(shown, (x, y))
        title = robot_titles()[name].en
        ImageDraw.Draw(page).text((x + CELL / 2, y + CELL + 4), title, "#333", fitting(title), anchor="ma")
    return page


def fitting(title: str) -> ImageFont.FreeTypeFont:
    """The largest font in which a title fits into its cell."""
    sizes = (ImageFont.load_default(size) for size in range(TITLE_SIZE, 0, -1))
    return next(font for font in sizes if font.getlength(title) <= CELL - 8)  # type: ignore[union-attr]


def main() -> None:
    """Take the pictures and write the sheet."""
    lab = opened()
    found = next(filter(None, map(shutil.which, CHROMIUMS)), None)
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=found, headless=True, args=FLAGS)
        page = chromium.new_page(viewport={"width": 2 * CELL, "height": 2 * CELL})
        page.goto(f"http://127.0.0.1:{lab.port}/")
        until(page, lambda: lab.session.ready and len(lab.windows) == 1, 300)
        taken = {name: picture(lab, page, name) for name in names()}
        chromium.close()
    lab.session.close()
    save_light(sheet(taken), PICTURE)


def save_light(image: Image.Image, path: Path) -> None:
    """Save a picture as PNG with few colours, which keeps the file small."""
    image.quantize(COLOURS, kmeans=2, dither=Image.Dither.NONE).save(path, optimize=True)


def cells(path: Path = PICTURE) -> dict[str, Array]:
    """The cells of the committed sheet by name, as grey values."""
    whole = np.asarray(Image.open(path).convert("L"), dtype=np.float64)
    found = {}
    for index, name in enumerate(names()):
        x, y = corner(index)
        found[name] = whole[y : y + CELL, x : x + CELL]
    return found
