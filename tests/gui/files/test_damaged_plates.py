"""Damaged pictures and movies in the window: a placeholder and a sentence each. `tests.endurance plates` opens more."""

from __future__ import annotations

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from roam_core.media import decoding
from tests.endurance.plates import KINDS, WRONG, Looker, Outcome, plates
from tests.fuzz import READERS, SEED
from tests.gui.windows import opened_window

OF_A_KIND = 3


def test_every_damaged_file_is_shown_or_told(qtbot: QtBot, tmp_path: Path, isolated: None) -> None:
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        looker = Looker(window)
        (tmp_path / "files").mkdir()
        looked = [looker.look(*plate) for plate in plates(tmp_path / "files", OF_A_KIND * len(KINDS), SEED + 1)]
        window.files.new()
    assert [(each.kind, each.outcome, each.sentence) for each in looked if each.outcome in WRONG] == []
    assert {each.outcome for each in looked} >= {Outcome.PLACEHOLDER, Outcome.REFUSED}
    assert any(str(tmp_path) in each.sentence for each in looked)


def test_whole_files_are_shown(qtbot: QtBot, tmp_path: Path, isolated: None) -> None:
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        looker = Looker(window)
        for kind in KINDS:
            suffix, make, what, _ = READERS[kind]
            path = tmp_path / kind / f"plate.1001{suffix}"
            path.parent.mkdir()
            path.write_bytes(make(what, tmp_path))
            assert looker.look(kind, b"", path).outcome is Outcome.SHOWN, kind
        window.files.new()


@pytest.fixture
def isolated() -> object:
    """Pictures are decoded in other processes, as in the program."""
    decoding.isolate()
    yield
    decoding.trust()
