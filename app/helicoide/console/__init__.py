"""The console: a small language of expressions over the multivectors of the scene, and its sheets.

A line is an expression, such as `join(elbow, wrist)`, or a definition, such as `L = join(elbow, wrist)`. `grammar.py`
reads it, `evaluate.py` computes it with the operators of `geometry`, `functions/` holds the functions, one entry each,
`scene_names.py` the names of the arm and of what is around it. Nothing of Python can be reached: a name is a key of a
table, and there are no attributes, no strings, no loops and no functions of the user.
"""

from helicoide.console.errors import ExpressionError, pointer
from helicoide.console.examples import ExampleSheet, example_sheets
from helicoide.console.functions import all_functions
from helicoide.console.kinds import Kind, kind_of
from helicoide.console.names import free_names
from helicoide.console.notation_of_values import unit_grade, unit_latex, value_latex, value_terms, value_text
from helicoide.console.results import LineResult, sheet_results
from helicoide.console.scene_names import SceneName, scene_names
from helicoide.console.values import Value

__all__ = [
    "ExampleSheet",
    "ExpressionError",
    "Kind",
    "LineResult",
    "SceneName",
    "Value",
    "all_functions",
    "example_sheets",
    "free_names",
    "kind_of",
    "pointer",
    "scene_names",
    "sheet_results",
    "unit_grade",
    "unit_latex",
    "value_latex",
    "value_terms",
    "value_text",
]
