"""Reads sequences of masks: each part becomes a Bezier with one number of points and a key on every frame."""

from __future__ import annotations

from pathlib import Path

from roam_core.errors import RoamError
from roam_core.interchange.reading import PLAIN, Imported, ImportOptions, ShapeReader
from roam_core.matte.vectorise import shapes_from_mask
from roam_core.media import open_clip
from roam_core.proposal.keys import keys_from_mask
from roam_core.roto import Clip, RotoShape


class MaskImporter:
    """Fits shapes to masks, white inside: a folder, a pattern, or one picture of a numbered sequence."""

    name = "masks"
    title = "Mask pictures"
    suffixes = ("", ".png", ".tif", ".tiff", ".exr", ".jpg", ".jpeg", ".dpx")
    """The empty one stands for a folder."""

    def read(self, path: Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
        """Fit shapes to every mask of the sequence; its pictures are numbered as the clip's frames.

        The first mask with anything in it decides on the shapes and their points; a part that comes later begins as a
        shape of its own, and one that vanishes ends its shape's lifetime.
        """
        reader = ShapeReader(path, clip, options)
        source = open_clip(path)
        shapes: list[RotoShape] = []
        for done, number in enumerate(source.frames):
            options.advance(done / len(source.frames), f"Mask of frame {number}")
            mask = source.read(number)
            frame = reader.frame(number)
            shapes = keys_from_mask(shapes, mask, frame) if shapes else shapes_from_mask(mask, frame)
            reader.check_points(sum(shape.point_count for shape in shapes), path.name, len(shapes))
        if not shapes:
            raise RoamError(f"Nothing is white in the masks {path}; paint the object white and the rest black.")
        if source.missing:
            reader.note(f"{len(source.missing)} masks are missing between the first and the last; no keys stand there.")
        return reader.finished(tuple(shapes), source.size)
