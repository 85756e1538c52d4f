"""Colours as people with dichromatic vision see them, and how different two colours look."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from helicoide.arrays import Array

# Machado, Oliveira and Fernandes 2009, table 1, severity 1.0, for linear RGB.
VISIONS = {
    "normal": np.eye(3),
    "protan": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "deutan": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "tritan": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}
# From linear sRGB to XYZ, with the white of D65.
TO_XYZ = np.array(
    [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
)
WHITE = TO_XYZ.sum(axis=1)


def linear(rgb: Sequence[float]) -> Array:
    """Linear RGB (3,), 0 to 1, of an sRGB colour, 0 to 255 each."""
    v = np.asarray(rgb, dtype=np.float64) / 255
    return np.asarray(np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4))


def lab(rgb: Sequence[float], vision: str = "normal") -> Array:
    """CIE L*a*b* of an sRGB colour as a vision sees it."""
    xyz = TO_XYZ @ np.clip(VISIONS[vision] @ linear(rgb), 0, 1) / WHITE
    f = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def ciede2000(one: Array, other: Array) -> float:
    """The colour difference ΔE₀₀ of two colours in L*a*b*. Source: Sharma, Wu and Dalal 2005, eqs. 2–22."""
    L, C = np.array([one[0], other[0]]), np.hypot([one[1], other[1]], [one[2], other[2]])
    G = 0.5 * (1 - np.sqrt(C.mean() ** 7 / (C.mean() ** 7 + 25.0**7)))
    a, b = (1 + G) * np.array([one[1], other[1]]), np.array([one[2], other[2]])
    C, h = np.hypot(a, b), np.degrees(np.arctan2(b, a)) % 360
    grey = C.prod() == 0
    turn = 0.0 if grey else (h[1] - h[0] + 180) % 360 - 180
    dL, dC, dH = L[1] - L[0], C[1] - C[0], 2 * np.sqrt(C.prod()) * np.sin(np.radians(turn / 2))
    far = abs(h[0] - h[1]) > 180
    mean = h.sum() if grey else (h.sum() + (360 if far and h.sum() < 360 else -360 if far else 0)) / 2
    T = 1 + sum(
        w * np.cos(np.radians(k * mean + s))
        for w, k, s in ((-0.17, 1, -30), (0.24, 2, 0), (0.32, 3, 6), (-0.2, 4, -63))
    )
    S_L = 1 + 0.015 * (L.mean() - 50) ** 2 / np.sqrt(20 + (L.mean() - 50) ** 2)
    S_C, S_H = 1 + 0.045 * C.mean(), 1 + 0.015 * C.mean() * T
    R = -2 * np.sqrt(C.mean() ** 7 / (C.mean() ** 7 + 25.0**7))
    R *= np.sin(np.radians(60 * np.exp(-(((mean - 275) / 25) ** 2))))
    x, y, z = dL / S_L, dC / S_C, dH / S_H
    return float(np.sqrt(x**2 + y**2 + z**2 + R * y * z))


def difference(one: Sequence[float], other: Sequence[float], vision: str) -> float:
    """How different two sRGB colours look to a vision, ΔE₀₀."""
    return ciede2000(lab(one, vision), lab(other, vision))


def contrast(one: Sequence[float], other: Sequence[float]) -> float:
    """The contrast of two sRGB colours, 1 to 21. Source: WCAG 2."""
    dark, light = sorted(float(TO_XYZ[1] @ linear(colour)) for colour in (one, other))
    return (light + 0.05) / (dark + 0.05)
