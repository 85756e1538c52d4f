"""One person at the lab: `seat` has the language, the lesson and the settings; the other files have parts of it."""

from helicoide.seat.chart_choice import ChartChoice
from helicoide.seat.inspection import Notation, Selection, SelectionKind, ShownAlgebra
from helicoide.seat.lesson_progress import LessonProgress, PredictionAnswer
from helicoide.seat.playground import AxisAngle, Playground
from helicoide.seat.seat import LinkedPosture, Seat, SeatUpdate

__all__ = [
    "AxisAngle",
    "ChartChoice",
    "LessonProgress",
    "LinkedPosture",
    "Notation",
    "Playground",
    "PredictionAnswer",
    "Seat",
    "SeatUpdate",
    "Selection",
    "SelectionKind",
    "ShownAlgebra",
]
