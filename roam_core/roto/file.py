"""The project file `.roam`: JSON in a stable order, every object with its type, written whole or not at all."""

from __future__ import annotations

import codecs
import hashlib
import json
import math
import re
import stat
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

from roam_core.arguments import MOST_SHOWN, path_of, shown
from roam_core.atomic_write import write_atomically
from roam_core.errors import RoamError
from roam_core.roto.backups import backup_path
from roam_core.roto.from_json import read_project
from roam_core.roto.migrate import VERSION, migrate
from roam_core.roto.project import Project
from roam_core.roto.to_json import pieces
from roam_core.system_errors import reason_of
from roam_core.translatable import Sentence, said_by, sentence

__all__ = [
    "MAX_BYTES",
    "DamagedProject",
    "contents",
    "digest",
    "dumps",
    "is_saved",
    "load",
    "load_versioned",
    "loads",
    "save",
    "save_checked",
]

MAX_BYTES = 1440 << 20
"""Larger files are neither read nor written: with what is made of it, it fits into three gigabytes of memory."""
MAX_VALUES = 12_000_000
"""Commas and opening brackets of a file: what a list or object costs in memory goes by these."""
MAX_NAMES = 2_000_000
"""Colons of a file: what the names of fields cost goes by these."""
MAX_MEMORY = 3072 << 20
"""Bytes that reading may take: two for each of the file's, and `VALUE_COST` for each value in it."""
VALUE_COST = 64
MOST_SAID = 400
"""Characters of the reason why a project cannot be read: a name in it may have a million."""
UNREADABLE = (KeyError, TypeError, ValueError, AttributeError, OverflowError, RecursionError)
"""What reading raises where a field is missing or holds what it may not."""
_EMPTY = re.compile(rb"[\0\s]*")
_BEGINNING = re.compile(rb'\s*\{\s*"type"\s*:\s*"roam\.Project"')


class DamagedProject(RoamError):
    """A file that was a project, and of which something is missing or wrong."""


def save(
    project: Project,
    path: str | Path,
    before_replacing: Callable[[], object] | None = None,
    *,
    replaces: bool = True,
) -> None:
    """Write `project` to `path`: to a temporary file beside it, flushed, then put in place in one step.

    A file that is there is replaced, unless it is to be a new one (`replaces` off); `before_replacing` is called when
    all is written, just before that. Paths of media below its folder are written relative to it.

    Raises
    ------
    NameTaken
        with `replaces` off, when a file is there.
    RoamError
        when the folder is missing or may not be written to, or the project is too large to be read again; a file that
        was there is then still there, whole.
    """
    path = path_of(path)
    write_atomically(path, contents(project, path.parent), before_replacing=before_replacing, replaces=replaces)


def contents(project: Project, folder: Path) -> Iterator[bytes]:
    """A project file that lies in `folder`, shape by shape: a large one need not be held at once.

    Raises
    ------
    RoamError
        when it becomes too large to be read again.
    """
    return _limited(_encoded(pieces(project, folder)))


def is_saved(project: Project, path: Path) -> bool:
    """Whether the file at `path` is, byte for byte, what saving the project there would write."""
    try:
        with path.open("rb") as file:
            contents = _encoded(pieces(project, path.parent))
            return all(file.read(len(content)) == content for content in contents) and not file.read(1)
    except OSError:
        return False


def save_checked(project: Project, path: str | Path) -> None:
    """Write `project` to `path` as `save` does, in one step, but nothing that could not be opened again.

    What artists do and what files say is checked where it comes in; what a script puts together is checked here.

    Raises
    ------
    ValueError
        when the path is none, or the project holds what no project file may, such as two shapes of one id.
    RoamError
        when the folder is missing or may not be written to, or the project is too large.
    """
    path = path_of(path)
    if not isinstance(project, Project):
        raise ValueError(f"a project file holds a Project, not {shown(project)}")
    try:
        text = "".join(content.decode() for content in contents(project, path.parent))
        document = json.loads(text, parse_float=_finite, parse_constant=_finite)
        del text
        read_project(migrate(document, VERSION), path.parent)
    except UNREADABLE as error:
        raise ValueError(f"the project cannot be saved, for it could not be opened again: {_reason(error)}") from None
    write_atomically(path, contents(project, path.parent))


def load(path: str | Path) -> Project:
    """Read a project file. The plate that it names is not opened.

    Raises
    ------
    ValueError
        when the path is none.
    RoamError
        when it is missing, not a project, too large, or of a newer version.
    DamagedProject
        when it is empty, cut short or damaged; its newest backup is named, where there is one.
    """
    return load_versioned(path_of(path))[0]


def load_versioned(path: Path) -> tuple[Project, int]:
    """Read a project file as `load` does; gives the version of the file, too."""
    try:
        document = _parsed(_content(path), str(path))
        project = _read(document, path.parent, str(path))
    except DamagedProject as error:
        backup = backup_path(path, 1)
        said = said_by(error)
        if backup.is_file():
            said = sentence("{error} Its newest backup is {backup}.", error=said, backup=backup)
        raise DamagedProject(said) from None
    return project, document["version"]


def dumps(project: Project, folder: Path) -> str:
    """The text of a project file that lies in `folder`."""
    return "".join(pieces(project, folder))


