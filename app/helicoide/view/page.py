"""Answers to a plain GET: viser's page with our additions, pages of text, the files of static/, a health check."""

from __future__ import annotations

import gzip
import hashlib
import json
import mimetypes
from collections.abc import Callable, Mapping
from http import HTTPStatus
from pathlib import Path
from types import MappingProxyType
from urllib.parse import parse_qs, unquote

import viser
from markupsafe import Markup
from websockets.datastructures import Headers
from websockets.http11 import Request, Response

from helicoide import content
from helicoide.export.errata import text_page
from helicoide.export.notebook import notebook_of_page
from helicoide.text import LANGUAGES, Language, Text

STOP = Text(en="Stop motion", pt_BR="Parar o movimento")
STOP_ALL = Text(en="Stop motion, real arm included", pt_BR="Parar o movimento, inclusive o braço real")
LOST = Text(
    en="Disconnected: the program does not answer. Trying again…",
    pt_BR="Sem conexão: o programa não responde. Tentando de novo…",
)

# What a screen reader says where viser shows an icon or the scene alone.
NAMES = {
    "scene": Text(
        en="Scene. Arrow keys move the target along x and y, Page Up and Page Down along z; Shift coarse, Alt fine.",
        pt_BR="Cena. As setas movem o alvo em x e y, Page Up e Page Down em z; Shift passo grande, Alt passo fino.",
    ),
    "commands": Text(en="Commands (Ctrl+K)", pt_BR="Comandos (Ctrl+K)"),
    "settings": Text(en="Connection and scene", pt_BR="Conexão e cena"),
}
HINT = {
    "title": Text(en="Where to begin", pt_BR="Por onde começar"),
    "lesson": Text(en="First lesson", pt_BR="Primeira lição"),
    "close": Text(en="Close", pt_BR="Fechar"),
}
STEPS = (
    Text(en="Drag the target at the end effector.", pt_BR="Arraste o alvo no efetuador."),
    Text(en="Move a joint: tab Robot, Joints.", pt_BR="Mova uma junta: aba Robô, Juntas."),
    Text(en="Press Play under Path.", pt_BR="Pressione Reproduzir em Trajetória."),
)

# Behind a sub-path, relative addresses need a slash at the end. The fragment, a link to a view, is taken out of the
# address before viser reads it, since viser would make it a part of the server's address. Without minimum-scale, a list
# that opens beyond the edge of a phone widens the page and pushes Stop out of view.
TAGS = Markup(
    "<script>"
    "window.helicoideLink = location.hash.slice(1);"
    'if (!location.pathname.endsWith("/"))'
    ' location.replace(location.pathname + "/" + location.search + location.hash);'
    'else if (location.hash) history.replaceState(null, "", location.pathname + location.search);'
    "</script>"
    '<meta name="viewport" content="width=device-width, initial-scale=1, minimum-scale=1" />'
    '<link rel="stylesheet" href="static/panel.css" /><link rel="stylesheet" href="static/helicoide.css" />'
    '<link rel="stylesheet" href="static/inspector.css" /><script src="static/copy.js" defer></script>'
    '<script src="static/helicoide.js" data-words="{}" defer></script>'
    '<script src="static/layout.js" defer></script><script src="static/diagram.js" defer></script>'
    '<script src="static/share.js" defer></script><script src="static/prose.js" defer></script>'
    '<script src="static/transparent.js" defer></script>'
    '<script src="static/keyboard.js" data-words="{}" defer></script>'
    '<link rel="stylesheet" href="static/hint.css" /><script src="static/hint.js" data-words="{}" defer></script>'
)
TITLES, HEAD_ENDS = (Markup("<title>Viser</title>"), Markup("<title>Helicoide</title>")), Markup("</head>")

# A page of text, opened in another tab of the browser.
LONG = Markup("""\
<!doctype html>
<html lang="{language}"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Helicoide</title><link rel="stylesheet" href="../../static/page.css" /></head>
<body>{body}</body></html>
""")

# viser's page is one file with inline scripts, blob workers and new Function; everything else stays on this host.
POLICY = "; ".join(
    (
        "default-src 'self'",
        "script-src 'self' 'unsafe-inline' 'unsafe-eval' blob: data:",
        "worker-src 'self' blob: data:",
        "style-src 'self' 'unsafe-inline'",
        "img-src 'self' data: blob:",
        "font-src 'self' data:",
        "connect-src 'self' data: blob:",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'none'",
    )
)

