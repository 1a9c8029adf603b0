"""Boxes for numbers in which what is typed beyond a bound becomes the bound.

Qt's own refuse the digit that goes beyond, and take what is left: 150 of at most 100 is 15.
"""

from __future__ import annotations

from math import isfinite

from PySide6.QtCore import QLocale
from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox, QSpinBox

Verdict = tuple[QValidator.State, str, int]
"""Of a text that is being typed: what it is, the text, and where the cursor is in it."""


class WholeBox(QSpinBox):
    """A whole number."""

    def validate(self, text: str, position: int) -> Verdict:
        return _allowing_beyond(self, super().validate(text, position))

    def fixup(self, text: str) -> str:
        number = typed_number(self, text)
        return text if number is None else f"{self.textFromValue(int(_bounded(self, number)))}{self.suffix()}"


class DecimalBox(QDoubleSpinBox):
    """A number with decimals."""

    def validate(self, text: str, position: int) -> Verdict:
        return _allowing_beyond(self, super().validate(text, position))

    def fixup(self, text: str) -> str:
        number = typed_number(self, text)
        if number is None:
            return text
        return f"{QDoubleSpinBox.textFromValue(self, _bounded(self, number))}{self.suffix()}"


def typed_number(box: QSpinBox | QDoubleSpinBox, text: str) -> float | None:
    """The number that a box's text stands for, within its bounds or not; None where it is none yet."""
    plain = box.locale()
    plain.setNumberOptions(QLocale.NumberOption.RejectGroupSeparator)
    number, is_number = plain.toDouble(_body(box, text))
    return number if is_number and isfinite(number) else None


def _allowing_beyond(box: QSpinBox | QDoubleSpinBox, verdict: Verdict) -> Verdict:
    state, text, position = verdict
    if state is not QValidator.State.Invalid:
        return verdict
    number = typed_number(box, text)
    is_beyond = number is not None and number != _bounded(box, number)
    if is_beyond or _body(box, text) in ("+", "-"):
        return QValidator.State.Intermediate, text, position
    return verdict


def _bounded(box: QSpinBox | QDoubleSpinBox, number: float) -> float:
    return min(max(number, box.minimum()), box.maximum())


def _body(box: QSpinBox | QDoubleSpinBox, text: str) -> str:
    return text.removesuffix(box.suffix()).strip()
