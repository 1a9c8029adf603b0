"""What a widget shows, as numbers."""

from __future__ import annotations

import numpy as np
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget

from roam_core.arrays import Int64


def pixels_of(widget: QWidget) -> Int64:
    """Red, green and blue of what is painted, `(rows, columns, 3)`, signed so that differences can be taken."""
    image = widget.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    shape = image.height(), image.width(), 4
    return np.frombuffer(image.constBits(), dtype=np.uint8).reshape(shape)[:, :, 2::-1].astype(np.int64)
