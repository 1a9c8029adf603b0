"""How frames are named: the number in a file's name, patterns such as `plate.%04d.exr`, files that form a sequence."""

from __future__ import annotations

import os
import re
import unicodedata
from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.system_errors import reason_of
from roam_core.translatable import sentence

WIDEST_RANGE = 1_000_000
"""Files whose numbers lie further apart are numbered by something else (a date, a time code) than by frame."""

# The last group of digits. A minus sign counts only after a separator: `a.-3` is frame -3, `shot-3` is frame 3.
# Ten digits and more are a date or a serial number, never a frame (and would not fit a frame's 32 bits in the window).
_LAST_NUMBER = re.compile(
    r"(?P<prefix>.*?)(?<![0-9])(?P<number>(?:(?<![^._\s-])-)?[0-9]{1,9})(?P<suffix>[^0-9]*)", re.DOTALL
)
_PERCENT = re.compile(r"%0?(?P<width>[0-9]*)d")
_DIGITS = re.compile(r"#+|@+")
# As Houdini writes it, After Effects and file dialogs, and a shell.
_OF_OTHERS = re.compile(
    r"\$F(?:(?P<width>[1-9])|(?![A-Za-z]))|\$\{F(?P<braced>[1-9]?)\}|\[(?P<first>[0-9]+)-[0-9]+\]|\*"
)
_GROUP = re.compile(r"(?<![0-9])[0-9]{1,9}(?![0-9])")
_INTEGER = re.compile(r"-?[0-9]{1,9}")


@dataclass(frozen=True)
class NamePattern:
    """A file name with a place for the frame number.

    Attributes
    ----------
    prefix, suffix : what stands before and after the number; the suffix ends in the extension.
    width : the least number of digits, filled with zeros; 0 where any padding will do.
    """

    prefix: str
    width: int
    suffix: str

    def __str__(self) -> str:
        return f"{self.prefix}{f'%0{self.width}d' if self.width else '%d'}{self.suffix}"

    def name(self, frame: int) -> str:
        """The file name of a frame."""
        return f"{self.prefix}{'-' if frame < 0 else ''}{abs(frame):0{max(self.width, 1)}d}{self.suffix}"

    def number_of(self, name: str) -> int | None:
        """The frame number that `name` bears, or None where it does not follow the pattern."""
        if len(name) <= len(self.prefix) + len(self.suffix):
            return None
        if not (name.startswith(self.prefix) and name.endswith(self.suffix)):
            return None
        text = name[len(self.prefix) : len(name) - len(self.suffix)]
        return int(text) if _INTEGER.fullmatch(text) and _is_padded(text, self.width) else None

    def number_in_any_letters(self, name: str) -> int | None:
        """As `number_of`, whether the extension of `name` is in capitals or not."""
        ending = Path(self.suffix).suffix or self.suffix
        there = name[len(name) - len(ending) :]
        is_alike = ending.startswith(".") and there.lower() == ending.lower()
        return self.number_of(name[: len(name) - len(ending)] + ending if is_alike else name)


@dataclass(frozen=True)
class FileSequence:
    """The files of one sequence in one folder: `names[frame]` is a file name; a lone un-numbered file is frame 1."""

    folder: Path
    names: Mapping[int, str]
    pattern: NamePattern | None
    clash: tuple[str, str] | None = None

    @property
    def path(self) -> Path:
        """The pattern, or the one file, as a path that opens this sequence again."""
        return self.folder / (str(self.pattern) if self.pattern else self.names[1])

    @property
    def first_file(self) -> Path:
        """The file of the first frame."""
        return self.folder / self.names[min(self.names)]

    @property
    def label(self) -> str:
        """The sequence in a few words, for messages."""
        if self.pattern is None:
            return sentence("{name} (one image)", name=self.path.name)
        held = {"name": self.path.name, "first": min(self.names), "last": max(self.names)}
        if len(self.names) == 1:
            return sentence("{name} (one frame, {first} to {last})", **held)
        return sentence("{name} ({count} frames, {first} to {last})", count=len(self.names), **held)

    def holds(self, name: str) -> bool:
        """Whether the file `name` belongs to this sequence."""
        return name in self.names.values() or name in (self.clash or ())

    def checked(self) -> FileSequence:
        """This sequence, or a sentence where its numbers make no sense."""
        if self.clash:
            one, other = self.clash
            raise RoamError(
                sentence(
                    "{one} and {other} in {folder} bear the same frame number; "
                    "remove one, or give a pattern with the number of digits, such as name.%04d.png.",
                    one=one,
                    other=other,
                    folder=self.folder,
                )
            )
        first, last = min(self.names), max(self.names)
        if last - first > WIDEST_RANGE:
            raise RoamError(
                sentence(
                    "The numbers of {path} run from {first} to {last}; that is no sequence of frames. "
                    "Rename the files so that they count the frames.",
                    path=self.path,
                    first=first,
                    last=last,
                )
            )
        return self


