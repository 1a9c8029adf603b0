"""The few questions that need a decision, and the file choosers."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from enum import Enum
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from ..translation import N_, tr, translated

MOVIES = N_("Movies (*.mov *.mp4 *.avi *.mkv *.m4v *.mxf *.webm *.mpg *.mpeg *.gif);;All files (*)")
MOST_LOSSES = 6
"""How many sentences a question shows at once."""
KEYMAPS = N_("Keymaps (*.json)")
MASKS = N_("Mask pictures (*.png *.tif *.tiff *.jpg *.jpeg *.exr);;All files (*)")
PROJECTS = N_("ROAM projects (*.roam)")
EARLIER = N_("Backups of ROAM projects (*.roam.*)")


class Unsaved(Enum):
    """What to do with unsaved changes."""

    SAVE = "save"
    DISCARD = "discard"
    CANCEL = "cancel"


def ask_unsaved(parent: QWidget, name: str) -> Unsaved:
    """Ask what shall become of unsaved changes."""
    box = QMessageBox(parent)
    box.setWindowTitle("ROAM")
    box.setText(tr("Save the changes to {name}?", name=name))
    box.setInformativeText(tr("They are lost if you do not."))
    button = QMessageBox.StandardButton
    box.setStandardButtons(button.Save | button.Discard | button.Cancel)
    box.setDefaultButton(button.Save)
    answers = {button.Save: Unsaved.SAVE, button.Discard: Unsaved.DISCARD}
    return answers.get(button(box.exec()), Unsaved.CANCEL)


class Contested(Enum):
    """What to do with a project that somebody else has open."""

    COPY = "copy"
    ANYWAY = "anyway"
    CANCEL = "cancel"


def ask_contested(parent: QWidget, name: str, who: str) -> Contested:
    """Ask how to open a project that is open elsewhere."""
    answers = {tr("Open a copy"): Contested.COPY, tr("Open anyway"): Contested.ANYWAY}
    text = tr("{name} is {who}.", name=name, who=translated(who))
    weak = tr("If both save, the later one wins. A copy is a project of its own, without a file until you save it.")
    return answers.get(_ask(parent, text, weak, tuple(answers)), Contested.CANCEL)


class Doubted(Enum):
    """What to do with a file that is not as it was left."""

    SAVE = "save"
    SAVE_AS = "save as"
    CANCEL = "cancel"


def ask_doubted(parent: QWidget, doubt: str) -> Doubted:
    """Ask whether to save over a file that somebody else changed or has open."""
    answers = {tr("Save as…"): Doubted.SAVE_AS, tr("Save anyway"): Doubted.SAVE}
    weak = tr("If you save anyway, what is in the file now stays beside it as a backup.")
    return answers.get(_ask(parent, doubt, weak, tuple(answers)), Doubted.CANCEL)


def not_saved_question(parent: QWidget, name: str, sentence: str) -> QMessageBox:
    """That a project could not be saved, why, and the ways on: accepted by Save as (which accepts) and Try again."""
    remedy = tr(
        "Your work is still here. Save it elsewhere; or make room there, or see to the permissions, and try again."
    )
    return _failed(parent, tr("{name} is not saved.", name=name), f"{sentence}\n\n{remedy}", tr("Save as…"))


def not_exported_question(parent: QWidget, name: str, sentence: str) -> QMessageBox:
    """That an export failed, why, and the ways on: accepted by Export elsewhere (which accepts) and Try again."""
    remedy = tr("Your work is unharmed. Export elsewhere, or see to what stands in the way and try again.")
    text = tr("{name} is not exported.", name=name)
    return _failed(parent, text, f"{sentence}\n\n{remedy}", tr("Export elsewhere…"))


def _failed(parent: QWidget, text: str, weak: str, elsewhere: str) -> QMessageBox:
    """A question that waits for nobody, with the button `elsewhere`, Try again and Later."""
    box = QMessageBox(QMessageBox.Icon.Warning, "ROAM", text, parent=parent)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setInformativeText(weak)
    box.setDefaultButton(box.addButton(elsewhere, QMessageBox.ButtonRole.AcceptRole))
    box.addButton(tr("Try again"), QMessageBox.ButtonRole.YesRole)
    box.addButton(tr("Later"), QMessageBox.ButtonRole.RejectRole)
    return box


def _ask(parent: QWidget, text: str, weak: str, choices: Sequence[str]) -> str:
    """Ask with a button for each choice, the first one ready to be pressed, and Cancel; gives the one pressed."""
    box = QMessageBox(parent)
    box.setWindowTitle("ROAM")
    box.setText(text)
    box.setInformativeText(weak)
    buttons = [box.addButton(choice, QMessageBox.ButtonRole.ActionRole) for choice in choices]
    box.addButton(QMessageBox.StandardButton.Cancel)
    box.setDefaultButton(buttons[0])
    box.exec()
    pressed = box.clickedButton()
    return "" if pressed is None else pressed.text()


def ask_overwrite(parent: QWidget, paths: Sequence[Path]) -> bool:
    """Ask before files are written over that ROAM did not make; all of them can be looked at."""
    others = len(paths) - 1
    name = paths[0].name
    several = tr("Write over {name} and %n other file(s)?", "", others, name=name)
    text = several if others else tr("Write over {name}?", name=name)
    weak = tr("ROAM did not make what is there in {folder}. It would be lost.", folder=paths[0].parent)
    return _may_write_over(parent, text, weak, "\n".join(str(path) for path in paths))


def ask_replace(parent: QWidget, path: Path) -> bool:
    """Ask before a file is replaced that the file chooser did not ask about: the suffix of its name was added since."""
    added = tr(
        "There is a file of that name in {folder}, now that {suffix} is added to it. It would be lost.",
        folder=path.parent,
        suffix=path.suffix,
    )
    return _may_write_over(parent, tr("Write over {name}?", name=path.name), added)


def _may_write_over(parent: QWidget, text: str, weak: str, details: str = "") -> bool:
    box = QMessageBox(parent)
    box.setWindowTitle("ROAM")
    box.setText(text)
    box.setInformativeText(weak)
    box.setDetailedText(details)
    overwrite = box.addButton(tr("Write over"), QMessageBox.ButtonRole.DestructiveRole)
    keep = box.addButton(QMessageBox.StandardButton.Cancel)
    box.setDefaultButton(keep)
    box.setEscapeButton(keep)
    box.exec()
    return box.clickedButton() is overwrite


def ask_stop_writing(parent: QWidget) -> bool:
    """Ask before the window closes over an export that goes on."""
    box = QMessageBox(parent)
    box.setWindowTitle("ROAM")
    box.setText(tr("Stop the export and close?"))
    box.setInformativeText(
        tr("Something is still being written. Files that are finished stay; the rest is not written.")
    )
    stop = box.addButton(tr("Stop it and close"), QMessageBox.ButtonRole.DestructiveRole)
    keep = box.addButton(tr("Keep it running"), QMessageBox.ButtonRole.RejectRole)
    box.setDefaultButton(keep)
    box.setEscapeButton(keep)
    box.exec()
    return box.clickedButton() is stop


def renumbered_question(parent: QWidget, before: int, now: int) -> QMessageBox:
    """Whether keys go along with a plate that begins on frame `now` instead of `before`: accepted where they do."""
    box = QMessageBox(parent)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setWindowTitle("ROAM")
    box.setText(tr("Shift keys and notes with the new numbers?"))
    box.setInformativeText(
        tr(
            "The plate shows the same pictures, numbered from {now} now, not from {before}. Tracked frames stay up to "
            "date if you shift them now; with Keys > Shift in time later they do not.",
            now=now,
            before=before,
        )
    )
    by = tr("Shift by {number}", number=f"{now - before:+}")
    box.setDefaultButton(box.addButton(by, QMessageBox.ButtonRole.AcceptRole))
    box.addButton(tr("Leave them"), QMessageBox.ButtonRole.RejectRole)
    return box


def ask_lossy(parent: QWidget, losses: Sequence[str]) -> bool:
    """Ask before an export whose mattes would differ in the other program; what differs is named."""
    box = QMessageBox(parent)
    box.setWindowTitle("ROAM")
    box.setText(tr("Export, although the mattes would differ in the other program?"))
    box.setInformativeText("\n".join(map(translated, losses[:MOST_LOSSES])))
    if len(losses) > MOST_LOSSES:
        box.setDetailedText("\n".join(map(translated, losses)))
    anyway = box.addButton(tr("Export anyway"), QMessageBox.ButtonRole.AcceptRole)
    stay = box.addButton(QMessageBox.StandardButton.Cancel)
    box.setDefaultButton(stay)
    box.setEscapeButton(stay)
    box.exec()
    return box.clickedButton() is anyway


def choose_clip_folder(parent: QWidget, start: Path) -> Path | None:
    return _path(QFileDialog.getExistingDirectory(parent, tr("Open clip: the folder of its frames"), str(start)))


def choose_movie(parent: QWidget, start: Path) -> Path | None:
    return _path(QFileDialog.getOpenFileName(parent, tr("Open movie"), str(start), tr(MOVIES))[0])


def choose_plate(parent: QWidget, start: Path) -> Path | None:
    """A frame of another version of the plate, or a movie."""
    title = tr("Relink clip: a frame of the plate, or a movie")
    return _path(QFileDialog.getOpenFileName(parent, title, str(start))[0])


def choose_project(parent: QWidget, start: Path) -> Path | None:
    return _path(
        QFileDialog.getOpenFileName(parent, tr("Open project"), str(start), f"{tr(PROJECTS)};;{tr(EARLIER)}")[0]
    )


def choose_save(parent: QWidget, start: Path) -> Path | None:
    """Where to save the project, as it was named: the suffix may be left out."""
    return _path(QFileDialog.getSaveFileName(parent, tr("Save project"), str(start), tr(PROJECTS))[0])


def choose_export(
    parent: QWidget, title: str, start: Path, suffix: str, others: Collection[str] = frozenset()
) -> Path | None:
    """Where to export to; the suffix is added to a name that has neither it nor one of the `others`."""
    chosen = _path(QFileDialog.getSaveFileName(parent, title, str(start), f"*{suffix}")[0])
    if chosen is None:
        return None
    path = with_suffix(chosen, suffix, others)
    return path if may_take(parent, chosen, path) else None


def with_suffix(path: Path, suffix: str, others: Collection[str] = frozenset()) -> Path:
    """The path with `suffix` added, unless it has that or one of the `others`: any other dot belongs to the name."""
    return path if path.suffix.lower() in {suffix, *others} else Path(f"{path}{suffix}")


def may_take(parent: QWidget, chosen: Path, path: Path) -> bool:
    """Whether `path` may be written, for which the artist named `chosen`: about that the file chooser asked already."""
    return path == chosen or not is_file(path) or ask_replace(parent, path)


def is_file(path: Path) -> bool:
    """Whether there is a file; none can have a name that is too long."""
    try:
        return path.is_file()
    except OSError:
        return False


def choose_shapes(parent: QWidget, start: Path, suffixes: Sequence[str]) -> Path | None:
    """A file of shapes: of another suffix, or none, it may be one, too."""
    kinds = tr("Shapes ({kinds});;All files (*)", kinds=" ".join(f"*{suffix}" for suffix in suffixes))
    return _path(QFileDialog.getOpenFileName(parent, tr("Import shapes"), str(start), kinds)[0])


def choose_mask(parent: QWidget, start: Path) -> Path | None:
    """The picture of a mask of one frame."""
    title = tr("Shape from the mask of this frame")
    return _path(QFileDialog.getOpenFileName(parent, title, str(start), tr(MASKS))[0])


def choose_keymap(parent: QWidget) -> Path | None:
    """A keymap that was exported."""
    return _path(QFileDialog.getOpenFileName(parent, tr("Import keys"), str(Path.home()), tr(KEYMAPS))[0])


def choose_folder(parent: QWidget, title: str, start: Path) -> Path | None:
    return _path(QFileDialog.getExistingDirectory(parent, title, str(start)))


def _path(chosen: str) -> Path | None:
    return Path(chosen) if chosen else None
