"""May this be written? Never what the same command reads, and what somebody else made only on their word."""

from __future__ import annotations

import errno
import os
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.interchange.authorship import Kind, is_project, written_by_us
from roam_core.interchange.matte_style import MATTES
from roam_core.interchange.protocol import STANDARD, Exporter, ExportOptions, WritesSeveral
from roam_core.media import PlateSource, open_clip
from roam_core.media.decoding import image_extensions
from roam_core.media.numbering import parse_pattern, split_number
from roam_core.roto import Clip, Project
from roam_core.roto.backups import rotate
from roam_core.translatable import N_, sentence

PROJECT = ".roam"
"""What the names of projects end in: by that they are told from plates and other programs' files."""
BACKUPS = 9
"""How many older projects are kept beside a project that is written over."""
SHOWN = 40
"""How much is told of a name that is too long."""

Identity = tuple[int, int] | str


@dataclass(frozen=True)
class Sources:
    """What a command reads: files, and the folder of a plate that is opened by its folder or by a pattern.

    A picture more in such a folder could be taken for a frame, or keep the folder from being opened again; one that is
    there may be a frame of another plate.
    """

    files: tuple[Path, ...]
    plate_folder: Path | None = None

    @classmethod
    def of(cls, plate: PlateSource | None, *files: Path) -> Sources:
        """A plate's files and others."""
        if plate is None:
            return cls(files)
        frames = dict.fromkeys(plate.file_of(frame) for frame in plate.frames)
        return cls((*frames, *files), _plate_folder(plate.path))

    @classmethod
    def of_clip(cls, clip: Clip | None, *files: Path) -> Sources:
        """The files of a project's clip, as far as it is at hand, and others."""
        if clip is None:
            return cls(files)
        try:
            return cls.of(open_clip(clip.path, content=clip.content), *files)
        except RoamError:
            # What cannot be opened now may be a plate all the same: none of its folder is touched.
            folder = _plate_folder(clip.path)
            return cls((*(folder.iterdir() if folder else [clip.path]), *files), folder)


def exported(
    exporter: Exporter, project: Project, path: Path, options: ExportOptions = STANDARD
) -> list[tuple[Path, Kind]]:
    """The files that an export would write, and what they will be."""
    files = exporter.files(project, path, options) if isinstance(exporter, WritesSeveral) else (path,)
    kind = Kind.PICTURE if exporter.name == MATTES else Kind.SHAPES
    return [(file, kind) for file in files]


def replaces_any(exporter: Exporter, project: Project, path: Path, options: ExportOptions = STANDARD) -> bool:
    """Whether an export would write over a file that is there.

    Quickly told of long sequences, too: only frames whose numbers are borne by files in their folders are asked about.
    Mattes that skip what is there replace nothing. Raises `RoamError` as `exported` does.
    """
    if exporter.name != MATTES:
        return any(file.name in _files_in(file.parent) for file, _ in exported(exporter, project, path, options))
    frames = options.frames_of(project.require_clip())
    if options.mattes.resumes or not frames:
        return False

    def files(frame: int) -> list[Path]:
        return [file for file, _ in exported(exporter, project, path, replace(options, frames=range(frame, frame + 1)))]

    first = files(frames[0])
    there = {folder: _files_in(folder) for folder in dict.fromkeys(file.parent for file in first)}
    suffixes = {file.suffix for file in first}
    names = (Path(name) for held in there.values() for name in held)
    numbered = [split_number(name.stem) for name in names if name.suffix in suffixes]
    found = {int(parts[1]) for parts in numbered if parts is not None}
    numbers = {signed - options.frame_offset for number in found for signed in (number, -number)}
    asked = (file for frame in frames if frame in numbers for file in files(frame))
    return any(file.name in there.get(file.parent, ()) for file in asked)


def _files_in(folder: Path) -> set[str]:
    """The names of the files of a folder; none where it cannot be read."""
    try:
        with os.scandir(folder) as entries:
            return {entry.name for entry in entries if entry.is_file()}
    except (OSError, ValueError):
        return set()


