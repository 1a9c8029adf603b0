"""What is typed beyond the bounds of a number is taken as the bound, and never as some of its digits."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QLocale, Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from app.widgets.controls import number_field
from app.widgets.fields import NumberField
from app.widgets.number_boxes import DecimalBox, WholeBox


def typed(box: WholeBox | DecimalBox, text: str) -> float:
    box.setFocus()
    box.selectAll()
    QTest.keyClicks(box.lineEdit(), text)
    QTest.keyClick(box, Qt.Key.Key_Return)
    return box.value()


@pytest.mark.parametrize(
    ("text", "found"), [("150", 100.0), ("-5", 0.0), ("99999999999999", 100.0), ("50", 50.0), ("1e", 1.0), ("-", 40.0)]
)
def test_a_number_of_a_panel_goes_no_farther_than_its_bounds(qtbot: QtBot, text: str, found: float) -> None:
    field, given = NumberField(0.0, 100.0, suffix=" %"), []
    qtbot.addWidget(field)
    field.edited.connect(lambda value, _merge_key: given.append(value))
    field.show_value(40.0)
    assert typed(field, text) == found
    assert given == ([] if text == "-" else [found])
    assert field.text() == f"{found:.0f} %"


def test_a_number_for_several_that_differ_goes_no_farther_either(qtbot: QtBot) -> None:
    field, given = NumberField(0.0, 100.0, suffix=" %"), []
    qtbot.addWidget(field)
    field.edited.connect(lambda value, _merge_key: given.append(value))
    field.show_value(None)
    assert typed(field, "150") == 100.0
    assert given == [100.0]


@pytest.mark.parametrize(
    ("text", "found"), [("1100", 1048), ("17", 1001), ("10480", 1048), ("1020", 1020), ("-3", 1001)]
)
def test_a_frame_beyond_the_clip_is_its_end(qtbot: QtBot, text: str, found: int) -> None:
    field, given = number_field("Frame"), []
    qtbot.addWidget(field)
    field.show_frame(1010, 1001, 1048)
    field.valueChanged.connect(given.append)
    assert typed(field, text) == found
    assert given == [found]


@pytest.mark.parametrize("text", ["20.25", "20,25"])
def test_decimals_of_any_language_are_bounded_too(qtbot: QtBot, text: str) -> None:
    field = NumberField(-8.0, 8.0, decimals=2)
    qtbot.addWidget(field)
    field.setLocale(QLocale(QLocale.Language.German))
    assert typed(field, text) == 8.0
    assert typed(field, f"-{text}") == -8.0
    assert typed(field, text[1:]) == 0.25


def test_numbers_of_dialogs_are_bounded_too(qtbot: QtBot) -> None:
    whole, decimal = WholeBox(), DecimalBox()
    for box in (whole, decimal):
        qtbot.addWidget(box)
        box.setSuffix(" frames")
        box.setRange(-30, 30)
        assert typed(box, "100") == 30
        assert typed(box, "-100") == -30
