"""The pictures of reviewing: notes and doubts beside the viewer, the dialog for movies, a contact sheet."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from scripts.camera import IMAGES, QUALITY, photograph, show_frame, until

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

NOTES = {
    1012: "The left fin is soft here, keep it inside.",
    1026: "Remoras in front: the outline follows them.\nHold the shape behind.",
    1040: "Tail is fine again.",
}
LOOKED_AT = 1026


def photograph_review(shown: MainWindow, panel: str, dialog: str, sheet: str) -> None:
    """The tracked demo with notes on it, in three pictures of these names; afterwards the notes are gone again."""
    from app.dialogs.review_dialog import ReviewDialog
    from roam_core.roto import timing

    project = shown.document.project
    for frame, text in NOTES.items():
        project = timing.set_mark(project, frame, text)
    shown.document.apply("Write notes", project)
    shown.actions_by_id["review.panel"].setChecked(True)
    show_frame(shown, LOOKED_AT)
    until(lambda: shown.review.entries, "the list")
    photograph(shown, panel)
    shown.actions_by_id["review.movie"].trigger()
    asked = shown.findChild(ReviewDialog)
    assert asked is not None
    asked.target.setText("shots/demo/manta_review.mp4")
    photograph(asked, dialog)
    asked.close()
    _write_sheet(shown, sheet)
    shown.actions_by_id["review.panel"].setChecked(False)
    shown.actions_by_id["edit.undo"].trigger()


def _write_sheet(shown: MainWindow, name: str) -> None:
    """The contact sheet that the window writes, as a JPEG for the guide."""
    import cv2

    from roam_core.review.frames import chosen_frames
    from roam_core.review.sheet import SheetLayout
    from roam_core.review.writing import Output, ReviewRequest

    project = shown.document.project
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "sheet.png"
        frames = chosen_frames(project, "x6,notes")
        layout = SheetLayout(columns=4, rows=3, width=1280)
        ended: list[object] = []
        shown.review_job.finished.connect(lambda ending, _: ended.append(ending))
        shown.review_job.start(ReviewRequest(project, frames, Output.SHEET, path, layout=layout))
        until(lambda: ended, "the contact sheet")
        cv2.imwrite(str(IMAGES / name), cv2.imread(str(path)), [cv2.IMWRITE_JPEG_QUALITY, QUALITY])
