"""The fuzz harness at its smallest: what once was too much is read again, and a few damaged files of every kind."""

from __future__ import annotations

import random
from contextlib import nullcontext, suppress
from pathlib import Path

import pytest

from roam_core.errors import RoamError
from tests.conftest import ROOT
from tests.fuzz import READERS, SEED, damaged

CORPUS = ROOT / "tests" / "golden" / "hostile"
REFUSED = {".exr", ".jp2", ".sfx"}
"""Of the corpus: what is refused whole. Of the others, what makes no sense is left out."""


@pytest.mark.parametrize("name", READERS)
def test_damaged_files_give_a_value_or_one_sentence(tmp_path: Path, name: str) -> None:
    suffix, make, kind, read = READERS[name]
    whole = make(kind, tmp_path)
    rng = random.Random(SEED)
    path = tmp_path / "damaged" / f"file{suffix}"
    path.parent.mkdir()
    for _ in range(20):
        path.write_bytes(damaged(whole, rng))
        with suppress(RoamError):
            read(path)


def test_whole_files_are_read(tmp_path: Path) -> None:
    for name, (suffix, make, kind, read) in READERS.items():
        path = tmp_path / name / f"file{suffix}"
        path.parent.mkdir()
        path.write_bytes(make(kind, tmp_path))
        assert read(path) is not None, name


@pytest.mark.parametrize("file", sorted(CORPUS.glob("*")), ids=lambda file: file.name)
def test_what_was_found_once_stays_mended(file: Path) -> None:
    read = READERS[file.name.partition("-")[0]][3]
    with pytest.raises(RoamError) if file.suffix in REFUSED else nullcontext():
        read(file)
