"""ImageSequence: a plate made of image files (PNG, JPEG, TIFF, EXR, DPX, ...), read with OpenImageIO."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses

from roam_core.arrays import Image
from roam_core.bounded import require_regular
from roam_core.errors import RoamError
from roam_core.media.colour import LINEAR, LOG, SRGB
from roam_core.media.measure import plain_name, require_size, require_told_size
from roam_core.media.numbering import FileSequence
from roam_core.media.source import DamagedFrame, MissingFrame

LARGEST_IMAGE_MB = 2048
"""A header that claims more uncompressed MiB, over all channels of which three are read, is taken for damaged."""

WIDEST_SPAN = 4
"""Channels that are read at once to get three of them."""

_FORMATS_WITHOUT_FILES = frozenset({"null", "term"})
_UNLIKELY_EXTENSIONS = frozenset({"z", "int", "inta", "env", "sm", "vsm"})
"""Extensions that a folder of plates uses for other things than images."""

# The limit is one for the process, and OpenImageIO's own would let a broken header ask for all of the memory.
oiio.attribute("limits:imagesize_MB", LARGEST_IMAGE_MB)


def image_extensions() -> frozenset[str]:
    """The extensions `.png`, `.exr`, ... (lower case) of the images that can be read."""
    extensions: set[str] = set()
    for entry in str(oiio.get_string_attribute("extension_list")).split(";"):
        format_name, _, names = entry.partition(":")
        if format_name not in _FORMATS_WITHOUT_FILES:
            extensions.update(names.split(","))
    return frozenset(f".{name}" for name in extensions - _UNLIKELY_EXTENSIONS if name)


class ImageSequence:
    """Image files as a plate. See `PlateSource` for the attributes.

    8-bit files give uint8. 16-bit integers give float32 in [0, 1]; half and float come as they are, scene-linear, not
    clipped. Where a file has alpha it is left out and colour is neither multiplied nor divided by it. An EXR's picture
    is its display window, zero where the file has no data. A camera's orientation flag is not applied: mattes belong
    to the pixels as they lie in the file.

    Parameters
    ----------
    sequence : the files and their numbers.
    path : how the user named the plate; the sequence's pattern if None.
    """

    def __init__(self, sequence: FileSequence, path: Path | None = None) -> None:
        self._sequence = sequence
        self.path = path or sequence.path
        self.frames = tuple(sorted(sequence.names))
        self.missing = tuple(sorted(set(range(self.frames[0], self.frames[-1] + 1)) - sequence.names.keys()))
        source = self._first_readable()
        self.size = _display_size(source)
        self.fps = _frame_rate(source.spec())
        self.pixel_aspect = _number(source.spec().getattribute("PixelAspectRatio"), 0.1, 10.0, 1.0)
        self.colour_space = _colour_space(source)
        self.depth = _depth(source.spec())

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
        """The picture `(h, w, 3)` of a frame, uint8 or float32."""
        name = self._sequence.names.get(frame)
        if name is None:
            raise MissingFrame(
                f"Frame {frame} of {self.path} is missing: the files there are {self.frames[0]} to {self.frames[-1]}"
                + (f" without {len(self.missing)} between." if self.missing else ".")
            )
        file = self._sequence.folder / name
        if not file.exists():
            raise MissingFrame(f"Frame {frame} of {self.path} is missing: {file} is no longer there.")
        try:
            image = read_image(file)
        except RoamError as error:
            raise DamagedFrame(str(error)) from None
        if (image.shape[1], image.shape[0]) != self.size:
            raise RoamError(
                f"{file} is {image.shape[1]} x {image.shape[0]} pixels, the plate is {self.size[0]} x {self.size[1]}; "
                "all frames of a plate need one size."
            )
        return image

    def _first_readable(self) -> Any:
        """The first image whose header can be read: one damaged frame does not keep a plate from opening."""
        first_error: RoamError | None = None
        for frame in self.frames:
            try:
                return _open(self._sequence.folder / self._sequence.names[frame])
            except RoamError as error:
                first_error = first_error or error
        assert first_error is not None
        raise first_error


def read_image(file: Path) -> Image:
    """Read one image as RGB `(h, w, 3)`, uint8 where the file has 8 bits, else float32.

    Raises
    ------
    RoamError
        when it is no image, damaged, cut short, or larger than `measure.MAX_PIXELS`.
    """
    source = _open(file)
    spec = source.spec()
    channels = colour_channels(spec.channelnames)
    first, end = min(channels), max(channels) + 1
    kind = "uint8" if spec.format.basetype == oiio.UINT8 else "float"
    if end - first > WIDEST_SPAN:  # what lies between is not read: it may be a thousand channels
        return _in_display_window(_separately(file, source, channels, kind), source)
    pixels = source.read_image(0, 0, first, end, kind)
    # A JPEG that is cut short still gives pixels (grey below the cut) beside its error.
    if pixels is None or source.has_error:
        raise RoamError(f"{file} cannot be read; it is damaged or cut short ({_reason(source)}). Render it again.")
    picked = [channel - first for channel in channels]
    if picked != list(range(end - first)):
        pixels = np.ascontiguousarray(pixels[..., picked])
    return _in_display_window(pixels, source)


def read_alpha(file: Path) -> Image | None:
    """The alpha of one image, thrice `(h, w, 3)` in its display window, uint8 or float32; None where it has none.

    Raises
    ------
    DamagedFrame
        when it is no image, damaged or cut short.
    """
    try:
        source = _open(file)
    except RoamError as error:
        raise DamagedFrame(str(error)) from None
    spec = source.spec()
    if spec.alpha_channel < 0:
        return None
    kind = "uint8" if spec.format.basetype == oiio.UINT8 else "float"
    pixels = source.read_image(0, 0, spec.alpha_channel, spec.alpha_channel + 1, kind)
    if pixels is None or source.has_error:
        raise DamagedFrame(f"{file} cannot be read; it is damaged or cut short ({_reason(source)}). Render it again.")
    return _in_display_window(np.repeat(pixels, 3, axis=2), source)


def _separately(file: Path, source: Any, channels: Sequence[int], kind: str) -> Image:
    """The channels one after another `(h, w, 3)`."""
    planes = [source.read_image(0, 0, channel, channel + 1, kind) for channel in channels]
    if source.has_error or any(plane is None for plane in planes):
        raise RoamError(f"{file} cannot be read; it is damaged or cut short ({_reason(source)}). Render it again.")
    return np.dstack(planes)


def colour_channels(names: Sequence[str]) -> tuple[int, int, int]:
    """The indices of the channels that show as red, green and blue.

    The plain R, G, B by name; else those of the first layer that has all three (`beauty.R`); else luminance for all
    three; else the first three channels; else the first one.
    """
    lower = [name.lower() for name in names]
    layers = ["", *(name[:-1] for name in lower if name.endswith(".r"))]
    for layer in layers:
        wanted = [layer + letter for letter in "rgb"]
        if all(name in lower for name in wanted):
            red, green, blue = (lower.index(name) for name in wanted)
            return red, green, blue
    if "y" in lower:
        luminance = lower.index("y")
        return luminance, luminance, luminance
    return (0, 1, 2) if len(names) >= 3 else (0, 0, 0)


def _open(file: Path) -> Any:
    # Without this OpenImageIO multiplies PNG colour by its alpha, and rounds it to 8 bits again.
    as_stored = oiio.ImageSpec()
    as_stored.attribute("oiio:UnassociatedAlpha", 1)
    source = opened_image(file, as_stored)
    if source is None:
        reason = _reason(oiio)
        raise RoamError(f"{file} is no image that can be read ({reason}); replace it or take it out of the plate.")
    return source


def opened_image(file: Path, config: Any = None) -> Any:
    """OpenImageIO's reader of a regular file whose header tells of no more than can be worked with; None for no image.

    Raises
    ------
    RoamError
        when it is no file, or larger than `measure.MAX_PIXELS`: the pixels that are stored, or the window around them.
    """
    require_regular(file)
    require_told_size(file)
    with plain_name(file) as name:
        source = oiio.ImageInput.open(name, config or oiio.ImageSpec())
    if source is not None:
        require_size(file, source.spec().width, source.spec().height)
        require_size(file, *_display_size(source))
    return source


def _has_window(source: Any) -> bool:
    """EXR has a display window. Other formats' offsets (a TIFF's place on its page, PNG oFFs) are hints for print."""
    return bool(source.format_name() == "openexr")


def _display_size(source: Any) -> tuple[int, int]:
    """(width, height) of the picture that is shown."""
    spec = source.spec()
    return (spec.full_width, spec.full_height) if _has_window(source) else (spec.width, spec.height)


def _in_display_window(pixels: Image, source: Any) -> Image:
    """The part of `pixels` inside the display window, zeros where it has none."""
    spec = source.spec()
    width, height = _display_size(source)
    left, top = (spec.x - spec.full_x, spec.y - spec.full_y) if _has_window(source) else (0, 0)
    if (left, top, spec.width, spec.height) == (0, 0, width, height):
        return pixels
    picture = np.zeros((height, width, 3), pixels.dtype)
    x0, x1 = max(left, 0), min(left + spec.width, width)
    y0, y1 = max(top, 0), min(top + spec.height, height)
    if x0 < x1 and y0 < y1:
        picture[y0:y1, x0:x1] = pixels[y0 - top : y1 - top, x0 - left : x1 - left]
    return picture


def _depth(spec: Any) -> str:
    """The depth of the values on disk; formats such as DPX hold fewer bits than the type they are read as."""
    if spec.format.basetype == oiio.HALF:
        return "half float"
    if spec.format.basetype in (oiio.FLOAT, oiio.DOUBLE):
        return "float"
    return f"{spec.get_int_attribute('oiio:BitsPerSample', 8 * spec.format.size())} bits"


def _frame_rate(spec: Any) -> float:
    for name in ("FramesPerSecond", "dpx:FrameRate", "dpx:TemporalFrameRate"):
        value = spec.getattribute(name)
        if isinstance(value, tuple) and len(value) == 2 and value[1]:
            value = value[0] / value[1]
        rate = _number(value, 1.0, 1000.0, 0.0)
        if rate:
            return rate
    return 24.0


def _number(value: object, low: float, high: float, default: float) -> float:
    """`value` where it is a number in [low, high]: headers hold zeros, NaN and leftovers."""
    if isinstance(value, int | float) and math.isfinite(value) and low <= value <= high:
        return float(value)
    return default


_SPACE_OF_WORD: Mapping[str, str] = {
    # In the order of search: "lin_rec709" is linear, not the transfer curve of Rec. 709.
    "lin": LINEAR,
    "aces": LINEAR,
    "log": LOG,
    "printing density": LOG,
    "srgb": SRGB,
    "709": SRGB,
    "itu-r": SRGB,
    "smpte": SRGB,
    "gamma": SRGB,
    "g18": SRGB,
    "g22": SRGB,
    "g24": SRGB,
}


def _colour_space(source: Any) -> str:
    """What the metadata says of the values' curve; else linear for floating point, log for DPX and Cineon, or sRGB."""
    spec = source.spec()
    for name in ("oiio:ColorSpace", "dpx:Transfer"):
        said = spec.get_string_attribute(name).lower()
        for word, space in _SPACE_OF_WORD.items():
            if word in said:
                return space
    if spec.format.basetype in (oiio.HALF, oiio.FLOAT, oiio.DOUBLE):
        return LINEAR
    return LOG if source.format_name() in ("dpx", "cineon") else SRGB


def _reason(speaker: Any) -> str:
    """What OpenImageIO, or one of its readers, says of the last failure, in one line."""
    try:
        return " ".join(speaker.geterror().split()) or "no reason given"
    except UnicodeDecodeError:
        # The message quotes bytes of the damaged file.
        return "no reason given"
