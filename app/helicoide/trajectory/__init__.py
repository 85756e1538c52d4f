"""Paths of the tool and of the joints, time scaling, and taught waypoints."""

from __future__ import annotations

from helicoide.trajectory.cerbaro import EQ_33, Ellipse
from helicoide.trajectory.path import Path

__all__ = ["EQ_33", "Ellipse", "Path"]
