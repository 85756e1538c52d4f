"""Rows for recordings: record the arm, look at what was recorded, replay it, take it home."""

from __future__ import annotations

from collections.abc import Sequence

from markupsafe import Markup
from viser import Icon

from helicoide.kinematics.robot import Robot
from helicoide.recorder import panel_state
from helicoide.recorder.folder import RecordingFile
from helicoide.recorder.recorder import BOUNDS
from helicoide.recorder.replay import replay_recording
from helicoide.studies.study import Chart
from helicoide.text import Text, untranslated
from helicoide.view import html
from helicoide.view.requests import DeleteRecording, ForArm, ForRecordingPanel, OpenRecording, RecordArm, SaveRecording
from helicoide.view.rows import Button, DependentRows, Dropdown, Folder, HtmlRow, Plot, Row, Slider, Upload
from helicoide.view.window_view import View

TITLE = Text(en="Recording", pt_BR="Gravação")
RECORD, STOP = Text(en="Record the arm", pt_BR="Gravar o braço"), Text(en="End recording", pt_BR="Terminar a gravação")
RECORDED = Text(en="Recorded: {s} s of motion, {mb} MB", pt_BR="Gravados: {s} s de movimento, {mb} MB")
LIST = Text(en="Recordings", pt_BR="Gravações")
NONE = Text(en="none", pt_BR="nenhuma")
LENGTH, SIZE = Text(en="{name} ({s:.1f} s)", pt_BR="{name} ({s:.1f} s)"), untranslated("{name} ({mb} MB)")
OPEN = Text(en="Open a recording (MCAP, rosbag)", pt_BR="Abrir uma gravação (MCAP, rosbag)")
READING = Text(en="Reading {name}…", pt_BR="Lendo {name}…")
TIME = Text(en="Time [s]", pt_BR="Tempo [s]")
PLAY, PAUSE = Text(en="Play as an outline", pt_BR="Reproduzir como contorno"), Text(en="Pause", pt_BR="Pausar")
REPLAY = Text(en="Replay on the arm", pt_BR="Reproduzir no braço")
SAVE_MCAP = Text(en="Save recording as MCAP", pt_BR="Salvar gravação como MCAP")
SAVE_CSV = Text(en="Save recording as CSV", pt_BR="Salvar gravação como CSV")
DELETE = Text(en="Delete this recording", pt_BR="Apagar esta gravação")
SHARED = Text(
    en="Everyone who uses this lab sees the same recordings. A deleted recording is gone for everyone.",
    pt_BR="Todos os que usam este laboratório veem as mesmas gravações. Uma gravação apagada desaparece para todos.",
)
THEN = Text(en="At this time: {status}", pt_BR="Neste instante: {status}")
STEP = 0.02  # s


def recording_rows(robot: Robot) -> Folder:
    """All rows about recordings, the same for every robot."""
    rows: list[Row] = [
        Button(
            lambda view: STOP if _records(view) else RECORD,
            lambda view: RecordArm(not _records(view)),
            Icon.PLAYER_RECORD,
            lambda view: view.ready,
            weight="primary",
        ),
        HtmlRow(_recorder),
        Dropdown(LIST, _options, lambda view: view.recordings.chosen, OpenRecording),
        Upload(OPEN, lambda _, name, content: OpenRecording(name, content)),
        HtmlRow(_about),
        Folder(
            Text(en="Time line", pt_BR="Linha do tempo"),
            DependentRows(_duration, _time_line),
        ),
        Plot(_charts, 0),
        Button(lambda _: SAVE_MCAP, lambda _: SaveRecording("mcap"), Icon.DOWNLOAD, shown=_is_in_folder),
        Button(lambda _: SAVE_CSV, lambda _: SaveRecording("csv"), Icon.DOWNLOAD, shown=_is_open),
        HtmlRow(lambda view: html.note(SHARED[view.seat.language]) if _is_in_folder(view) else Markup("")),
        Button(
            lambda _: DELETE,
            lambda view: DeleteRecording(view.recordings.chosen),
            Icon.TRASH,
            shown=_is_in_folder,
            weight="destructive",
        ),
    ]
    return Folder(TITLE, rows)


