"""The start page: what an empty window offers - the demo, opening, and the projects of before with their pictures."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QImage, QPixmap
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from .. import style
from ..actions.actions import Actions
from ..jobs.thumbnails import RecentEntry, Thumbnails, empty_picture
from ..model.document import Document
from ..model.personal import Personal
from ..translation import N_, moment, tr
from ..widgets.controls import weak_label
from .files import Files

OFFERS = ("file.open_demo", "file.open_clip", "file.open_movie", "file.open_project")
PICTURE = QSize(176, 99)
CARD = QSize(PICTURE.width() + 20, PICTURE.height() + 52)
DROP = N_("Or drop a folder of images, a movie or a project anywhere in this window.")
_PATH = Qt.ItemDataRole.UserRole


class StartPage(QWidget):
    """Lies over the viewer as long as the project is empty, from the moment that `begin` is called.

    Signals
    -------
    chosen(path) : a recent project or clip is to be opened.
    """

    chosen = Signal(object)

    def __init__(
        self,
        viewer: QWidget,
        document: Document,
        files: Files,
        actions: Actions,
        personal: Personal,
        thumbnails: Thumbnails,
    ) -> None:
        super().__init__(viewer)
        self._document, self._files, self._actions = document, files, actions
        self._personal, self._thumbnails = personal, thumbnails
        self._has_begun = False
        self.setObjectName("startPage")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setCursor(Qt.CursorShape.ArrowCursor)
        self.recent = QListWidget()
        self._build_recent()
        self._lay_out()
        self.hide()
        viewer.installEventFilter(self)
        for signal in (document.replaced, document.changed, files.progress, files.finished):
            signal.connect(self.pull)
        personal.recent_changed.connect(self._look)
        thumbnails.seen.connect(self._show)

    def begin(self) -> None:
        """Appear now, and whenever the project is empty."""
        self._has_begun = True
        self.pull()

    def pull(self, *_news: object) -> None:
        """Be there where the project is empty and nothing is being opened."""
        project = self._document.project
        is_wanted = self._has_begun and project.clip is None and not project.shapes and not self._files.is_opening
        if is_wanted and self.isHidden():
            self._look()
            self._fill_viewer()
        self.setVisible(is_wanted)

    # ---- building

    def _build_recent(self) -> None:
        self.recent.setViewMode(QListWidget.ViewMode.IconMode)
        self.recent.setIconSize(PICTURE)
        self.recent.setGridSize(CARD)
        self.recent.setMovement(QListWidget.Movement.Static)
        self.recent.setResizeMode(QListWidget.ResizeMode.Adjust)
        self.recent.setWordWrap(False)
        self.recent.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.recent.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.recent.itemActivated.connect(self._choose)
        self.recent.itemClicked.connect(self._choose)
        forget = self.recent.addAction(tr("Take off this list"))
        forget.triggered.connect(self._forget)

    def _lay_out(self) -> None:
        name = QLabel("ROAM")
        name.setObjectName("heading")
        offers = QVBoxLayout()
        offers.setSpacing(style.MARGIN)
        offers.addWidget(name)
        offers.addWidget(weak_label(tr("Curves carried through a shot")))
        offers.addSpacing(style.MARGIN)
        for action_id in OFFERS:
            offers.addWidget(_button(self._actions, action_id))
        offers.addStretch(1)
        self._recent_title = weak_label(tr("Opened lately"))
        self.recent.setAccessibleName(self._recent_title.text())
        right = QVBoxLayout()
        right.addWidget(self._recent_title)
        right.addWidget(self.recent, 1)
        self._block = QWidget()
        upper = QHBoxLayout(self._block)
        upper.setContentsMargins(0, 0, 0, 0)
        upper.setSpacing(4 * style.MARGIN)
        upper.addLayout(offers)
        upper.addLayout(right, 1)
        column = QVBoxLayout(self)
        column.setContentsMargins(*(4 * style.MARGIN,) * 4)
        column.setSpacing(2 * style.MARGIN)
        column.addWidget(self._block, 1)
        drop = weak_label(tr(DROP))
        drop.setAlignment(Qt.AlignmentFlag.AlignCenter)
        column.addWidget(drop)
        self._place(False)

    # ---- pulling

    def _look(self) -> None:
        self._thumbnails.look(self._personal.recent)

    def _show(self, entries: list[RecentEntry]) -> None:
        self.recent.clear()
        for entry in entries:
            self.recent.addItem(_card(entry))
        self._place(bool(entries))

    def _place(self, has_recent: bool) -> None:
        """Offers and recent projects fill the page; offers alone stand in its middle."""
        for widget in (self._recent_title, self.recent):
            widget.setVisible(has_recent)
        middle = Qt.AlignmentFlag.AlignCenter
        layout = self.layout()
        assert layout is not None
        layout.setAlignment(self._block, Qt.AlignmentFlag(0) if has_recent else middle)

    def _fill_viewer(self) -> None:
        if (viewer := self.parentWidget()) is not None:
            self.setGeometry(viewer.rect())

    def _choose(self, item: QListWidgetItem) -> None:
        # What was not there a moment ago may be there now; if not, opening says why.
        self.chosen.emit(item.data(_PATH))

    def _forget(self) -> None:
        if (item := self.recent.currentItem()) is not None:
            self._personal.forget_recent(item.data(_PATH))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() is QEvent.Type.Resize:
            self._fill_viewer()
        return False


def _button(actions: Actions, action_id: str) -> QPushButton:
    """A wide button for an action; its keys stand in the tooltip."""
    action = actions[action_id]
    button = QPushButton(action.text())
    button.setFixedWidth(180)
    button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    button.setToolTip(action.toolTip())
    action.changed.connect(lambda: button.setToolTip(action.toolTip()))
    button.clicked.connect(action.trigger)
    return button


def _card(entry: RecentEntry) -> QListWidgetItem:
    """Picture, name and day; dim where it is gone."""
    path = entry.recent.path
    day = moment(entry.recent.when)
    item = QListWidgetItem(_icon(entry.picture), f"{path.name}\n{day if entry.is_there else tr('not there any more')}")
    item.setData(_PATH, path)
    item.setToolTip(str(path))
    item.setTextAlignment(Qt.AlignmentFlag.AlignHCenter)
    if not entry.is_there:
        item.setForeground(QColor(style.DISABLED))
    return item


def _icon(picture: QImage | None) -> QIcon:
    """The picture, or an empty frame of its size."""
    return QIcon(empty_picture(PICTURE) if picture is None else QPixmap.fromImage(picture))
