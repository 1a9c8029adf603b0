"""An export that failed is told where nobody overlooks it, with the ways on."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QMessageBox, QWidget

from ..dialogs import questions
from ..jobs.export import Export, Request
from ..translation import tr


class FailedExports(QObject):
    """Asks for each export that failed, in a dialog that the work does not wait for: again, elsewhere, or later."""

    def __init__(self, window: QWidget, export: Export) -> None:
        super().__init__(window)
        self._window, self._export = window, export
        export.failed.connect(self._tell)

    def _tell(self, request: Request, sentence: str) -> None:
        box = questions.not_exported_question(self._window, request.path.name, sentence)

        def go_on() -> None:
            if box.buttonRole(box.clickedButton()) is not QMessageBox.ButtonRole.AcceptRole:
                self._export.again(request)
            elif (path := self._elsewhere(request)) is not None:
                self._export.again(request, path)

        box.accepted.connect(go_on)
        box.open()

    def _elsewhere(self, request: Request) -> Path | None:
        from roam_core.interchange import EXPORTERS

        if request.is_folder:
            return questions.choose_folder(self._window, tr("Export mattes to a folder"), request.path.parent)
        exporter = EXPORTERS[request.format_name]
        title = tr("Export: {title}", title=tr(exporter.title))
        return questions.choose_export(self._window, title, request.path, exporter.suffix)