def split_number(stem: str) -> tuple[str, str, str] | None:
    """A file's stem as (before, number, after) around its last group of digits; None where it has no digit.

    `shot_v002.1001` gives `("shot_v002.", "1001", "")`.
    """
    match = _LAST_NUMBER.fullmatch(stem)
    return (match["prefix"], match["number"], match["suffix"]) if match else None


def parse_pattern(name: str) -> NamePattern | None:
    """The pattern that a file name with `%04d`, `%d`, `####` or `@@@@` in it stands for; None where it is a plain name.

    The last `%d` is the frame number (else the last run of `#` or `@`): what else looks like one belongs to the name.
    Without either it is what other programs write: `$F4`, `[1001-1100]`, which is as wide as its first number, or `*`.
    """
    for match in reversed([*_PERCENT.finditer(name)]):
        return NamePattern(name[: match.start()], int(match["width"] or 0), name[match.end() :])
    for match in reversed([*_DIGITS.finditer(name)]):
        # One `#` or `@` is the custom for "the number, however it is padded".
        width = len(match[0]) if len(match[0]) > 1 else 0
        return NamePattern(name[: match.start()], width, name[match.end() :])
    for match in reversed([*_OF_OTHERS.finditer(name)]):
        width = int(match["width"] or match["braced"] or 0) or len(match["first"] or "")
        return NamePattern(name[: match.start()], width, name[match.end() :])
    return None


def find_pattern(folder: Path, pattern: NamePattern) -> FileSequence | None:
    """The files in `folder` that follow `pattern`, or None.

    A file whose extension is in other letters (`.PNG` for `.png`) follows it, too, where it is the only one of its
    number. Where none does, those do whose names the disk takes for its own (`spelled_otherwise`).
    """
    names = file_names(folder)
    numbered = [(number, name) for name in names if (number := pattern.number_of(name)) is not None]
    taken, exact = {number for number, _ in numbered}, {name for _, name in numbered}
    for name in names:
        number = None if name in exact else pattern.number_in_any_letters(name)
        if number is not None and number not in taken:
            numbered.append((number, name))
    numbered = numbered or spelled_otherwise(folder, names, pattern)
    return _sequence(folder, numbered, pattern) if numbered else None


def spelled_otherwise(folder: Path, names: Iterable[str], pattern: NamePattern) -> list[tuple[int, str]]:
    """Numbers and names of those that follow `pattern` but for their case or how accents are written.

    None on a disk that tells such names apart: on that of Windows or macOS either opens the same file.
    """
    alike = NamePattern(folded(pattern.prefix), pattern.width, folded(pattern.suffix))
    found = [(number, name) for name in names if (number := alike.number_of(folded(name))) is not None]
    if not found:
        return []
    name = folded(found[0][1])
    digits = name[len(alike.prefix) : len(name) - len(alike.suffix)]
    return found if os.path.exists(folder / f"{pattern.prefix}{digits}{pattern.suffix}") else []  # noqa: PTH110


def listed_name(file: Path) -> str:
    """The name of a file that is there as its folder lists it.

    On a disk of Windows or macOS it may be given in other case, or with its accents written otherwise.
    """
    names = file_names(file.parent)
    alike = [] if file.name in names else [name for name in names if folded(name) == folded(file.name)]
    return next((name for name in alike if file.samefile(file.with_name(name))), file.name)


