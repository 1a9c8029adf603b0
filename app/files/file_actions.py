"""The File menu's verbs: which file, and what becomes of unsaved changes, asked of the artist."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QMessageBox, QWidget
from shiboken6 import isValid

from roam_core.errors import RoamError
from roam_core.interchange.registry import SHAPE_SUFFIXES, holds_shapes
from roam_core.roto import Clip
from roam_core.roto.project_lock import Holder
from roam_core.roto.shifting import frames_held

from ..dialogs import questions
from ..dialogs.questions import Contested, Doubted, Unsaved
from ..features.verbs.shifting import follow_numbers
from ..folders import cache_folder
from ..jobs.export import MATTES, Export
from ..jobs.found_clip import FoundClip
from ..jobs.importing import Import
from ..model.document import PROJECT_SUFFIX, Document
from ..model.last_folders import LastFolders, Purpose
from ..model.personal import Personal
from ..model.view_state import ViewState
from ..translation import N_, sentence_of, tr
from ..widgets.asking import ask
from ..widgets.focus import end_typing
from .failed_exports import FailedExports
from .files import Files
from .plate_names import file_stem
from .reading import holds_project

if TYPE_CHECKING:
    from ..dialogs.clip_dialog import ClipDialog
    from ..dialogs.export_dialog import ExportDialog

NOTHING_TO_EXPORT = N_("There is nothing to export yet; open a clip first.")


class FileActions(QObject):
    """Each method asks what must be asked and hands the rest to `Files`, `Export` and `Import`.

    Signals
    -------
    refused_to_open() : the artist does not want to open a project after all.
    leaving() : the project is saved to be left then, or left as it is: nothing may go on changing it.
    """

    refused_to_open = Signal()
    leaving = Signal()

    def __init__(
        self,
        window: QWidget,
        document: Document,
        view_state: ViewState,
        files: Files,
        export: Export,
        importing: Import,
        personal: Personal,
    ) -> None:
        super().__init__(window)
        self._window, self._document, self._view, self._files = window, document, view_state, files
        self._export, self._import, self._personal = export, importing, personal
        self.folders = LastFolders()
        """Where choosers begin."""
        self._after_saving: Callable[[], object] | None = None
        self._wanted: Callable[[], object] | None = None  # the save that is to follow the one that is under way
        self._export_dialog: ExportDialog | None = None
        self._not_saved: QMessageBox | None = None
        files.saved.connect(self._saved)
        export.written.connect(lambda path: self.folders.note(Purpose.EXPORT, path.parent))
        files.not_saved.connect(self._tell_not_saved)
        self._failed_exports = FailedExports(window, export)
        document.replaced.connect(self._disarm)
        files.doubted.connect(self._ask_doubted)
        files.contested.connect(self._ask_contested)
        files.renumbered.connect(self._ask_renumbered)
        files.overtaken.connect(self.leave_project)
        files.looked.connect(self._show_found)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "file.new": self.new,
            "file.open_clip": self.open_clip,
            "file.open_movie": self.open_movie,
            "file.relink_clip": self.relink_clip,
            "file.reload_clip": self._files.reload_plate,
            "file.clip_settings": self.clip_settings,
            "file.open_project": self.open_project,
            "file.save": self.save,
            "file.save_as": self.save_as,
            "file.save_version": self.save_new_version,
            "file.import_shapes": self.import_shapes,
            "file.import_masks": self.import_masks,
            "file.export": self.export,
            "file.export_selected": lambda: self.export(selected=True),
            "file.export_nuke": self.export_nuke,
            "file.export_mattes": self.export_mattes,
        }

    def leave_project(self, then: Callable[[], object]) -> None:
        """Do `then` once nothing is lost by it: at once, after saving, or never.

        A shape that is half drawn counts, and is finished where the artist wants it saved.
        """
        end_typing(self._window)
        if self._files.is_saving:
            self._after_saving = lambda: self.leave_project(then)
            self._view.say(tr("The project is being saved …"))
            return
        if not self._document.is_modified and not self._view.is_in_use:
            then()
            return
        answer = questions.ask_unsaved(self._window, self.title)
        if answer is Unsaved.DISCARD:
            self.leaving.emit()
            then()
        elif answer is Unsaved.SAVE:
            self._view.set_tool("select")
            # What was edited while it was saved is asked about again.
            self._after_saving = lambda: self.leave_project(then)
            self.save()

    def leave_window(self, then: Callable[[], object], *, is_writing: bool) -> None:
        """Do `then`, which closes the window, once nothing is lost by it: of what is being written neither."""
        if not is_writing or questions.ask_stop_writing(self._window):
            self.leave_project(then)

    @property
    def title(self) -> str:
        """The project's name, for titles and questions."""
        return self._document.path.name if self._document.path else tr("untitled")

    def new(self) -> None:
        self.leave_project(self._files.new)

    def open_clip(self) -> None:
        path = questions.choose_clip_folder(self._window, self._start_folder(Purpose.CLIP))
        self._open_asking(self._noted(Purpose.CLIP, path))

    def open_movie(self) -> None:
        path = questions.choose_movie(self._window, self._start_folder(Purpose.CLIP))
        self._open_asking(self._noted(Purpose.CLIP, path))

    def relink_clip(self) -> None:
        """Ask for another version of the plate, to lie below the same shapes."""
        if self._lacks_clip():
            return
        path = questions.choose_plate(self._window, self._start_folder(Purpose.CLIP))
        if path is not None:
            self.folders.note(Purpose.CLIP, path.parent)
            self._files.open_plate(path)

    def clip_settings(self) -> None:
        """Show what holds for the project's clip, where it may be changed."""
        clip = self._document.project.clip
        if clip is None:
            self._view.say(tr("There is no clip yet; open one."))
        elif self._files.lacks_plate:
            self._view.say(tr("The plate of the project is not there: File > Relink clip says where it lies."))
        else:
            self._files.look_at(clip.path, clip.layer, clip)

    def open_project(self) -> None:
        path = questions.choose_project(self._window, self._start_folder(Purpose.PROJECT))
        self._open(self._noted(Purpose.PROJECT, path))

    def open_chosen(self, path: Path) -> None:
        """Open a project or clip that was chosen among those of before."""
        self._open(path)

    def open_dropped(self, paths: Sequence[Path], *, at_once: bool = False) -> None:
        """Open the first of what was dropped on the window; files of shapes of other programs join the project's, all.

        A clip is shown first, with what was found out about it, unless it is to be opened `at_once`.
        """
        path = paths[0]
        if holds_shapes(path):
            for each in filter(holds_shapes, paths):
                self._import.start(each)
        elif at_once:
            self._open(path)
        else:
            self._open_asking(path)

    def save(self) -> None:
        """Save to the project's file; ask for one if it has none."""
        if self._files.is_saving and self._files.version.is_begun:
            self._wait_for_saving(self.save)
        elif self._document.path is None:
            self.save_as()
        else:
            self._write(self._document.path)

    def save_as(self) -> None:
        """Ask where, and save there."""
        own = self._document.path
        chosen = questions.choose_save(self._window, own or self.suggested(PROJECT_SUFFIX, Purpose.PROJECT))
        if chosen is None or not self._may_save_to(path := questions.with_suffix(chosen, PROJECT_SUFFIX), chosen):
            self._disarm()
        else:
            self._write(path)

    def save_new_version(self) -> None:
        """Save under the next version number beside the project's file; ask for a name if it has none."""
        if self._files.is_saving:
            self._wait_for_saving(self.save_new_version)
        elif self._document.path is None:
            self.save_as()
        elif self._files.version.is_unchanged:  # a key that is held, or pressed twice, makes one
            told = tr("{name} is the new version already; nothing changed since it was saved.", name=self.title)
            self._view.say(told)
        else:
            self._files.save_new_version(self._document.path)

    def import_shapes(self) -> None:
        """Ask for a file of shapes, and read it."""
        if self._lacks_clip():
            return
        chosen = questions.choose_shapes(self._window, self._start_folder(Purpose.SHAPES), SHAPE_SUFFIXES)
        if (path := self._noted(Purpose.SHAPES, chosen)) is not None:
            self._import.start(path)

    def import_masks(self) -> None:
        """Ask for a folder of masks, and how near and with how few keys they are to be followed."""
        if self._lacks_clip():
            return
        start = self._start_folder(Purpose.SHAPES)
        chosen = questions.choose_folder(self._window, tr("Import the masks of a folder"), start)
        if (folder := self._noted(Purpose.SHAPES, chosen)) is None:
            return
        from ..dialogs.mask_dialog import MaskDialog

        clip = self._document.project.clip
        dialog = MaskDialog(folder.name, clip.size if clip else None, self._window)
        dialog.finished.connect(dialog.deleteLater)
        ask(dialog, lambda: self._import.start(folder, dialog.options), self._document.replaced)

    def choose_mask(self) -> Path | None:
        """Ask for the picture of a mask."""
        return self._noted(Purpose.MASK, questions.choose_mask(self._window, self._start_folder(Purpose.MASK)))

    def export(self, *, selected: bool = False) -> None:
        """Show the export dialog, for all shapes or those selected; all else in it stays as it was left."""
        # Formats load what the window can begin without.
        from ..dialogs.export_dialog import ExportDialog

        if self._export_dialog is None:
            self._export_dialog = ExportDialog(
                self._document, self._view, self._export, self.suggested, parent=self._window
            )
        self._export_dialog.selected.setChecked(selected)
        self._export_dialog.show()
        self._export_dialog.activateWindow()

    def export_nuke(self) -> None:
        if not self._lacks_clip(tr(NOTHING_TO_EXPORT)):
            self._export_file("nuke", tr("Export to Nuke"))

    def export_mattes(self) -> None:
        if self._lacks_clip(tr(NOTHING_TO_EXPORT)):
            return
        start = self._start_folder(Purpose.EXPORT)
        if (folder := questions.choose_folder(self._window, tr("Export mattes to a folder"), start)) is not None:
            self._export.start(MATTES, folder)

    def suggested(self, suffix: str, purpose: Purpose = Purpose.EXPORT) -> Path:
        """The file that is proposed for what is written of the project."""
        clip = self._document.project.clip
        stem = self._document.path.stem if self._document.path else (file_stem(clip) if clip else "untitled")
        return self._start_folder(purpose) / f"{stem}{suffix}"

    # ---- the rest is private

    def _open_asking(self, path: Path | None) -> None:
        """Open what was chosen; a new clip only after the artist saw what was found."""
        asks = self._personal.preferences.asks_about_clips
        if path is None or holds_project(path) or self._files.lacks_plate or not asks:
            self._open(path)
        else:
            self._files.look_at(path)

    def _show_found(self, found: FoundClip) -> None:
        from ..dialogs.clip_dialog import ClipDialog

        for shown in self._window.findChildren(ClipDialog):
            if shown.isVisible() and shown.found.path == found.path:
                shown.take(found)
                return
        dialog = ClipDialog(found, self._window)
        dialog.chosen.connect(lambda: self._open_found(dialog))
        dialog.layer_wanted.connect(lambda layer: self._files.look_at(found.path, layer, found.held))
        dialog.open()

    def _open_found(self, dialog: ClipDialog) -> None:
        """Open the clip of the dialog, or read the project's, as it is declared there."""
        from roam_core.media import declared

        if dialog.asks_no_more.isChecked():
            self._personal.set_preferences(replace(self._personal.preferences, asks_about_clips=False))
        said = dialog.colour_space, dialog.fps, dialog.pixel_aspect
        path, layer, held = dialog.found.path, dialog.layer, dialog.found.held
        if held is not None:
            if held == self._document.project.clip:
                self._files.read_plate_as(layer, lambda source: declared(source, *said))
            return
        self.leave_project(lambda: self._files.open_clip(path, lambda source: declared(source, *said), layer))

    def _open(self, path: Path | None) -> None:
        """Open a project or a clip; a clip takes the place of the plate that the project looks for in vain."""
        if path is None:
            return
        if self._files.lacks_plate and not holds_project(path):
            self._files.open_plate(path)
        else:
            self.leave_project(lambda: self._files.open(path))

    def _write(self, path: Path) -> None:
        if self._after_saving is not None:
            self.leaving.emit()
        self._files.save(path)

    def _lacks_clip(self, sentence: str = "") -> bool:
        """True, and said, where there is no clip for shapes to come into, or out of: told before anything is asked."""
        if self._document.project.clip is None:
            self._view.say(sentence or tr("Open a clip first: shapes come into its frames and pixels."))
            return True
        return False

    def _export_file(self, format_name: str, title: str) -> None:
        from roam_core.interchange import EXPORTERS

        suffix = EXPORTERS[format_name].suffix
        path = questions.choose_export(self._window, title, self.suggested(suffix), suffix)
        if path is not None:
            self._export.start(format_name, path)

    def _may_save_to(self, path: Path, chosen: Path) -> bool:
        """Whether the project may be written there: not onto the plate; onto what is no project if the artist says so.

        Over another project the file chooser has asked already, if that is what was `chosen` in it.
        """
        from roam_core.interchange.authorship import Kind
        from roam_core.interchange.targets import Sources, obstacles

        found = obstacles([(path, Kind.PROJECT)], Sources.of(self._files.plate), self._document.path)
        try:
            found.refuse_always()
        except RoamError as error:
            self._view.say(sentence_of(error))
            return False
        if found.foreign:
            return questions.ask_overwrite(self._window, found.foreign)
        return path == self._document.path or questions.may_take(self._window, chosen, path)

    def _noted(self, purpose: Purpose, path: Path | None) -> Path | None:
        """What was chosen, if anything was; its folder is where the next chooser of this kind begins."""
        if path is not None:
            self.folders.note(purpose, path.parent)
        return path

    def _saved(self) -> None:
        self._noted(Purpose.PROJECT, self._document.path)
        wanted, self._wanted = self._wanted, None
        if wanted is not None:
            wanted()
        if not self._files.is_saving and (then := self._after_saving) is not None:
            self._after_saving = None
            then()

    def _wait_for_saving(self, wanted: Callable[[], object]) -> None:
        """Save so once what is being saved is: begun now, it would drop that."""
        self._wanted = wanted
        self._view.say(tr("The project is being saved …"))

    def _disarm(self) -> None:
        """What was to be done after saving is not done."""
        self._after_saving = self._wanted = None

    def _tell_not_saved(self, path: Path, sentence: str, again: Callable[[], None]) -> None:
        """Say so where nobody overlooks it, with the ways on; the artist may go on to work first."""
        self._disarm()
        sitting = self._document.sitting
        if self._not_saved is not None and isValid(self._not_saved):
            self._not_saved.reject()
        self._not_saved = box = questions.not_saved_question(self._window, path.name, sentence)

        def go_on() -> None:
            if sitting != self._document.sitting:
                return
            if box.buttonRole(box.clickedButton()) is QMessageBox.ButtonRole.AcceptRole:
                self.save_as()
            else:
                again()

        box.accepted.connect(go_on)
        box.open()

    def _ask_doubted(self, path: Path, doubt: str) -> None:
        answer = questions.ask_doubted(self._window, doubt)
        if answer is Doubted.SAVE:
            self._files.save(path, anyway=True)
        elif answer is Doubted.SAVE_AS:
            self.save_as()
        else:
            self._disarm()

    def _ask_contested(self, path: Path, holder: Holder) -> None:
        answer = questions.ask_contested(self._window, path.name, holder.sentence)
        if answer is Contested.COPY:
            self._files.open_copy(path)
        elif answer is Contested.ANYWAY:
            self._files.open_anyway(path)
        else:
            self._view.say(tr("{name} was not opened.", name=path.name))
            self.refused_to_open.emit()

    def _ask_renumbered(self, before: Clip) -> None:
        """Ask, once the plate is there, whether what stands on frames goes along with their new numbers."""
        if not frames_held(self._document.project):
            return
        sitting, clip = self._document.sitting, self._document.project.require_clip()
        box = questions.renumbered_question(self._window, before.first, clip.first)
        box.accepted.connect(
            lambda: follow_numbers(self._document, self._view, before) if sitting == self._document.sitting else None
        )
        box.open()

    def _start_folder(self, purpose: Purpose) -> Path:
        """Where choosers begin: where the last one of the kind was used, else beside the project, the clip, what was
        opened last, or at home.

        Never in the cache: it may be emptied.
        """
        if (last := self.folders.of(purpose)) is not None:
            return last
        clip = self._document.project.clip
        if self._document.path is not None:
            return self._document.path.parent
        known = [*([clip.path] if clip else []), *(recent.path for recent in self._personal.recent)]
        kept = (path.parent for path in known if not path.is_relative_to(cache_folder()))
        return next(kept, Path.home())
