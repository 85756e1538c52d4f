"""The velocity ellipsoid of the tool: the velocities that joint velocities of unit norm give."""

from __future__ import annotations

from helicoide import readout
from helicoide.arrays import Array
from helicoide.kinematics.manipulability import Ellipsoid
from helicoide.state import State
from helicoide.text import Text
from helicoide.view.colours import BLUE
from helicoide.view.ellipsoid_layer import EllipsoidLayer
from helicoide.view.layers import Stage

NAME = "velocity_ellipsoid"
SHARED = False
TITLE = Text(en="Velocity ellipsoid", pt_BR="Elipsoide de velocidade")
SHOWN = False
KIND = "velocity"
SAID = Text(
    en="The velocities of the end effector that joint velocities with ‖q̇‖ = 1 rad/s give (a sliding joint: one reach "
    "per second). The numbers are the semi-axes in m/s; 1 m/s is 250 mm long.",
    pt_BR="As velocidades do efetuador que velocidades de junta com ‖q̇‖ = 1 rad/s dão (junta prismática: um alcance "
    "por segundo). Os números são os semieixos em m/s; 1 m/s tem 250 mm.",
)

SCALE = 0.25  # m for 1 m/s, as for the Jacobian columns
METRES_PER_SECOND = Text(en="{value:.3f} m/s", pt_BR="{value:.3f} m/s")


def build(stage: Stage) -> EllipsoidLayer:
    """The layer."""
    return EllipsoidLayer(stage, NAME, BLUE, velocity_semi_axes, METRES_PER_SECOND)


def velocity_semi_axes(state: State) -> tuple[Ellipsoid, Array]:
    """The ellipsoid, m/s, and its drawn semi-axes (3,), m."""
    found = readout.position_analysis(state).velocity_ellipsoid
    return found, SCALE * found.lengths
