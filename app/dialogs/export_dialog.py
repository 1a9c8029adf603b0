"""The export dialog: every format, which keys, which frames, how mattes are written, and what a format cannot hold."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QFormLayout,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QProgressBar,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, Exporter, ExportOptions, KeyChoice
from roam_core.interchange.foresight import Foreseen
from roam_core.interchange.protocol import WritesSeveral
from roam_core.interchange.targets import exported, replaces_any
from roam_core.roto.layers import only

from .. import style
from ..jobs.export import MATTES, Export
from ..jobs.foreseeing import Foresight
from ..jobs.runner import Ending
from ..model.document import Document
from ..model.view_state import ViewState, selected_shapes
from ..translation import N_, tr, translated
from ..widgets.controls import dense_form, form_label, measure_field, side_by_side, weak_label
from ..widgets.floating import resize_on_screen
from . import questions
from .frame_range import FrameRange
from .matte_form import MatteForm

KEYS = {
    KeyChoice.EVERY: N_("Every key"),
    KeyChoice.ARTIST: N_("My keys only"),
    KeyChoice.REDUCED: N_("As few as hold the outline"),
}
STRAYING = N_("How far the outline may stray from the tracked one when keys are left out")
SMOOTHING = N_(
    "How far tracked keys may move so that shapes move evenly through time, in pixels of the plate;\n"
    "your own keys stay where they are, and so does the project"
)
NOTES_HEIGHT = 44
"""What is left of them on a small screen."""
ANYWAY = N_("Export anyway")
LOOKING, NOTHING_LOST = (
    N_("Looking for what the format cannot hold …"),
    N_("The format holds all that is chosen."),
)


class ExportDialog(QDialog):
    """Stays open beside the work: an export runs on the writer's thread and tells here what it noted.

    `suggested(suffix)` gives the file that is proposed.
    """

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        export: Export,
        suggested: Callable[[str], Path],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._export, self._suggested = document, view_state, export, suggested
        self._number, self._format = 0, ""
        """The number of the export that was started here, 0 where none is under way, and its format."""
        self._ending = ""
        """What the format that was proposed for last puts after the name."""
        self._targets: dict[bool, str] = {}
        """What stood in the target last, of formats that are a folder of pictures and of those that are a file."""
        self._losses: tuple[str, ...] = ()
        """What the artist sees that the format would lose, as long as nothing else is chosen."""
        self._foresight = Foresight(export.runner, self)
        self.setWindowTitle(tr("Export"))
        resize_on_screen(self, 760, 580)
        self._build()
        self._lay_out()
        self._connect()
        self._pull_project()

    # ---- building

    def _build(self) -> None:
        self.formats = QTreeWidget()
        self.formats.setColumnCount(2)
        self.formats.setHeaderHidden(True)
        self.formats.setRootIsDecorated(False)
        for exporter in EXPORTERS.values():
            item = QTreeWidgetItem(self.formats, [tr(exporter.title), exporter.suffix])
            item.setData(0, Qt.ItemDataRole.UserRole, exporter.name)
            item.setTextAlignment(1, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        mode = QHeaderView.ResizeMode
        self.formats.header().setSectionResizeMode(0, mode.Stretch)
        self.formats.header().setSectionResizeMode(1, mode.ResizeToContents)
        self.formats.header().setStretchLastSection(False)
        self.selected = QCheckBox(tr("Selected shapes only"))
        self.keys = QComboBox()
        self.tolerance = measure_field(tr(" px"), 0.5, 0.01, 100.0, 0.1, tr(STRAYING))
        self.smoothing = measure_field(tr(" px"), 0.0, 0.0, 100.0, 0.1, tr(SMOOTHING))
        self.smoothing.setSpecialValueText(tr("Off"))
        self.frames = FrameRange(self._view, tr("The first frame to export"), tr("The last frame to export"))
        self.all_frames = QPushButton(tr("All"))
        self.mattes = MatteForm()
        self.target, self.browse = QLineEdit(), QPushButton(tr("Browse…"))
        self.hint = weak_label("")
        self.notes = QPlainTextEdit()
        self.notes.setReadOnly(True)
        for part, name in ((self.formats, tr("Format")), (self.notes, tr("What the format cannot hold"))):
            part.setAccessibleName(name)
        self.notes.setMinimumHeight(NOTES_HEIGHT)
        self.bar = QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.start, self.stop, self.leave = QPushButton(tr("Export")), QPushButton(tr("Stop")), QPushButton(tr("Close"))
        self.start.setMinimumWidth(QPushButton(tr(ANYWAY)).sizeHint().width())  # nothing moves when its word changes
        self.start.setDefault(True)
        self.stop.setEnabled(False)

    def _lay_out(self) -> None:
        form = dense_form()
        form.addRow(form_label(tr("Shapes")), self.selected)
        form.addRow(form_label(tr("Keys")), self.keys)
        self._tolerance_label = form_label(tr("Within"))
        form.addRow(self._tolerance_label, side_by_side(self.tolerance, None))
        self._smoothing_label, self._smoothing_word = (
            form_label(tr("Smooth", "what is done to keys")),
            weak_label(tr("through time")),
        )
        form.addRow(self._smoothing_label, side_by_side(self.smoothing, self._smoothing_word, None))
        form.addRow(
            form_label(tr("Frames")),
            side_by_side(
                self.frames.first, QLabel(tr("to")), self.frames.last, self.all_frames, self.frames.in_out, None
            ),
        )
        right = QVBoxLayout()
        right.setSpacing(6)
        right.addLayout(form)
        right.addWidget(self.mattes)
        right.addStretch(1)
        upper = QHBoxLayout()
        upper.setSpacing(2 * style.MARGIN)
        upper.addWidget(self.formats, 1)
        upper.addLayout(right, 1)
        column = QVBoxLayout(self)
        column.setSpacing(style.MARGIN)
        column.addLayout(upper, 3)
        where: QFormLayout = dense_form()
        where.addRow(form_label(tr("To", "where it is written")), side_by_side(self.target, self.browse))
        where.addRow(form_label(""), self.hint)
        column.addLayout(where)
        column.addWidget(self.notes, 2)
        column.addLayout(side_by_side(self.bar, self.stop, self.start, self.leave))

    def _connect(self) -> None:
        self.formats.currentItemChanged.connect(lambda *_: self._pull_format())
        self.selected.toggled.connect(lambda _: self._pull_shapes())
        self._view.selection_changed.connect(lambda: self._pull_shapes() if self.selected.isChecked() else None)
        self._document.changed.connect(lambda _: self._look_ahead())
        self._foresight.seen.connect(self._show_foreseen)
        self._foresight.refused.connect(self._show_refused)
        self.keys.currentIndexChanged.connect(lambda _: self._pull_keys())
        self.target.textChanged.connect(lambda _: self._pull_target())
        for choice in (self.mattes.file, self.mattes.parts, self.mattes.gathering):
            choice.currentIndexChanged.connect(lambda _: self._pull_hint())
        self.mattes.resumes.toggled.connect(lambda _: self._pull_hint())
        for field in (self.frames.first, self.frames.last):
            field.valueChanged.connect(lambda _: self._pull_hint())
            field.valueChanged.connect(lambda _: self._look_ahead())
        self.all_frames.clicked.connect(self._take_all_frames)
        self.browse.clicked.connect(self._browse)
        self.start.clicked.connect(self._start)
        self.stop.clicked.connect(lambda: self._export.stop(self._number))
        self.leave.clicked.connect(self.close)
        self._document.replaced.connect(self._pull_project)
        self._export.progress.connect(self._show_progress)
        self._export.noted.connect(self._show_notes)
        self._export.finished.connect(self._show_end)

    # ---- what is chosen

    @property
    def exporter(self) -> Exporter:
        """The format that is selected."""
        item = self.formats.currentItem()
        assert item is not None  # one is selected from the beginning
        return EXPORTERS[item.data(0, Qt.ItemDataRole.UserRole)]

    def choose(self, name: str) -> None:
        """Select a format."""
        for row in range(self.formats.topLevelItemCount()):
            item = self.formats.topLevelItem(row)
            if item is not None and item.data(0, Qt.ItemDataRole.UserRole) == name:
                self.formats.setCurrentItem(item)

    @property
    def options(self) -> ExportOptions:
        """The options as they stand in the fields."""
        clip, frames = self._document.project.clip, self.frames.chosen
        return ExportOptions(
            keys=KeyChoice(self.keys.currentData()),
            tolerance=self.tolerance.value(),
            frames=None if clip is None or frames == clip.frame_range else frames,
            smoothing=self.smoothing.value() if self.smoothing.isEnabled() else 0.0,
            mattes=self.mattes.chosen,
        )

    @property
    def shapes(self) -> frozenset[str] | None:
        """The ids of the shapes to export, None for all."""
        if not self.selected.isChecked():
            return None
        return frozenset(shape.id for shape in selected_shapes(self._document.project, self._view.selection))

    @property
    def path(self) -> Path:
        """Where the export goes; a name alone lies beside the suggested file, a missing suffix is added."""
        path = self._suggested("").parent / Path(self.target.text().strip()).expanduser()
        return path if self._is_folder else questions.with_suffix(path, self.exporter.suffix)

    @property
    def _is_folder(self) -> bool:
        return self.exporter.name == MATTES

    # ---- pulling

    def _pull_project(self) -> None:
        """Another project: its frames, and a name for what is written of it."""
        clip = self._document.project.clip
        self.frames.pull(clip)
        self.target.clear()
        self._targets.clear()
        if self.formats.currentItem() is None:
            self.choose(next(iter(EXPORTERS)))
        self._pull_format()

    def _pull_format(self) -> None:
        chosen, kinds = (
            self.keys.currentData(),
            [kind for kind in KEYS if kind != KeyChoice.REDUCED or not self._is_folder],
        )
        self.keys.clear()
        for kind in kinds:
            self.keys.addItem(tr(KEYS[kind]), kind.value)
        self.keys.setCurrentIndex(max(self.keys.findData(chosen), 0))
        self.mattes.setVisible(self._is_folder)
        self.target.setText(str(self._renamed()))
        self.notes.clear()
        self._pull_keys()

    def _renamed(self) -> Path:
        """The target for the format that is selected now: the artist's own name with another suffix.

        Formats that share a suffix propose names of their own: none takes the place of what another wrote. The folder
        of mattes and the name of files go each their own way: a look at one does not take the other away.
        """
        if self._is_folder:
            suggested = self._suggested("")
            return Path(self._targets.get(True) or suggested.with_name(f"{suggested.name}_mattes"))
        own, last, suffix = Path(self._targets.get(False, "")), self._ending, self.exporter.suffix
        self._ending = f"{_mark(self.exporter)}{suffix}"
        if not own.name:
            own = self._suggested(suffix)
        elif last and own.name.endswith(last):
            own = own.with_name(own.name.removesuffix(last) + suffix)
        known = {exporter.suffix for exporter in EXPORTERS.values()}
        bare = own.with_suffix("") if own.suffix.lower() in known else own
        return Path(f"{bare}{self._ending}")

    def _pull_keys(self) -> None:
        """What is asked about keys depends on which are written: the artist's own are never moved."""
        keys = self.keys.currentData()
        if keys is None:  # the list is being filled
            return
        for widgets, is_used in (
            ((self._tolerance_label, self.tolerance), keys == KeyChoice.REDUCED),
            ((self._smoothing_label, self.smoothing, self._smoothing_word), keys != KeyChoice.ARTIST),
        ):
            for widget in widgets:
                widget.setEnabled(is_used)
        self._look_ahead()

    def _pull_shapes(self) -> None:
        """Other shapes are to be exported."""
        self._pull_hint()
        self._look_ahead()

    def _pull_target(self) -> None:
        self._targets[self._is_folder] = self.target.text().strip()
        self._pull_hint()

    def _pull_hint(self) -> None:
        is_named, has_clip = bool(self.target.text().strip()), self._document.project.clip is not None
        has_shapes = self.shapes is None or bool(self.shapes)
        self.start.setEnabled(is_named and has_shapes and has_clip and not self._is_ours)
        if not has_clip:
            self.hint.setText(tr("There is nothing to export yet; open a clip first."))
        elif not is_named:
            self.hint.setText(tr("Say where to write it."))
        elif not has_shapes:
            self.hint.setText(tr("No shape is selected; select some, or export all."))
        elif isinstance(self.exporter, WritesSeveral):
            self.hint.setText(self._told_of_files())
        else:
            self.hint.setText(tr("Replaces the file that is there.") if questions.is_file(self.path) else "")

    def _told_of_files(self) -> str:
        """The first of the mattes, and whether the export would write over a file that is there."""
        options, project = self.options, only(self._document.project, self.shapes)
        said = []
        with suppress(RoamError):  # it would write none; why is told by what looks ahead
            if self._is_folder:
                files = exported(self.exporter, project, self.path, replace(options, frames=self.frames.chosen[:1]))
                names = [os.path.relpath(file, self.path.parent) for file, _ in files[:1]]
                said += [tr("The pictures are {first} and so on.", first=name) for name in names]
            if replaces_any(self.exporter, project, self.path, options):
                said.append(tr("Replaces files that are there."))
        return " ".join(said)

    def _take_all_frames(self) -> None:
        if (clip := self._document.project.clip) is not None:
            self.frames.take(clip.frame_range)

    # ---- what would be lost

    def _look_ahead(self) -> None:
        """Find out what the format would lose of what is chosen now; until that is known nothing may be lost.

        What is told stays until then, so that nothing flickers while shapes are tracked or dragged.
        """
        self._set_losses(())
        project = self._document.project
        is_asked = not self._is_ours and self.isVisible() and project.clip is not None
        self.notes.setPlaceholderText(tr(LOOKING) if is_asked else "")
        if is_asked:
            self._foresight.ask(self.exporter.name, project, self.options, self.shapes)

    def _show_foreseen(self, found: Foreseen) -> None:
        self._set_losses(found.losses)
        losses = (
            [tr("The mattes would differ in the other program:"), *map(translated, found.losses)]
            if found.losses
            else []
        )
        besides = ["", tr("Besides:")] if found.losses and found.notes else []
        self.notes.setPlaceholderText(tr(NOTHING_LOST))
        self.notes.setPlainText("\n".join([*losses, *besides, *map(translated, found.notes)]))

    def _show_refused(self, sentence: str) -> None:
        self.notes.setPlainText(sentence)

    def _set_losses(self, losses: tuple[str, ...]) -> None:
        self._losses = losses
        self.start.setText(tr(ANYWAY) if losses else tr("Export"))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._look_ahead()

    def hideEvent(self, event: QHideEvent) -> None:
        self._foresight.drop()
        super().hideEvent(event)

    # ---- the export

    def _browse(self) -> None:
        if self._is_folder:
            chosen = questions.choose_folder(self, tr("Export mattes to a folder"), self.path)
        else:
            chosen = questions.choose_export(
                self, tr("Export: {title}", title=tr(self.exporter.title)), self.path, self.exporter.suffix
            )
        if chosen is not None:
            self.target.setText(str(chosen))

    def _start(self) -> None:
        self._foresight.drop()
        self.notes.clear()
        self._format = self.exporter.name
        options = replace(self.options, lossy=bool(self._losses))
        self._number = self._export.start(self.exporter.name, self.path, options, self.shapes)
        self._pull_running()

    @property
    def _is_ours(self) -> bool:
        """Whether an export is under way that was started here."""
        return bool(self._number)

    @property
    def _is_told(self) -> bool:
        """Whether it is this one that the export tells of now."""
        return self._is_ours and self._export.current == self._number

    def _pull_running(self) -> None:
        self.stop.setEnabled(self._is_ours)
        self.bar.setValue(0)
        self._pull_hint()

    def _show_progress(self, fraction: float, _text: str) -> None:
        if self._is_told:
            self.bar.setValue(round(1000 * fraction))

    def _show_notes(self, notes: tuple[str, ...]) -> None:
        if self._is_told:
            self.notes.setPlainText("\n".join(notes))

    def _show_end(self, ending: Ending, sentence: str) -> None:
        if not self._is_told:
            return
        if ending is not Ending.DONE:
            self.notes.setPlainText(sentence)
        self._number = 0
        self._pull_running()
        if self.exporter.name != self._format:  # chosen meanwhile
            self._look_ahead()


def _mark(exporter: Exporter) -> str:
    """What tells the files of a format from those of the first one with its suffix; of that one itself nothing."""
    same = [other.name for other in EXPORTERS.values() if other.suffix == exporter.suffix]
    return "" if exporter.name == same[0] else f"_{exporter.name.removeprefix('nuke-')}"
