"""The onion skin: outlines of frames before and after, thin, the fainter the farther away, with their numbers."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen

from roam_core.roto import Project, RotoShape

from ...model.shown import shown_shapes, visible_shapes
from ...model.view_state import Selection
from ...model.viewing import Onion
from ...paint import marks
from ...paint.outline_paths import OutlinePaths
from ...paint.viewport import Viewport

WIDTH, SHADOW = 1.0, 0.6
NEAREST, FARTHEST = 1.0, 0.45
"""Opacity of the outlines of the nearest and of the farthest frame."""
MOST_NUMBERED = 2
"""So many shapes carry the frames' numbers; more of them would be a heap of figures."""
FIGURES = 11


def ghosts(project: Project, frame: int, onion: Onion, shapes: list[RotoShape]) -> list[tuple[int, float]]:
    """The frames whose outlines are drawn and their opacities, the farthest first.

    With `only_keys` the artist's keys of `shapes` before and after `frame`, else every `step`-th frame of the clip.
    """
    if onion.only_keys:
        keys = sorted({key for shape in shapes for key in shape.artist_frames} - {frame})
        before = [key for key in reversed(keys) if key < frame][: onion.before]
        after = [key for key in keys if key > frame][: onion.after]
    else:
        before = [frame - onion.step * (k + 1) for k in range(onion.before)]
        after = [frame + onion.step * (k + 1) for k in range(onion.after)]
    clip = project.clip
    found = [pair for side in (before, after) for pair in _faded(side) if clip is None or pair[0] in clip.frame_range]
    return sorted(found, key=lambda pair: -abs(pair[0] - frame))


def paint_onion(
    painter: QPainter,
    viewport: Viewport,
    project: Project,
    frame: int,
    selection: Selection,
    onion: Onion,
    paths: OutlinePaths,
) -> None:
    """Paint the ghosts of the selected shapes, or of all where none is selected; the shapes themselves go over them.

    A shape that does not exist on `frame` has its ghosts on those frames on which it does. `paths` remembers the
    outlines.
    """
    visible = visible_shapes(project)
    chosen = [] if onion.all_shapes else [shape for shape in visible if shape.id in selection.shapes]
    shapes = chosen or visible
    wanted = {shape.id for shape in shapes}
    numbers: list[tuple[QPointF, str, QColor]] = []
    for ghost, opacity in ghosts(project, frame, onion, shapes):
        colour = marks.faded(QColor(onion.before_colour if ghost < frame else onion.after_colour), opacity)
        for shown in shown_shapes(project, ghost):
            if shown.shape.id in wanted:
                path = viewport.transform.map(paths.whole(shown.shape, ghost))
                _paint_ghost(painter, path, colour)
                numbers.append((_top(path), str(ghost), colour))
    if len(wanted) <= MOST_NUMBERED:
        _paint_numbers(painter, numbers)


def _faded(frames: list[int]) -> Iterator[tuple[int, float]]:
    """Each of the frames, the nearest first, with its opacity."""
    for index, frame in enumerate(frames):
        yield frame, NEAREST + (FARTHEST - NEAREST) * index / max(len(frames) - 1, 1)


def _paint_ghost(painter: QPainter, path: QPainterPath, colour: QColor) -> None:
    """A thin line with a shadow beside it: it reads on bright plates, and many of them do not darken the picture."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for ink, aside in ((marks.faded(marks.EDGE, SHADOW * colour.alphaF()), WIDTH), (colour, 0.0)):
        painter.setPen(QPen(ink, WIDTH))
        painter.translate(aside, aside)
        painter.drawPath(path)
        painter.translate(-aside, -aside)


def _top(path: QPainterPath) -> QPointF:
    """The uppermost of an outline's points."""
    top = min((path.elementAt(k) for k in range(path.elementCount())), key=lambda element: element.y)
    return QPointF(top.x, top.y)


def _paint_numbers(painter: QPainter, numbers: list[tuple[QPointF, str, QColor]]) -> None:
    """The frames' numbers over their outlines, dark-edged so that they read on any plate; the nearest frame's first.

    Where two would lie upon each other the farther one is left out.
    """
    painter.save()
    font = painter.font()
    font.setPixelSize(FIGURES)
    font.setBold(True)  # thin figures drown in their dark edge
    edge = QPen(marks.EDGE, 2.0, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin)
    taken: list[QRectF] = []
    for top, text, colour in reversed(numbers):
        words = QPainterPath()
        words.addText(top + QPointF(3.0, -5.0), font, text)
        box = words.boundingRect().adjusted(-3.0, -1.0, 3.0, 1.0)
        if any(box.intersects(other) for other in taken):
            continue
        taken.append(box)
        painter.strokePath(words, edge)
        painter.fillPath(words, marks.faded(colour, 1.0 / colour.alphaF()))
    painter.restore()
