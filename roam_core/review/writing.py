"""Writing for review: a movie, a folder of pictures, or a contact sheet; one run for command line and window."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from enum import StrEnum
from pathlib import Path
from typing import Any

import cv2

from roam_core.arrays import UInt8
from roam_core.atomic_write import make_folder, require_open, writable_target, write_atomically
from roam_core.cancel import CancelToken, Progress
from roam_core.errors import RoamError
from roam_core.interchange.authorship import Kind
from roam_core.interchange.mattes.files import signed_png
from roam_core.media import MissingFrame
from roam_core.media.source import ReadImage
from roam_core.review.fonts import lacking
from roam_core.review.lettering import ELLIPSIS, UNKNOWN, required_font
from roam_core.review.look import Burn, ReviewLook
from roam_core.review.movie import ENCODERS, is_movie, require_encoder, write_movie
from roam_core.review.picture import review_picture
from roam_core.review.sheet import SheetLayout, page_paths, page_picture
from roam_core.roto import Project
from roam_core.roto.timing import mark_at
from roam_core.translatable import sentence

PNG = ".png"
PICTURE_NAME = "review.{frame:04d}.png"
OTHER_SUFFIXES = frozenset({".mkv", ".webm", ".m4v", ".wmv", ".gif", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".pdf"})
"""Of pictures and movies that are not written: a path with one of these is no folder that somebody means."""
MOST_NAMED = 8
"""Of the characters that no font has."""


class Output(StrEnum):
    """What is written."""

    MOVIE = "movie"
    PICTURES = "pictures"
    SHEET = "sheet"


@dataclass(frozen=True)
class ReviewRequest:
    """All that is asked for.

    Attributes
    ----------
    project : with a clip. frames : the plate's frame numbers, in the order in which they are shown.
    output, path : what is written, and where: a movie, a folder, or the first page of a contact sheet.
    look : of the pictures. layout : of a contact sheet. fps : of a movie; None for the clip's.
    """

    project: Project
    frames: tuple[int, ...]
    output: Output
    path: Path
    look: ReviewLook = field(default_factory=ReviewLook)
    layout: SheetLayout = field(default_factory=SheetLayout)
    fps: float | None = None

    @property
    def size(self) -> tuple[int, int]:
        """(width, height) of each picture of a movie or folder."""
        clip = self.project.require_clip()
        return self.look.size(clip.size, clip.pixel_aspect)

    def targets(self) -> list[tuple[Path, Kind]]:
        """The files that `write_review` would write, and what they will be."""
        if self.output is Output.MOVIE:
            return [(self.path, Kind.MOVIE)]
        if self.output is Output.SHEET:
            pages = page_paths(self.path, len(self.layout.pages(self.frames)))
            return [(page, Kind.PICTURE) for page in pages]
        return [(self.path / PICTURE_NAME.format(frame=frame), Kind.PICTURE) for frame in self.frames]


def output_of(path: Path, *, is_sheet: bool = False) -> Output:
    """What a path asks for: a movie by its suffix, else a folder; a contact sheet is a PNG picture.

    Raises
    ------
    RoamError
        for the name of a file of a kind that is not written.
    """
    if is_sheet:
        if path.suffix.lower() != PNG:
            raise RoamError(sentence("A contact sheet is written as PNG; {name} does not end in .png.", name=path.name))
        return Output.SHEET
    if is_movie(path):
        return Output.MOVIE
    if path.suffix.lower() in OTHER_SUFFIXES | {PNG} and not path.is_dir():
        *known, last = sorted(ENCODERS)
        raise RoamError(
            sentence(
                "{name} is neither a folder nor a movie that ends in {known} or {last}.",
                name=path.name,
                known=", ".join(known),
                last=last,
            )
        )
    return Output.PICTURES


def write_review(
    request: ReviewRequest, read: ReadImage, token: CancelToken | None = None, progress: Progress | None = None
) -> str:
    """Write what is asked for, each file whole or not at all; says in a sentence what was made.

    Parameters
    ----------
    read : the plate's pictures; frames that it lacks are shown as such.
    token, progress : asked before, and told of, every frame. Of a run that is cancelled pictures and pages stay that
        are finished, a movie does not appear.

    Raises
    ------
    RoamError
        when the font, the encoder or the place is not there, or a file cannot be written.
    Cancelled
        when the token was cancelled.
    """
    request = replace(request, look=replace(request.look, font=required_font(request.look.font)))
    if not request.frames:
        raise RoamError(sentence("There is no frame to write."))
    shown = _Frames(request, read, token or CancelToken(), progress or (lambda fraction, words: None))
    write = {Output.MOVIE: _write_movie, Output.PICTURES: _write_pictures, Output.SHEET: _write_sheet}
    made, unwritten = write[request.output](request, shown), _unwritten(request)
    said = sentence("{made} {unwritten}", made=made, unwritten=unwritten) if unwritten else made
    shown.progress(1.0, said)
    return said


class _Frames:
    """Reads frames and says how far they are."""

    def __init__(self, request: ReviewRequest, read: ReadImage, token: CancelToken, progress: Progress) -> None:
        self._request, self._read, self._token, self.progress = request, read, token, progress
        self._done = 0

    def plate(self, frame: int) -> Any | None:
        """The working picture of a frame; None where the plate lacks it."""
        self._token.check()
        self.progress(self._done / len(self._request.frames), sentence("Frame {frame}", frame=frame))
        self._done += 1
        try:
            return self._read(frame)
        except MissingFrame:
            return None

    def pictures(self) -> Iterator[tuple[int, UInt8]]:
        """Each frame with its picture for review."""
        for frame in self._request.frames:
            yield frame, review_picture(self.plate(frame), self._request.project, frame, self._request.look)


def _write_movie(request: ReviewRequest, shown: _Frames) -> str:
    require_encoder(request.path, request.size)
    fps = request.project.require_clip().fps if request.fps is None else request.fps
    _make(request.path.parent)
    writable_target(request.path)  # before an hour's pictures are made for it
    count = write_movie(request.path, (picture for _, picture in shown.pictures()), request.size, fps)
    return sentence("Wrote {count} frame(s) at {fps:g} fps to {path}.", count=count, fps=fps, path=request.path)


def _write_pictures(request: ReviewRequest, shown: _Frames) -> str:
    _make(request.path)
    for frame, picture in shown.pictures():
        _write_png(request.path / PICTURE_NAME.format(frame=frame), picture)
    return sentence("Wrote {count} picture(s) to {path}.", count=len(request.frames), path=request.path)


def _write_sheet(request: ReviewRequest, shown: _Frames) -> str:
    pages = request.layout.pages(request.frames)
    paths = page_paths(request.path, len(pages))
    _make(request.path.parent)
    for path in paths:
        writable_target(path)
    clip = request.project.require_clip()
    for number, (path, frames) in enumerate(zip(paths, pages, strict=True), 1):
        title = f"{clip.name}   frames {request.frames[0]}-{request.frames[-1]}   page {number} of {len(pages)}"
        _write_png(path, page_picture(request.project, frames, shown.plate, request.look, request.layout, title))
    count, more = len(request.frames), len(paths) - 1
    if not more:
        return sentence("Wrote {count} frame(s) on {pages} page(s) to {path}.", count=count, pages=1, path=paths[0])
    return sentence(
        "Wrote {count} frame(s) on {pages} page(s) to {path} and {more} more.",
        count=count,
        pages=len(paths),
        path=paths[0],
        more=more,
    )


def _write_png(path: Path, picture: UInt8) -> None:
    _, buffer = cv2.imencode(".png", cv2.cvtColor(picture, cv2.COLOR_RGB2BGR))
    write_atomically(path, signed_png(buffer.tobytes()))


def _unwritten(request: ReviewRequest) -> str:
    """What is said of characters that no font of this machine has; empty where all are written."""
    has_notes = request.output is Output.SHEET or Burn.NOTE in request.look.burns
    marks = (mark_at(request.project, frame) for frame in request.frames if has_notes)
    unknown = lacking("".join(mark.text for mark in marks if mark is not None), request.look.font)
    if not unknown:
        return ""
    named = unknown if len(unknown) <= MOST_NAMED else f"{unknown[:MOST_NAMED]}{ELLIPSIS}"
    return sentence(
        "No font of this machine has {named}: {unknown} stands for each; install a font that has them.",
        named=named,
        unknown=UNKNOWN,
    )


def _make(folder: Path) -> None:
    make_folder(folder)
    require_open(folder)
