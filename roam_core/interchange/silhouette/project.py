"""Silhouette's project files `.sfx`: how they are packed, and where they hold what a shape file says at its root.

As a public reader of six production projects describes them (`docs/FORMATS.md`): XML as it is, or the length of the XML
in four bytes, the highest first, and a zlib stream.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from xml.etree.ElementTree import Element

from roam_core.errors import RoamError
from roam_core.interchange.reading import MAX_BYTES, ShapeReader
from roam_core.interchange.silhouette.values import words_of
from roam_core.interchange.xml import local_name
from roam_core.translatable import sentence


def unpacked(reader: ShapeReader) -> bytes:
    """The XML of the reader's file, unpacked where it is packed.

    Raises `RoamError` where it cannot be unpacked, or would be larger than `MAX_BYTES`.
    """
    content = reader.content()
    if not _begins_a_stream(content[4:6]):
        return content
    try:
        whole = zlib.decompressobj().decompress(content[4:], MAX_BYTES + 1)
    except zlib.error:
        raise RoamError(sentence("{path} is packed, but damaged; save it again.", path=reader.called)) from None
    if len(whole) > MAX_BYTES:
        raise RoamError(
            sentence(
                "{path} unpacks to more than {most} MiB; split it into several files.",
                path=reader.called,
                most=MAX_BYTES >> 20,
            )
        )
    return whole


def _begins_a_stream(head: bytes) -> bool:
    """True for the two bytes with which zlib begins: its method, and a remainder that only chance gives to text."""
    return head[:1] == b"x" and int.from_bytes(head, "big") % 31 == 0


def project_session(project: Element) -> Element:
    """A project's first session as a shape file says it at its root; what is not there is left out."""
    found: dict[str, str] = {}
    for session in _named(project, "Session"):
        values = dict(_values(session))
        for name, said in (("pixelAspect", "pixelAspect"), ("startFrame", "sessionStartFrame")):
            if values.get(name):
                found.setdefault(said, values[name][0])
        for word, size in zip(("width", "height"), values.get("size", []), strict=False):
            found.setdefault(word, size)
    for source in _named(project, "Source"):
        for word in ("width", "height"):
            if source.get(word):
                found.setdefault(word, str(source.get(word)))
    return Element("Silhouette", found)


def project_shapes(project: Element) -> Element:
    """What the Roto nodes of a project hold, in one element; of several nodes each is a layer of its name."""
    nodes = [node for node in _named(project, "Node") if node.get("type") == "RotoNode"]
    whole = Element("Silhouette")
    for node in nodes:
        held = [item for entry in _properties(node) if entry.get("id") == "objects" for item in entry]
        if len(nodes) == 1:
            whole.extend(held)
        elif held:
            layer = Element("Layer", type="Layer", label=node.get("label", "Roto"))
            objects = Element("Property", id="objects")
            objects.extend(held)
            properties = Element("Properties")
            properties.append(objects)
            layer.append(properties)
            whole.append(layer)
    return whole


def _named(root: Element, name: str) -> Iterator[Element]:
    return (element for element in root.iter() if local_name(element) == name)


def _properties(element: Element) -> Iterator[Element]:
    return (entry for group in element if local_name(group) == "Properties" for entry in group)


def _values(element: Element) -> Iterator[tuple[str, list[str]]]:
    """The names of an element's properties, and the words of their first values."""
    for entry in _properties(element):
        for value in entry:
            if local_name(value) == "Value":
                yield entry.get("id", ""), words_of(value)
                break
