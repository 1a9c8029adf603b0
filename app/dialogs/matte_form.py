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
    Gathering.CRYPTOMATTE: N_("Cryptomatte"),
}
ALL_BY_NAME = N_("Shapes and layers")
"""What a Cryptomatte tells apart where nothing is left out: it has no matte of all together."""
WINDOW_WORDS = {DataWindow.FULL: N_("All pixels"), DataWindow.TIGHT: N_("Around the shapes only")}


class MatteForm(QWidget):
    """Only what the kind of file can hold may be chosen. While it is hidden its place stays its own."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        policy = self.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self.setSizePolicy(policy)
        self.file, self.depths, self.compression, self.parts, self.gathering, self.pixels = (
            QComboBox() for _ in range(6)
        )
        self._depth: str | None = None
        """What was chosen before Cryptomatte took its own."""
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
        self.gathering.currentIndexChanged.connect(lambda _: self._pull())
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

    @property
    def _is_cryptomatte(self) -> bool:
        return self._kind is MatteFile.EXR and self.gathering.currentData() == Gathering.CRYPTOMATTE

    def _pull(self) -> None:
        kind, is_cryptomatte = self._kind, self._is_cryptomatte
        if self.depths.count() > 1:
            self._depth = self.depths.currentData()
        depths = (Depth.FLOAT,) if is_cryptomatte else DEPTHS[kind]
        _fill(self.depths, ((depth, DEPTH_WORDS[depth]) for depth in depths), self._depth)
        all_parts = ALL_BY_NAME if is_cryptomatte else PART_WORDS[Parts.ALL]
        self.parts.setItemText(self.parts.findData(str(Parts.ALL)), tr(all_parts))
        _fill(self.compression, ((word, word) for word in COMPRESSIONS[kind]))
        for field in (self.gathering, self.pixels):
            field.setEnabled(kind is MatteFile.EXR)
            field.setToolTip("" if kind is MatteFile.EXR else tr("EXR files only"))


def _fill(field: QComboBox, choices: Iterable[tuple[StrEnum | str, str]], chosen: str | None = None) -> None:
    """Put words into a field; what is `chosen`, or stands there, stays where it still can."""
    chosen = field.currentData() if chosen is None else chosen
    field.clear()
    for value, word in choices:
        field.addItem(tr(word), str(value))
    field.setCurrentIndex(max(field.findData(chosen), 0))
