"""The main window: builds the parts and connects them. What they do is theirs."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QMainWindow, QScrollArea, QSplitter, QUndoView, QVBoxLayout, QWidget

from app import dialogs, menus, style
from app.actions import Actions
from app.belonging import Belonging
from app.canvas.proposal_bar import ProposalBar
from app.canvas.ripple_frame import RippleFrame
from app.canvas.view import CanvasView
from app.clipboard import ShapeClipboard
from app.defects import Defects
from app.desk import Desk
from app.document import Document
from app.edge_kinds import EdgeKinds
from app.file_actions import FileActions
from app.files import Files
from app.focus import FocusFollowsPointer
from app.history import History
from app.jobs.copying import Copying
from app.jobs.decode import PlateReader
from app.jobs.export import Export
from app.jobs.importing import Import
from app.jobs.picture_work import PictureWork
from app.jobs.planar import PlanarTrack
from app.jobs.propagation import Propagation
from app.jobs.runner import Runner
from app.jobs.under_way import UnderWay
from app.journal.journal import Journal
from app.layer_verbs import LayerVerbs
from app.mask_shapes import MaskShapes
from app.navigation import Navigation
from app.node_clipboard import NodeClipboard
from app.object_verbs import ObjectVerbs
from app.panels.controls import tool_button
from app.panels.mode_bar import ModeBar
from app.panels.panel import Panel
from app.panels.planar import PlanarPanel
from app.panels.properties import PropertiesPanel
from app.panels.readout import Readout
from app.panels.shapes import ShapesPanel
from app.panels.status import StatusBar
from app.panels.tool_column import ToolColumn
from app.panels.tracker import TrackerPanel
from app.panels.view_bar import ViewBar
from app.personal import Personal
from app.planar_tracking import PlanarTracking
from app.playback import Playback
from app.proposals import Proposals
from app.recovering import Recovering
from app.reopening import Reopening
from app.shape_verbs import ShapeVerbs
from app.spline_verbs import SplineVerbs
from app.timeline.timeline import Timeline
from app.timeline.transport import Transport
from app.tools import TOOLS
from app.tools.feather import FeatherActions
from app.tools.transform_actions import TransformActions
from app.tracking import Tracking
from app.view_state import ViewState

PANEL_WIDTH = 272
TIMELINE_HEIGHT = 200


class MainWindow(QMainWindow):
    """ROAM's window. `journal_root` is the folder of the journals, `personal` the artist's own settings."""

    def __init__(self, journal_root: Path, personal: Personal | None = None) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose, False)
        self.setAcceptDrops(True)
        self.resize(1500, 940)
        self._is_leaving = False
        self.personal = personal or Personal(parent=self)
        self._build_state(journal_root)
        self._build_parts()
        self._lay_out()
        self._connect()
        self._connect_actions()
        self._pull_title()
        self.canvas.setFocus()

    # ---- building

    def _build_state(self, journal_root: Path) -> None:
        self.document, self.view_state = Document(self), ViewState(self)
        self.solver, self.writer = Runner("solver", self), Runner("writer", self)
        self.saver = Runner("saver", self)
        self.reader = PlateReader(self)
        self.files = Files(self.document, self.view_state, self.reader, self.writer, self.saver, self)
        asks = partial(dialogs.ask_overwrite, self), partial(dialogs.ask_lossy, self)
        self.export = Export(self.document, self.writer, self, *asks)
        self.importing, self.copying = Import(self.document, self.writer, self), Copying(self.writer, self)
        self.journal = Journal(self.document, journal_root, self)
        self.propagation = Propagation(self.document, self.view_state, self.solver, self.reader.engine_frame, self)
        self.proposals = Proposals(self.document, self.view_state, self.propagation, self)
        self.eye = Runner("eye", self)
        self.pictures = PictureWork(self.eye, self)
        self.belonging = Belonging(self.document, self.view_state, self.eye, self)
        self.edge_kinds = EdgeKinds(self.document, self.view_state, self.reader.engine_frame, self.eye, self)
        self.planar = PlanarTrack(self.document, self.view_state, self.solver, self.reader.engine_frame, self)
        works = self.files, self.export, self.importing, self.copying, self.propagation, self.planar, self.pictures
        self.under_way = UnderWay(*works, parent=self)
        self.playback = Playback(self.view_state, self)
        self.navigation = Navigation(self.document, self.view_state)
        self.tracking = Tracking(self.document, self.view_state, self.propagation)
        self.planar_tracking = PlanarTracking(self.document, self.view_state, self.planar)
        self.shape_verbs = ShapeVerbs(self.document, self.view_state)
        self._journal_root = journal_root
        self.file_actions = FileActions(
            self, self.document, self.view_state, self.files, self.export, self.importing, self.personal
        )

    def _build_parts(self) -> None:
        document, view_state = self.document, self.view_state
        self.canvas = CanvasView(document, view_state)
        self.canvas.lend(self.pictures)
        FocusFollowsPointer(self.canvas)
        self.actions_by_id = actions = Actions(self, self.canvas, self.personal.keys.keymap)
        self.canvas.proposed = lambda: self.proposals.current
        self.canvas.bones, self.canvas.edges = self.belonging.bones, self.edge_kinds.here
        self.canvas.stage.plate_of = self.reader.plate
        RippleFrame(view_state, self.canvas)
        self.proposal_bar = ProposalBar(self.proposals, actions, self.canvas)
        self.tool_column = ToolColumn(view_state, actions, tuple(TOOLS))
        self.view_bar = ViewBar(document, self.canvas, actions)
        self.shapes = ShapesPanel(document, view_state)
        self.planar_panel = PlanarPanel(self.planar_tracking, actions)
        self.tracker = TrackerPanel(document, view_state, self.tracking, actions)
        self.properties = PropertiesPanel(document, view_state, self.belonging)
        self.history = QUndoView(document.undo_stack)
        self.history.setEmptyLabel("As opened")
        self.history.setMinimumHeight(6 * style.ROW_HEIGHT)
        self.transport = Transport(self.navigation, view_state, self.playback, actions)
        self.timeline = Timeline(document, view_state, self.reader.cached_frames, self._missing_frames, actions)
        self.status = StatusBar(view_state, self.under_way)
        self.status.add(Readout(self.canvas))
        self.status.add(ModeBar(view_state, actions))
        self.desk, self.reopening = Desk(self, self.personal), Reopening(self)
        self.defects = Defects(self)
        self.recovering = Recovering(self, self._journal_root, self.writer)
        self.setMenuWidget(_top_row(menus.menu_bar(actions, self.reopening.menu), self.view_bar))

    def _lay_out(self) -> None:
        self.panel_column = self._panel_column()
        self._upper = QSplitter(Qt.Orientation.Horizontal)
        picture = QWidget()
        _fill(QHBoxLayout(picture), self.tool_column, self.canvas)
        for part, stretch in ((picture, 1), (self.panel_column, 0)):
            self._upper.addWidget(part)
            self._upper.setStretchFactor(self._upper.indexOf(part), stretch)
        lower = QWidget()
        _fill(QVBoxLayout(lower), self.transport, self.timeline)
        self._halves = QSplitter(Qt.Orientation.Vertical)
        for half, stretch in ((self._upper, 1), (lower, 0)):
            self._halves.addWidget(half)
            self._halves.setStretchFactor(self._halves.indexOf(half), stretch)
        for splitter in (self._upper, self._halves):
            splitter.setChildrenCollapsible(False)
            splitter.setHandleWidth(3)
        self.splitters = {"upper": self._upper, "halves": self._halves}
        self._upper.setSizes([self.width() - PANEL_WIDTH, PANEL_WIDTH])
        self._halves.setSizes([self.height() - TIMELINE_HEIGHT, TIMELINE_HEIGHT])
        whole = QWidget()
        _fill(QVBoxLayout(whole), self._halves, self.status)
        self.setCentralWidget(whole)

    def _panel_column(self) -> QScrollArea:
        actions = self.actions_by_id
        shape_tools = tuple(tool_button(actions, name) for name in ("shape.group", "shape.duplicate", "shape.delete"))
        key_tools = tuple(tool_button(actions, name) for name in ("key.set", "key.delete"))
        self.history_panel = Panel("History", self.history)
        self.history_panel.setVisible(False)
        column = QWidget()
        column.setObjectName("panelColumn")
        column.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        box = QVBoxLayout(column)
        shapes = Panel("Shapes", self.shapes, shape_tools)
        tracks = Panel("Track", self.tracker), Panel("Planar track", self.planar_panel)
        _fill(box, shapes, *tracks, Panel("Shape", self.properties, key_tools), self.history_panel)
        box.addWidget(self.desk.log_panel)
        box.setStretchFactor(shapes, 1)
        scroll = QScrollArea()  # for small screens: nothing is squeezed, what does not fit is scrolled to
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(column)
        scroll.setMinimumWidth(240)
        return scroll

    # ---- connecting

    def _connect(self) -> None:
        view, reader, status = self.view_state, self.reader, self.status
        view.frame_changed.connect(lambda: reader.show(view.frame))
        self.belonging.changed.connect(self.canvas.update)
        self.edge_kinds.changed.connect(self.canvas.update)
        reader.plate_changed.connect(self.edge_kinds.forget)
        reader.plate_changed.connect(lambda: reader.show(view.frame))
        reader.picture.connect(self.canvas.set_image)
        reader.picture.connect(self.playback.note_picture)
        reader.picture.connect(self.pictures.show)
        reader.plate_changed.connect(self.pictures.clear)
        reader.refused.connect(view.say)
        reader.cache_changed.connect(self.timeline.ruler.update)
        reader.cache_changed.connect(lambda: status.show_memory(*reader.memory()))
        self.propagation.finished.connect(lambda _, sentence: view.say(self.proposals.told(sentence)))
        self.under_way.changed.connect(self._pull_running)
        self.document.replaced.connect(self._pull_clip)
        self.document.path_changed.connect(self._pull_title)
        self.document.forgot.connect(lambda: self.history.setEmptyLabel("Earlier steps were dropped"))
        self.document.replaced.connect(lambda: self.history.setEmptyLabel("As opened"))
        undo = self.document.undo_stack
        undo.canUndoChanged.connect(self.actions_by_id["edit.undo"].setEnabled)
        undo.canRedoChanged.connect(self.actions_by_id["edit.redo"].setEnabled)
        undo.undoTextChanged.connect(lambda text: self.actions_by_id["edit.undo"].setText(f"Undo {text}".rstrip()))
        undo.redoTextChanged.connect(lambda text: self.actions_by_id["edit.redo"].setText(f"Redo {text}".rstrip()))

    def _connect_actions(self) -> None:
        actions = self.actions_by_id
        actions.connect_all(self._handlers())
        for name in ("edit.undo", "edit.redo", "track.stop"):
            actions[name].setEnabled(False)
        actions["view.panels"].setChecked(True)
        for name, switch in (
            ("edit.history", self.history_panel.setVisible),
            ("view.panels", self.panel_column.setVisible),
            ("view.tall_timeline", self._set_tall_timeline),
        ):
            actions[name].toggled.connect(switch)

    def _handlers(self) -> dict[str, Callable[[], object]]:
        """What each action calls; tools and switches are connected by their own widgets."""
        nodes = NodeClipboard(self.document, self.view_state, self.copying, self.importing)
        clipboard = ShapeClipboard(self.document, self.view_state, self, nodes.paste)
        history = History(self.document, self.view_state)
        files, tracking, time, playback = self.file_actions, self.tracking, self.navigation, self.playback
        handlers: dict[str, Callable[[], object]] = {
            "file.quit": self.close,
            "shape.delete": self._delete_in_list,
            "track.stop": self.under_way.stop,
            "view.fit_time": self.timeline.axis.fit,
        }
        for part in (
            self.canvas,
            FeatherActions(self.document, self.view_state),
            LayerVerbs(self.document, self.view_state),
            ObjectVerbs(self.document, self.view_state),
            self.planar_tracking,
            TransformActions(self.document, self.view_state, self),
            self.desk,
            self.reopening,
            self.recovering,
            self.defects,
            files,
            history,
            clipboard,
            nodes,
            self.shape_verbs,
            MaskShapes(self, self.document, self.view_state, self.pictures),
            SplineVerbs(self.document, self.view_state),
            tracking,
            self.proposals,
            time,
            playback,
        ):
            handlers |= part.handlers()
        return handlers | self.timeline.handlers() | self.timeline.verbs.taking_over(handlers)

    # ---- pulling

    def _pull_title(self) -> None:
        self.setWindowTitle(f"{self.file_actions.title}[*] – ROAM")
        self.setWindowModified(self.document.is_modified)

    def _pull_clip(self) -> None:
        clip = self.document.project.clip
        self.playback.pause()
        self.playback.fps = clip.fps if clip is not None else 24.0

    def _missing_frames(self) -> tuple[int, ...]:
        return () if self.reader.source is None else self.reader.source.missing

    def _pull_running(self) -> None:
        self.actions_by_id["track.stop"].setEnabled(self.under_way.is_any)
        self.canvas.set_waiting(self.files.is_opening)

    def _set_tall_timeline(self, tall: bool) -> None:
        height = self._halves.height()
        lower = height // 2 if tall else TIMELINE_HEIGHT
        self._halves.setSizes([height - lower, lower])

    def _delete_in_list(self) -> None:
        self.shapes.tree.delete_selected()

    # ---- events of the window

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        paths = [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]
        if paths:
            event.acceptProposedAction()
            alt = bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
            self.file_actions.open_dropped(paths[0], at_once=alt)

    def closeEvent(self, event: QCloseEvent) -> None:
        if self._is_leaving:
            self._shut_down()
            event.accept()
        else:
            event.ignore()
            self.file_actions.leave_project(self._leave)

    def leave_unasked(self) -> None:
        """Close without a question, because the desktop or the terminal says so; unsaved work waits for recovery."""
        self.journal.leave_for_recovery()
        self._leave()

    def _leave(self) -> None:
        """Close for good. Later, because Qt lets no window close while it is being asked to."""
        self._is_leaving = True
        QTimer.singleShot(0, self, self.close)

    def _shut_down(self) -> None:
        self.playback.pause()
        self.propagation.drop()
        self.planar.drop()
        for part in (self.solver, self.eye, self.reader, self.writer, self.saver, self.files.claim, self.journal):
            part.close()


def _top_row(menu_bar: QWidget, view_bar: QWidget) -> QWidget:
    row = QWidget()
    box = QHBoxLayout(row)
    _fill(box, menu_bar, view_bar)
    box.setStretchFactor(menu_bar, 1)
    return row


def _fill(box: QHBoxLayout | QVBoxLayout, *parts: QWidget) -> None:
    box.setContentsMargins(0, 0, 0, 0)
    box.setSpacing(0)
    for part in parts:
        box.addWidget(part)
