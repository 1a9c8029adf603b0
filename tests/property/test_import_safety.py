"""Damaged and hostile files: a reader gives shapes or one sentence, and never anything else."""

from __future__ import annotations

import tempfile
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, read_shapes
from roam_core.interchange.reading import sensible
from roam_core.roto import Layer, Project
from tests.unit.interchange.conftest import CLIP, animated

PIECES = {
    ".nk": [
        b"{",
        b"}",
        b'"',
        b"\\",
        b"[exit]",
        b"x",
        b"x 9 {",
        b"px",
        b"{}",
        b"=a",
        b"-",
        b"1e999",
        b"xffffffff",
        b"#",
        b"\n",
    ],
    ".fxs": [
        b"<",
        b">",
        b'"',
        b"&",
        b"<Path>",
        b"</Property>",
        b"<Key/>",
        b"(",
        b",",
        b"nan",
        b"-1e99",
        b"<!--",
        b"\0",
    ],
}


def written(suffix: str) -> bytes:
    """A small file of the format."""
    name = {".nk": "nuke", ".fxs": "silhouette"}[suffix]
    layer = Layer("layer-1", "Body", (animated("A"),))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "file"
        EXPORTERS[name].export(Project(CLIP, Layer("root", "Root", (layer, animated("B")))), path)
        return path.read_bytes()


@pytest.mark.parametrize("suffix", PIECES)
def test_damaged_files_give_shapes_or_a_sentence(suffix: str) -> None:
    whole = written(suffix)
    cuts = st.tuples(
        st.integers(0, len(whole)), st.integers(0, 40), st.sampled_from(PIECES[suffix]) | st.binary(max_size=8)
    )

    @settings(deadline=None, max_examples=80, phases=[Phase.explicit, Phase.reuse, Phase.generate])
    @given(st.lists(cuts, min_size=1, max_size=4))
    def read(changes: list[tuple[int, int, bytes]]) -> None:
        content = whole
        for place, length, piece in changes:
            content = content[:place] + piece + content[place + length :]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"a{suffix}"
            path.write_bytes(content)
            with suppress(RoamError):
                for shape in read_shapes(path, CLIP).layer.shapes():
                    assert sensible(shape.keys)

    read()
