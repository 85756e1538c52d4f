"""The workspace of a robot: the positions that its tool can reach."""

from __future__ import annotations

import json as json_format
import os
import sys
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import tyro

from helicoide.commands import chain_ends, chain_ends_json, language, print_remarks
from helicoide.jobs import chunks
from helicoide.jobs.chunks import Backend
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import MapKind, WorkspaceMap, fixed_tool_text, plan_map
from helicoide.text import HelicoideError, Language, Text, numbers_text

WIDTH = 40
REACHED = Text(
    en="{robot}: {what} of {measure:.4g} m{power} reached by {samples} postures",
    pt_BR="{robot}: alcança {what} de {measure:.4g} m{power}, em {samples} posturas",
)
AREA, VOLUME = Text(en="an area", pt_BR="uma área"), Text(en="a volume", pt_BR="um volume")
CELLS = Text(en="   {reached} of {count} cells of {mm:.1f} mm", pt_BR="   {reached} de {count} células de {mm:.1f} mm")
DEXTEROUS = Text(
    en="   at best {value:.1%} of all orientations, at {position} m; mean {mean:.1%}",
    pt_BR="   no melhor lugar, {value:.1%} de todas as orientações, em {position} m; média {mean:.1%}",
)
MANIPULABILITY = Text(
    en="   at best w = {value:.4g}, at {position} m; mean {mean:.4g}",
    pt_BR="   no melhor lugar, w = {value:.4g}, em {position} m; média {mean:.4g}",
)


def run(
    robot: tyro.conf.Positional[str],
    kind: MapKind = "reachable",
    samples: int = 1_000_000,
    workers: Annotated[int | None, tyro.conf.arg(help="processes; as many as there are processors if none")] = None,
    backend: Backend = "loky",
    tip: str | None = None,
    base: str | None = None,
    set: tuple[str, ...] = (),
    json: bool = False,
    out: Path | None = None,
) -> None:
    """Map what the tool of a robot reaches, by random postures within its joint limits.

    Ends with 0 if the map was made, and with 2 for wrong input.

    Args:
        robot: name of a robot, or the path of a URDF file.
        kind: where it reaches at all; with what share of all orientations; or with what manipulability of position.
        samples: how many postures; the more, the finer the map.
        backend: processes of this machine, or those of a Dask or Ray cluster: DASK_SCHEDULER_ADDRESS, RAY_ADDRESS.
        tip: the link of a URDF where the arm ends.
        base: the link of a URDF where the arm begins; its root if none.
        set: parameters of a robot to change, mm, such as l1=1500.
        json: print JSON (SI units).
        out: write the map to this file (.npz): hits, values, shape, origin, axes and size of the cells, m.
    """
    arm = load_robot(robot, tip, set, base)
    print_remarks(arm)
    _check(out)
    plan = plan_map(arm, kind, samples)
    found = chunks.workspace_map(plan, os.cpu_count() or 1 if workers is None else workers, backend, _show)
    if out is not None:
        chunks.write_arrays(out, map_arrays(found))
    if json:
        print(json_format.dumps(map_json(arm, found), indent=1))
        return
    print("\n".join(_lines(arm, found, language())))


def map_arrays(found: WorkspaceMap) -> chunks.Arrays:
    """What `--out` writes."""
    cells = found.cells
    grid = {"origin": cells.origin, "axes": cells.axes, "size": np.array(cells.size), "shape": np.array(cells.shape)}
    return {"hits": found.hits, "values": found.values, **grid}


def map_json(robot: Robot, found: WorkspaceMap) -> dict[str, Any]:
    """A map as JSON, in m, m² or m³; best: the largest value and the centre of its cell."""
    best = int(np.argmax(found.values))
    return {
        "robot": robot.name,
        **chain_ends_json(robot),
        "kind": found.kind,
        "samples": found.samples,
        "dimensions": len(found.cells.shape),
        "cell": found.cells.size,
        "shape": list(found.cells.shape),
        "reached": int(found.reached.sum()),
        "measure": 0.0 if robot.fixed_tool_point else found.measure,
        "best": {"value": float(found.values[best]), "position": found.cells.centres[best].tolist()},
        "mean": float(found.values[found.reached].mean()),
    }


def _lines(robot: Robot, found: WorkspaceMap, spoken: Language) -> list[str]:
    """The numbers as lines of text."""
    said = map_json(robot, found)
    what, power = (AREA, "²") if said["dimensions"] == 2 else (VOLUME, "³")
    position = numbers_text([x + 0.0 for x in said["best"]["position"]], ".3f")
    value, mean = said["best"]["value"], said["mean"]
    lines = [
        REACHED.format(robot=robot.name, what=what, measure=said["measure"], power=power, samples=found.samples),
        CELLS.format(reached=said["reached"], count=found.cells.count, mm=1000 * found.cells.size),
    ]
    if found.kind == "dexterous":
        lines.append(DEXTEROUS.format(value=value, position=position, mean=mean))
    if found.kind == "manipulability":
        lines.append(MANIPULABILITY.format(value=value, position=position, mean=mean))
    if robot.fixed_tool_point:
        lines[:2] = [fixed_tool_text(robot, robot.name)]
    return [line[spoken] for line in [lines[0], chain_ends(robot), *lines[1:]]]


def _show(share: float) -> None:
    """Show a progress bar if stderr is a terminal."""
    if sys.stderr.isatty():
        bar = "█" * round(WIDTH * share)
        print(f"\r{bar:·<{WIDTH}} {share:4.0%}", end="\n" if share >= 1 else "", file=sys.stderr, flush=True)


def _check(out: Path | None) -> None:
    """Refuse an output file that cannot be written before the work begins."""
    if out is not None and not os.access(out.absolute().parent, os.W_OK):
        raise HelicoideError(
            Text(
                en="{out} cannot be written: give a file in an existing folder that can be written to.",
                pt_BR="Não dá para gravar {out}: indique um arquivo numa pasta que existe e aceita gravação.",
            ).format(out=out)
        )