@dataclass(frozen=True)
class Obstacles:
    """Why files may not be written, first come first: those that are `read`, those `in_plate`, those not `ours`.

    `odd` are no plain files, `twice` those that two results would go to; names that are `too_long` lead nowhere, and a
    project under one of the `misnamed` would be taken for none.
    """

    too_long: tuple[Path, ...] = ()
    read: tuple[Path, ...] = ()
    in_plate: tuple[Path, ...] = ()
    odd: tuple[Path, ...] = ()
    twice: tuple[Path, ...] = ()
    misnamed: tuple[Path, ...] = ()
    foreign: tuple[Path, ...] = ()

    def refuse_always(self) -> None:
        """Raise `RoamError` for what is never permitted."""
        if self.too_long:
            raise RoamError(
                sentence("The name {name}… is too long; choose a shorter one.", name=self.too_long[0].name[:SHOWN])
            )
        for paths, told in (
            (self.read, N_("{files} is read for this and is never written over; name another place.")),
            (self.in_plate, N_("{files} would lie among the frames of the plate; choose another folder.")),
            (self.odd, N_("{files} is no plain file and cannot be written over; name another.")),
            (self.twice, N_("{files} would be written twice; give each result a place of its own.")),
        ):
            if paths:
                raise RoamError(sentence(told, files=listed(paths)))
        if self.misnamed:
            name, better = self.misnamed[0].name, self.misnamed[0].with_suffix(PROJECT).name
            raise RoamError(
                sentence(
                    "{name} is no name for a project; end it in {suffix}, as {better}.",
                    name=name,
                    suffix=PROJECT,
                    better=better,
                )
            )

    def refuse_foreign(self) -> None:
        """Raise `RoamError` for what is permitted only on the user's word."""
        if self.foreign:
            raise RoamError(
                sentence(
                    "{files} is there already and is no file of this kind that ROAM made; name another place, or "
                    "say --overwrite.",
                    files=listed(self.foreign),
                )
            )


def obstacles(targets: Iterable[tuple[Path, Kind]], sources: Sources, rewritten: Path | None = None) -> Obstacles:
    """What stands against writing `targets`, each with what it will be.

    Links and detours do not hide that two paths are one file. `rewritten` is a project that may take the place of
    itself. A file of ROAM's is free for what is of its own kind; so is an empty one.
    """
    wanted = list(targets)
    read = {_identity(path) for path in sources.files}
    own = None if rewritten is None else _identity(rewritten)
    folder = None if sources.plate_folder is None else _identity(sources.plate_folder)
    places = Counter(os.path.realpath(path) for path, _ in wanted)  # two names of one file are two places
    too_long = tuple(path for path, _ in wanted if _is_too_long(path))
    others = [(path, kind) for path, kind in wanted if path not in too_long]
    rest = [(path, kind) for path, kind in others if not (kind is Kind.PROJECT and _identity(path) == own)]
    there = [(path, kind) for path, kind in rest if path.exists()]
    return Obstacles(
        too_long=too_long,
        read=tuple(path for path, kind in there if _identity(path) in read),
        in_plate=tuple(
            path
            for path, kind in rest
            if _identity(path.parent) == folder and (kind is Kind.PICTURE or _is_picture(path))
        ),
        odd=tuple(path for path, _ in there if not path.is_file() and not path.is_dir()),
        twice=tuple(dict.fromkeys(path for path, _ in wanted if places[os.path.realpath(path)] > 1)),
        misnamed=tuple(path for path, kind in rest if kind is Kind.PROJECT and path.suffix.lower() != PROJECT),
        foreign=tuple(path for path, kind in there if path.is_file() and not _is_free(path, kind)),
    )


def require_free(
    targets: Iterable[tuple[Path, Kind]], sources: Sources, *, overwrite: bool, rewritten: Path | None = None
) -> None:
    """Raise `RoamError` where a target may not be written; `overwrite` is the user's word for what is not ours."""
    found = obstacles(targets, sources, rewritten)
    found.refuse_always()
    if not overwrite:
        found.refuse_foreign()


def listed(paths: Sequence[Path]) -> str:
    """The first path, and how many others."""
    others = len(paths) - 1
    if not others:
        return str(paths[0])
    if others == 1:
        return sentence("{path} (and {count} other file)", path=paths[0], count=others)
    return sentence("{path} (and {count} other files)", path=paths[0], count=others)


def kept_aside(path: Path) -> Path | None:
    """Keep the project at `path` as a backup before another takes its place (`roto.backups.rotate`).

    Returns where it is kept; None where there was none, or where it is the newest backup already. Raises `RoamError`
    when it cannot be kept.
    """
    return rotate(path, BACKUPS, is_project) if is_project(path) else None


def _plate_folder(path: Path) -> Path | None:
    """The folder of a plate that is opened by its folder or by a pattern; of a movie and a lone image there is none."""
    if path.is_dir():
        return path
    by_pattern = parse_pattern(path.name) is not None and not path.is_file()
    return path.parent if by_pattern and path.parent.is_dir() else None


def _is_picture(path: Path) -> bool:
    return path.is_file() and path.suffix.lower() in image_extensions()


def _is_free(path: Path, kind: Kind) -> bool:
    return path.stat().st_size == 0 or written_by_us(path) is kind


def _is_too_long(path: Path) -> bool:
    try:
        path.lstat()
    except OSError as error:
        return error.errno == errno.ENAMETOOLONG
    return False


def _identity(path: Path) -> Identity:
    """The same for all paths that lead to one file, or to one place where none is yet."""
    try:
        found = path.stat()
    except OSError:
        return os.path.realpath(path)
    return (found.st_dev, found.st_ino) if found.st_ino else os.path.realpath(path)
