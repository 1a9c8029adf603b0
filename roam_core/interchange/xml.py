"""XML of strangers and for strangers: parsing that follows nothing and stays within limits, text that XML can hold."""

from __future__ import annotations

import codecs
import re
from typing import Any, Literal
from xml.etree.ElementTree import Element, ParseError, TreeBuilder

from defusedxml.common import DefusedXmlException
from defusedxml.ElementTree import DefusedXMLParser

from roam_core.errors import RoamError
from roam_core.interchange.reading import MAX_PARTS, ShapeReader
from roam_core.interchange.recognition import text_of
from roam_core.translatable import said_by, sentence

CHUNK = 1 << 20
"""Bytes that are parsed at once."""


def xml_text(text: str) -> str:
    """`text` with every character that XML 1.0 cannot hold (controls, lone surrogates) replaced by U+FFFD."""
    return re.sub(r"[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "\ufffd", text)


def parsed(
    reader: ShapeReader, *, doctype: Literal["refused", "ignored"] = "refused", content: bytes | None = None
) -> Element:
    """The root element of the reader's file, or of the `content` that was unpacked from it.

    A document type without entities, with which many drawing programs begin their SVG, may be `ignored`: it is not
    followed either.

    Raises
    ------
    RoamError
        when the file is no XML, too large or too deep, or when it declares a document type or an entity: files of
        shapes need neither, and they are the ways to make a reader fetch other files or grow without end.
    """
    content, told = _as_it_is(reader.content() if content is None else content)
    told = told if reader.options.content is None else "utf-8"  # a text that was copied; what it says was its file's
    parser: Any = DefusedXMLParser(target=_ShallowTree(reader), encoding=told, forbid_dtd=doctype == "refused")
    try:
        if content.count(b"=") > MAX_PARTS:  # attributes, of which one element may have as many as the file is long
            raise RoamError(
                sentence(
                    "{path} holds more than {most} attributes; split it into several files.",
                    path=reader.called,
                    most=MAX_PARTS,
                )
            )
        for start in range(0, len(content), CHUNK):  # in pieces: what is too much is found before all of it is built
            parser.feed(content[start : start + CHUNK])
        root = parser.close()
    except DefusedXmlException:
        raise RoamError(
            sentence(
                "{path} declares a document type or an entity, which files of shapes do not need; it was not read.",
                path=reader.called,
            )
        ) from None
    except (ParseError, ValueError, LookupError) as error:  # LookupError: an encoding that does not exist
        raise RoamError(
            sentence("{path} is no valid XML ({reason}).", path=reader.called, reason=said_by(error))
        ) from None
    assert isinstance(root, Element)
    return root


def _as_it_is(content: bytes) -> tuple[bytes, str | None]:
    """The content, and its encoding where that is not what it says of itself.

    A byte order mark says more than a declaration, which programs keep that save the text anew; letters of Western
    Windows stand in files that declare UTF-8, or nothing.
    """
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return text_of(content).encode("utf-8", "replace"), "utf-8"
    if content.startswith(codecs.BOM_UTF8):
        return content, "utf-8"
    declared = _DECLARED.match(content)
    if (declared and declared[1].lower() not in (b"utf-8", b"utf8")) or content.isascii() or b"\0" in content[:4]:
        return content, None
    try:
        content.decode("utf-8")
    except UnicodeDecodeError:
        return text_of(content).encode("utf-8", "replace"), "utf-8"
    return content, None


_DECLARED = re.compile(rb"""\s*<\?xml\s[^>]{0,200}?\bencoding\s*=\s*["']([\w.:-]*)""")


def local_name(element: Element) -> str:
    """The tag without its namespace."""
    return str(element.tag).rpartition("}")[2]


class _ShallowTree(TreeBuilder):
    """Builds the tree and refuses one that is too deep or too large while it grows."""

    def __init__(self, reader: ShapeReader) -> None:
        super().__init__()
        self._reader = reader
        self._depth = 0

    def start(self, tag: Any, attrs: Any, /) -> Element:
        self._depth += 1
        self._reader.check_depth(self._depth)
        self._reader.check_parts(1 + len(attrs))
        return super().start(tag, attrs)

    def end(self, tag: str, /) -> Element:
        self._depth -= 1
        return super().end(tag)
