"""Paths of the tool and of the joints, their time scaling, and paths that were taught point by point."""

from __future__ import annotations

from helicoide.trajectory.cerbaro import EQ_33, Ellipse
from helicoide.trajectory.path import Path

__all__ = ["EQ_33", "Ellipse", "Path"]
