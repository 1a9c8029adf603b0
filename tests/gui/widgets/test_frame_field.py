"""Fields for frame numbers: all digits are seen, however many there are."""

from __future__ import annotations

from pytestqt.qtbot import QtBot

from app.widgets.controls import FRAME_ASIDE, FRAME_WIDTH, number_field


def test_a_field_has_room_for_the_frame_that_it_shows(qtbot: QtBot) -> None:
    """Of nine digits the first two were cut off."""
    field = number_field("Frame")
    qtbot.addWidget(field)
    field.show()
    field.setValue(1001)
    assert field.width() == FRAME_WIDTH
    field.show_frame(103680000, 103680000, 103680100)
    assert field.width() == field.fontMetrics().horizontalAdvance("103680000") + FRAME_ASIDE
