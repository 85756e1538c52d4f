"""The XML of a URDF as a tree: any encoding, prefixes declared or not, without external entities."""

from __future__ import annotations

import codecs
import re
from collections.abc import Mapping
from pathlib import Path
from string import Template
from types import MappingProxyType
from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

from helicoide.files import text_file
from helicoide.text import HelicoideError, Text

NO_PARAMETERS: Mapping[str, float] = MappingProxyType({})
MOST_BYTES = 64_000_000
BYTE_ORDER_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
    (b"<\0", "utf-16-le"),
    (b"\0<", "utf-16-be"),
)
DECLARED = re.compile(rb"<\?xml[^>]*?encoding\s*=\s*[\"']([\w.:-]+)[\"']")
DECLARATION = re.compile(r"<\?xml\s[^>]*\?>")
# Error messages by the error number of expat.
EMPTY = Text(en="nothing is there", pt_BR="não há nada")
XML_ERRORS = {
    3: EMPTY,
    5: Text(en="a tag is not finished", pt_BR="uma tag ficou inacabada"),
    7: Text(en="a tag is closed that is not the one opened last", pt_BR="fecha-se uma tag que não é a última aberta"),
    8: Text(en="an attribute is there twice", pt_BR="um atributo aparece duas vezes"),
    9: Text(en="something follows the end of the robot", pt_BR="há algo depois do fim do robô"),
    11: Text(en="an entity is not defined", pt_BR="uma entidade não está definida"),
}
NO_XML = Text(en="this is no XML", pt_BR="isto não é XML")
AT = Text(en="line {line}, column {column}: {why}", pt_BR="linha {line}, coluna {column}: {why}")
TOO_BIG = Text(en="it has more than {mb:.0f} MB", pt_BR="tem mais de {mb:.0f} MB")
NO_TEXT = Text(en="it is not text in {encoding}, as it says", pt_BR="não é um texto em {encoding}, como ele diz")


def urdf_error(path: Path, reason: Text) -> HelicoideError:
    """The error of a URDF that cannot be used."""
    return HelicoideError(
        Text(en="The URDF {path} cannot be used: {reason}", pt_BR="Não dá para usar o URDF {path}: {reason}").format(
            path=path, reason=reason
        )
    )


def parse_xml(path: Path, parameters: Mapping[str, float] = NO_PARAMETERS) -> Element:
    """The root of a URDF with ${name} replaced by parameters (m); tags and attributes keep their prefixes.

    Raises HelicoideError if the file cannot be read or is not XML. External entities are never loaded.
    """
    text = Template(_text(path)).safe_substitute(parameters)
    text = DECLARATION.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text, count=1)
    builder, parser = TreeBuilder(), expat.ParserCreate("utf-8")
    parser.StartElementHandler, parser.EndElementHandler = builder.start, builder.end
    try:
        parser.Parse(text.encode(errors="replace"), True)
    except expat.ExpatError as error:
        why = XML_ERRORS.get(error.code, NO_XML)
        raise urdf_error(path, AT.format(line=error.lineno, column=error.offset, why=why)) from error
    return builder.close()


def root_link(path: Path, parameters: Mapping[str, float] = NO_PARAMETERS) -> str:
    """The root link of a URDF file, which is no joint's child. Raises HelicoideError as `parse_xml`."""
    root = parse_xml(path, parameters)
    children = {child.get("link") for child in root.findall("joint/child")}
    return next(name for link in root.findall("link") if (name := link.get("name", "")) not in children)


def _text(path: Path) -> str:
    """The text of a file, in the encoding of its byte order mark, else of its declaration, else UTF-8 or Latin-1."""
    try:
        content = text_file.read_bytes(path, MOST_BYTES)
    except HelicoideError as error:
        raise urdf_error(path, error.text) from error
    if len(content) > MOST_BYTES:
        raise urdf_error(path, TOO_BIG.format(mb=MOST_BYTES / 1e6))
    marked = next((encoding for mark, encoding in BYTE_ORDER_MARKS if content.startswith(mark)), None)
    declared = DECLARED.search(content[:1000])
    encoding = marked or (declared[1].decode() if declared else "utf-8")
    if marked is None and encoding.lower().startswith(("utf", "ucs")):
        encoding = "utf-8"  # a declaration in single bytes cannot be right about UTF-16
    try:
        return content.decode(encoding)
    except (UnicodeError, LookupError) as error:
        if encoding == "utf-8":
            return content.decode("latin-1")
        raise urdf_error(path, NO_TEXT.format(encoding=encoding)) from error
