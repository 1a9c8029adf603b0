"""Names in Nuke's shapes: ASCII that its grammar of strings and Tcl's lists read alike, and what they were beside it.

The vendor's grammar (NDK developer guide, "Roto serialisation format") puts a string with a space, quotes, a backslash
or a brace in double quotes, the last four kinds behind a backslash (the page prints the code of another character,
which cannot be meant), and knows ASCII alone. A list of Tcl's reads such a string as the same text. Brackets and the
dollar are plain characters in both, but a program that ran a list as a command would run them: they become round ones
and an underscore.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import reduce

from roam_core.interchange.literals import whole
from roam_core.interchange.naming import ascii_name, distinct
from roam_core.roto import Layer
from roam_core.translatable import sentence

KNOB = "roam_names"
"""The knob that holds the true names."""

LAYER_KNOB = "roam_layer"
"""The knob of the last node of a layer that is a matte of its own: what `layer_word` tells of it."""

TOLD = 6
"""Names that a sentence or label lists one by one."""

_HARMLESS = str.maketrans("[]$", "()_")


@dataclass(frozen=True)
class Names:
    """What the shapes and layers of a project are called in Nuke.

    Attributes
    ----------
    by_id : the ASCII name of each item.
    changed : true names by ASCII ones, of those that had to change; these ASCII names are unlike all others.
    """

    by_id: dict[str, str] = field(default_factory=dict)
    changed: dict[str, str] = field(default_factory=dict)

    @classmethod
    def of(cls, root: Layer) -> Names:
        """Names for all that lies in `root`: those that Nuke can hold stay as they are."""
        names = cls()
        items = list(root.items())
        taken = {item.name for item in items if _plain(item.name) == item.name}
        for item in items:
            plain = _plain(item.name)
            if plain != item.name:
                plain = distinct(plain.strip() or "unnamed", taken)
                taken.add(plain)
                names.changed[plain] = whole(item.name)
            names.by_id[item.id] = plain
        return names

    def notes(self) -> Iterator[str]:
        """One sentence, where a name had to change."""
        if self.changed:
            yield (
                sentence(
                    "Nuke's names of shapes are ASCII: {listed}. The true names stand in the node's label "
                    "and come back when ROAM reads the file.",
                    listed=_listed(self.changed),
                )
            )

    def within(self, layer: Layer) -> Names:
        """Those of what lies in a layer."""
        by_id = {item.id: self.by_id[item.id] for item in layer.items()}
        return Names(by_id, {plain: self.changed[plain] for plain in by_id.values() if plain in self.changed})

    @property
    def label(self) -> str:
        """The true names beside the ASCII ones, for a reader of the node."""
        lines = [inert(f"{plain} = {true}") for plain, true in list(self.changed.items())[:TOLD]]
        more = len(self.changed) - TOLD
        return "\n".join([*lines, f"and {more} more"] if more > 0 else lines)

    @property
    def knob(self) -> str:
        """The same for `true_names`: letters, digits and `%=,._-` only."""
        return ",".join(f"{_coded(plain)}={_coded(true)}" for plain, true in self.changed.items())

    def lines(self) -> tuple[list[str], list[str]]:
        """The lines of a node that hold the label, and those of the knob; none where no name had to change."""
        if not self.changed:
            return [], []
        knob = [f' addUserKnob {{1 {KNOB} l "true names" +INVISIBLE}}', f" {KNOB} {self.knob}"]
        return [f" label {knob_text(self.label)}"], knob


def true_names(knob: str) -> dict[str, str]:
    """True names by ASCII ones, as the knob tells them."""
    pairs = (pair.partition("=") for pair in knob.split(","))
    return {_decoded(plain): _decoded(true) for plain, sign, true in pairs if sign}


def layer_word(layer: Layer) -> str:
    """Name and lock of a layer, as letters, digits and `%,._-`."""
    return f"{_coded(layer.name)},{'locked' if layer.locked else 'free'}"


def read_layer_word(word: str) -> tuple[str, bool]:
    """What `layer_word` told: the name, and whether the layer is locked."""
    name, _, lock = word.partition(",")
    return _decoded(name), lock == "locked"


def roto_string(name: str) -> str:
    """An ASCII name as a string of the grammar, which is one word of a Tcl list as well."""
    return name if _BARE.fullmatch(name) else '"' + re.sub(r"""["'\\{}]""", r"\\\g<0>", name) + '"'


_BARE = re.compile(r"[A-Za-z][A-Za-z0-9_.-]*")


def inert(text: str) -> str:
    """Any text as a line of a label, which Nuke evaluates: nothing of it runs."""
    return _CONTROL.sub(" ", whole(text)).translate(_HARMLESS)


_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]")


def knob_text(text: str) -> str:
    """The same, of several lines, as a word of a script."""
    shown = "\n".join(map(inert, text.split("\n")))
    return '"' + re.sub(r'["\\{}]', r"\\\g<0>", shown).replace("\n", "\\n") + '"'


def _plain(name: str) -> str:
    return ascii_name(name).translate(_HARMLESS)


def _coded(text: str) -> str:
    """Any text as letters, digits and `_.-`, everything else as `%` and two hexadecimal digits for each byte."""
    return re.sub(rb"[^A-Za-z0-9_.-]", lambda found: b"%%%02X" % found.group()[0], whole(text).encode()).decode("ascii")


def _decoded(word: str) -> str:
    codes = re.sub(rb"%([0-9A-Fa-f]{2})", lambda found: bytes([int(found.group(1), 16)]), word.encode())
    return codes.decode("utf-8", "replace")


def _listed(changed: dict[str, str]) -> str:
    some = [sentence("{true!r} is called {plain!r}", true=true, plain=plain) for plain, true in changed.items()]
    named = reduce(lambda before, after: sentence("{before}, {after}", before=before, after=after), some[:TOLD])
    more = len(changed) - TOLD
    return sentence("{named}, and {count} more alike", named=named, count=more) if more > 0 else named
