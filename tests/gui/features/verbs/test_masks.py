"""Shapes from a picture of the frame's mask."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.features.verbs.masks import MaskShapes
from app.jobs.picture_work import PictureWork
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.kernels.coverage import coverage
from roam_core.roto import Clip, Project
from tests.gui.waiting import WAIT


@pytest.fixture
def chosen() -> list[Path]:
    """What the artist chooses, if anything."""
    return []


@pytest.fixture
def masks(document: Document, view_state: ViewState, runner: Runner, chosen: list[Path]) -> MaskShapes:
    """On frame 4 of a clip of 120 x 80."""
    document.open(Project(clip=Clip(Path("plate"), 1, 20, (120, 80))), None)
    view_state.set_frame(4)
    return MaskShapes(lambda: chosen[-1] if chosen else None, document, view_state, PictureWork(runner, runner))


def written(path: Path, mask: np.ndarray) -> Path:
    assert cv2.imwrite(str(path), mask)
    return path


def test_a_mask_becomes_a_selected_shape(
    masks: MaskShapes, document: Document, view_state: ViewState, tmp_path: Path, qtbot: QtBot, chosen: list[Path]
) -> None:  # fmt: skip
    mask = np.zeros((80, 120), dtype=np.uint8)
    cv2.circle(mask, (60, 40), 25, 255, -1, cv2.LINE_AA)
    chosen.append(written(tmp_path / "mask.png", mask))
    masks.handlers()["shape.from_mask"]()
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    (shape,) = document.project.shapes
    assert shape.frames == (4,)
    assert np.abs(coverage(shape.at(4).flatten(), (80, 120)) - mask / 255.0).mean() < 0.01
    assert view_state.selection.shapes == {shape.id}
    assert document.undo_stack.undoText() == "Shape from mask"
    document.undo_stack.undo()
    assert not document.project.shapes


@pytest.mark.parametrize("is_busy", [True, False])
def test_a_mask_that_comes_while_the_artist_draws_takes_no_tool_out_of_the_hand(
    masks: MaskShapes, document: Document, view_state: ViewState, tmp_path: Path, qtbot: QtBot, is_busy: bool
) -> None:
    """What was half drawn ended there as an open shape, or was lost; a tool that was taken since was laid down."""
    mask = np.zeros((80, 120), dtype=np.uint8)
    cv2.circle(mask, (60, 40), 25, 255, -1, cv2.LINE_AA)
    masks.read(written(tmp_path / "mask.png", mask))
    view_state.set_tool("bezier")
    view_state.ask_hand(lambda: is_busy)
    qtbot.waitUntil(lambda: bool(document.project.shapes), timeout=WAIT)
    assert view_state.tool == "bezier"
    assert bool(view_state.selection.shapes) is not is_busy


@pytest.mark.parametrize(
    ("size", "value", "sentence"), [((80, 120), 0, "Nothing is white in mask.png"), ((40, 60), 255, "is 60x40")]
)
def test_a_mask_that_gives_nothing_is_told(
    masks: MaskShapes, document: Document, view_state: ViewState, tmp_path: Path, qtbot: QtBot,
    size: tuple[int, int], value: int, sentence: str,
) -> None:  # fmt: skip
    masks.read(written(tmp_path / "mask.png", np.full(size, value, dtype=np.uint8)))
    qtbot.waitUntil(lambda: sentence in view_state.message, timeout=WAIT)
    assert not document.project.shapes


def test_no_choice_does_nothing(masks: MaskShapes, runner: Runner) -> None:
    masks.choose()
    assert runner.is_idle


def test_without_a_clip_it_says_what_to_do(masks: MaskShapes, document: Document, view_state: ViewState) -> None:
    document.open(Project(), None)
    masks.choose()
    assert view_state.message.startswith("Open a clip first")


def test_a_photograph_is_said_to_be_no_mask(
    masks: MaskShapes, document: Document, view_state: ViewState, tmp_path: Path, qtbot: QtBot
) -> None:
    """Its brightest places became shapes."""
    picture = np.random.default_rng(0).integers(60, 200, (80, 120, 3)).astype(np.uint8)
    cv2.imwrite(str(tmp_path / "plate.png"), picture)
    masks.read(tmp_path / "plate.png")
    qtbot.waitUntil(lambda: "plate.png is a picture in colour, no mask" in view_state.message, timeout=WAIT)
    assert not document.project.shapes
