"""The form that says how mattes are written: kind of file, depth, compression, what has a picture of its own."""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum

from PySide6.QtWidgets import QCheckBox, QComboBox, QWidget

from roam_core.interchange.matte_style import (
    COMPRESSIONS,
    DEPTHS,
    DataWindow,
    Depth,
    Gathering,
    MatteFile,
    MatteStyle,
    Parts,
)

from ..translation import N_, tr
from ..widgets.controls import dense_form, form_label

FILES = {MatteFile.PNG: "PNG", MatteFile.EXR: "EXR", MatteFile.TIFF: "TIFF"}
DEPTH_WORDS = {
    Depth.BITS_8: N_("8 bits"),
    Depth.BITS_16: N_("16 bits"),
    Depth.HALF: N_("Half float"),
    Depth.FLOAT: N_("Float"),
}
PART_WORDS = {
    Parts.ALL: N_("All shapes together"),
    Parts.LAYER: N_("Every layer"),
    Parts.SHAPE: N_("Every shape"),
}
GATHERING_WORDS = {
    Gathering.FILES: N_("Files of their own"),
    Gathering.CHANNELS: N_("Channels of one file"),
}
WINDOW_WORDS = {DataWindow.FULL: N_("All pixels"), DataWindow.TIGHT: N_("Around the shapes only")}


class MatteForm(QWidget):
    """Only what the kind of file can hold may be chosen."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.file, self.depths, self.compression, self.parts, self.gathering, self.pixels = (
            QComboBox() for _ in range(6)
        )
        self.resumes = QCheckBox(tr("Skip frames whose files are there"))
        _fill(self.file, FILES.items())
        _fill(self.parts, PART_WORDS.items())
        _fill(self.gathering, GATHERING_WORDS.items())
        _fill(self.pixels, WINDOW_WORDS.items())
        form = dense_form()
        for title, field in (
            (tr("Files"), self.file),
            (tr("Depth"), self.depths),
            (tr("Packing"), self.compression),
            (tr("Mattes of"), self.parts),
            (tr("Put into"), self.gathering),
            (tr("Pixels"), self.pixels),
            ("", self.resumes),
        ):
            form.addRow(form_label(title), field)
        self.setLayout(form)
        self.file.currentIndexChanged.connect(lambda _: self._pull())
        self._pull()

    @property
    def chosen(self) -> MatteStyle:
        """The style as it stands in the fields."""
        is_exr = self._kind is MatteFile.EXR
        return MatteStyle(
            file=self._kind,
            depth=Depth(self.depths.currentData()),
            compression=self.compression.currentData(),
            parts=Parts(self.parts.currentData()),
            gathering=Gathering(self.gathering.currentData()) if is_exr else Gathering.FILES,
            window=DataWindow(self.pixels.currentData()) if is_exr else DataWindow.FULL,
            resumes=self.resumes.isChecked(),
        )

    @property
    def _kind(self) -> MatteFile:
        return MatteFile(self.file.currentData())

    def _pull(self) -> None:
        kind = self._kind
        _fill(self.depths, ((depth, DEPTH_WORDS[depth]) for depth in DEPTHS[kind]))
        _fill(self.compression, ((word, word) for word in COMPRESSIONS[kind]))
        for field in (self.gathering, self.pixels):
            field.setEnabled(kind is MatteFile.EXR)
            field.setToolTip("" if kind is MatteFile.EXR else tr("EXR files only"))


def _fill(field: QComboBox, choices: Iterable[tuple[StrEnum | str, str]]) -> None:
    """Put words into a field; what was chosen stays where it still can."""
    chosen = field.currentData()
    field.clear()
    for value, word in choices:
        field.addItem(tr(word), str(value))
    field.setCurrentIndex(max(field.findData(chosen), 0))