def loads(text: str, folder: Path, name: str = "the file") -> Project:
    """The project that `text` describes; relative media paths are taken from `folder`."""
    return _read(_parsed(text.encode("utf-8", "surrogatepass"), name), folder, name)


def digest(project: Project) -> str:
    """A hash of everything in the project: equal projects, and only they, have equal digests."""
    found = hashlib.sha256()
    for piece in _encoded(pieces(project, Path("/"))):
        found.update(piece)
    return found.hexdigest()


def _encoded(texts: Iterable[str]) -> Iterator[bytes]:
    """UTF-8. A file name that is no UTF-8 reaches us as lone surrogates, which JSON writes as escapes."""
    return (text.encode("utf-8", "backslashreplace") for text in texts)


def _limited(contents: Iterable[bytes]) -> Iterator[bytes]:
    """The pieces of a file, as long as it can be read again."""
    length = values = names = 0
    for content in contents:
        length += len(content)
        more_values, more_names = _counts(content)
        values, names = values + more_values, names + more_names
        if length > MAX_BYTES or _is_too_much(length, values, names):
            raise RoamError(
                sentence("The project is too large for a file that can be opened again; take keys or shapes away.")
            )
        yield content


def _counts(content: bytes) -> tuple[int, int]:
    """At least how many values, and how many names of fields, a part of a file holds."""
    return sum(content.count(mark) for mark in (b",", b"[", b"{")), content.count(b":")


def _is_too_much(length: int, values: int, names: int) -> bool:
    """Whether a file of so many bytes, values and names would take more memory or time to read than it may."""
    return values > MAX_VALUES or names > MAX_NAMES or 2 * length + VALUE_COST * values > MAX_MEMORY


def _content(path: Path) -> bytes:
    try:
        found = path.stat()
        if stat.S_ISDIR(found.st_mode):
            raise RoamError(sentence("{path} is a folder, not a project file.", path=path))
        if not stat.S_ISREG(found.st_mode):
            raise RoamError(sentence("{path} is no regular file, so it is no ROAM project.", path=path))
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1) if found.st_size <= MAX_BYTES else b""
    except FileNotFoundError:
        raise RoamError(sentence("{path} does not exist.", path=path)) from None
    except (OSError, ValueError) as error:  # a name that no file can have
        raise RoamError(sentence("{path} cannot be read: {reason}.", path=path, reason=reason_of(error))) from None
    if max(found.st_size, len(content)) > MAX_BYTES:
        raise RoamError(
            sentence("{path} is larger than {most} MiB; that is no ROAM project.", path=path, most=MAX_BYTES >> 20)
        )
    return content


def _parsed(content: bytes, name: str) -> Any:
    """The plain data of a file; what would take more memory than a project may is refused before it is parsed."""
    content = content.removeprefix(codecs.BOM_UTF8)
    values, names = _counts(content)
    if _is_too_much(len(content), values, names):
        raise RoamError(
            sentence(
                "{path} holds more values ({values}) than can be opened; it is damaged, or no ROAM project.",
                path=name,
                values=values,
            )
        )
    if _EMPTY.fullmatch(content):
        raise DamagedProject(sentence("{path} is empty: it was cut short while it was written or copied.", path=name))
    begins_as_ours = _BEGINNING.match(content) is not None
    try:
        text = content.decode("utf-8", "surrogatepass")
        del content
        return json.loads(text, parse_float=_finite, parse_constant=_finite)
    except (ValueError, RecursionError) as error:
        is_text = not isinstance(error, UnicodeDecodeError)
        reason = sentence("it is not valid JSON") if is_text else sentence("it is no text file")
        if begins_as_ours:
            told = sentence("{path} is damaged or cut short ({reason}).", path=name, reason=reason)
            raise DamagedProject(told) from None
        raise RoamError(sentence("{path} is not a ROAM project ({reason}).", path=name, reason=reason)) from None


def _finite(text: str) -> float:
    """A number of the file. JSON has no NaN and no infinity, though Python's reader lets them pass."""
    number = float(text)
    if not math.isfinite(number):
        raise ValueError(f"{text} is no number")
    return number


def _read(document: Any, folder: Path, name: str) -> Project:
    if not isinstance(document, dict) or document.get("type") != "roam.Project":
        raise RoamError(sentence("{path} is not a ROAM project.", path=name))
    version = document.get("version")
    if type(version) is not int or version < 1:  # `true` is an int to Python
        raise DamagedProject(sentence("{path} says no valid version; it may be damaged.", path=name))
    if version > VERSION:
        raise RoamError(
            sentence(
                "{path} was written by a newer ROAM (file version {version}, this program reads up to {newest}); "
                "open it with that version.",
                path=name,
                version=version,
                newest=VERSION,
            )
        )
    try:
        return read_project(migrate(document, version), folder)
    except UNREADABLE as error:
        raise DamagedProject(sentence("{path} is damaged: {reason}.", path=name, reason=_reason(error))) from None


def _reason(error: BaseException) -> str:
    if isinstance(error, KeyError):
        return sentence("{name!r} is missing or unknown", name=str(error.args[0])[:MOST_SHOWN])
    if isinstance(error, TypeError | AttributeError):
        return sentence("a value in it is of another kind than it must be")
    if isinstance(said := said_by(error), Sentence) and len(said) <= MOST_SAID:
        return said
    text = " ".join(str(error).split())
    return text[:MOST_SAID] if text else type(error).__name__
