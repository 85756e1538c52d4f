"""The colours of the scene, sRGB, 0 to 255; those of charts are the same (`export/svg.py`).

People who do not see red, green or blue can tell all pairs of them apart (`tests/view/test_colours.py`). Those of
`LINES` have a contrast of at least 3 : 1 with the light and the dark background. Objects that mean different things in
one picture have different colours here, or differ in shape. Source: Okabe and Ito 2008, with grey in place of black.
"""

from __future__ import annotations

Colour = tuple[int, int, int]

BLUE: Colour = (0, 114, 178)
VERMILION: Colour = (213, 94, 0)
GREEN: Colour = (0, 158, 115)
PURPLE: Colour = (204, 121, 167)
ORANGE: Colour = (230, 159, 0)
SKY: Colour = (86, 180, 233)
GREY: Colour = (105, 105, 105)
LINES = (BLUE, VERMILION, GREEN, PURPLE, GREY)
PALETTE = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, GREY)
