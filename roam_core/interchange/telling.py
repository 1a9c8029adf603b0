"""What is told of many shapes alike is told once, with the names of those that it is so with."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass, field

from roam_core.roto import BlendMode
from roam_core.translatable import Sentence, enumerated, sentence

MODE_WORDS = {
    BlendMode.ADD: sentence("add"),
    BlendMode.PLUS: sentence("plus"),
    BlendMode.SUBTRACT: sentence("subtract"),
    BlendMode.INTERSECT: sentence("intersect"),
    BlendMode.DIFFERENCE: sentence("difference"),
    BlendMode.MAX: sentence("max"),
}
"""How a sentence calls the modes: by the words of files and of the command line, in a window by its own."""

MOST_NAMES = 6
"""Of shapes or layers that a sentence is true of besides the first; more are counted."""


@dataclass
class _Kind:
    """The first note of a kind, its subject, and the subjects of the others."""

    note: str
    subject: str
    others: dict[str, None] = field(default_factory=dict)  # in their order

    def told(self) -> str:
        if not self.others:
            return self.note
        names = enumerated([*self.others], MOST_NAMES)
        return sentence("{note} So it is with {names}.", note=self.note, names=names)


def gathered(notes: Iterable[str]) -> tuple[str, ...]:
    """The notes in their order; those that differ in the name of their shape or layer alone are one."""
    kinds: dict[Hashable, _Kind] = {}
    for note in notes:
        kind, subject = _told_apart(note)
        found = kinds.setdefault(kind, _Kind(note, subject))
        if subject != found.subject:
            found.others[subject] = None
    return tuple(kind.told() for kind in kinds.values())


def _told_apart(note: str) -> tuple[Hashable, str]:
    """What a note says, and of whom: its `name`, or that in its `subject`; one on none is of a kind of its own."""
    if not isinstance(note, Sentence):
        return note, ""
    holder = note.values.get("subject")
    said = note if "name" in note.values or not isinstance(holder, Sentence) else holder
    if "name" not in said.values:
        return note, ""
    name = said.values["name"]
    rest = tuple((key, str(value)) for key, value in note.values.items() if key not in ("name", "subject"))
    subject = repr(name) if "{name!r}" in said.template else name if isinstance(name, str) else str(name)
    return (note.template, said.template, rest), subject
