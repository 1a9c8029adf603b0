"""Files that are one text: written in parts, the same as in one go."""

from __future__ import annotations

import tracemalloc
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.interchange import EXPORTERS, text_exporter
from roam_core.interchange.protocol import STANDARD, ExportOptions
from roam_core.interchange.text_exporter import TextExporter
from roam_core.roto import BlendMode, Keyframe, Layer, Project, RotoShape
from tests.unit.interchange.conftest import CLIP

TEXT = "Größe \U0001f3ac\n" * 50


class Told(TextExporter):
    name, title, suffix, encoding = "told", "Told", ".txt", "utf-8"

    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        return TEXT, ("a note",)


@pytest.mark.parametrize("chunk", [1, 7, 1 << 20])
def test_a_text_is_the_same_in_parts_of_any_size(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, chunk: Any) -> None:
    monkeypatch.setattr(text_exporter, "CHUNK", chunk)
    assert Told().export(Project(), tmp_path / "a.txt", STANDARD) == ("a note",)
    assert (tmp_path / "a.txt").read_bytes() == TEXT.encode()


def tracked(shapes: int, points: int, keys: int) -> Project:
    places = np.random.default_rng(1).uniform(0.0, 1000.0, (shapes, keys, points, 3, 2))
    held = tuple(
        RotoShape(
            f"s{each}",
            f"<!--{each}--> @PARTS@",
            tuple(Keyframe(CLIP.first + key, places[each, key]) for key in range(keys)),
        )
        for each in range(shapes)
    )
    inner = Layer("inner", "@CLIP@ &", held[:2], blend=BlendMode.SUBTRACT, invert=True)
    return Project(CLIP, Layer("root", "<!--0-->", (held[2], inner, *held[3:])))


@pytest.mark.parametrize("name", ["after-effects", "nuke", "silhouette"])
def test_keys_are_held_as_their_text_alone(tmp_path: Path, name: str) -> None:
    """As elements and lists of numbers they took ten times the room of the file."""
    project, path = tracked(8, 40, 30), tmp_path / "a"
    EXPORTERS[name].export(replace(project, root=Layer("root", "Root", project.shapes[:1])), path)  # what stays
    tracemalloc.start()
    try:
        EXPORTERS[name].export(project, path)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 3 * path.stat().st_size


@pytest.mark.parametrize("name", ["after-effects", "nuke", "silhouette"])
def test_the_pieces_are_the_document(name: str) -> None:
    project, exporter = tracked(4, 3, 2), EXPORTERS[name]
    assert isinstance(exporter, TextExporter)
    pieces, told = exporter.pieces(project, STANDARD)
    pieces = list(pieces)
    assert len(pieces) > len(project.shapes)
    assert ("".join(pieces), told) == exporter.document(project, STANDARD)
