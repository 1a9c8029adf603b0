"""The marks: thin outlines drawn the quick way look as those drawn the plain way."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QImage, QPainter, QPainterPath

from app.paint import marks
from roam_core.arrays import Int64

COLOUR, BACKGROUND = QColor("#e0a030"), 128


def drawn(draw: Callable[[QPainter], None], ratio: float = 1.0) -> Int64:
    """What a grey background of 80 x 80 looks like after drawing, (80, 80, 3)."""
    background = QImage(80, 80, QImage.Format.Format_RGB32)
    background.setDevicePixelRatio(ratio)
    background.fill(QColor(BACKGROUND, BACKGROUND, BACKGROUND))
    painter = QPainter(background)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    draw(painter)
    painter.end()
    return np.frombuffer(background.constBits(), dtype=np.uint8).reshape(80, 80, 4)[..., :3].astype(np.int64)


def line(degrees: float) -> QPainterPath:
    """A line through the middle."""
    aside = 30.0 * QPointF(np.cos(np.radians(degrees)), np.sin(np.radians(degrees)))
    path = QPainterPath(QPointF(40.3, 40.4) - aside)
    path.lineTo(QPointF(40.3, 40.4) + aside)
    return path


@pytest.mark.parametrize("degrees", [0.0, 20.0, 45.0, 70.0, 90.0, 135.0])
def test_thin_outlines_are_as_wide_and_bright_as_plain_ones(degrees: float) -> None:
    path = line(degrees)
    plain = drawn(lambda painter: marks.stroke(painter, path, COLOUR, marks.OUTLINE_WIDTH))
    quick = drawn(lambda painter: marks.thin_stroke(painter, path, COLOUR))
    for way in (1, -1):  # what is brighter than the background, and what is darker
        ink, expected = (
            float(np.clip(way * (picture[..., 2] - BACKGROUND), 0, None).sum()) for picture in (quick, plain)
        )
        assert ink == pytest.approx(expected, rel=0.4)
    assert np.abs(plain - quick).mean() < 1.0


def test_faded_outlines_and_dense_screens_take_the_plain_way() -> None:
    path, faded = line(30.0), marks.faded(COLOUR, 0.4)
    for colour, ratio in ((faded, 1.0), (COLOUR, 2.0)):
        plain = drawn(lambda painter, c=colour: marks.stroke(painter, path, c, marks.OUTLINE_WIDTH), ratio)
        np.testing.assert_array_equal(
            drawn(lambda painter, c=colour: marks.thin_stroke(painter, path, c), ratio), plain
        )


def test_many_anchors_and_handles_look_as_each_by_itself() -> None:
    """Thousands of them share pens and brushes; what lies over what stays."""
    kinds = [marks.Anchor(QPointF(8 + 4.3 * k, 40.2), k % 2 > 0, k % 3 > 0, k == 7) for k in range(15)]
    discs = [(QPointF(8 + 4.3 * k, 60.7), k == 3) for k in range(15)]

    def each(painter: QPainter) -> None:
        for at, round_, filled, grown, _ in kinds:
            marks.anchor(painter, at, COLOUR, round_=round_, filled=filled, grown=grown)
        for at, grown in discs:
            marks.handle(painter, at, COLOUR, grown=grown)

    def together(painter: QPainter) -> None:
        marks.anchors(painter, kinds, COLOUR)
        marks.handles(painter, discs, COLOUR)

    assert np.array_equal(drawn(each), drawn(together))


def test_the_anchor_with_which_a_shape_begins_is_larger() -> None:
    def ink(*, first: bool) -> int:
        anchor = marks.Anchor(QPointF(40.0, 40.0), False, False, False, first)
        return int(np.count_nonzero(drawn(lambda painter: marks.anchors(painter, [anchor], COLOUR)) != BACKGROUND))

    assert ink(first=True) > 1.5 * ink(first=False)


def test_an_arrow_needs_a_line_that_is_long_enough() -> None:
    def ink(length: float) -> int:
        path = QPainterPath(QPointF(10.0, 40.0))
        path.lineTo(QPointF(10.0 + length, 40.0))
        return int(np.count_nonzero(drawn(lambda painter: marks.arrow(painter, path, COLOUR)) != BACKGROUND))

    assert ink(marks.ARROW_ROOM + 5.0) > 0
    assert ink(marks.ARROW_ROOM - 5.0) == 0
