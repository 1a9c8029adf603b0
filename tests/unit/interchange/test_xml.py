"""XML of strangers: what is refused, each with one sentence."""

from __future__ import annotations

from pathlib import Path

import pytest

from roam_core.errors import RoamError
from roam_core.interchange.reading import MAX_DEPTH, ShapeReader
from roam_core.interchange.xml import local_name, parsed, xml_text
from tests.unit.interchange.conftest import CLIP


def reader(folder: Path, content: bytes) -> ShapeReader:
    path = folder / "file.xml"
    path.write_bytes(content)
    return ShapeReader(path, CLIP)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "no valid XML"),
        (b"<a>", "no valid XML"),
        (b"\x89PNG\r\n\x1a\n\x00\x00", "no valid XML"),
        (b'<?xml version="1.0" encoding="none-such"?><a/>', "no valid XML"),
        (b'<!DOCTYPE a [<!ENTITY x "y">]><a>&x;</a>', "document type or an entity"),
        (b'<!DOCTYPE a [<!ENTITY x SYSTEM "file:///etc/hostname">]><a>&x;</a>', "document type or an entity"),
        (b'<!DOCTYPE a SYSTEM "http://localhost/a.dtd"><a/>', "document type or an entity"),
        (b"<a>" * (MAX_DEPTH + 1) + b"</a>" * (MAX_DEPTH + 1), "deep"),
    ],
)
def test_refusals(tmp_path: Path, content: bytes, message: str) -> None:
    with pytest.raises(RoamError, match=message):
        parsed(reader(tmp_path, content))


def test_a_file_of_the_greatest_depth_is_read(tmp_path: Path) -> None:
    root = parsed(reader(tmp_path, b"<a>" * MAX_DEPTH + b"</a>" * MAX_DEPTH))
    assert len(list(root.iter())) == MAX_DEPTH


def test_a_namespace_is_no_part_of_the_local_name(tmp_path: Path) -> None:
    root = parsed(reader(tmp_path, b'<a xmlns="urn:x"><b/></a>'))
    assert [local_name(element) for element in root.iter()] == ["a", "b"]


def test_characters_that_xml_cannot_hold_are_replaced() -> None:
    assert xml_text("a\0b\ud83d\ufffe\tc\N{HAIRCUT}") == "a\ufffdb\ufffd\ufffd\tc\N{HAIRCUT}"


@pytest.mark.parametrize(
    ("declared", "encoding"),
    [
        ("utf-8", "utf-16"),  # saved anew by an editor of Windows, which leaves the declaration as it was
        ("UTF-16", "utf-16"),
        ("UTF-16", "utf-16-be"),
        ("UTF-16", "utf-8-sig"),
        ("utf-8", "cp1252"),
        ("", "cp1252"),
        ("", "utf-8"),
        ("iso-8859-5", "iso-8859-5"),
    ],
)
def test_text_is_what_its_mark_says_or_what_its_bytes_are(tmp_path: Path, declared: str, encoding: str) -> None:
    name = "Щука" if encoding == "iso-8859-5" else "Größe"
    head = f'<?xml version="1.0" encoding="{declared}"?>' if declared else ""
    root = parsed(reader(tmp_path, f'{head}<a label="{name}"/>'.encode(encoding)))
    assert root.get("label") == name
