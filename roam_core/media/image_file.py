"""One image file (PNG, JPEG, TIFF, EXR, DPX, ...), read with OpenImageIO: its layers, pixels and metadata."""

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
from roam_core.media.colour_spaces import space_by_rule, space_called, space_with_primaries
from roam_core.media.curves import LINEAR, LOG, SRGB
from roam_core.media.layers import ImageLayer, Part, colour_layer, layers_of
from roam_core.media.measure import plain_name, require_size, require_told_size
from roam_core.media.source import DamagedFrame, ImageHeader

LARGEST_IMAGE_MB = 2048
"""A header that claims more uncompressed MiB, over all channels of which three are read, is taken for damaged."""

WIDEST_SPAN = 4
"""Channels that are read at once to get three of them."""

MOST_BYTES = 512 << 20
"""Of an image whose channels are all read."""
MOST_CHANNELS = 1024
"""Channels of a part, above which a header is taken for damaged."""
MOST_PARTS = 256
"""Parts of a file that are looked at."""
MOST_LISTED = 12
"""Layers that a message names."""

_KINDS = {oiio.UINT8: "uint8", oiio.UINT16: "uint16", oiio.HALF: "half"}
_WITH_ROWS = frozenset({"openexr", "dpx", "tiff"})
"""Formats of which some rows are read without those before them."""
_FORMATS_WITHOUT_FILES = frozenset({"null", "term"})
_UNLIKELY_EXTENSIONS = frozenset({"z", "int", "inta", "env", "sm", "vsm"})
"""Extensions that a folder of plates uses for other things than images."""

# The limit is one for the process, and OpenImageIO's own would let a broken header ask for all of the memory.
oiio.attribute("limits:imagesize_MB", LARGEST_IMAGE_MB)
oiio.attribute("limits:channels", MOST_CHANNELS)


def image_extensions() -> frozenset[str]:
    """The extensions `.png`, `.exr`, ... (lower case) of the images that can be read."""
    extensions: set[str] = set()
    for entry in str(oiio.get_string_attribute("extension_list")).split(";"):
        format_name, _, names = entry.partition(":")
        if format_name not in _FORMATS_WITHOUT_FILES:
            extensions.update(names.split(","))
    return frozenset(f".{name}" for name in extensions - _UNLIKELY_EXTENSIONS if name)


def read_header(file: Path, layer: str = "") -> ImageHeader:
    """What a file says of one of its layers; of the picture itself if "". Raises `RoamError` as `read_image` does."""
    source, layers = _open(file)
    chosen = _seek(file, source, layers, layer)
    spec = source.spec()
    return ImageHeader(
        _display_size(source),
        _frame_rate(spec),
        _number(spec.getattribute("PixelAspectRatio"), 0.1, 10.0, 1.0),
        _colour_space(file, source),
        _depth(spec),
        chosen.name,
        tuple(other.name for other in layers),
    )


def read_image(file: Path, layer: str = "", rows: tuple[int, int] | None = None) -> Image:
    """Read one image as RGB `(h, w, 3)`: uint8, uint16, float16 or float32, whichever holds its values.

    Parameters
    ----------
    layer : the name of one of its layers (`roam_core.media.layers`); the one that is the picture itself if "".
    rows : only those from the first to before the second, `(end - first, w, 3)`; of a file with `size_in_rows`
        the others are not decoded. None: all.

    Raises
    ------
    RoamError
        when it is no image, damaged, cut short, larger than `measure.MAX_PIXELS`, or has no such layer. Of some `rows`,
        where those are damaged.
    """
    source, layers = _open(file)
    chosen = _seek(file, source, layers, layer)
    stored = _stored_rows(source, rows)
    first, end = min(chosen.channels), max(chosen.channels) + 1
    if end - first > WIDEST_SPAN:  # what lies between is not read: it may be a thousand channels
        planes = [_pixels(file, source, chosen.part, (channel, channel + 1), stored) for channel in chosen.channels]
        return _in_display_window(np.dstack(planes), source, stored, rows)
    pixels = _pixels(file, source, chosen.part, (first, end), stored)
    picked = [channel - first for channel in chosen.channels]
    if picked != list(range(end - first)):
        pixels = np.ascontiguousarray(pixels[..., picked])
    return _in_display_window(pixels, source, stored, rows)


def size_in_rows(file: Path, layer: str = "") -> tuple[int, int] | None:
    """The picture's (width, height) where some rows of a layer are read in less time than all; None where not.

    Raises
    ------
    RoamError
        as `read_image` does; of the pixels only the last row is looked at, which a file that is cut short has not.
    """
    source, layers = _open(file)
    chosen = _seek(file, source, layers, layer)
    if source.format_name() not in _WITH_ROWS:
        return None
    end = source.spec().height
    _pixels(file, source, chosen.part, (chosen.channels[0], chosen.channels[0] + 1), (end - 1, end))
    return _display_size(source)