def folded(name: str) -> str:
    """A name as all those that some file systems do not tell from it: in small letters, accents written in one way."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", name).casefold())


def find_sequences(folder: Path, extensions: Collection[str]) -> list[FileSequence]:
    """All sequences and lone images in `folder`, longest first.

    Hidden files are passed over, and so are files whose extension (lower case, with its dot) is none of `extensions`.
    Extensions in other letters, `.PNG` for `.png`, are one, unless there are files of the same number.
    """
    groups: dict[tuple[str, str], dict[str, list[str]]] = defaultdict(lambda: defaultdict(list))
    sequences = []
    for name in file_names(folder):
        path = Path(name)
        if path.suffix.lower() not in extensions:
            continue
        parts = split_number(path.stem)
        if parts:
            groups[parts[0], parts[2] + path.suffix.lower()][parts[2] + path.suffix].append(parts[1])
        else:
            sequences.append(FileSequence(folder, {1: name}, None))
    for (prefix, _), spellings in groups.items():
        for numbers in _joined(spellings):
            pattern = NamePattern(prefix, _common_width(text for text, _ in numbers), numbers[0][1])
            found = [(int(text), f"{prefix}{text}{suffix}") for text, suffix in numbers]
            sequences.append(_sequence(folder, found, pattern))
    return sorted(sequences, key=lambda sequence: (-len(sequence.names), sequence.path.name))


def _joined(spellings: Mapping[str, Sequence[str]]) -> list[list[tuple[str, str]]]:
    """The numbers of each suffix as (number, suffix), joined where no two are the same; the most frequent first."""
    ordered = sorted(spellings.items(), key=lambda item: -len(item[1]))
    groups = [[(text, suffix) for text in texts] for suffix, texts in ordered]
    every = [int(text) for group in groups for text, _ in group]
    return [list(chain(*groups))] if len(set(every)) == len(every) else groups


def varying_pattern(names: Iterable[str]) -> NamePattern | None:
    """The pattern that most of the names follow, whichever group of digits it varies; None where no two follow one.

    Of `shot_0001_v002.png` and `shot_0002_v002.png` that is `shot_%04d_v002.png`.
    """
    groups: dict[tuple[str, str], list[str]] = defaultdict(list)
    for name in names:
        for match in _GROUP.finditer(Path(name).stem):
            groups[name[: match.start()], name[match.end() :]].append(match[0])
    most = max(groups.items(), key=lambda item: len(item[1]), default=None)
    if most is None or len(most[1]) < 2:
        return None
    (prefix, suffix), numbers = most
    return NamePattern(prefix, _common_width(numbers), suffix)


def file_names(folder: Path) -> list[str]:
    """The names of the plain files in `folder`, sorted; without hidden ones.

    Bytes of a name that are no UTF-8 are lone surrogates in it, as everywhere in Python.
    """
    try:
        return sorted(entry.name for entry in folder.iterdir() if not entry.name.startswith(".") and entry.is_file())
    except FileNotFoundError:
        raise RoamError(sentence("The folder {folder} does not exist; check the path.", folder=folder)) from None
    except OSError as error:
        raise RoamError(
            sentence("The folder {folder} cannot be read: {reason}.", folder=folder, reason=reason_of(error))
        ) from error


def _sequence(folder: Path, numbered: Iterable[tuple[int, str]], pattern: NamePattern) -> FileSequence:
    names: dict[int, str] = {}
    clash = None
    for number, name in sorted(numbered):
        if number in names:
            clash = clash or (names[number], name)
        names[number] = name
    return FileSequence(folder, names, pattern, clash)


def _common_width(numbers: Iterable[str]) -> int:
    """The padding that all these numbers share, or 0."""
    texts = list(numbers)
    width = min(len(text.lstrip("-")) for text in texts)
    return width if width > 1 and all(_is_padded(text, width) for text in texts) else 0


def _is_padded(text: str, width: int) -> bool:
    """True where `text` is its number filled to `width` digits; the sign may or may not count as one (as in C)."""
    number = int(text)
    plain = f"{abs(number):0{width}d}" if width else ""
    return width == 0 or text in (("-" if number < 0 else "") + plain, f"{number:0{width}d}")
