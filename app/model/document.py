"""Document: the current project, its undo stack and its file. The one door for edits."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from roam_core.roto import Project, RotoShape, file
from roam_core.roto.fingerprint import Fingerprint
from roam_core.roto.project import Clip, Layer

from .beginning import Beginning
from .commands import ProjectEdit

PROJECT_SUFFIX = ".roam"
UNDO_BYTES = 256 << 20
"""Bound on what the undo stack holds, where the artist set no other."""
SPARE = 0.75
"""What is left of the bound when the oldest steps go: it is not done again with the very next edit."""


class Document(QObject):
    """Holds one immutable project at a time. Views listen to `changed` and pull what they show.

    Signals
    -------
    changed(ids) : after every edit, undo and redo: the ids of layers and shapes that differ, as a frozenset.
    replaced() : another project was opened or begun; everything may differ.
    path_changed() : the project has another file name, or became saved or unsaved.
    rebased(fate, beginning) : from now on edits build on another file or project, as a `Beginning`; what becomes of
        those before: `saved` or `discarded`.
    forgot() : the oldest undo steps were dropped.
    """

    changed = Signal(object)
    replaced = Signal()
    path_changed = Signal()
    rebased = Signal(str, object)
    forgot = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._project = self._saved = Project()
        self.path: Path | None = None
        self.sitting = 0
        """How often another project was shown: what was begun before is not about this one."""
        self.begun = 0
        """How often another project was opened or begun: one with another clip is the same."""
        self.fingerprint: Fingerprint | None = None
        """Of the file when it was read or saved last; None where there is none."""
        self.undo_stack = QUndoStack(self)
        self.undo_bytes = UNDO_BYTES
        """The most that the undo stack may hold; steps beyond it go, the oldest first."""
        self._held_at_most = 0
        """What the steps hold, or more: they are weighed one by one only where this passes the bound."""
        self._is_quiet = False

    @property
    def project(self) -> Project:
        return self._project

    def apply(self, text: str, project: Project, merge_key: str = "") -> None:
        """Make `project` the current one as an undo step named `text`.

        Steps in a row with the same non-empty `merge_key` are one step for the artist (a tracked run, a held key).
        """
        if project is self._project or project == self._project:
            return
        step = ProjectEdit(self._project, project, text, merge_key, self._show)
        self._held_at_most += step.most_bytes
        self.undo_stack.push(step)
        if self._held_at_most > self.undo_bytes:
            self._forget_oldest()

    def amend(
        self, text: str, change: Callable[[Project], Project], merge_key: str, *, keeps_undone: bool = False
    ) -> None:
        """Make a change part of the undo step with `merge_key`, wherever that lies below later steps.

        So a run in the background stays one step, and what the artist does meanwhile stays theirs, each in its place.
        `change` must not care what those steps did: it is made to the projects between them, too. Where there is no
        such step the change becomes one, named `text`; with `keeps_undone` what is undone can be done again after it.
        """
        stack = self.undo_stack
        steps = [stack.command(index) for index in range(stack.count())]
        own = [i for i in range(stack.index()) if isinstance(s := steps[i], ProjectEdit) and s.merge_key == merge_key]
        if not own and keeps_undone and stack.canRedo():
            self._insert(text, change, merge_key)
            return
        if not own:
            self.apply(text, change(self._project), merge_key)
            return
        once = _once(change)
        for index in range(own[-1], stack.count()):
            step = steps[index]
            assert isinstance(step, ProjectEdit)
            step.change(once, begins_changed=index > own[-1])
        self._show(once(self._project))
        self._forget_oldest()

    def is_undone(self, merge_key: str) -> bool:
        """Whether the step with `merge_key` was undone, and could be done again."""
        stack = self.undo_stack
        undone = (stack.command(index) for index in range(stack.index(), stack.count()))
        return any(isinstance(step, ProjectEdit) and step.merge_key == merge_key for step in undone)

    def open(self, project: Project, path: Path | None, fingerprint: Fingerprint | None = None) -> None:
        """Show another project; the undo stack starts anew."""
        self.begun += 1
        self._replace(project, project, Beginning.on_file(project, path, fingerprint))

    def recover(
        self,
        project: Project,
        path: Path | None,
        fingerprint: Fingerprint | None = None,
        follows: Path | None = None,
    ) -> None:
        """Show a project that no file holds yet, as unsaved work on the file `path`.

        `fingerprint` is that of the file which the work builds on, `follows` the journal that it comes from.
        """
        self.begun += 1
        self._replace(project, Project(), Beginning(project, path, fingerprint, follows=follows))

    def relink(self, clip: Clip) -> None:
        """Give the project, and all that undo and redo lead to, another clip: as unsaved work on the same file."""
        change, stack = _once(lambda project: replace(project, clip=clip)), self.undo_stack
        steps, done = (
            [step.copy() for i in range(stack.count()) if isinstance(step := stack.command(i), ProjectEdit)],
            stack.index(),
        )
        for step in steps:
            step.change(change, begins_changed=True)
        project = change(self._project)
        self._replace(project, Project(), Beginning(project, self.path, self.fingerprint), steps, done)

    def save(self, path: Path) -> None:
        """Write the project; raises `RoamError` when it cannot be written."""
        file.save(self._project, path)
        self.mark_saved(self._project, path, Fingerprint.of(path))

    def mark_saved(self, project: Project, path: Path, fingerprint: Fingerprint | None = None) -> None:
        """Note that `project` lies in the file `path`: it may be an older value, written while the artist went on."""
        self._saved, self.path, self.fingerprint = project, path, fingerprint
        self.rebased.emit("saved", Beginning.on_file(project, path, fingerprint))
        self.path_changed.emit()

    @property
    def is_modified(self) -> bool:
        """True when the file does not hold the current project. Undoing back to the saved value is enough."""
        return self._project is not self._saved

    def _replace(
        self, project: Project, saved: Project, beginning: Beginning, steps: Sequence[ProjectEdit] = (), done: int = 0
    ) -> None:
        """Show a project from which `steps` lead to others, the first `done` of them done."""
        fate = "discarded" if self.is_modified else "saved"
        self.sitting += 1
        self._project, self._saved = project, saved
        self.path, self.fingerprint = beginning.original, beginning.fingerprint
        self._keep_steps(steps, done)
        self._held_at_most = sum(step.most_bytes for step in steps)
        self.rebased.emit(fate, beginning)
        self.replaced.emit()
        self.path_changed.emit()

    def _insert(self, text: str, change: Callable[[Project], Project], merge_key: str) -> None:
        """Make a change the last step that is done, and part of those that are undone."""
        stack, once = self.undo_stack, _once(change)
        steps = [step.copy() for i in range(stack.count()) if isinstance(step := stack.command(i), ProjectEdit)]
        done, after = stack.index(), once(self._project)
        if after == self._project:
            return
        for step in steps[done:]:
            step.change(once, begins_changed=True)
        own = ProjectEdit(self._project, after, text, merge_key, self._show)
        self._held_at_most += own.most_bytes
        self._keep_steps([*steps[:done], own, *steps[done:]], done + 1)
        self._show(after)
        self._forget_oldest()

    def _forget_oldest(self) -> None:
        """Drop the oldest steps where all together hold more than they may; the newest stays in any case."""
        stack = self.undo_stack
        steps = [step for i in range(stack.count()) if isinstance(step := stack.command(i), ProjectEdit)]
        held = [step.held_bytes(is_undone=i >= stack.index()) for i, step in enumerate(steps)]
        self._held_at_most = sum(step.most_bytes for step in steps)
        if (total := sum(held)) <= self.undo_bytes:
            return
        gone = 0
        while gone < stack.index() - 1 and total > SPARE * self.undo_bytes:
            total -= held[gone]
            self._held_at_most -= steps[gone].most_bytes
            gone += 1
        if gone:
            self._keep_steps([step.copy() for step in steps[gone:]], stack.index() - gone)
            self.forgot.emit()

    def _keep_steps(self, steps: Sequence[ProjectEdit], done: int) -> None:
        """Make these the only steps, the first `done` of them done. Qt's stack lets nothing go at its lower end."""
        self._is_quiet = True
        self.undo_stack.clear()
        for step in steps:
            self.undo_stack.push(step)
        self.undo_stack.setIndex(done)
        self._is_quiet = False

    def _show(self, project: Project) -> None:
        if self._is_quiet:
            return
        before, was_modified = self._project, self.is_modified
        self._project = project
        self.changed.emit(changed_ids(before, project))
        if self.is_modified != was_modified:
            self.path_changed.emit()


