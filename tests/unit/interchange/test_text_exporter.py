"""Files that are one text: written in parts, the same as in one go."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from roam_core.interchange import text_exporter
from roam_core.interchange.protocol import STANDARD, ExportOptions
from roam_core.interchange.text_exporter import TextExporter
from roam_core.roto import Project

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
