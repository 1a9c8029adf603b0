"""The program's icon in the forms that desktops want: PNG of several sizes, `.ico` and `.icns`.

python -m bundle.icons FOLDER
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

DRAWN = Path(__file__).parent / "icon.svg"
SIZES = (16, 32, 48, 128, 256)
LARGEST = 256
"""Pixels of the picture in `.ico` and `.icns`; desktops make smaller ones of it."""


def write(folder: Path) -> None:
    """Write `roam-SIZE.png` of every size, `roam.ico` and `roam.icns`; what Qt cannot write is an `OSError`."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from PySide6.QtGui import QGuiApplication, QImage, QPainter
    from PySide6.QtSvg import QSvgRenderer

    application = QGuiApplication.instance() or QGuiApplication([])
    folder.mkdir(parents=True, exist_ok=True)
    renderer = QSvgRenderer(str(DRAWN))

    def picture(size: int) -> QImage:
        image = QImage(size, size, QImage.Format.Format_ARGB32)
        image.fill(0)
        painter = QPainter(image)
        renderer.render(painter)
        painter.end()
        return image

    wanted = [(f"roam-{size}.png", size) for size in SIZES] + [("roam.ico", LARGEST), ("roam.icns", LARGEST)]
    for name, size in wanted:
        if not picture(size).save(str(folder / name)):
            raise OSError(f"{folder / name} could not be written")
    del application


if __name__ == "__main__":
    write(Path(sys.argv[1]))
