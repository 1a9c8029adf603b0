"""The review dialog: a movie, pictures or a contact sheet; of which frames, how they look, and where they go."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QLabel,
    QLineEdit,
    QProgressBar,
    QPushButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from roam_core.errors import RoamError
from roam_core.review.frames import HINT, chosen_frames
from roam_core.review.look import SCALES, Burn, Ground, ReviewLook, ReviewView
from roam_core.review.movie import ENCODERS, SPEEDS
from roam_core.review.sheet import MOST_ACROSS, MOST_DOWN, SheetLayout
from roam_core.review.writing import OTHER_SUFFIXES, PNG, Output, ReviewRequest, output_of

from .. import style
from ..jobs.review.job import ReviewJob
from ..jobs.runner import Ending
from ..model.document import Document
from ..model.view_state import ViewState
from ..model.viewing import ViewMode
from ..translation import N_, sentence_of, tr
from ..widgets.controls import dense_form, form_label, measure_field, number_field, side_by_side, weak_label
from . import questions
from .frame_range import FrameRange

OUTPUTS = {Output.MOVIE: N_("Movie"), Output.PICTURES: N_("Pictures (PNG)"), Output.SHEET: N_("Contact sheet")}
VIEWS = {ReviewView.OVERLAY: N_("Outlines on the plate"), ReviewView.CUTOUT: N_("Cut-out")}
GROUNDS = {Ground.GREY: N_("Grey"), Ground.CHECKER: N_("Checkerboard"), Ground.BLACK: N_("Black")}
BURNS = {Burn.FRAME: N_("Frame number"), Burn.NOTE: N_("Note"), Burn.CONFIDENCE: N_("Confidence")}
WHICH = {
    "all": N_("all"),
    "x10": "x10",
    "keys": N_("keys"),
    "notes": N_("notes"),
    "doubtful": N_("doubtful"),
    "boil": N_("boil"),
}
"""Frames by what they are called on the command line, and what the artist reads."""
SUFFIXES = {Output.MOVIE: ".mp4", Output.PICTURES: "", Output.SHEET: ".png"}
KNOWN = frozenset({*ENCODERS, *OTHER_SUFFIXES, PNG})
"""Suffixes that say what a file is; what follows another dot belongs to the name."""
TITLES = {Output.MOVIE: N_("Movie"), Output.PICTURES: N_("Pictures"), Output.SHEET: N_("Contact sheet")}


class ReviewDialog(QDialog):
    """Stays open beside the work, which runs on the writer's thread and tells here what it made.

    `suggested(suffix)` gives the file that is proposed.
    """

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        writing: ReviewJob,
        suggested: Callable[[str], Path],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._writing, self._suggested = document, view_state, writing, suggested
        self._is_ours = False
        self.setWindowTitle(tr("Review"))
        self.resize(560, 360)
        self._build()
        self._lay_out()
        self._connect()
        self._pull_project()

    def show_for(self, output: Output, mode: ViewMode) -> None:
        """Open for a kind of output; a cut-out is proposed where the viewer shows one."""
        self.output.setCurrentIndex(self.output.findData(output.value))
        view = ReviewView.CUTOUT if mode is ViewMode.CUTOUT else ReviewView.OVERLAY
        self.view.setCurrentIndex(self.view.findData(view.value))
        self._pull_hint()
        self.show()
        self.activateWindow()

    # ---- building

    def _build(self) -> None:
        self.output, self.view, self.ground = _choice(OUTPUTS), _choice(VIEWS), _choice(GROUNDS)
        self.burns = {burn: QCheckBox(tr(title)) for burn, title in BURNS.items()}
        for burn in ReviewLook().burns:
            self.burns[burn].setChecked(True)
        self.which = QComboBox()
        self.which.setEditable(True)
        self.which.addItems([tr(word) for word in WHICH.values()])
        self.which.setToolTip(tr(HINT))
        self.frames = FrameRange(self._view, tr("The first frame"), tr("The last frame"))
        least, most = (100.0 * scale for scale in SCALES)
        self.scale = measure_field(tr(" %"), 100.0, least, most, 25.0, tr("Size of the pictures"))
        self.fps = measure_field(tr(" fps"), 24.0, *SPEEDS, 1.0, tr("Frames a second of the movie"))
        self.columns = _number(SheetLayout.columns, MOST_ACROSS, tr("Pictures beside each other on a page"))
        self.rows = _number(SheetLayout.rows, MOST_DOWN, tr("Rows of pictures on a page"))
        self.target, self.browse = QLineEdit(), QPushButton(tr("Browse…"))
        self.hint = weak_label("")
        self.hint.setWordWrap(True)
        self.bar = QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.start, self.stop, self.leave = QPushButton(tr("Write")), QPushButton(tr("Stop")), QPushButton(tr("Close"))
        self.start.setDefault(True)
        self.stop.setEnabled(False)

    def _lay_out(self) -> None:
        form = dense_form()
        form.addRow(form_label(tr("Write")), self.output)
        form.addRow(form_label(tr("Show")), side_by_side(self.view, weak_label(tr("on")), self.ground, None))
        form.addRow(form_label(tr("On it")), side_by_side(*self.burns.values(), None))
        form.addRow(form_label(tr("Frames")), side_by_side(self.which, None))
        form.addRow(
            form_label(tr("Range")),
            side_by_side(self.frames.first, QLabel(tr("to")), self.frames.last, self.frames.in_out, None),
        )
        form.addRow(form_label(tr("Size")), side_by_side(self.scale, weak_label(tr("of the plate")), None))
        form.addRow(form_label(tr("Frame rate")), side_by_side(self.fps, None))
        form.addRow(
            form_label(tr("Page")),
            side_by_side(self.columns, weak_label(tr("by")), self.rows, weak_label(tr("pictures")), None),
        )
        form.addRow(form_label(tr("To", "where it is written")), side_by_side(self.target, self.browse))
        form.addRow(form_label(""), self.hint)
        column = QVBoxLayout(self)
        column.setSpacing(style.MARGIN)
        column.addLayout(form)
        column.addStretch(1)
        column.addLayout(side_by_side(self.bar, self.stop, self.start, self.leave))

    def _connect(self) -> None:
        self.output.currentIndexChanged.connect(lambda _: self._pull_output())
        self.view.currentIndexChanged.connect(lambda _: self._pull_hint())
        self.which.currentTextChanged.connect(lambda _: self._pull_hint())
        for field in (self.frames.first, self.frames.last, self.columns, self.rows):
            field.valueChanged.connect(lambda _: self._pull_hint())
        self.scale.valueChanged.connect(lambda _: self._pull_hint())
        self.target.textChanged.connect(lambda _: self._pull_hint())
        self.browse.clicked.connect(self._browse)
        self.start.clicked.connect(self._start)
        self.stop.clicked.connect(self._writing.stop)
        self.leave.clicked.connect(self.close)
        self._document.replaced.connect(self._pull_project)
        self._document.changed.connect(lambda _: self._pull_hint() if self.isVisible() else None)
        self._writing.progress.connect(self._show_progress)
        self._writing.finished.connect(self._show_end)

    # ---- what is chosen

    @property
    def chosen_output(self) -> Output:
        return Output(self.output.currentData())

    @property
    def which_words(self) -> str:
        """Which frames, in the words of the command line; those of the window's language are understood, too."""
        meant = {tr(shown).casefold(): word for word, shown in WHICH.items()}
        parts = (part.strip() for part in self.which.currentText().split(","))
        return ",".join(meant.get(part.casefold(), part) for part in parts)

    @property
    def path(self) -> Path:
        """Where it goes; a name alone lies beside the suggested file, a missing suffix is added."""
        path = self._suggested("").parent / Path(self.target.text().strip()).expanduser()
        suffix = SUFFIXES[self.chosen_output]
        return questions.with_suffix(path, suffix, KNOWN) if suffix else path

    def request(self) -> ReviewRequest:
        """What is asked for as it stands in the fields.

        Raises `RoamError` where that makes no sense.
        """
        project, output = self._document.project, self.chosen_output
        if project.clip is None:
            raise RoamError(tr("There is nothing to show yet; open a clip first."))
        if not self.target.text().strip():
            raise RoamError(tr("Say where to write it."))
        if output_of(self.path, is_sheet=output is Output.SHEET) is not output:
            raise RoamError(tr("A movie ends in {suffixes}; pictures go to a folder.", suffixes=", ".join(ENCODERS)))
        return ReviewRequest(
            project,
            chosen_frames(project, self.which_words, self.frames.chosen),
            output,
            self.path,
            ReviewLook(
                ReviewView(self.view.currentData()),
                Ground(self.ground.currentData()),
                frozenset(burn for burn, box in self.burns.items() if box.isChecked()),
                self.scale.value() / 100.0,
            ),
            SheetLayout(self.columns.value(), self.rows.value()),
            self.fps.value(),
        )

    # ---- pulling

    def _pull_project(self) -> None:
        """Another project: its frames, its speed, and a name for what is written of it."""
        clip = self._document.project.clip
        self.frames.pull(clip)
        self.fps.setValue(clip.fps if clip is not None else 24.0)
        self.target.clear()
        self._pull_output()

    def _pull_output(self) -> None:
        output = self.chosen_output
        own = Path(self.target.text().strip()) if self.target.text().strip() else self._suggested("_review")
        bare = own.with_suffix("") if own.suffix.lower() in KNOWN else own
        self.target.setText(f"{bare}{SUFFIXES[output]}")
        self.setWindowTitle(tr(TITLES[output]))
        self.fps.setEnabled(output is Output.MOVIE)
        is_sheet = output is Output.SHEET
        for page_field in (self.columns, self.rows):
            page_field.setEnabled(is_sheet)
        self.scale.setEnabled(not is_sheet)
        for box in self.burns.values():  # a sheet says all of it under its pictures
            box.setEnabled(not is_sheet)
        if self.which_words in ("all", "x10"):
            self.which.setCurrentText(tr(WHICH["x10" if is_sheet else "all"]))
        self._pull_hint()

    def _pull_hint(self) -> None:
        """What would be written, or why nothing can be; while something is written that is told instead."""
        if self._is_ours:
            self.start.setEnabled(False)
            return
        self.ground.setEnabled(self.view.currentData() == ReviewView.CUTOUT)
        try:
            request = self.request()
        except RoamError as error:
            self.hint.setText(sentence_of(error))
            self.start.setEnabled(False)
            return
        count, (width, height) = len(request.frames), request.size
        pages = len(request.layout.pages(request.frames))
        said = tr("%n frame(s)", "", count)
        if request.output is Output.SHEET:
            said = tr("{frames} on {pages}", frames=said, pages=tr("%n page(s)", "", pages))
        else:
            said = tr("{frames}, {width} × {height}", frames=said, width=width, height=height)
        self.hint.setText(said)
        self.start.setEnabled(True)

    # ---- the work

    def _browse(self) -> None:
        output = self.chosen_output
        if output is Output.PICTURES:
            found = questions.choose_folder(self, tr("Pictures to a folder"), self.path)
        else:
            found = questions.choose_export(self, tr(TITLES[output]), self.path, SUFFIXES[output], KNOWN)
        if found is not None:
            self.target.setText(str(found))

    def _start(self) -> None:
        try:
            request = self.request()
        except RoamError as error:  # the project changed in between
            self.hint.setText(sentence_of(error))
            return
        self._is_ours = True
        self._pull_running()
        self._writing.start(request)

    def _pull_running(self) -> None:
        self.stop.setEnabled(self._is_ours)
        self.bar.setValue(0)
        self._pull_hint()

    def _show_progress(self, fraction: float, text: str) -> None:
        if self._is_ours and self._writing.is_told_of_writing:
            self.bar.setValue(round(1000 * fraction))
            self.hint.setText(text)

    def _show_end(self, _ending: Ending, sentence: str) -> None:
        if self._is_ours and self._writing.is_told_of_writing:
            self._is_ours = False
            self._pull_running()
            self.hint.setText(sentence)


def _choice(titles: dict[Output, str] | dict[ReviewView, str] | dict[Ground, str]) -> QComboBox:
    box = QComboBox()
    for value, title in titles.items():
        box.addItem(tr(title), value.value)
    return box


def _number(value: int, most: int, tip: str) -> QSpinBox:
    field = number_field(tip)
    field.setRange(1, most)
    field.setValue(value)
    field.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    return field
