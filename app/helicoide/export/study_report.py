"""The report of studies: one self-contained HTML page."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from helicoide.export import errata
from helicoide.export.chart_scale import scaled_chart
from helicoide.export.study_table import HEADINGS, computed_cell, fitted_line, row_cells, sorted_by_verdict, source_cell
from helicoide.export.svg import figure
from helicoide.ik.method import OneOf, Quantity, settings
from helicoide.markup import typeset
from helicoide.studies.study import Interpretation, Result, Row, Statement, Study, Verdict
from helicoide.text import Language, Text, untranslated

TITLE = Text(en="Studies of Helicoide", pt_BR="Estudos do Helicoide")
VERDICT_COUNTS = Text(
    en="Studies: {studies}. Rows: {rows}; {counts}. The whole took {seconds:.0f} s, some studies in parallel.",
    pt_BR="Estudos: {studies}. Linhas: {rows}; {counts}. Tudo levou {seconds:.0f} s, com estudos em paralelo.",
)
SOURCE_COUNTS = Text(
    en="{source}: rows compared: {stated}; different statements of the source in them: {said}; values fitted for them: "
    "{fitted}; readings chosen: {read}",
    pt_BR="{source}: linhas comparadas: {stated}; afirmações distintas da fonte nelas: {said}; valores ajustados para "
    "elas: {fitted}; leituras escolhidas: {read}",
)
DIFFERS = Text(en="What differs", pt_BR="O que difere")
DIFFERENCE = Text(
    en="{name}, {quantity}: the source says {printed}; computed here: {ours}{why}",
    pt_BR="{name}, {quantity}: a fonte diz {printed}; calculado aqui: {ours}{why}",
)
AND_WHY = untranslated("; {why}")
NONE_DIFFERS = Text(en="Nothing.", pt_BR="Nada.")
ABOUT_VERDICTS = Text(
    en="First comes what a source says, with its place: a number as it is printed, anything else in our words. The "
    "verdict is about that. A printed number is met to half a unit of its last digit, one printed with ≈ to a whole "
    "unit; words are met as the row reads them. Values that the source does not give may have been fitted so "
    "that its statements hold: they are named, with the range in which they do. Where it allows two readings, or "
    "leaves the instant open, the one that was taken is named, with what comes out otherwise. What a source shows in "
    "a figure only, what was put in, what holds by construction, and what no source prints, stands apart.",
    pt_BR="Primeiro vem o que a fonte diz, com o lugar: um número como está impresso, o resto em palavras nossas. É "
    "disso que trata o veredito. Um número impresso confere até meia unidade do último algarismo; se vem com ≈, até "
    "uma unidade inteira; palavras conferem como a linha as lê. Valores que a fonte não informa podem ter "
    "sido ajustados para que suas afirmações valham: são nomeados, com a faixa em que valem. Onde ela admite duas "
    "leituras, ou deixa o instante em aberto, a que foi tomada é nomeada, com o que resulta da outra. O que a fonte só "
    "mostra em figura, o que é dado de entrada, o que vale por construção e o que ninguém imprimiu ficam à parte.",
)
JUDGED = (Verdict.PRINTED, Verdict.FITTED, Verdict.DIFFERS, Verdict.ERRATUM)
SHORT = Text(en="quick run", pt_BR="execução rápida")
FAILED = Text(en="did not run to its end: {why}", pt_BR="não chegou ao fim: {why}")
TOOK = Text(en="{robot} · took {seconds:.1f} s", pt_BR="{robot} · levou {seconds:.1f} s")
STYLE = Markup("""
:root { color-scheme: light; font: 16px/1.5 system-ui, sans-serif; color: #1c2430; background: #fff; }
body { max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h2 { margin-top: 3rem; border-top: 1px solid #ccd2da; padding-top: 1rem; }
.source, .took, figure ul { color: #55606e; font-size: 0.9rem; }
.wide { overflow-x: auto; }
code { overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; font-size: 0.9rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 0.25rem 0.6rem; border-bottom: 1px solid #e3e7ec; vertical-align: top; }
td:nth-child(3) { white-space: nowrap; }
.verdict { font-weight: 600; border-left: 0.4rem solid; padding-left: 0.5rem; }
.printed { color: #1b6b3a; } .fitted { color: #5a3fa0; } .erratum { color: #8a5a00; } .differs { color: #b3261e; }
.figure, .ours { color: #55606e; font-weight: 400; }
figure { margin: 1.5rem 0; max-width: 44rem; } figcaption { font-weight: 600; }
figure ul, .axes { list-style: none; margin: 0; padding: 0; display: flex; flex-wrap: wrap; gap: 0.2rem 1.2rem; }
.axes { justify-content: space-between; font-size: 0.9rem; }
svg { width: 100%; height: auto; font-size: 12px; fill: #1c2430; } svg.swatch { width: 28px; height: 8px; }
.frame { fill: none; stroke: #8a94a0; } .grid { stroke: #e3e7ec; fill: none; }
.line { fill: none; stroke-width: 1.6; stroke-linejoin: round; }
@media (max-width: 40rem) { table { display: block; } thead, tbody { display: block; }
  tr { display: grid; grid-template-columns: 3fr 2fr; border-bottom: 1px solid #e3e7ec; padding: 0.3rem 0; }
  th, td { border: 0; padding: 0 0.4rem 0 0; } th:first-child, th:last-child { display: none; }
  td:first-child, td:last-child { grid-column: 1 / -1; } td:first-child { font-weight: 600; }
  td:nth-child(3) { white-space: normal; }
  svg { font-size: 15px; } }
@media print { body { max-width: none; margin: 0; font-size: 10pt; } h2, figcaption { break-after: avoid; }
  table, figure, tr { break-inside: avoid; } * { print-color-adjust: exact; } }
""").strip()
PAGE = Markup("""\
<!doctype html>
<html lang="{language}"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
{style}
</style></head><body>
<h1>{title}</h1>
<p>{counted}</p>
<ul>{of_sources}</ul>
<p>{about}</p>
<ol>{contents}</ol>
{sections}
<section id="differs"><h2>{differs}</h2>
{differences}</section>
<section id="errata">{errata}</section>
</body></html>
""")
SECTION = Markup("""\
<section id="{name}"><h2>{title}</h2>
<p class="source">{source}</p>
<p>{about}</p>
{options}{body}
<p class="took">{took}</p></section>""")
TABLE = Markup("""\
<div class="wide"><table><thead><tr>{heads}</tr></thead><tbody>
{rows}
</tbody></table></div>
{fitted}{charts}""")


@dataclass(frozen=True, eq=False)
class Record:
    """A study that was run: its options, its result or the reason of its failure; seconds: its duration."""

    name: str
    study: Study
    options: Any
    short: bool
    result: Result | None
    failure: Text | None
    seconds: float

    @property
    def differences(self) -> tuple[Row, ...]:
        """The rows that differ from what the source prints."""
        return () if self.result is None else tuple(r for r in self.result.rows if r.verdict is Verdict.DIFFERS)

    @property
    def unexplained(self) -> bool:
        """Whether the study failed or has a difference without an explanation."""
        return self.result is None or any(row.why is None for row in self.differences)


def report_page(records: Sequence[Record], seconds: float, language: Language) -> Markup:
    """The report as an HTML document. seconds: duration of all studies together."""
    entry = Markup('<li><a href="#{}">{}</a></li>')
    item = Markup("<li>{}</li>")
    return PAGE.format(
        language="pt-BR" if language == "pt_BR" else "en",
        title=TITLE[language],
        style=STYLE,
        counted=verdict_counts(records, seconds)[language],
        of_sources=_joined(item.format(words[language]) for words in source_counts(records)),
        about=ABOUT_VERDICTS[language],
        contents=_joined(entry.format(record.name, record.study.TITLE[language]) for record in records),
        sections=Markup("\n").join(_section(record, language) for record in records),
        differs=DIFFERS[language],
        differences=Markup("<ul>{}</ul>").format(
            _joined(item.format(typeset(words[language])) for words in differences(records))
        ),
        errata=errata.sources_page(language),
    )


def _joined(parts: Iterable[Markup]) -> Markup:
    return Markup("").join(parts)


def verdict_counts(records: Sequence[Record], seconds: float) -> Text:
    """The number of rows of each verdict, and the duration of all studies together, s."""
    verdicts = [row.verdict for record in records if record.result for row in record.result.rows]
    found = [(verdict.value, verdicts.count(verdict)) for verdict in Verdict]
    counts = Text(
        en="; ".join(f"{words.en}: {n}" for words, n in found if n) or "–",
        pt_BR="; ".join(f"{words.pt_BR}: {n}" for words, n in found if n) or "–",
    )
    return VERDICT_COUNTS.format(studies=len(records), rows=len(verdicts), counts=counts, seconds=seconds)


def source_counts(records: Sequence[Record]) -> list[Text]:
    """For each source: rows compared, different statements among them, fitted values and chosen interpretations."""
    results = [(record.study.SOURCE.partition(",")[0], record.result) for record in records if record.result]
    lines = []
    for name in dict.fromkeys(name for name, _ in results):
        of_it = [result for other, result in results if other == name]
        rows = [row for result in of_it for row in result.rows if row.verdict in JUDGED]
        chosen = {choice for result in of_it for choice in result.fitted}
        read = sum(isinstance(choice, Interpretation) for choice in chosen)
        said = {(row.source.words, row.source.place) for row in rows if isinstance(row.source, Statement)}
        lines.append(
            SOURCE_COUNTS.format(source=name, stated=len(rows), said=len(said), fitted=len(chosen) - read, read=read)
        )
    return lines


def differences(records: Sequence[Record]) -> list[Text]:
    """A sentence for each row that differs from its source."""
    found = [(record.study, row) for record in records for row in record.differences]
    return [_difference(study, row) for study, row in found] or [NONE_DIFFERS]


def _difference(study: Study, row: Row) -> Text:
    return DIFFERENCE.format(
        name=study.TITLE,
        quantity=row.quantity,
        printed=source_cell(row),
        ours=computed_cell(row),
        why=untranslated("") if row.why is None else AND_WHY.format(why=row.why),
    )


def options_line(record: Record, language: Language) -> str:
    """The options of a study and their values, in one line."""
    return "; ".join(
        f"{setting.title[language]}: {_value(setting, getattr(record.options, name), language)}"
        for name, setting in settings(type(record.options)).items()
    )


def _value(setting: object, value: Any, language: Language) -> str:
    match setting:
        case Quantity(_, _, _, unit):
            return untranslated("{value:g} {unit}").format(value=value, unit=unit)[language].strip()
        case OneOf(_, choices):
            return choices[value][language]
    return str({True: Text(en="yes", pt_BR="sim"), False: Text(en="no", pt_BR="não")}[value][language])


def _section(record: Record, language: Language) -> Markup:
    study, short = record.study, f" ({SHORT[language]})" if record.short else ""
    options = options_line(record, language)
    return SECTION.format(
        name=record.name,
        title=study.TITLE[language] + short,
        source=study.SOURCE,
        about=typeset(study.ABOUT[language]),
        options=Markup('<p class="source">{}</p>\n').format(options) if options else "",
        body=_body(record, language),
        took=TOOK.format(robot=study.ROBOT, seconds=record.seconds)[language],
    )


def _body(record: Record, language: Language) -> Markup:
    if record.result is None:
        why = record.failure[language] if record.failure else ""
        return Markup('<p class="verdict differs">{}</p>').format(FAILED.format(why=why)[language])
    chosen = fitted_line(record.result)
    return TABLE.format(
        fitted=Markup('<p class="source">{}</p>\n').format(typeset(chosen[language])) if chosen else "",
        heads=_joined(Markup("<th>{}</th>").format(head[language]) for head in HEADINGS),
        rows=Markup("\n").join(_row(row, language) for row in sorted_by_verdict(record.result.rows)),
        charts=Markup("\n").join(figure(scaled_chart(chart), language) for chart in record.result.charts),
    )


def _row(row: Row, language: Language) -> Markup:
    *plain, verdict = (typeset(cell[language]) for cell in row_cells(row))
    said = Markup('<a href="#{}">{}</a>').format(row.erratum, verdict) if row.verdict is Verdict.ERRATUM else verdict
    return Markup('<tr>{}<td><span class="verdict {}">{}</span></td></tr>').format(
        _joined(Markup("<td>{}</td>").format(cell) for cell in plain), row.verdict.name.lower(), said
    )
