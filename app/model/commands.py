"""The only undo class: a step from one immutable project to another."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QUndoCommand

from roam_core.roto import Project

from .holding import held_only_by


class ProjectEdit(QUndoCommand):
    """Replaces `before` by `after`; undo goes back. Steps with the same `merge_key` in a row become one."""

    def __init__(
        self, before: Project, after: Project, text: str, merge_key: str, show: Callable[[Project], None]
    ) -> None:
        super().__init__(text)
        self._before, self._after, self._merge_key, self._show = before, after, merge_key, show
        self._weighed: dict[bool, tuple[Project, Project, int]] = {}

    def redo(self) -> None:
        self._show(self._after)

    def undo(self) -> None:
        self._show(self._before)

    @property
    def merge_key(self) -> str:
        return self._merge_key

    def change(self, change: Callable[[Project], Project], *, begins_changed: bool) -> None:
        """Make a later change part of this step; `begins_changed` where a step before it has made it already."""
        if begins_changed:
            self._before = change(self._before)
        self._after = change(self._after)

    def copy(self) -> ProjectEdit:
        """The same step, for another place."""
        return ProjectEdit(self._before, self._after, self.text(), self._merge_key, self._show)

    def held_bytes(self, *, is_undone: bool) -> int:
        """Bytes of what only this step keeps: of a done step what it replaced, of an undone one what it would bring."""
        held, other = (self._after, self._before) if is_undone else (self._before, self._after)
        known = self._weighed.get(is_undone)
        if known is None or known[0] is not held or known[1] is not other:
            known = self._weighed[is_undone] = held, other, held_only_by(held, other)
        return known[2]

    @property
    def most_bytes(self) -> int:
        """The most that this step keeps, done or undone."""
        return max(self.held_bytes(is_undone=is_undone) for is_undone in (False, True))

    def id(self) -> int:
        return 1 if self._merge_key else -1

    def mergeWith(self, other: QUndoCommand) -> bool:
        if not isinstance(other, ProjectEdit) or other._merge_key != self._merge_key:
            return False
        self._after = other._after
        return True
