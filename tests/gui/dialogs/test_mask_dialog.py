"""The dialog before masks come in: what it proposes, what is chosen in it, and an import that goes by it."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.dialogs.mask_dialog import MaskDialog
from app.jobs.importing import Import
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from roam_core.interchange import KeyChoice, MaskOptions
from roam_core.roto import Clip, Project
from tests.gui.waiting import WAIT

CLIP = Clip(Path("/plates/shot"), 1001, 1006, (120, 90))


@pytest.fixture
def masks(tmp_path: Path) -> Path:
    """A disc that glides, on six frames."""
    folder = tmp_path / "masks"
    folder.mkdir()
    for f in range(6):
        mask = np.zeros((90, 120), np.uint8)
        cv2.circle(mask, (40 + 4 * f, 45), 20, 255, -1, cv2.LINE_AA)
        cv2.imwrite(str(folder / f"mask.{1001 + f}.png"), mask)
    return folder


def test_it_proposes_a_pixel_few_keys_and_specks_by_the_size(qtbot: QtBot) -> None:
    small, large = MaskDialog("masks", (854, 480)), MaskDialog("masks", (1920, 1080))
    qtbot.addWidget(small)
    qtbot.addWidget(large)
    assert small.options == MaskOptions(1.0, KeyChoice.REDUCED, 64.0)
    assert large.options == MaskOptions(1.0, KeyChoice.REDUCED, 324.0)


def test_what_is_chosen_counts(qtbot: QtBot) -> None:
    dialog = MaskDialog("masks", None)
    qtbot.addWidget(dialog)
    dialog.keys.setCurrentIndex(dialog.keys.findData(KeyChoice.EVERY.value))
    dialog.tolerance.setValue(2.5)
    dialog.speckle.setValue(0.0)
    assert dialog.options == MaskOptions(2.5, KeyChoice.EVERY, 0.0)


@pytest.mark.parametrize(("keys", "count"), [(KeyChoice.REDUCED, 2), (KeyChoice.EVERY, 6)])
def test_an_import_goes_by_it(
    qtbot: QtBot, document: Document, runner: Runner, masks: Path, keys: KeyChoice, count: int
) -> None:
    document.open(Project(CLIP), None)
    importing = Import(document, runner)
    with qtbot.waitSignal(importing.finished, timeout=WAIT) as finished:
        importing.start(masks, MaskOptions(keys=keys))
    assert finished.args[0] is Ending.DONE
    assert f"{count} keys for 6 frames" in finished.args[1]
    (shape,) = document.project.shapes
    assert len(shape.keys) == count


def test_one_that_is_stopped_leaves_nothing(qtbot: QtBot, document: Document, runner: Runner, masks: Path) -> None:
    document.open(Project(CLIP), None)
    importing = Import(document, runner)
    importing.progress.connect(lambda fraction, _text: importing.stop() if fraction > 0.0 else None)
    with qtbot.waitSignal(importing.finished, timeout=WAIT) as finished:
        importing.start(masks)
    assert finished.args[0] is Ending.CANCELLED
    qtbot.waitUntil(lambda: runner.is_idle, timeout=WAIT)
    assert document.project.shapes == ()
