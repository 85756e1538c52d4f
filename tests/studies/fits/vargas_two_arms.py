"""What the two arms of Vargas 2013 (figs. 4.43–4.44) come to around the values that were chosen for them.

`python -m tests.studies.fits.vargas_two_arms` prints the least distance without the term, and with it at two steps, for
each value changed by 5 and 10 %; the last column is what half the step changes. Some minutes.
"""

from __future__ import annotations

from helicoide.studies.vargas.secondary import least_link_distance, no_progress
from helicoide.studies.vargas_two_arms import ALPHA, BASE, RADIUS, Options, second_arm, second_arm_run

STEPS, FACTORS = (4e-3, 2e-3), (0.9, 0.95, 1.0, 1.05, 1.1)


def distance(weight: float, dt: float, radius: float, base: float) -> float:
    """The least distance of both arms after the transient, ℓ."""
    run = second_arm_run(weight, Options().gain, dt, no_progress, radius, base)
    return least_link_distance(run, lambda t: second_arm(t, base=base))


def main() -> None:
    """A line for each set of values."""
    sets = {(ALPHA * k, RADIUS, BASE) for k in FACTORS} | {(ALPHA, RADIUS * k, BASE) for k in FACTORS}
    for alpha, radius, base in sorted(sets | {(ALPHA, RADIUS, BASE * k) for k in FACTORS[1:4]}):
        without = distance(0.0, STEPS[0], radius, base)
        coarse, fine = (distance(alpha, dt, radius, base) for dt in STEPS)
        values = f"α = {alpha:.3g}, ρ = {radius:.3g}, x = {base:.3g}"
        print(f"{values}: {without:.4f} → {coarse:.4f}, {fine:.4f} ({fine / coarse - 1:+.2%})", flush=True)


if __name__ == "__main__":
    main()
