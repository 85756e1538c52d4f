"""The zones of the distance from a plane: free, warning, critical; and their valid ranges."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum

from helicoide.text import HelicoideError, Text

# The shell of the arm extends this far from the screw axes (Cerbaro 2022, fig. 43). Distances are taken from points, so
# the critical distance must be larger. The source adds 15 mm; at least MARGIN is required here.
SHELL_THICKNESS, MARGIN = 0.065, 0.010
LEAST_CRITICAL = SHELL_THICKNESS + MARGIN
# With larger values an arm between walls 620 mm apart, as in the source, has hardly any free space.
MOST_CRITICAL, MOST_WARNING = 0.150, 0.250
# Least depth of the warning zone: a point that approaches at 1 m/s is in it for at least one tick.
LEAST_DEPTH = 0.010


class Zone(Enum):
    """The zone of a point's distance from a plane."""

    FREE = "free"
    WARNING = "warning"
    CRITICAL = "critical"


@dataclass(frozen=True)
class Zones:
    """Distances, m: no monitored point comes closer to a plane than `critical`; below `warning` people are warned.

    body_clearance: least clearance between two bodies, from surface to surface.
    """

    critical: float = 0.080
    warning: float = 0.110
    body_clearance: float = 0.010

    def zone_of(self, distance: float) -> Zone:
        """The zone of a distance, m; a point limited at the critical distance counts as critical."""
        if distance <= self.critical + 1e-6:
            return Zone.CRITICAL
        return Zone.WARNING if distance < self.warning else Zone.FREE

    def adjusted(self, critical: float, warning: float) -> Zones:
        """The zones with other distances, m; raises HelicoideError outside the valid range, which it states."""
        if not LEAST_CRITICAL <= critical <= MOST_CRITICAL or not critical + LEAST_DEPTH <= warning <= MOST_WARNING:
            raise HelicoideError(
                Text(
                    en="The safety distance must be {least:g} to {most:g} mm (the arm's shell is {shell:g} mm thick). "
                    "The warning distance must be at least {depth:g} mm larger, and at most {far:g} mm.",
                    pt_BR="A distância de segurança vai de {least:g} a {most:g} mm (a carcaça do braço tem {shell:g} "
                    "mm). A distância de aviso deve ser pelo menos {depth:g} mm maior, e no máximo {far:g} mm.",
                ).format(
                    least=1000 * LEAST_CRITICAL,
                    most=1000 * MOST_CRITICAL,
                    shell=1000 * SHELL_THICKNESS,
                    depth=1000 * LEAST_DEPTH,
                    far=1000 * MOST_WARNING,
                )
            )
        return replace(self, critical=float(critical), warning=float(warning))
