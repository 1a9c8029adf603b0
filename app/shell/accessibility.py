"""The window for those who do not see it, or have no mouse: names of what is painted, and keys to every control."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QUndoView, QWidget

from ..features.playback import Playback
from ..model.document import Document
from ..model.view_state import ViewState, selected_shapes
from ..panels.shapes import ShapesPanel
from ..timeline.timeline import Timeline
from ..translation import tr
from ..widgets.reach import KeyboardReach

MOST_NAMES = 4
"""Selected shapes that are told by their names; of more their number."""


class Accessibility(QObject):
    """Tells screen readers what painted parts are, and on which frame and shapes the artist works.

    The viewer's description follows frame and selection, but not while the clip plays. The keyboard goes from the
    viewer to `parts`, in their order, and back to it.
    """

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        viewer: QWidget,
        parts: Sequence[QWidget],
        playback: Playback,
    ) -> None:
        super().__init__(viewer)
        self._document, self._view, self._viewer, self._playback = document, view_state, viewer, playback
        self.reach = KeyboardReach(viewer, (viewer, *parts))
        viewer.setAccessibleName(tr("Viewer"))
        view_state.frame_changed.connect(self._tell)
        view_state.selection_changed.connect(self._tell)
        document.changed.connect(lambda _: self._tell())
        document.replaced.connect(self._tell)
        playback.playing_changed.connect(self._tell)
        self._tell()

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return self.reach.handlers()

    @property
    def sentence(self) -> str:
        """The frame, and what is selected."""
        shapes = selected_shapes(self._document.project, self._view.selection)
        points = len(self._view.selection.points)
        if not shapes:
            selected = tr("Nothing is selected.")
        elif len(shapes) > MOST_NAMES:
            selected = tr("{count} shapes are selected.", count=len(shapes))
        else:
            selected = tr("Selected: {names}.", names=", ".join(shape.name for shape in shapes))
        more = [tr("%n point(s) of it.", "", points)] if points else []
        return " ".join([tr("Frame {frame}.", frame=self._view.frame), selected, *more])

    def _tell(self) -> None:
        if self._playback.speed == 0.0:
            self._viewer.setAccessibleDescription(self.sentence)


def name_parts(timeline: Timeline, history: QUndoView, shapes: ShapesPanel) -> None:
    """Tell screen readers what lists and painted parts are, beside which no label stands."""
    for part, name in (
        (timeline.ruler, tr("Timeline ruler")),
        (timeline.marks, tr("Marks")),
        (timeline.tracks, tr("Motion of layers")),
        (timeline.rows, tr("Keys of shapes")),
        (timeline.confidence, tr("Confidence")),
        (history, tr("History")),
        (shapes.tree, tr("Shapes")),
    ):
        part.setAccessibleName(name)
