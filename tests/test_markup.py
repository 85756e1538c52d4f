"""Symbols with an index, as HTML and as plain text."""

from __future__ import annotations

import pytest
from markupsafe import Markup

from helicoide.markup import plain_subscripts, typeset


@pytest.mark.parametrize(
    ("words", "html", "plain"),
    [
        ("‖e_p‖, cm", "‖e<sub>p</sub>‖, cm", "‖eₚ‖, cm"),
        ("V_c = 0", "V<sub>c</sub> = 0", "V_c = 0"),
        ("e_x and e_y", "e<sub>x</sub> and e<sub>y</sub>", "e_x and e_y"),
        ("(v_rd)", "(v<sub>rd</sub>)", "(v_rd)"),
        ("l_a² w_i", "l<sub>a</sub>² w<sub>i</sub>", "lₐ² wᵢ"),
        ("dt_max of virtual_effector", "dt_max of virtual_effector", "dt_max of virtual_effector"),
        ("<b> & x_i", "&lt;b&gt; &amp; x<sub>i</sub>", "<b> & xᵢ"),
        ("", "", ""),
    ],
)
def test_an_index_is_lowered(words: str, html: str, plain: str) -> None:
    assert typeset(words) == Markup(html)
    assert plain_subscripts(words) == plain