def _records(view: View) -> bool:
    return view.recorder is not None and view.recorder.running


def _recorder(view: View) -> Markup:
    """How much is recorded, or why the recording ended, or within which bounds one may be."""
    recorder, language = view.recorder, view.seat.language
    if recorder is None:
        return html.note(BOUNDS[language])
    if recorder.reason is not None:
        return html.note(recorder.reason[language])
    mark = Markup("<span class='helicoide-recording'>●</span> ") if recorder.running else Markup("")
    said = RECORDED.format(s=recorder.seconds, mb=recorder.megabytes)[language]
    return Markup("<p class='helicoide-note'>{}{}</p>").format(mark, said)


def _options(view: View) -> list[tuple[str, Text]]:
    """The recordings in the folder, and the one that is open, which may come from elsewhere."""
    files, chosen = view.recordings.files, view.recordings.chosen
    options = [("", NONE), *((file.name, _title(file)) for file in files)]
    return options if chosen in dict(options) else [*options, (chosen, untranslated("{name}").format(name=chosen))]


def _title(file: RecordingFile) -> Text:
    if file.seconds is None:
        return SIZE.format(name=file.name, mb=round(file.size / 1e6, 1))
    return LENGTH.format(name=file.name, s=file.seconds)


def _is_open(view: View) -> bool:
    return view.recordings.recording is not None


def _is_in_folder(view: View) -> bool:
    return view.recordings.chosen in {file.name for file in view.recordings.files}


def _about(view: View) -> Markup:
    """Whether a recording is being read, why it is not shown, or notes on it and what the arm did at the time shown."""
    panel, language = view.recordings, view.seat.language
    if panel.reading:
        return html.note(READING.format(name=panel.chosen)[language])
    if panel.recording is None and panel.refusal is None:
        return Markup("")
    notes = list(panel.recording.notes) if panel.recording is not None else []
    if panel.refusal is not None:
        notes.append(panel.refusal)
    elif panel.recording is not None and (status := panel.recording.status_at(panel.instant)) is not None:
        notes.append(THEN.format(status=status))
    return Markup("").join(html.note(note[language]) for note in notes)


def _duration(view: View) -> float | None:
    """The length of the recording that is shown on the arm, s; None without one."""
    shown = view.recordings.shown
    return None if shown is None or not shown.fits(view.state.robot) else shown.recording.duration


def _time_line(duration: float | None) -> Sequence[Row]:
    if duration is None:
        return [HtmlRow(lambda view: html.note(NOTHING_OPEN[view.seat.language]))]
    return [
        Slider(
            TIME,
            0.0,
            max(duration, STEP),
            STEP,
            lambda view: view.recordings.instant,
            lambda instant: ForRecordingPanel(panel_state.with_instant(instant)),
        ),
        Button(
            lambda view: PAUSE if view.recordings.plays else PLAY,
            lambda _: ForRecordingPanel(panel_state.with_play),
            Icon.PLAYER_PLAY,
        ),
        Button(lambda _: REPLAY, _replay, Icon.ROBOT, weight="primary"),
    ]


NOTHING_OPEN = Text(
    en="Open a recording of this arm to move through it in time. The arm itself does not move.",
    pt_BR="Abra uma gravação deste braço para percorrê-la no tempo. O próprio braço não se move.",
)


def _replay(view: View) -> ForArm:
    recording = view.recordings.recording
    assert recording is not None  # otherwise the row is not there
    return ForArm(replay_recording(recording))


def _charts(view: View) -> Sequence[Chart]:
    """The distances to the planes, if the recording is shown on the arm."""
    shown = view.recordings.shown
    return () if _duration(view) is None or shown is None or shown.chart is None else (shown.chart,)
