"""How near is near: the zones of the distance from a plane, and what may be chosen for them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum

from helicoide.text import HelicoideError, Text

# The shell of the arm extends this far from the screw axes (Cerbaro 2022, fig. 43): the planes watch points, so no
# critical distance may be less. The source leaves 15 mm beyond it; at least MARGIN is always left.
SHELL_THICKNESS, MARGIN = 0.065, 0.010
LEAST_CRITICAL = SHELL_THICKNESS + MARGIN
# Beyond these an arm between walls 620 mm apart, those of the source, has hardly room left to move or to be free.
MOST_CRITICAL, MOST_WARNING = 0.150, 0.250
# The warning zone is at least so deep: what approaches at 1 m/s is in it for one tick at least.
LEAST_DEPTH = 0.010


class Zone(Enum):
    """How near a point is to a plane."""

    FREE = "free"
    WARNING = "warning"
    CRITICAL = "critical"


@dataclass(frozen=True)
class Zones:
    """Distances in m: no guarded point comes closer to a plane than `critical`; from `warning` on the arm is said to be
    near. `body_clearance`: what stays free between two bodies, measured from surface to surface.
    """

    critical: float = 0.080
    warning: float = 0.110
    body_clearance: float = 0.010

    def zone_of(self, distance: float) -> Zone:
        """The zone of a distance in m; what is held at the critical distance counts as critical."""
        if distance <= self.critical + 1e-6:
            return Zone.CRITICAL
        return Zone.WARNING if distance < self.warning else Zone.FREE

    def adjusted(self, critical: float, warning: float) -> Zones:
        """The same zones with other distances, m; raises HelicoideError outside the safe bounds, which it names."""
        if not LEAST_CRITICAL <= critical <= MOST_CRITICAL or not critical + LEAST_DEPTH <= warning <= MOST_WARNING:
            raise HelicoideError(
                Text(
                    en="The critical distance is {least:g} to {most:g} mm (the arm's shell is {shell:g} mm thick), and "
                    "the warning begins {depth:g} mm or more before it, at {far:g} mm at most.",
                    pt_BR="A distância crítica vai de {least:g} a {most:g} mm (a carcaça do braço tem {shell:g} mm), e "
                    "o aviso começa pelo menos {depth:g} mm antes dela, no máximo a {far:g} mm.",
                ).format(
                    least=1000 * LEAST_CRITICAL,
                    most=1000 * MOST_CRITICAL,
                    shell=1000 * SHELL_THICKNESS,
                    depth=1000 * LEAST_DEPTH,
                    far=1000 * MOST_WARNING,
                )
            )
        return replace(self, critical=float(critical), warning=float(warning))
