"""What was done, told by content: a record beside the results says what went into a step and what came out."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from roam_core.atomic_write import write_atomically
from roam_core.bounded import bounded_bytes
from roam_core.errors import RoamError
from roam_core.media import open_clip
from roam_core.media.decoding import image_extensions
from roam_core.media.numbering import find_pattern, find_sequences, listed_name, parse_pattern
from roam_core.system_errors import reason_of
from roam_core.translatable import sentence

TYPE, VERSION = "roam.StepDone", 1
MOST_BYTES = 256 << 20


@dataclass(frozen=True)
class Seen:
    """A file as it was: its name, size and time (ns), and the SHA-256 of its content."""

    name: str
    size: int
    changed: int
    digest: str

    @classmethod
    def of(cls, path: Path, before: Seen | None = None) -> Seen:
        """A file as it is; one that looks untouched since `before` is not read again.

        Raises `RoamError` where it cannot be read.
        """
        try:
            found = path.stat()
            if before is not None and (before.size, before.changed) == (found.st_size, found.st_mtime_ns):
                return cls(path.name, before.size, before.changed, before.digest)
            return cls(path.name, found.st_size, found.st_mtime_ns, digest_of(path))
        except OSError as error:
            raise RoamError(sentence("{path} cannot be read: {reason}.", path=path, reason=reason_of(error))) from None


def digest_of(path: Path) -> str:
    """The SHA-256 of a file's content. Raises `OSError`."""
    with path.open("rb") as opened:
        return hashlib.file_digest(opened, "sha256").hexdigest()


@dataclass(frozen=True)
class Record:
    """What went into a step, what came out (by path, from the folder of the job), and what the command said."""

    settings: Mapping[str, Any]
    inputs: tuple[Seen, ...]
    outputs: Mapping[str, str]
    outcome: Mapping[str, Any]

    def holds(self, settings: Mapping[str, Any], inputs: Sequence[Seen], folder: Path) -> bool:
        """True when the step would be the same again, and its results are there as they were written."""
        is_same = _plain(self.settings) == _plain(settings) and _contents(self.inputs) == _contents(inputs)
        return (
            is_same
            and bool(self.outputs)
            and all(is_as_written(folder / name, digest) for name, digest in self.outputs.items())
        )

    def write(self, path: Path) -> None:
        """Put the record at `path`, whole or not at all. Raises `RoamError`."""
        document = {
            "type": TYPE,
            "version": VERSION,
            "settings": self.settings,
            "inputs": [[seen.name, seen.size, seen.changed, seen.digest] for seen in self.inputs],
            "outputs": self.outputs,
            "outcome": self.outcome,
        }
        write_atomically(path, json.dumps(document).encode(), flushes=False)

    @classmethod
    def read(cls, path: Path) -> Record | None:
        """The record at `path`; None where there is none that can be read: the step is then done."""
        try:
            document = json.loads(bounded_bytes(path, MOST_BYTES))
            if (document["type"], document["version"]) != (TYPE, VERSION):
                return None
            inputs = tuple(
                Seen(str(name), int(size), int(time), str(sha)) for name, size, time, sha in document["inputs"]
            )
            outputs = {str(name): str(digest) for name, digest in document["outputs"].items()}
            return cls(dict(document["settings"]), inputs, outputs, dict(document["outcome"]))
        except (RoamError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
            return None


def is_as_written(path: Path, digest: str) -> bool:
    """Whether a file is there with this content."""
    try:
        return digest_of(path) == digest
    except OSError:
        return False


def inputs_of(
    reads: Sequence[str],
    plate: str,
    layer: str,
    before: Record | None,
    content: str = "",
    *,
    are_sequences: bool = True,
) -> list[Seen]:
    """All files that a step reads, in order: its own, those of folders, the pictures of the plate, and `$OCIO`.

    Raises `RoamError` where one is missing.
    """
    files: list[Path] = []
    for path in map(Path, reads):
        if path.is_dir():
            files += sorted(each for each in path.iterdir() if each.is_file())
        else:  # a mask to track from is one file, whatever lies beside it
            files += _sequence_of(path) if are_sequences else [path]
    if plate:
        source = open_clip(plate, layer, content)
        files += dict.fromkeys(source.file_of(frame) for frame in source.frames)
        if (colours := Path(os.environ.get("OCIO") or "none")).is_file():
            files.append(colours)
    known = () if before is None or len(before.inputs) != len(files) else before.inputs
    return [Seen.of(path, known[k] if known and known[k].name == path.name else None) for k, path in enumerate(files)]


def _sequence_of(path: Path) -> list[Path]:
    """The files that a path leads to: of a pattern, or one of numbered pictures, all of the sequence."""
    pattern = None if path.exists() else parse_pattern(path.name)
    if pattern is not None:
        sequence = find_pattern(path.parent, pattern)
    else:
        is_picture = path.is_file() and path.suffix.lower() in image_extensions()
        found = find_sequences(path.parent, {path.suffix.lower()}) if is_picture else []
        sequence = next((each for each in found if each.holds(listed_name(path))), None)
    return [path] if sequence is None else [path.parent / name for name in sorted(sequence.names.values())]


def _contents(inputs: Sequence[Seen]) -> list[tuple[str, str]]:
    return [(seen.name, seen.digest) for seen in inputs]


def _plain(settings: Mapping[str, Any]) -> Any:
    """Settings as they come back from a file."""
    return json.loads(json.dumps(settings))
