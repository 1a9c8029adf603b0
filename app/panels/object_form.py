"""The rows of the shape panel that tell what the selected shapes are in their object, and change it."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QWidget

from roam_core.roto import RotoShape
from roam_core.roto.linking import AS_STACKED, links

from .. import style
from ..features.belonging import Belonging
from ..features.verbs.objects import LEVELS, ObjectVerbs
from ..model.document import Document
from ..model.view_state import ViewState, selected_shapes
from ..translation import N_, tr
from ..widgets.controls import ChoiceBox, dense_form, form_label
from ..widgets.fields import MIXED, SwitchBox, shared

BY_OUTLINES, NEW_LINK, APART, OF_LINK = "outlines", "new", "apart", "link:"
"""What can be chosen: left to the outlines, a new link, a link of its own, or a link by its name."""

SOLVE_TIP = N_(
    "What is solved together. By outlines: shapes that overlap or touch are parts, which move by themselves and hang"
    " together; the outlines of one mask or path are one whole; others are objects of their own, however near they lie."
)
CHOICE_WIDTH = 90
"""Least width of how they are solved: the column is narrow, and links' names may be long."""

DEPTH_TIP = N_("What hides what, from this frame on; mattes go by the order in the list")
ATTACHED_TIP = N_("A part hangs by joints on the parts that it overlaps")


class ObjectForm(QWidget):
    """How the selected shapes are solved, what that makes of them, their depth on this frame, and what they hang on."""

    def __init__(
        self, document: Document, view_state: ViewState, belonging: Belonging, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._belonging = document, view_state, belonging
        self._verbs = ObjectVerbs(document, view_state)
        self.solve, self.level = _choice(tr(SOLVE_TIP)), _choice(tr(DEPTH_TIP))
        self.solve.setMinimumWidth(CHOICE_WIDTH)
        self.place = QLabel()
        self.place.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)  # names can be long
        self.attached = SwitchBox(tr("Attached"), tr(ATTACHED_TIP))
        for level, word in ((level, tr(word)) for level, word in LEVELS.items()):
            self.level.addItem(word, level)
        form = dense_form()
        form.addRow(form_label(tr("Solve")), self.solve)
        form.addRow(form_label(tr("Object")), self.place)
        row = QHBoxLayout()
        row.setSpacing(style.MARGIN)
        self.level.setSizeAdjustPolicy(ChoiceBox.SizeAdjustPolicy.AdjustToContents)
        row.addWidget(self.level, 1)
        row.addWidget(self.attached)
        form.addRow(form_label(tr("Depth")), row)
        self.form = form
        self.setLayout(form)
        self.solve.activated.connect(lambda _: self._push_solve(str(self.solve.currentData())))
        self.level.activated.connect(lambda _: self._push_depth(int(self.level.currentData())))
        self.attached.clicked.connect(self._push_attached)
        for signal in (
            document.changed,
            document.replaced,
            view_state.selection_changed,
            view_state.frame_changed,
            belonging.changed,
        ):
            signal.connect(self.pull)
        self.pull()

    # ---- widget to model

    def _push_solve(self, choice: str) -> None:
        verbs = {BY_OUTLINES: self._verbs.unlink, NEW_LINK: self._verbs.link, APART: self._verbs.set_apart}
        if choice in verbs:
            verbs[choice]()
        else:
            self._verbs.link(choice.removeprefix(OF_LINK))
        self.pull()

    def _push_depth(self, level: int) -> None:
        self._verbs.set_depth(level)
        self.pull()

    def _push_attached(self, on: bool) -> None:
        self._verbs.attach(on)
        self.pull()

    # ---- model to widget

    def pull(self, _ids: object = None) -> None:
        """Show the selected shapes as they are on this frame."""
        shapes = selected_shapes(self._document.project, self._view.selection)
        if not shapes:
            return
        self._pull_solve(shapes)
        places = self._belonging.places()
        told = shared(str(places.get(shape.id, "")) for shape in shapes)
        self.place.setText(tr(MIXED) if told is None else told)
        self.place.setToolTip(self.place.text())
        level = shared(shape.depth_at(self._view.frame) for shape in shapes)
        with QSignalBlocker(self.level):
            self.level.setCurrentIndex(-1 if level is None else self.level.findData(level))
        # A file may hold a level that is not among those to choose from.
        self.level.setPlaceholderText(tr(MIXED) if level is None else _level_word(level))
        self.level.setToolTip(f"{tr(DEPTH_TIP)}{_told(shapes)}")
        self.attached.show_value(shared(shape.attached for shape in shapes))
        is_free = any(not self._document.project.is_locked(shape.id) for shape in shapes)
        for control in (self.solve, self.level, self.attached):
            control.setEnabled(is_free)

    def _pull_solve(self, shapes: Sequence[RotoShape]) -> None:
        held = links(self._document.project)
        alone = {link for link, holders in held.items() if len(holders) == 1}
        choices = {BY_OUTLINES: tr("By outlines"), APART: tr("By itself")}
        if len(shapes) > 1:
            choices[NEW_LINK] = tr("As one new object")
        choices |= {f"{OF_LINK}{link}": tr("As one: {link}", link=link) for link in held if link not in alone}
        chosen = shared(_choice_of(shape.link, alone) for shape in shapes)
        with QSignalBlocker(self.solve):
            # Frames of a run come while the list is open: what is chosen in it stays under the hand.
            if choices != {self.solve.itemData(row): self.solve.itemText(row) for row in range(self.solve.count())}:
                self.solve.clear()
                for choice, word in choices.items():
                    self.solve.addItem(word, choice)
            self.solve.setCurrentIndex(-1 if chosen is None else self.solve.findData(chosen))


def _choice(tip: str) -> ChoiceBox:
    box = ChoiceBox(tip)
    box.setPlaceholderText(tr(MIXED))
    return box


def _choice_of(link: str, alone: set[str]) -> str:
    return BY_OUTLINES if not link else APART if link in alone else f"{OF_LINK}{link}"


def _told(shapes: Sequence[RotoShape]) -> str:
    """The changes of depth of one shape, to follow the tip."""
    if len(shapes) != 1 or not shapes[0].depth:
        return ""
    changes = [tr("from {frame} {level}", frame=frame, level=_level_word(level)) for frame, level in shapes[0].depth]
    return tr(".\nNow: {level}, {changes}", level=_level_word(AS_STACKED), changes=", ".join(changes))


def _level_word(level: int) -> str:
    return tr(LEVELS[level]).lower() if level in LEVELS else str(level)
