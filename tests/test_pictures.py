"""The pictures of the README: each is there, is named, has the size of its row, and shows something."""

from __future__ import annotations

import re
from pathlib import Path
from typing import get_args

import numpy as np
import pytest
from PIL import Image
from tests.browser import sheet
from tests.browser.conftest import SIZES
from tests.browser.gallery import GALLERY, Picture

from helicoide.content import STATIC
from helicoide.text import Language

ROOT = Path(__file__).parents[1]
FOLDER = STATIC / "pictures"
HEAVIEST = 250_000  # bytes
LEAST_ENTROPY, LARGEST_SHARE, LEAST_DEVIATION = 2.5, 0.75, 15.0  # bits; of one grey value; of 255 grey values
NAMES = {picture.name for picture in GALLERY}


def shown(picture: Picture) -> Image.Image:
    with Image.open(FOLDER / f"{picture.name}.png") as image:
        return image.convert("L")


def test_the_gallery_covers_each_size_look_and_language() -> None:
    assert {picture.size for picture in GALLERY} == {"desktop", "projector", "phone"}
    assert {picture.dark for picture in GALLERY} == {False, True}
    assert {picture.language for picture in GALLERY} == set(get_args(Language))
    assert len(NAMES) == len(GALLERY)


@pytest.mark.parametrize("page", ["README.md", "README.pt-BR.md"])
def test_each_picture_is_shown_in_the_readme_and_each_shown_one_is_there(page: str) -> None:
    named = re.findall(r"static/pictures/(\w+)\.png", (ROOT / page).read_text("utf-8"))
    assert sorted(named) == sorted({*NAMES, sheet.PICTURE.stem})
    assert {path.name for path in FOLDER.iterdir()} == {f"{name}.png" for name in named}


@pytest.mark.parametrize("page", ["README.md", "README.pt-BR.md"])
def test_each_picture_has_words_for_those_who_do_not_see_it(page: str) -> None:
    words = re.findall(r"!\[(.*?)\]\(static/pictures/", (ROOT / page).read_text("utf-8"))
    assert all(len(said) > 10 for said in words)
    assert len(set(words)) == len(words) == len(GALLERY) + 1


@pytest.mark.parametrize("picture", GALLERY, ids=lambda picture: picture.name)
def test_a_picture_is_whole_and_light(picture: Picture) -> None:
    assert shown(picture).size == SIZES[picture.size]
    assert (FOLDER / f"{picture.name}.png").stat().st_size <= HEAVIEST


@pytest.mark.parametrize("picture", GALLERY, ids=lambda picture: picture.name)
def test_a_picture_is_not_empty_and_has_its_look(picture: Picture) -> None:
    grey = shown(picture)
    values = np.asarray(grey)
    assert grey.entropy() > LEAST_ENTROPY
    assert np.bincount(values.ravel()).max() < LARGEST_SHARE * values.size
    assert values.std() > LEAST_DEVIATION
    assert (np.median(values) < 128) == picture.dark
