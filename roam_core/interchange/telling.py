"""What is told of many shapes alike is told once, with the names of those that it is so with."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass, field

from roam_core.roto import BlendMode
from roam_core.translatable import Sentence, sentence

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


class Note(str):
    """A sentence on one shape or layer of a file, in English alone.

    Attributes
    ----------
    subject : the name of the shape or layer, as it stands in the sentence.
    """

    __slots__ = ("subject",)
    subject: str

    @classmethod
    def of(cls, text: str, subject: str) -> Note:
        """The sentence `text`, in which the name stands as `subject`."""
        note = cls(text)
        note.subject = subject
        return note


@dataclass
class _Kind:
    """The first note of a kind, its subject, and the subjects of the others."""

    note: str
    subject: str
    others: dict[str, None] = field(default_factory=dict)  # in their order

    def told(self) -> str:
        if not self.others:
            return self.note
        names, more = ", ".join([*self.others][:MOST_NAMES]), len(self.others) - MOST_NAMES
        if more > 0:
            names = sentence("{names} and {count} more", names=names, count=more)
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
    """What a note says, and of whom; a note on none in particular is of a kind of its own."""
    if isinstance(note, Note):
        return note.replace(note.subject, "\0", 1), note.subject
    if not isinstance(note, Sentence) or "name" not in note.values:
        return note, ""
    name = note.values["name"]
    rest = tuple((key, str(value)) for key, value in note.values.items() if key != "name")
    return (note.template, rest), repr(name) if "{name!r}" in note.template else str(name)