def read_alpha(file: Path) -> Image | None:
    """The alpha of one image, thrice `(h, w, 3)` in its display window, as it is stored; None where it has none.

    Raises
    ------
    DamagedFrame
        when it is no image, damaged or cut short.
    """
    try:
        source, _ = _open(file)
        channel = source.spec().alpha_channel
        if channel < 0:
            return None
        stored = _stored_rows(source, None)
        pixels = _pixels(file, source, 0, (channel, channel + 1), stored)
    except RoamError as error:
        raise DamagedFrame(str(error)) from None
    return _in_display_window(np.repeat(pixels, 3, axis=2), source, stored, None)


def read_channels(file: Path) -> Image | None:
    """All channels of one image `(h, w, n)` in the type that they are stored in; None where it is none, or damaged.

    Raises
    ------
    RoamError
        when it holds more than `MOST_BYTES` of pixels.
    """
    source = opened_image(file)
    if source is not None and source.spec().image_bytes() > MOST_BYTES:
        raise RoamError(f"{file} holds more than {MOST_BYTES >> 20} MiB of pixels; give a mask of one channel.")
    pixels = None if source is None else source.read_image("unknown")
    # What a reader has to say is fetched, or it says it on the terminal later.
    failed = bool((source or oiio).geterror())
    return None if failed or pixels is None else np.asarray(pixels)


def has_several_images(file: Path) -> bool:
    """Whether a file holds more than one image; False for what is no image."""
    source = opened_image(file)
    several = source is not None and bool(source.seek_subimage(1, 0))
    _reason(oiio if source is None else source)  # nobody asks why not
    return several


def software_of(file: Path) -> str:
    """What an image says it was written by; "" where it says nothing, or is none that can be read."""
    try:
        source = opened_image(file)
    except RoamError:
        return ""
    if source is None:
        _reason(oiio)  # nobody asks why not
        return ""
    return _text(source.spec().get_string_attribute("Software"))


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
        _require_size(file, source)
    return source


def _open(file: Path) -> tuple[Any, tuple[ImageLayer, ...]]:
    """OpenImageIO's reader of a file, and the layers that it holds."""
    # Without this OpenImageIO multiplies PNG colour by its alpha, and rounds it to 8 bits again.
    as_stored = oiio.ImageSpec()
    as_stored.attribute("oiio:UnassociatedAlpha", 1)
    source = opened_image(file, as_stored)
    if source is None:
        reason = _reason(oiio)
        raise RoamError(f"{file} is no image that can be read ({reason}); replace it or take it out of the plate.")
    layers = layers_of(_parts(source))
    if not layers:
        raise RoamError(f"{file} holds deep pixels and no picture; flatten it to one.")
    return source, layers


def _parts(source: Any) -> list[Part]:
    """The parts of an EXR; of other formats the first image.

    Their further images are pages, frames and thumbnails, no layers of one picture. Deep pixels are no picture either:
    such a part keeps its place and has no channels.
    """
    parts: list[Part] = []
    while len(parts) < MOST_PARTS and source.seek_subimage(len(parts), 0):
        spec = source.spec()
        name, view = (_text(spec.get_string_attribute(field)) for field in ("name", "view"))
        parts.append(Part(name, view, () if spec.deep else tuple(map(_text, spec.channelnames))))
        if not _is_exr(source):
            return parts
    _reason(source)  # that there are no more of them is no error of the file
    return parts


def _text(name: str) -> str:
    """A name of a file's in letters: bytes that are no UTF-8, lone surrogates in Python, are taken for Latin-1."""
    return name if name.isprintable() else name.encode(errors="surrogateescape").decode("latin-1")


def _seek(file: Path, source: Any, layers: Sequence[ImageLayer], name: str) -> ImageLayer:
    """Go to the part of the layer of a name, or of the picture itself; the layer."""
    named = {layer.name: layer for layer in layers}
    if name and name not in named:
        raise RoamError(f"{file} has no layer {name!r}; it has {_listed(list(named))}.")
    chosen = named[name] if name else colour_layer(layers)
    if not source.seek_subimage(chosen.part, 0):
        raise _damaged(file, source)
    _require_size(file, source)
    return chosen


def _listed(names: Sequence[str]) -> str:
    more = len(names) - MOST_LISTED
    return ", ".join(names[:MOST_LISTED]) + (f" and {more} more" if more > 0 else "")


