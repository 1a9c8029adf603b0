"""Reads sequences of masks: each part becomes a Bezier whose points stay on their spots, with as few keys as do."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.interchange.protocol import KeyChoice
from roam_core.interchange.reading import PLAIN, Imported, ImportOptions, MaskOptions, ShapeReader
from roam_core.matte.vectorise import coverage_of, is_in_colour, may_be_picture
from roam_core.media import open_clip
from roam_core.media.decoding import read_channels
from roam_core.media.sequence import ImageSequence
from roam_core.media.source import DamagedFrame, PlateSource
from roam_core.media.unseen import unseen_of_mask
from roam_core.params import scale_for
from roam_core.roto import Clip, RotoShape
from roam_core.translatable import N_, said_by, sentence

if TYPE_CHECKING:
    from roam_core.interchange.masks.sequence import Fitted, Wanted
    from roam_core.interchange.masks.tracks import Track, Tracker

READING = 0.25
"""Share of the work that reading the masks is."""
FOLLOWED = 0.25
"""Share of the area of a speck below which an outline is not even followed from mask to mask."""
TOLD = 12
"""Shapes that get a sentence of their own; of more only the worst figures are told."""


class MaskImporter:
    """Fits shapes to masks, white inside: a folder, a pattern, or one picture of a numbered sequence."""

    name = "masks"
    title = N_("Mask pictures")
    suffixes = ("", ".png", ".tif", ".tiff", ".exr", ".jpg", ".jpeg", ".dpx")
    """The empty one stands for a folder."""

    def read(self, path: Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
        """Fit shapes to the masks of a sequence; its pictures are numbered as the clip's frames.

        One picture alone, that bears no number of these, is of the first of them.

        A part of the masks is one shape for as long as it is one part: it begins where it comes up or parts from
        another, and ends where it vanishes or joins a larger one. All keys are the artist's. What was achieved is told
        in a sentence a shape: keys, and how near the curves lie to the masks.
        """
        return self.measured(path, clip, options)[0]

    def measured(self, path: Path, clip: Clip, options: ImportOptions = PLAIN) -> tuple[Imported, tuple[Fitted, ...]]:
        """As `read`, with the figures of each shape in their order."""
        source = open_clip(path)
        reader = ShapeReader(path, clip, _placed(options, source, clip))
        if reader.options is not options:
            reader.note(
                sentence(
                    "The mask bears no number of the clip's frames: its key stands on the first, {first}.",
                    first=clip.first,
                )
            )
        if isinstance(source, ImageSequence) and (pages := unseen_of_mask(source.file_of(source.frames[0]))):
            reader.note(pages)
        wanted = _wanted(options.masks, source)
        _require_masks(source, reader)
        tracker = _followed(source, reader, wanted)
        if not tracker.tracks:
            raise RoamError(
                sentence("Nothing is white in the masks {path}; paint the object white and the rest black.", path=path)
            )
        kept = _without_specks(tracker, reader, _speck(options.masks, source))
        shapes, parts = _fitted_shapes(kept, source, reader, wanted)
        if source.missing:
            reader.note(
                sentence(
                    "{count} masks are missing between the first and the last; no keys stand there.",
                    count=len(source.missing),
                )
            )
        return reader.finished(tuple(shapes), source.size), parts


def _placed(options: ImportOptions, source: PlateSource, clip: Clip) -> ImportOptions:
    """The options, by which one mask that has no number, or none of the clip's, is of the clip's first frame."""
    if options.frame_offset or len(source.frames) > 1 or source.frames[0] in clip.frame_range:
        return options
    return replace(options, frame_offset=source.frames[0] - clip.first)


def _wanted(asked: MaskOptions, source: PlateSource) -> Wanted:
    from roam_core.interchange.masks.sequence import Wanted  # numba: a command's help must not wait for it

    if not 0.0 < asked.tolerance < np.inf:
        raise RoamError(
            sentence(
                "The tolerance of masks must be a positive number of pixels, not {tolerance:g}.",
                tolerance=asked.tolerance,
            )
        )
    if asked.keys is KeyChoice.ARTIST:
        raise RoamError(sentence("Masks have no keys of an artist's; ask for every key or for reduced ones."))
    if asked.speckle is not None and not 0.0 <= asked.speckle < np.inf:
        raise RoamError(
            sentence("The area of specks must be a number of square pixels, not {speckle:g}.", speckle=asked.speckle)
        )
    scale = scale_for(source.size[::-1])
    return Wanted(asked.tolerance, _speck(asked, source) / 2.0, scale, asked.keys is KeyChoice.EVERY)


def _speck(asked: MaskOptions, source: PlateSource) -> float:
    return asked.speckle_for(source.size)


def _require_masks(source: PlateSource, reader: ShapeReader) -> None:
    """Refuse a folder of photographs before hours go into the outlines of their brightest places."""
    frames = source.frames
    probed = sorted({frames[0], frames[len(frames) // 2], frames[-1]})
    reader.options.advance(0.0, sentence("Looking at the masks"))
    with suppress(DamagedFrame):  # it is told where it is read in its turn
        if all(is_in_colour(_stored(source, number)) for number in probed):
            raise RoamError(
                sentence(
                    "{path} holds pictures in colour, no masks; give the masks of them, white inside and black "
                    "elsewhere.",
                    path=reader.called,
                )
            )


def _followed(source: PlateSource, reader: ShapeReader, wanted: Wanted) -> Tracker:
    """The parts of all masks that can be read."""
    from roam_core.interchange.masks.tracks import Tracker

    tracker = Tracker(max(FOLLOWED * 2.0 * wanted.scrap, 1.0))
    frames, grey = source.frames, 0
    for done, number in enumerate(frames):
        reader.options.advance(READING * done / len(frames), sentence("Mask of frame {frame}", frame=number))
        try:
            field = _coverage(source, number)
        except DamagedFrame as damage:
            reader.note(
                sentence("{damage} The shapes pass over frame {number}.", damage=said_by(damage), number=number)
            )
            continue
        grey += may_be_picture(field)
        tracker.take(field, reader.frame(number) + reader.options.frame_offset)
    if grey:
        reader.note(
            sentence(
                "{grey} of the {count} masks are grey for the most part, neither black nor white; if they "
                "are pictures, give the masks of them, white inside.",
                grey=grey,
                count=len(frames),
            )
        )
    return tracker


def _coverage(source: PlateSource, number: int) -> Array:
    """A mask as coverage: its alpha where it has one that is not white all over, else its brightest channel."""
    return coverage_of(_stored(source, number))


def _stored(source: PlateSource, number: int) -> NDArray[Any]:
    """The pixels of a mask with all their channels, in the type in which they are stored."""
    width, height = source.size
    if isinstance(source, ImageSequence):
        stored = read_channels(source.file_of(number))
        if stored is not None and stored.shape[:2] == (height, width):
            return stored
    return source.read(number)  # a movie; and what is wrong with a picture is told in reading it


def _without_specks(tracker: Tracker, reader: ShapeReader, speck: float) -> list[Track]:
    """The parts that are worth a shape, in the order of compositing; where there are none, the largest of all."""
    from roam_core.interchange.masks.sequence import in_order

    kept = [track for track in tracker.tracks if track.largest >= speck]
    if not any(not track.is_hole for track in kept):
        kept.append(max((track for track in tracker.tracks if not track.is_hole), key=lambda track: track.largest))
    left = tracker.scraps + sum(len(track.frames) for track in tracker.tracks) - sum(len(t.frames) for t in kept)
    if left:
        reader.note(
            sentence(
                "{left} speck(s) and pinhole(s) on {count} mask(s) were left out, each below {speck:.0f} square "
                "pixels; the smallest area that is followed can be chosen (--speckle).",
                left=left,
                count=len(tracker.taken),
                speck=speck,
            )
        )
    return in_order(kept)


@dataclass
class _Progress:
    """How far the fitting has come: `whole` is all of the work, `done` what lies behind."""

    reader: ShapeReader
    whole: float
    done: float = 0.0

    def told(self, track: Track, name: str, share: float) -> None:
        at = (self.done + share * _work(track)) / self.whole
        self.reader.options.advance(READING + (1.0 - READING) * min(at, 1.0), sentence("Curves of {name}", name=name))


def _work(track: Track) -> float:
    return float(sum(len(ring.line) for ring in track.rings))


def _fitted_shapes(
    tracks: list[Track], source: PlateSource, reader: ShapeReader, wanted: Wanted
) -> tuple[list[RotoShape], tuple[Fitted, ...]]:
    from roam_core.interchange.masks.sequence import as_shapes, part_as_keys

    progress = _Progress(reader, max(sum(_work(track) for track in tracks), 1.0))
    token = reader.options.token
    parts: list[tuple[Track, Fitted]] = []
    for number, track in enumerate(tracks, start=1):
        name = sentence("part {number} of {count}", number=number, count=len(tracks))
        found = part_as_keys(
            track,
            wanted,
            (lambda: None) if token is None else token.check,
            lambda share, track=track, name=name: progress.told(track, name, share),  # type: ignore[misc]
        )
        progress.done += _work(track)
        reader.check_points(sum(len(points) for _, points in found.keys), name, len(found.keys))
        parts.append((track, found))
    compound = reader.fresh_id("compound")
    shapes = as_shapes(parts, source.frames[0], source.frames[-1], compound, reader.options.frame_offset)
    figures = tuple(part for _, part in parts)
    _tell(reader, shapes, figures)
    return shapes, figures


def _tell(reader: ShapeReader, shapes: list[RotoShape], parts: tuple[Fitted, ...]) -> None:
    from roam_core.interchange.masks.sequence import at_least

    for shape, part in list(zip(shapes, parts, strict=True))[:TOLD]:
        reader.note(part.report(shape.name, reader.options.frame_offset))
    rest = parts[TOLD:]
    if rest:
        keys, frames = sum(len(part.keys) for part in rest), sum(len(part.frames) for part in rest)
        reader.note(
            sentence(
                "{count} more shapes: {keys} keys for {frames} frames; at least {share:.0f} % of the outline within "
                "{tolerance:g} px, {greatest:.1f} px at the farthest, IoU at least {overlap:.3f}; not held on {missed} "
                "frames.",
                count=len(rest),
                keys=keys,
                frames=frames,
                share=at_least(min(part.within for part in rest), 2) * 100.0,
                tolerance=rest[0].tolerance,
                greatest=max(part.greatest for part in rest),
                overlap=at_least(min(part.overlap for part in rest), 3),
                missed=sum(len(part.beyond) for part in rest),
            )
        )
