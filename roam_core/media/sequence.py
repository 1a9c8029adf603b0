"""ImageSequence: a plate made of image files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from roam_core.arguments import frame_number
from roam_core.arrays import Image
from roam_core.errors import RoamError
from roam_core.media.area import Area
from roam_core.media.decoding import read_header, read_image, size_in_areas
from roam_core.media.decoding.answers import NoRoom
from roam_core.media.numbering import FileSequence
from roam_core.media.source import DamagedFrame, ImageHeader, MissingFrame
from roam_core.translatable import sentence


class ImageSequence:
    """Image files as a plate. See `PlateSource` for the attributes.

    Files give uint8, uint16, float16 or float32, whichever holds their values: floating point comes as it is, not
    clipped. Where a file has alpha it is left out and colour is neither multiplied nor divided by it. An EXR's picture
    is its display window, zero where the file has no data. A camera's orientation flag is not applied: mattes belong
    to the pixels as they lie in the file. All frames show the layer of one name.

    Parameters
    ----------
    sequence : the files and their numbers.
    path : how the user named the plate; the sequence's pattern if None.
    layer : which of the files' layers is the plate; the picture itself if "".
    """

    readers = 2

    def __init__(self, sequence: FileSequence, path: Path | None = None, layer: str = "") -> None:
        self._sequence = sequence
        self.path = path or sequence.path
        self.frames = tuple(sorted(sequence.names))
        self.missing = tuple(sorted(set(range(self.frames[0], self.frames[-1] + 1)) - sequence.names.keys()))
        header = self._first_header(layer)
        self.size, self.fps, self.pixel_aspect = header.size, header.fps, header.pixel_aspect
        self.colour_space, self.depth = header.colour_space, header.depth
        self.layer, self.layers = header.layer, header.layers

    def file_of(self, frame: int) -> Path:
        """The frame's file; the plate's own path for a frame that it has not."""
        name = self._sequence.names.get(frame)
        return self._sequence.folder / name if name else self.path

    def frame_name(self, frame: int) -> str:
        """The stem of the frame's file, or what it would be for a frame that is not on disk."""
        name = self._sequence.names.get(frame)
        if name is None and self._sequence.pattern:
            name = self._sequence.pattern.name(frame)
        return Path(name).stem if name else f"{self.path.stem}.{frame:04d}"

    def read(self, frame: int) -> Image:
        """The picture `(h, w, 3)` of a frame, uint8, uint16, float16 or float32."""
        file = self._existing(frame)
        image = _read(file, self.layer, None)
        self._require_size(file, (image.shape[1], image.shape[0]))
        return image

    def areas(self, frame: int) -> FileAreas | None:
        """The areas of a frame, where one is read in less time than all of it."""
        file = self._existing(frame)
        try:
            size = size_in_areas(file, self.layer)
        except RoamError as error:
            raise DamagedFrame(*error.args) from None
        if size is None:
            return None
        self._require_size(file, size)
        return FileAreas(file, self.layer)

    def _existing(self, frame: int) -> Path:
        """The file of a frame that there is; a `ValueError` for what is no frame's number."""
        frame = frame_number(frame)
        name = self._sequence.names.get(frame)
        if name is None:
            raise MissingFrame(self._lacks(frame))
        file = self._sequence.folder / name
        if not file.exists():
            raise MissingFrame(
                sentence(
                    "Frame {frame} of {path} is missing: {file} is no longer there.",
                    frame=frame,
                    path=self.path,
                    file=file,
                )
            )
        return file

    def _lacks(self, frame: int) -> str:
        there = {"frame": frame, "path": self.path, "first": self.frames[0], "last": self.frames[-1]}
        if not self.missing:
            return sentence("Frame {frame} of {path} is missing: the files there are {first} to {last}.", **there)
        return sentence(
            "Frame {frame} of {path} is missing: the files there are {first} to {last}, with {count} missing between.",
            count=len(self.missing),
            **there,
        )

    def _require_size(self, file: Path, size: tuple[int, int]) -> None:
        if size != self.size:
            raise DamagedFrame(
                sentence(
                    "{file} is {width} x {height} pixels, the plate is {plate_width} x {plate_height}; "
                    "all frames of a plate need one size.",
                    file=file,
                    width=size[0],
                    height=size[1],
                    plate_width=self.size[0],
                    plate_height=self.size[1],
                )
            )

    def _first_header(self, layer: str) -> ImageHeader:
        """What the first image says that can be read: one damaged frame does not keep a plate from opening."""
        first_error: RoamError | None = None
        for frame in self.frames:
            try:
                return read_header(self._sequence.folder / self._sequence.names[frame], layer)
            except RoamError as error:
                first_error = first_error or error
        assert first_error is not None
        raise first_error


@dataclass(frozen=True)
class FileAreas:
    """The areas of one file's layer."""

    file: Path
    layer: str

    def read(self, area: Area) -> Image:
        """An area `(rows, columns, 3)` of the picture; raises `DamagedFrame`."""
        return _read(self.file, self.layer, area)


def _read(file: Path, layer: str, area: Area | None) -> Image:
    try:
        return read_image(file, layer, area)
    except NoRoom:
        raise  # no frame could be read: nothing is bridged
    except RoamError as error:
        raise DamagedFrame(*error.args) from None
