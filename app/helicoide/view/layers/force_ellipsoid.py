"""The force ellipsoid of the tool: the forces that joint torques of unit norm balance."""

from __future__ import annotations

import numpy as np

from helicoide import readout
from helicoide.arrays import Array
from helicoide.kinematics.manipulability import Ellipsoid
from helicoide.state import State
from helicoide.text import Text
from helicoide.view.colours import VERMILION
from helicoide.view.ellipsoid_layer import EllipsoidLayer
from helicoide.view.layers import Stage

NAME = "force_ellipsoid"
SHARED = False
TITLE = Text(en="Force ellipsoid", pt_BR="Elipsoide de força")
SHOWN = False
KIND = "velocity"
SAID = Text(
    en="The forces on the end effector that joint torques with ‖τ‖ = 1 N·m balance (a sliding joint: 1 N times the "
    "reach). The numbers are the semi-axes in N; beyond half the reach the drawing is cut, ∞ needs no torque.",
    pt_BR="As forças no efetuador que torques de junta com ‖τ‖ = 1 N·m equilibram (junta prismática: 1 N vezes o "
    "alcance). Os números são os semieixos em N; além de meio alcance o desenho é cortado, e ∞ não requer torque.",
)

SHARE, LONGEST_SHARE = 0.05, 0.5  # of the reach: the semi-axis for a force of 1/reach N, and the longest that is drawn
NEWTONS_BALANCED = Text(en="{value:.2f} N", pt_BR="{value:.2f} N")


def build(stage: Stage) -> EllipsoidLayer:
    """The layer."""
    return EllipsoidLayer(stage, NAME, VERMILION, force_semi_axes, NEWTONS_BALANCED)


def force_semi_axes(state: State) -> tuple[Ellipsoid, Array]:
    """The ellipsoid, N, and its drawn semi-axes (3,), m."""
    found, reach = readout.position_analysis(state).force_ellipsoid, state.robot.reach
    return found, np.minimum(SHARE * reach * reach * found.lengths, LONGEST_SHARE * reach)
