"""Rows that save what the page shows: as a notebook, as a clip, as a picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from markupsafe import Markup
from viser import Icon

from helicoide.text import Text, untranslated
from helicoide.view import html
from helicoide.view.requests import ForSeat, SaveClip, SaveNotebook, SavePicture
from helicoide.view.rows import Button, DependentRows, Dropdown, Folder, HtmlRow, Row
from helicoide.view.window_view import View

TITLE = Text(en="Take home", pt_BR="Levar para casa")
NOTEBOOK = Text(en="Jupyter notebook of this scene", pt_BR="Caderno Jupyter desta cena")
CLIP = Text(en="Clip of the last seconds", pt_BR="Clipe dos últimos segundos")
CLIP_OF = Text(en="Clip: {motion}", pt_BR="Clipe: {motion}")
PICTURE = Text(en="Picture (PNG)", pt_BR="Imagem (PNG)")
SIZE = Text(en="Size of the picture", pt_BR="Tamanho da imagem")
ABOUT = Text(
    en="A clip opens in any browser, without a network. The notebook computes the numbers of the scene again.",
    pt_BR="O clipe abre em qualquer navegador, sem rede. O caderno calcula de novo os números da cena.",
)
NO_MOTION = Text(en="Run a study first.", pt_BR="Execute um estudo primeiro.")
HOW = Text(en="Helicoide in a notebook", pt_BR="O Helicoide num caderno")
NOTE = Markup("<div class='helicoide-note'><p>{}</p><p><a href='pages/{}/notebook' target='_blank'>{}</a></p></div>")
# The page draws a picture with the pixels of its screen, up to three for each of these in both directions.
PICTURES: dict[str, tuple[int, int]] = {
    "small": (640, 360),
    "page": (1280, 720),
    "slide": (1920, 1080),
    "print": (2560, 1440),
    "upright": (1080, 1920),
}


def export_rows() -> Folder:
    """The folder of what can be taken home."""
    size = untranslated("{width} × {height}")
    rows: list[Row] = [
        HtmlRow(_about),
        Button(lambda _: NOTEBOOK, lambda _: SaveNotebook(), Icon.NOTEBOOK, lambda view: view.ready),
        Button(lambda _: CLIP, lambda _: SaveClip(), Icon.MOVIE, lambda view: view.ready),
        Folder(
            Text(en="Motions of the study", pt_BR="Movimentos do estudo"),
            DependentRows(lambda view: tuple(motion.title for motion in view.study_panel.motions), _clips),
            open=False,
        ),
        Dropdown(
            SIZE,
            [(key, size.format(width=width, height=height)) for key, (width, height) in PICTURES.items()],
            lambda view: view.seat.picture,
            lambda key: ForSeat(lambda seat: replace(seat, picture=key)),
        ),
        Button(lambda _: PICTURE, lambda view: SavePicture(PICTURES[view.seat.picture]), Icon.PHOTO),
    ]
    return Folder(TITLE, rows, open=False)


def _about(view: View) -> Markup:
    language = view.seat.language
    return NOTE.format(ABOUT[language], language, HOW[language])


def _clips(titles: tuple[Text, ...]) -> Sequence[Row]:
    """A button for each motion of the study."""
    if not titles:
        return [HtmlRow(lambda view: html.note(NO_MOTION[view.seat.language]))]
    return [_clip(index, title) for index, title in enumerate(titles)]


def _clip(index: int, title: Text) -> Button:
    label = CLIP_OF.format(motion=title)
    return Button(lambda _: label, lambda view: SaveClip(view.study_panel.motions[index]), Icon.MOVIE)