# Pages that may show the lab in a frame: notebooks on this computer.
NOTEBOOKS = "frame-ancestors http://127.0.0.1:* http://localhost:*"

# Fixed here, because the tables of operating systems differ.
TYPES = {
    ".css": "text/css; charset=utf-8",
    ".html": "text/html; charset=utf-8",
    ".ipynb": "application/x-ipynb+json",
    ".js": "text/javascript; charset=utf-8",
    ".svg": "image/svg+xml",
    ".txt": "text/plain; charset=utf-8",
    ".woff2": "font/woff2",
}


def site(static: Path, framed: bool = False) -> Callable[[Request], Response]:
    """The answer to any GET. Files are found in a table made at the start, so no path leads out of the folder.

    framed: whether notebooks on this computer may show the lab in a frame.
    """
    policy = POLICY.replace("frame-ancestors 'none'", NOTEBOOKS) if framed else POLICY
    of_page = {"Content-Type": TYPES[".html"], "Content-Encoding": "gzip", "Content-Security-Policy": policy}
    page = gzip.compress(_page().encode())
    pages = {
        f"/pages/{language}/{file.stem}": _long(file.stem, language)
        for language in LANGUAGES
        for file in (content.STATIC / "pages" / language).glob("*.md")
    }
    notebooks = {f"/pages/{language}/notebook.ipynb": notebook_of_page(language) for language in LANGUAGES}
    files = {f"/static/{file.relative_to(static).as_posix()}": file for file in static.rglob("*") if file.is_file()}

    def answer(request: Request) -> Response:
        path, _, query = request.path.partition("?")
        if path == "/healthz":
            return reply(HTTPStatus.OK, b"ok")
        if path == "/" and "websocket" in parse_qs(query, keep_blank_values=True):
            # such a link would connect our page to another server
            return reply(HTTPStatus.FOUND, headers={"Location": "./"})
        if path == "/":
            return reply(HTTPStatus.OK, page, of_page)
        if body := pages.get(path):
            return reply(HTTPStatus.OK, body, {"Content-Type": TYPES[".html"]})
        if notebook := notebooks.get(path):
            return reply(
                HTTPStatus.OK, notebook, {"Content-Type": TYPES[".ipynb"], "Content-Disposition": "attachment"}
            )
        if file := files.get(unquote(path)):
            return _file(file, request)
        return reply(HTTPStatus.NOT_FOUND, b"not found")

    return answer


def reply(status: HTTPStatus, body: bytes = b"", headers: Mapping[str, str] = MappingProxyType({})) -> Response:
    """A response with the headers that all responses have, overridden by those given."""
    base = {
        "Content-Type": TYPES[".txt"],
        "Content-Length": str(len(body)),
        "Content-Security-Policy": POLICY,
        "X-Content-Type-Options": "nosniff",
        "Cache-Control": "no-store",
    }
    return Response(status, status.phrase, Headers({**base, **headers}), body)


def _file(file: Path, request: Request) -> Response:
    body = file.read_bytes()
    kind = TYPES.get(file.suffix) or mimetypes.guess_type(file.name)[0] or "application/octet-stream"
    tag = f'"{hashlib.sha256(body).hexdigest()[:32]}"'
    headers = {"Content-Type": kind, "Cache-Control": "no-cache", "ETag": tag}
    if request.headers.get("If-None-Match") == tag:
        return reply(HTTPStatus.NOT_MODIFIED, headers=headers)
    return reply(HTTPStatus.OK, body, headers)


def _long(name: str, language: Language) -> bytes:
    return LONG.format(language=language.replace("_", "-"), body=text_page(name, language)).encode()


def _page() -> str:
    source = Path(viser.__file__).parent / "client" / "build" / "index.html"
    said = {"stop": STOP, "stop_all": STOP_ALL, "lost": LOST}
    hint = {key: words | {"steps": [step[key] for step in STEPS]} for key, words in _in_both(HINT).items()}
    tags = TAGS.format(json.dumps(_in_both(said)), json.dumps(_in_both(NAMES)), json.dumps(hint))
    titled = source.read_text("utf-8").replace(*TITLES, 1)
    return titled.replace(HEAD_ENDS, tags + HEAD_ENDS, 1)


def _in_both(texts: Mapping[str, Text]) -> dict[Language, dict[str, str]]:
    return {language: {key: text[language] for key, text in texts.items()} for language in LANGUAGES}
