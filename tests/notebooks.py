"""Notebooks in tests: validated by nbformat, run by a kernel of this environment, and what their cells give."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbclient import NotebookClient

PATIENCE = 600  # s, for the first kernels to be compiled


def ran(file: bytes, folder: Path) -> list[Any]:
    """The code cells of a notebook after it has been run in a folder. A cell that raises fails the test."""
    notebook = nbformat.reads(file.decode(), as_version=nbformat.NO_CONVERT)
    nbformat.validate(notebook)
    with pytest.MonkeyPatch.context() as patch:
        for place in ("IPYTHONDIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR"):  # nothing of the user's own
            patch.setenv(place, str(folder / place))
        NotebookClient(notebook, timeout=PATIENCE, resources={"metadata": {"path": str(folder)}}).execute()
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def shown(cell: Any) -> dict[str, Any]:
    """What the last line of a cell gives, by its kind, such as text/plain; empty without a result."""
    results = [output for output in cell.outputs if output.output_type == "execute_result"]
    return dict(results[0].data) if results else {}


def last_json(cell: Any) -> Any:
    """What a cell prints, read as JSON."""
    return json.loads("".join(output.text for output in cell.outputs if output.output_type == "stream"))
