"""The stamps of projects that are looked at now, each made once for all who ask what of them is stale."""

from __future__ import annotations

from weakref import ref

from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Project

AT_ONE_TIME = 2
"""Of how many projects the stamps are kept: of the one before an edit, and of the one after it."""

_known: list[tuple[ref[Project], Stamps]] = []
"""Those that were asked about last, the last one first; one that nobody holds any more goes."""


def stamps_of(project: Project) -> Stamps:
    """The stamps of all shapes of a project; for the window's thread, or the only one that there is."""
    for held, stamps in _known:
        if held() is project:
            return stamps
    made = ref(project, _forget), Stamps.of(project.shapes, project.clip)
    _known[:] = [made, *_known[: AT_ONE_TIME - 1]]
    return made[1]


def _forget(gone: ref[Project]) -> None:
    _known[:] = [each for each in _known if each[0] is not gone]
