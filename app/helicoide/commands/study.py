"""Run studies: print a table of printed and computed numbers, and write a report with charts."""

from __future__ import annotations

import json as json_format
import logging
import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

import tyro
from tqdm import tqdm

from helicoide import studies
from helicoide.commands import NOT_REACHED, language
from helicoide.export.study_json import study_json
from helicoide.export.study_report import (
    DIFFERS,
    FAILED,
    Record,
    differences,
    options_line,
    report_page,
    source_counts,
    verdict_counts,
)
from helicoide.export.study_table import HEADINGS, fitted_line, row_cells, sorted_by_verdict
from helicoide.files.os_errors import os_error_reason
from helicoide.ik.method import OneOf, Quantity, YesNo, changed, settings
from helicoide.jobs.parallel import JobOutcome, Progress, run_parallel, run_timed
from helicoide.studies.study import Result
from helicoide.text import HelicoideError, Language, Text, untranslated

log = logging.getLogger("helicoide")

WORDS = {"true": True, "yes": True, "sim": True, "false": False, "no": False, "não": False}
CRASHED = Text(en="the program failed; the terminal shows where", pt_BR="o programa falhou; o terminal mostra onde")
CANNOT_WRITE = Text(en="{report} cannot be written: {why}.", pt_BR="Não dá para gravar {report}: {why}.")


@dataclass(frozen=True)
class StudyRequest:
    """A study to run: its name, its options, and whether it is a quick run."""

    name: str
    options: Any
    short: bool


def run(
    name: Annotated[tyro.conf.Positional[str | None], tyro.conf.arg(help="name of a study, see --list")] = None,
    list: bool = False,
    all: bool = False,
    short: bool = False,
    set: tuple[str, ...] = (),
    report: Path | None = None,
    json: bool = False,
    workers: int = 2,
    lang: Annotated[
        Literal["en", "pt_BR"] | None,
        tyro.conf.arg(help="language of what is printed and reported; that of the terminal if none"),
    ] = None,
) -> None:
    """Run a study, or all of them, and print what the source states next to what is computed.

    Ends with 0 if all is well, with 1 if a row differs without an explanation, with 3 if a study did not run to its
    end, and with 2 for wrong input.

    Args:
        list: print the names of all studies and their options.
        all: run every study, several in parallel.
        short: a quick run of a few seconds.
        set: options of the study, such as gain=500.
        report: an HTML file to write, with the curves.
        json: print JSON (with the curves).
        workers: how many studies run at a time with --all.
    """
    spoken = lang or language()
    if list:
        _print_list(spoken)
        return
    asked = _asked(name, all, set, short)
    _check(report, workers)
    began = time.perf_counter()
    records = _run(asked, workers)
    seconds = time.perf_counter() - began
    if report is not None:
        _write(report, report_page(records, seconds, spoken))
    if json:
        print(json_format.dumps([study_json(record) for record in records], indent=1, allow_nan=False))
    else:
        _print(records, seconds, spoken)
    if any(record.result is None for record in records):
        sys.exit(NOT_REACHED)
    if any(record.unexplained for record in records):
        sys.exit(1)


def _asked(name: str | None, all: bool, set: tuple[str, ...], short: bool) -> tuple[StudyRequest, ...]:
    """The studies to run; raises HelicoideError, which lists the names."""
    if all and (name is not None or set):
        raise HelicoideError(
            Text(
                en="--all runs every study as it is: give it neither a name nor --set, or one name without --all.",
                pt_BR="--all executa todos os estudos como são: use sem nome e sem --set, ou um nome sem --all.",
            )
        )
    if all:
        return tuple(StudyRequest(each, studies.study_named(each).Options(), short) for each in studies.study_names())
    if name is None:
        raise HelicoideError(
            Text(
                en="Name a study, or use --list or --all; studies: {known}.",
                pt_BR="Diga o nome de um estudo, ou use --list ou --all; estudos: {known}.",
            ).format(known=", ".join(studies.study_names()))
        )
    return (StudyRequest(name, _with(studies.study_named(name).Options(), set), short),)


def _with(options: Any, set: tuple[str, ...]) -> Any:
    """The options changed by `set`; raises HelicoideError, which lists the valid values."""
    for pair in set:
        name, _, text = pair.partition("=")
        options = changed(options, name, _value(settings(type(options)).get(name), text))
    return options


