"""The application killed at work: whatever the journal said to be on the disk comes back, and the project opens.

How much is lost by the clock, at 200 moments, is for `python -m tests.endurance kill`.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.endurance.artist import SAVING, TITLED, UNTITLED
from tests.endurance.kill import outcome
from tests.gui.windows import write_clip


@pytest.mark.parametrize("mode", [UNTITLED, TITLED, SAVING])
def test_a_kill_loses_nothing_that_the_journal_holds(tmp_path: Path, mode: str) -> None:
    left = outcome(tmp_path / "work", write_clip(tmp_path / "plate"), mode, 0.5, flushed=True)
    assert left.opens
    assert left.committed > 0
    assert left.lost_edits == 0