def _once(change: Callable[[Project], Project]) -> Callable[[Project], Project]:
    """The change, made to each project once: what was one project stays one."""
    made: dict[int, tuple[Project, Project]] = {}

    def once(project: Project) -> Project:
        # The project is kept with its successor: while it lives no other can have its identity.
        if id(project) not in made:
            made[id(project)] = project, change(project)
        return made[id(project)][1]

    return once


def changed_ids(before: Project, after: Project) -> frozenset[str]:
    """The ids of the layers and shapes that are new, gone or different."""
    old, new = (_parts(project) for project in (before, after))
    return frozenset(item_id for item_id in old.keys() | new.keys() if _differs(old.get(item_id), new.get(item_id)))


def _parts(project: Project) -> dict[str, Layer | RotoShape]:
    """Layers as they are, shapes in plate space: one that a layer carries elsewhere has changed, too."""
    layers = {item.id: item for item in (project.root, *project.root.items()) if isinstance(item, Layer)}
    return {**layers, **{shape.id: shape for shape in project.shapes}}


def _differs(a: object, b: object) -> bool:
    if a is b:
        return False
    if isinstance(a, Layer) and isinstance(b, Layer):
        shallow = [tuple(child.id for child in layer.children) for layer in (a, b)]
        return shallow[0] != shallow[1] or _plain(a) != _plain(b)
    return a != b


def _plain(layer: Layer) -> tuple[object, ...]:
    return (layer.name, layer.visible, layer.locked, layer.opacity, layer.invert, layer.blend, layer.transform)