def _value(setting: object, text: str) -> object:
    """The typed text as a value of the setting; unchanged if it is invalid, so that it is refused later."""
    match setting:
        case Quantity():
            try:
                return float(text)
            except ValueError:
                return text
        case YesNo():
            return WORDS.get(text.lower(), text)
    return text


def _check(report: Path | None, workers: int) -> None:
    if not 1 <= workers <= 64:
        raise HelicoideError(
            Text(en="--workers takes 1 … 64, not {n}.", pt_BR="--workers aceita 1 … 64, não {n}.").format(n=workers)
        )
    if report is None:
        return
    if report.is_dir() or not os.access(report.parent, os.W_OK) or (report.exists() and not os.access(report, os.W_OK)):
        _refuse(report)


def _refuse(report: Path) -> None:
    raise HelicoideError(
        Text(
            en="{report} cannot be written; --report takes a file, such as report.html, in an existing folder.",
            pt_BR="Não dá para escrever {report}; --report recebe um arquivo, como relatorio.html, em pasta existente.",
        ).format(report=report)
    )


def _write(report: Path, text: str) -> None:
    try:
        report.write_text(text, "utf-8")
    except OSError as error:
        raise HelicoideError(CANNOT_WRITE.format(report=report, why=os_error_reason(error))) from error


def _work(call: StudyRequest, progress: Progress) -> Result:
    return studies.run_study(call.name, call.options, call.short, progress)


def _run(call: tuple[StudyRequest, ...], workers: int) -> list[Record]:
    with _bar(len(call)) as progress:
        if len(call) == 1:
            outcomes = [run_timed(_work, call[0], progress)]
        else:
            outcomes = run_parallel(_work, call, workers, progress)
    return [_record(one, outcome) for one, outcome in zip(call, outcomes, strict=True)]


def _record(call: StudyRequest, outcome: JobOutcome[Result]) -> Record:
    error, failure = outcome.failure, None
    if error is not None:
        failure = error.text if isinstance(error, HelicoideError) else CRASHED
    if failure is CRASHED:
        log.error("the study %s stopped", call.name, exc_info=error)
    study = studies.study_named(call.name)
    return Record(call.name, study, call.options, call.short, outcome.value, failure, outcome.seconds)


@contextmanager
def _bar(count: int) -> Iterator[Callable[[float], None]]:
    """A progress bar on stderr."""
    form = "{percentage:3.0f}% |{bar}| {elapsed} < {remaining}"
    with tqdm(total=1.0, bar_format=form, leave=False, mininterval=0.5, file=sys.stderr) as bar:

        def progress(share: float) -> None:
            bar.update(share - bar.n)

        yield progress


def _print_list(language: Language) -> None:
    for name in studies.study_names():
        study = studies.study_named(name)
        print(f"{name}: {study.TITLE[language]} ({study.SOURCE})")
        for option, setting in settings(study.Options).items():
            print(f"   {option}={_range(setting)}: {setting.title[language]}")


def _range(setting: object) -> str:
    match setting:
        case Quantity(_, lower, upper, unit):
            return f"{lower:g}…{upper:g} {unit}".strip()
        case OneOf(_, choices):
            return "|".join(choices)
    return "yes|no"


def _print(records: list[Record], seconds: float, language: Language) -> None:
    for record in records:
        print(f"{record.study.TITLE[language]} ({record.study.SOURCE})")
        if options := options_line(record, language):
            print(options)
        if record.result is None:
            print(FAILED.format(why=record.failure or untranslated(""))[language] + "\n")
            continue
        for line in _table(record.result, language):
            print(line)
        if chosen_for_it := fitted_line(record.result):
            print(chosen_for_it[language])
        print()
    print(verdict_counts(records, seconds)[language])
    for said in (*source_counts(records), DIFFERS, *differences(records)):
        print(said[language])


def _table(result: Result, language: Language) -> list[str]:
    lines = [HEADINGS, *(row_cells(row) for row in sorted_by_verdict(result.rows))]
    rows = [tuple(cell[language] for cell in line) for line in lines]
    widths = [max(len(row[i]) for row in rows) for i in range(len(HEADINGS))]
    return ["  ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)).rstrip() for row in rows]