def _pixels(file: Path, source: Any, part: int, channels: tuple[int, int], rows: tuple[int, int]) -> Image:
    """The channels from the first to before the second of some of the rows that are stored, `(k, w, n)`."""
    spec, kind = source.spec(), _kind(source)
    first, end = rows
    if end <= first:
        return np.asarray(source.read_image(part, 0, *channels, kind))[:0]
    if (first, end) == (0, spec.height) or source.format_name() not in _WITH_ROWS:
        pixels, top = source.read_image(part, 0, *channels, kind), 0
    elif spec.tile_height:
        top, below = first - first % spec.tile_height, min(end + -end % spec.tile_height, spec.height)
        across = spec.x, spec.x + spec.width
        pixels = source.read_tiles(part, 0, *across, spec.y + top, spec.y + below, 0, 1, *channels, kind)
    else:
        pixels, top = source.read_scanlines(part, 0, spec.y + first, spec.y + end, 0, *channels, kind), first
    # A JPEG that is cut short still gives pixels (grey below the cut) beside its error.
    if pixels is None or source.has_error:
        raise _damaged(file, source)
    return np.asarray(pixels)[first - top : end - top]


def _damaged(file: Path, source: Any) -> RoamError:
    return RoamError(f"{file} cannot be read; it is damaged or cut short ({_reason(source)}). Render it again.")


def _kind(source: Any) -> str:
    """The type that the pixels are read as: the smallest of four that holds them."""
    return _KINDS.get(source.spec().format.basetype, "float")


def _require_size(file: Path, source: Any) -> None:
    """Refuse what is too large: the pixels of a part, or its picture."""
    require_size(file, source.spec().width, source.spec().height)
    require_size(file, *_display_size(source))


def _is_exr(source: Any) -> bool:
    return bool(source.format_name() == "openexr")


def _display_size(source: Any) -> tuple[int, int]:
    """(width, height) of the picture that is shown: an EXR's display window.

    Other formats' offsets (a TIFF's place on its page, PNG oFFs) are hints for print.
    """
    spec = source.spec()
    return (spec.full_width, spec.full_height) if _is_exr(source) else (spec.width, spec.height)


def _corner(source: Any) -> tuple[int, int]:
    """Where the pixels that are stored begin in the picture that is shown: (column, row)."""
    spec = source.spec()
    return (spec.x - spec.full_x, spec.y - spec.full_y) if _is_exr(source) else (0, 0)


def _stored_rows(source: Any, rows: tuple[int, int] | None) -> tuple[int, int]:
    """Those of the rows that are stored which hold some `rows` of the picture that is shown; None: all."""
    height = source.spec().height
    if rows is None:
        return 0, height
    first, end = (min(max(row - _corner(source)[1], 0), height) for row in rows)
    return first, end


def _in_display_window(pixels: Image, source: Any, stored: tuple[int, int], rows: tuple[int, int] | None) -> Image:
    """Some `rows` of the display window (None: all) out of the `stored` ones; zeros where it has none."""
    spec = source.spec()
    width, height = _display_size(source)
    first, end = rows or (0, height)
    left, top = _corner(source)
    top += stored[0] - first
    if (left, top, spec.width, len(pixels)) == (0, 0, width, end - first):
        return pixels
    picture = np.zeros((end - first, width, 3), pixels.dtype)
    x0, x1 = max(left, 0), min(left + spec.width, width)
    y0, y1 = max(top, 0), min(top + len(pixels), end - first)
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
_PLAIN_LINEAR = frozenset({"lin_rec709_scene", "lin_rec709", "lin_srgb", "linear", "scene_linear"})


def _colour_space(file: Path, source: Any) -> str:
    """The space of the values: by the studio's file rules, else by the metadata, else as is usual for the format.

    Usual are linear for floating point, log for DPX and Cineon, else sRGB.
    """
    spec = source.spec()
    if space := space_by_rule(file) or _said_space(spec):
        return space
    if spec.format.basetype in (oiio.HALF, oiio.FLOAT, oiio.DOUBLE):
        return LINEAR
    return LOG if source.format_name() in ("dpx", "cineon") else SRGB


def _said_space(spec: Any) -> str | None:
    """What the metadata says of the values' curve and primaries; None where it says nothing that is understood."""
    said = spec.get_string_attribute("oiio:ColorSpace").lower()
    # OpenColorIO is a large library: it is loaded for what the words do not tell.
    word = next((space for word, space in _SPACE_OF_WORD.items() if word in said), None)
    if said and word != SRGB and said not in _PLAIN_LINEAR:
        word = space_called(said) or word
    if word:
        return word
    chromaticities = spec.getattribute("chromaticities")
    if isinstance(chromaticities, tuple):  # a damaged file has anything there
        return space_with_primaries(chromaticities)
    transfer = spec.get_string_attribute("dpx:Transfer").lower()
    return next((space for word, space in _SPACE_OF_WORD.items() if word in transfer), None)


def _reason(speaker: Any) -> str:
    """What OpenImageIO, or one of its readers, says of the last failure, in one line."""
    try:
        return " ".join(speaker.geterror().split()) or "no reason given"
    except UnicodeDecodeError:
        # The message quotes bytes of the damaged file.
        return "no reason given"
