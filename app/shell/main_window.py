"""The main window: builds the parts and connects them. What they do is theirs."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QKeyEvent
from PySide6.QtWidgets import QMainWindow, QUndoView

from .. import style
from ..actions import menus
from ..actions.actions import Actions
from ..canvas.proposal_bar import ProposalBar
from ..canvas.ripple_frame import RippleFrame
from ..canvas.view import CanvasView
from ..dialogs import questions
from ..features.belonging import Belonging
from ..features.clipboards.nodes import NodeClipboard
from ..features.clipboards.shapes import ShapeClipboard
from ..features.edge_kinds import EdgeKinds
from ..features.history import History
from ..features.messages import MessageLog
from ..features.navigation import Navigation
from ..features.planar_tracking import PlanarTracking
from ..features.playback import Playback
from ..features.proposals import Proposals
from ..features.tracking import Tracking
from ..features.verbs.by_plate import plate_verbs
from ..features.verbs.layers import LayerVerbs
from ..features.verbs.masks import MaskShapes
from ..features.verbs.objects import ObjectVerbs
from ..features.verbs.shapes import ShapeVerbs
from ..features.verbs.shifting import Shifting
from ..features.verbs.solo import SoloVerbs
from ..features.verbs.splines import SplineVerbs
from ..files.file_actions import FileActions
from ..files.files import Files
from ..files.recovering import Recovering
from ..files.reopening import Reopening
from ..files.reviewing import Reviewing
from ..jobs import warm_up
from ..jobs.by_plate.jobs import PlateJobs
from ..jobs.copying import Copying
from ..jobs.decode import PlateReader
from ..jobs.export import Export
from ..jobs.importing import Import
from ..jobs.picture_work import PictureWork
from ..jobs.planar import PlanarTrack
from ..jobs.propagation import Propagation
from ..jobs.review.job import ReviewJob
from ..jobs.runner import Runner
from ..jobs.under_way import UnderWay
from ..journal.journal import Journal
from ..model.document import Document
from ..model.personal import Personal
from ..model.view_state import ViewState
from ..panels.bars.mode_bar import ModeBar
from ..panels.bars.readout import Readout
from ..panels.bars.status import StatusBar
from ..panels.bars.tool_column import ToolColumn
from ..panels.bars.top_bar import TopBar
from ..panels.bars.view_bar import ViewBar
from ..panels.planar import PlanarPanel
from ..panels.properties import PropertiesPanel
from ..panels.review import ReviewPanel
from ..panels.shapes import ShapesPanel
from ..panels.tracker import TrackerPanel
from ..timeline.timeline import Timeline
from ..timeline.transport import Transport
from ..tools.edit.feather import FeatherActions
from ..tools.edit.order_actions import OrderActions
from ..tools.edit.transform_actions import TransformActions
from ..tools.in_hand import ToolInHand
from ..tools.toolbox import TOOLS
from ..translation import tr
from ..widgets.focus import FocusFollowsPointer, end_typing
from ..widgets.panel import Panel
from . import settings
from .accessibility import Accessibility, name_parts
from .context_menus import ContextMenus
from .defects import Defects
from .full_screen import FullScreen, Told
from .laying_out import layout
from .laying_out.panel_column import PanelColumn, PanelParts
from .laying_out.timeline_height import TimelineHeight
from .second_view import second_viewer
from .undo_words import name_steps
from .window_services import WindowServices
from .workspace import Workspace

PANEL_WIDTH = 272
LEAVING_SECONDS = 10.0  # for which threads that read are waited for


class MainWindow(QMainWindow):
    """ROAM's window. `journal_root` is the folder of the journals, `personal` the artist's own settings."""

    def __init__(self, journal_root: Path, personal: Personal | None = None) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose, False)
        self.setAcceptDrops(True)
        self._is_leaving = False
        self._threads = 0  # as many as the libraries think fit
        self.personal = personal or Personal(parent=self)
        self._build_state(journal_root)
        self._build_parts()
        self._lay_out()
        self._connect()
        self._connect_actions()
        self._connect_personal()
        self._pull_title()
        self.canvas.setFocus()

    # ---- building

    def _build_state(self, journal_root: Path) -> None:
        self.document, self.view_state = Document(self), ViewState(self)
        names = "solver", "writer", "exporter", "saver"
        self.solver, self.writer, self.exporter, self.saver = (Runner(name, self) for name in names)
        self.reader = PlateReader(self)
        self.files = Files(self.document, self.view_state, self.reader, self.writer, self.saver, self)
        asks = partial(questions.ask_overwrite, self), partial(questions.ask_lossy, self)
        self.export = Export(self.document, self.exporter, self, *asks)
        self.importing, self.copying = Import(self.document, self.writer, self), Copying(self.writer, self)
        self.journal = Journal(self.document, journal_root, self)
        self.files.saving.connect(self.journal.note_saving)
        solving = self.document, self.view_state, self.solver
        self.propagation = Propagation(*solving, self.reader.engine_parts, self)
        self.proposals = Proposals(self.document, self.view_state, self.propagation, self)
        self.eye = Runner("eye", self)
        self.pictures = PictureWork(self.eye, self, self.reader.full_picture)
        self.belonging = Belonging(self.document, self.view_state, self.eye, self)
        self.edge_kinds = EdgeKinds(self.document, self.view_state, self.reader.engine_parts, self.eye, self)
        self.planar = PlanarTrack(*solving, self.reader.engine_frame, self, self.propagation.make_way)
        self.plate_jobs = PlateJobs.of(self.document, self.solver, self.reader.engine_frame, self)
        self.review_job = ReviewJob(self.document, self.exporter, self.reader.frames_of_this_plate, self, asks[0])
        works = self.files, self.export, self.importing, self.copying, self.propagation, self.planar, self.pictures
        self.under_way = UnderWay(*works, *self.plate_jobs.all, self.review_job, self.reader, parent=self)
        self.playback = Playback(self.view_state, self)
        self.navigation = Navigation(self.document, self.view_state)
        without = self.reader.frames_without_picture
        self.tracking = Tracking(self.document, self.view_state, self.propagation, without)
        self.planar_tracking = PlanarTracking(self.document, self.view_state, self.planar, without)
        self.shape_verbs = ShapeVerbs(self.document, self.view_state)
        self.solo_verbs = SoloVerbs(self.document, self.view_state)
        self.file_actions = FileActions(
            self, self.document, self.view_state, self.files, self.export, self.importing, self.personal
        )

    def _build_parts(self) -> None:
        document, view_state = self.document, self.view_state
        self.canvas = CanvasView(document, view_state, in_hand=ToolInHand(document, view_state, self))
        self.canvas.in_hand.lend(self.pictures)
        FocusFollowsPointer(self.canvas)
        self.actions_by_id = actions = Actions(self, self.canvas, self.personal.keys.keymap)
        self.canvas.proposed = lambda: self.proposals.current
        self.canvas.bones, self.canvas.edges = self.belonging.bones, self.edge_kinds.here
        self.canvas.stage.plate_of = self.reader.plate
        RippleFrame(view_state, self.canvas)
        self.second_viewer = second_viewer(self.canvas, document, view_state, actions, self, self.reader.look_through)
        self.proposal_bar = ProposalBar(self.proposals, actions, self.canvas)
        self.tool_column = ToolColumn(view_state, actions, tuple(TOOLS))
        self.view_bar = ViewBar(document, self.canvas, actions)
        self.shapes = ShapesPanel(document, view_state, actions)
        self.planar_panel = PlanarPanel(document, self.planar_tracking, actions)
        self.tracker = TrackerPanel(document, view_state, self.tracking, actions)
        self.properties = PropertiesPanel(document, view_state, self.belonging)
        self.review = ReviewPanel(document, view_state, actions)
        self.history = QUndoView(document.undo_stack)
        self.history.setMinimumHeight(6 * style.ROW_HEIGHT)
        self.transport = Transport(self.navigation, view_state, self.playback, actions)
        self.timeline = Timeline(
            document, view_state, self.reader.cached_frames, self.reader.frames_without_picture, actions
        )
        self.status = StatusBar(view_state, self.under_way)
        self.status.add(Readout(self.canvas), ModeBar(view_state, actions))
        self.status.follow(document)
        self._build_surroundings(actions)

    def _build_surroundings(self, actions: Actions) -> None:
        """What lies around the work: dialogs, the start page, and what is there for bad days."""
        document, view_state, files, file_actions = self.document, self.view_state, self.files, self.file_actions
        messages = MessageLog(view_state, self.under_way, self)
        self.services = WindowServices(actions, view_state, messages, self.personal, self)
        about = document, view_state, files, file_actions
        self.reopening = Reopening(*about, self.reader, self.personal, actions, self.canvas, self.writer, self)
        self.reviewing = Reviewing(document, view_state, self.canvas.viewing, self.review_job, file_actions, self)
        self.defects = Defects(view_state, self.journal, messages, self)
        self.recovering = Recovering(self.journal, self.writer, files, file_actions, view_state, self)
        self.recovering.asking.connect(self.defects.wait_for)
        self.context_menus = ContextMenus(document, view_state, actions, self)
        for part in (self.canvas, self.shapes.tree):
            part.menu_asked.connect(self.context_menus.open)
        self.setMenuWidget(TopBar(menus.menu_bar(actions, self.reopening.menu), self.view_bar))

    def _lay_out(self) -> None:
        actions = self.actions_by_id
        self.workspace = Workspace(self, actions, self._lay_out_anew)
        second = Panel("second_viewer", tr("Second viewer"), self.second_viewer, (self.second_viewer.mode,))
        viewers = layout.split(Qt.Orientation.Horizontal, self.canvas, second)
        tools, lower = self.tool_column, layout.column(self.transport, self.timeline)
        parts = PanelParts(
            self.shapes, self.tracker, self.planar_panel, self.properties, self.review, self.history,
            self.services.log_panel,
        )  # fmt: skip
        self.panels = PanelColumn(parts, actions, self.workspace)
        self.panel_column = self.panels.area
        upper = layout.split(Qt.Orientation.Horizontal, layout.row(tools, viewers, growing=viewers), self.panel_column)
        self._halves = layout.split(Qt.Orientation.Vertical, upper, lower)
        self.splitters = {"upper": upper, "viewers": viewers}
        self.timeline_height = TimelineHeight(self._halves)
        self.workspace.add(second.name, second.title, second, is_shown_first=False)
        self.workspace.add("timeline", tr("Timeline"), lower)
        curves = self.timeline.curve_panel
        self.workspace.add(curves.name, curves.title, curves, show="view.curves", is_shown_first=False)
        self._lay_out_anew()
        self.setCentralWidget(layout.column(self._halves, self.status))
        named = self.tool_column, self.view_bar, self.panel_column, self.transport, self.timeline, self.status
        self.accessibility = Accessibility(self.document, self.view_state, self.canvas, named, self.playback)
        name_parts(self.timeline, self.history, self.shapes)
        around, panels = (self.menuWidget(), tools, self.status), actions["view.panels"]
        self.told = Told(self.status, actions["window.full_screen"], self.canvas)
        self.full_screen = FullScreen(
            self, actions["window.full_screen"], around, lambda: [*self.workspace.at_home, panels]
        )

    def _lay_out_anew(self) -> None:
        """Give the parts the sizes of a new window."""
        half = self.width() // 2
        self.splitters["viewers"].setSizes([half, half])
        self.splitters["upper"].setSizes([self.width() - PANEL_WIDTH, PANEL_WIDTH])
        self.actions_by_id["view.panels"].setChecked(True)
        self.actions_by_id["view.tall_timeline"].setChecked(False)
        self.timeline_height.forget_drag()

    # ---- connecting

    def _connect(self) -> None:
        view, reader, status = self.view_state, self.reader, self.status
        view.frame_changed.connect(lambda: reader.show(view.frame))
        self.belonging.changed.connect(self.canvas.update)
        self.edge_kinds.changed.connect(self.canvas.update)
        for forget in (self.edge_kinds.forget, self.propagation.forget, self.planar.drop):
            reader.plate_changed.connect(forget)
        reader.plate_changed.connect(lambda: reader.show(view.frame))
        seeing = self.canvas.set_image, self.second_viewer.set_image, self.playback.note_picture, self.pictures.show
        for see in (*seeing, view.note_picture):
            reader.picture.connect(see)
        reader.plate_changed.connect(self.pictures.clear)
        reader.refused.connect(view.say_of_picture)
        reader.cache_changed.connect(self.timeline.ruler.update)
        reader.cache_changed.connect(lambda: status.show_memory(*reader.memory()))
        self.propagation.finished.connect(lambda ending, text: status.tell_end(ending, self.proposals.told(text)))
        self.under_way.changed.connect(self._pull_running)
        self.file_actions.leaving.connect(self.under_way.drop_edits)
        self.planar.doubted.connect(view.say)
        self.files.watching.doubted.connect(view.say)
        self.document.replaced.connect(self._pull_clip)
        self.document.path_changed.connect(self._pull_title)
        name_steps(self.document, self.canvas.in_hand, self.history, self.actions_by_id)

    def _connect_actions(self) -> None:
        actions = self.actions_by_id
        actions.connect_all(self._handlers())
        actions["track.stop"].setEnabled(False)
        actions["view.tall_timeline"].toggled.connect(self.timeline_height.make_tall)

    def _connect_personal(self) -> None:
        personal, say = self.personal, self.view_state.say
        personal.keys_changed.connect(self._pull_keys)
        personal.preferences_changed.connect(self._pull_preferences)
        for told_by in (personal.refused, self.journal.refused, self.journal.restored):
            told_by.connect(say)
        self._pull_keys()
        self._pull_preferences()
        if personal.trouble:
            say(personal.trouble)

    def _handlers(self) -> dict[str, Callable[[], object]]:
        """What each action calls; tools and switches are connected by their own widgets."""
        nodes = NodeClipboard(self.document, self.view_state, self.copying, self.importing)
        clipboard = ShapeClipboard(self.document, self.view_state, self, nodes.paste)
        history = History(self.document, self.view_state, self.canvas.in_hand.take_back)
        handlers: dict[str, Callable[[], object]] = {
            "file.quit": self.close,
            "track.stop": self.under_way.stop_by_key,
        }
        for part in (
            self.canvas,
            self.panels,
            FeatherActions(self.document, self.view_state),
            LayerVerbs(self.document, self.view_state),
            ObjectVerbs(self.document, self.view_state),
            self.planar_tracking,
            TransformActions(self.document, self.view_state, self),
            OrderActions(self.document, self.view_state),
            self.services,
            self.workspace,
            self.accessibility,
            self.reopening,
            self.reviewing,
            self.recovering,
            self.defects,
            self.file_actions,
            history,
            clipboard,
            nodes,
            self.shape_verbs,
            self.solo_verbs,
            MaskShapes(self.file_actions.choose_mask, self.document, self.view_state, self.pictures),
            SplineVerbs(self.document, self.view_state),
            *plate_verbs(self, self.document, self.view_state, self.plate_jobs),
            Shifting(self, self.document, self.view_state),
            self.tracking,
            self.proposals,
            self.navigation,
            self.playback,
        ):
            handlers |= part.handlers()
        handlers |= {name: self._with_typed(call) for name, call in handlers.items() if name.startswith("file.")}
        return self.timeline.taking_over(handlers)

    def _with_typed(self, handler: Callable[[], object]) -> Callable[[], object]:
        """The same, once what is being typed is taken: it belongs to what is saved and exported."""

        def act() -> None:
            end_typing(self)
            handler()

        return act

    # ---- settings

    def restore_settings(self, path: Path) -> None:
        """Give the window what was kept of the last one; a damaged file is set aside, and told."""
        if trouble := settings.restore(self._kept(), path, self.personal.preferences.config):
            self.view_state.say(trouble)

    def keep_settings(self, path: Path) -> None:
        """Write what the next window is to begin with."""
        self.full_screen.leave()
        settings.keep(self._kept(), path)

    def _kept(self) -> settings.Kept:
        return settings.Kept(
            frame=self,
            splitters=self.splitters,
            switches={name: self.actions_by_id[name] for name in settings.SWITCHES},
            panels=self.workspace.panels,
            mode=self.tracker.mode,
            tables={
                "proposals": self.proposals,
                "dials": self.tracker,
                "viewing": self.canvas.viewing,
                "timeline": self.timeline_height,
                "second_viewer": self.second_viewer,
                "layout": self.workspace,
                "folders": self.file_actions.folders,
            },
        )

    # ---- pulling

    def _pull_keys(self) -> None:
        """Other keys hold: whoever has them or tells them."""
        actions = self.actions_by_id
        actions.set_keymap(self.personal.keys.keymap)
        self.status.show_stop_keys(actions.keys_of("track.stop"))
        self.view_state.set_keymap(actions.keymap)

    def _pull_preferences(self) -> None:
        held = self.personal.preferences
        self.reader.set_cache_limit(held.cache_bytes)
        self.files.backups, self.propagation.processes = held.backups, held.processes
        self.document.undo_bytes = held.undo_megabytes << 20
        if held.threads != self._threads:
            self._threads = held.threads
            warm_up.use_threads(self.writer, held.threads)

    def _pull_title(self) -> None:
        self.setWindowTitle(f"{self.file_actions.title}[*] – ROAM")
        self.setWindowModified(self.document.is_modified)

    def _pull_clip(self) -> None:
        clip = self.document.project.clip
        self.playback.pause()
        self.playback.fps = clip.fps if clip is not None else 24.0
        self.timeline_height.make_room(self.timeline.wanted_rows)

    def _pull_running(self) -> None:
        self.actions_by_id["track.stop"].setEnabled(self.under_way.is_stopped_by_key)
        self.canvas.set_waiting(self.files.is_opening, self.files.lacks_plate)
        self.second_viewer.set_waiting(self.files.is_opening, self.files.lacks_plate)

    # ---- events of the window

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        paths = [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]
        if paths:
            event.acceptProposedAction()
            alt = bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
            self.file_actions.open_dropped(paths, at_once=alt)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc that nothing else had a use for pauses what plays, else it leaves the full screen."""
        if event.key() == Qt.Key.Key_Escape and (self.view_state.is_playing or self.full_screen.is_on):
            (self.playback.pause if self.view_state.is_playing else self.full_screen.leave)()
        else:
            event.ignore()

    def closeEvent(self, event: QCloseEvent) -> None:
        if self._is_leaving:
            self._shut_down()
            event.accept()
        else:
            event.ignore()
            is_writing = self.export.is_writing or self.review_job.is_writing
            self.file_actions.leave_window(self._leave, is_writing=is_writing)

    def leave_unasked(self) -> None:
        """Close without a question, because the desktop or the terminal says so; unsaved work waits for recovery."""
        end_typing(self)
        self.view_state.set_tool("select")  # what is half drawn is finished
        self.journal.leave_for_recovery()
        self._leave()

    def _leave(self) -> None:
        """Close for good. Later, because Qt lets no window close while it is being asked to."""
        self._is_leaving = True
        QTimer.singleShot(0, self, self.close)

    def _shut_down(self) -> None:
        self.playback.pause()
        self.under_way.drop_edits()
        self.hide()  # what is read may lie on a disk that does not answer: nobody looks at that
        for each in (reading := (self.solver, self.eye, self.reader, self.writer)):
            each.close(0.0)  # they end beside one another
        for part in (self.reopening, self.exporter, self.saver, self.files.claim, self.journal):
            part.close()
        until = time.monotonic() + LEAVING_SECONDS
        for each in reading:
            each.close(max(0.0, until - time.monotonic()))
