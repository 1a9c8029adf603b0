"""What a `.json` file holds, told by its content: shapes of ours, COCO instances, or a spline of MLT's."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from roam_core.errors import RoamError
from roam_core.interchange.labels.coco_reading import CocoReader, is_coco
from roam_core.interchange.mlt.exporter import is_mlt
from roam_core.interchange.mlt.reading import MltReader
from roam_core.interchange.plain_json import FORMAT, JsonReader
from roam_core.interchange.reading import MAX_PARTS, PLAIN, Imported, ImportOptions, ShapeReader, quietly
from roam_core.roto import Clip
from roam_core.translatable import N_, sentence


class JsonImporter:
    """Reads every kind of JSON that ROAM knows."""

    name = "json"
    title = N_("JSON (ROAM, COCO, MLT)")
    suffixes = (".json",)

    @quietly
    def read(self, path: Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
        """Read the shapes of a file; one sentence for a file that is of no kind that is known."""
        reader = ShapeReader(path, clip, options)
        document = parsed_json(reader)
        if isinstance(document, dict) and document.get("format") == FORMAT:
            return JsonReader(path, clip, options).shapes(document)
        if is_coco(document):
            return CocoReader(path, clip, options).shapes(document)
        if is_mlt(document):
            return MltReader(path, clip, options).shapes(document)
        raise RoamError(
            sentence(
                '{path} holds no shapes: it has neither a "format" of "{format}", nor "images" and '
                '"annotations" as COCO has, nor is it a spline of MLT.',
                path=reader.called,
                format=FORMAT,
            )
        )


def parsed_json(reader: ShapeReader) -> Any:
    """The reader's file as plain values; one sentence where it is no JSON or holds too much."""
    text = reader.text()
    # Every list, object and comma may become an object in memory: they are counted before the text is taken apart.
    if max(text.count("{") + text.count("["), text.count(",") // 4) > MAX_PARTS:
        raise RoamError(
            sentence(
                "{path} holds more than {most} lists and objects; split it into several files.",
                path=reader.called,
                most=MAX_PARTS,
            )
        )
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        raise RoamError(
            sentence(
                "{path} is no valid JSON (line {line}, column {column}).",
                path=reader.called,
                line=error.lineno,
                column=error.colno,
            )
        ) from None
    except (ValueError, RecursionError):
        raise RoamError(sentence("{path} is no valid JSON.", path=reader.called)) from None
