"""The partial products of the joints' motors as frames: where the base frame is carried by m₁, by m₁m₂, …"""

from __future__ import annotations

import numpy as np

from helicoide.readout import partial_displacements
from helicoide.text import Text
from helicoide.view.figures import FrameSet, Names
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.window_view import View

NAME = "products"
SHARED = False
TITLE = Text(en="Partial products of motors", pt_BR="Produtos parciais de motores")
SHOWN = False
KIND = "algebra"
SAID = Text(
    en="Where the base frame is carried by the motor of the first joint, m₁, by the product m₁m₂, and so on; the whole "
    "product times M₀, the end effector with all joints at zero, is the end-effector motor M.",
    pt_BR="Aonde o referencial da base é levado pelo motor da primeira junta, m₁, pelo produto m₁m₂ e assim por "
    "diante; o produto todo vezes M₀, o efetuador com todas as juntas em zero, é o motor M do efetuador.",
)

AXES, ABOVE = 0.11, 0.02  # length of the axes, and height of the names above the origins, × size, m
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def build(stage: Stage) -> ProductsLayer:
    """The layer."""
    return ProductsLayer(stage, NAME)


def product_name(count: int) -> str:
    """The name of the product of the first motors: m₁, m₁m₂, m₁…m₃."""
    last = f"m{count}".translate(SUBSCRIPTS)
    return last if count == 1 else f"m₁{'' if count == 2 else '…'}{last}"


class ProductsLayer(OptionalLayer):
    """The frames in one node, and their names."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.frames = FrameSet(stage, f"/{name}/frames", AXES)
        self.names = Names(stage, f"/{name}")

    def draw(self, view: View) -> None:
        """Follow the joints."""
        state = view.state
        Ts = np.concatenate([partial_displacements(state), state.T_world_tool[None]])
        self.frames.write(Ts)
        count = len(Ts) - 1
        names = [*(product_name(k + 1) for k in range(count)), f"M = {product_name(count)}M₀"]
        self.names.write(names, Ts[:, :3, 3] + [0, 0, ABOVE * self.stage.size])
