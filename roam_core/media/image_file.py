"""One image file (PNG, JPEG, TIFF, EXR, DPX, ...), read with OpenImageIO: its layers, pixels and metadata."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses

from roam_core.arrays import Image
from roam_core.bounded import require_regular
from roam_core.errors import RoamError
from roam_core.media.area import Area
from roam_core.media.colour_spaces import space_by_rule, space_called, space_with_primaries
from roam_core.media.curves import LINEAR, LOG, SRGB
from roam_core.media.display_window import all_of, display_size, in_display_window, is_exr, stored_area
from roam_core.media.layers import ImageLayer, Part, colour_layer, layers_of, listed, mask_channels
from roam_core.media.measure import plain_name, require_size, require_told_size
from roam_core.media.source import SPEEDS, USUAL_SPEED, ImageHeader
from roam_core.translatable import sentence

if TYPE_CHECKING:
    from roam_core.media.scanlines import ScanlineReader

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

_KINDS = {oiio.UINT8: "uint8", oiio.UINT16: "uint16", oiio.HALF: "half"}
_TYPES = {"uint8": np.uint8, "uint16": np.uint16, "half": np.float16, "float": np.float32}
_WITH_AREAS = frozenset({"openexr", "dpx", "tiff"})
"""Formats of which an area is read without what lies before it."""
_WITH_PAGES = frozenset({"gif", "tiff", "webp"})
"""Formats whose further images are pages, or frames of an animation."""
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
        display_size(source),
        _frame_rate(spec),
        _number(spec.getattribute("PixelAspectRatio"), 0.1, 10.0, 1.0),
        _colour_space(file, source),
        _depth(spec),
        chosen.name,
        tuple(other.name for other in layers),
    )


def read_image(file: Path, layer: str = "", area: Area | None = None, scanlines: ScanlineReader | None = None) -> Image:
    """Read one image as RGB `(h, w, 3)`: uint8, uint16, float16 or float32, whichever holds its values.

    Parameters
    ----------
    layer : the name of one of its layers (`roam_core.media.layers`); the one that is the picture itself if "".
    area : only that of the picture, `(rows, columns, 3)`; of a file with `size_in_areas` as little is decoded beside
        it as the format allows. None: all.
    scanlines : reads those of an EXR, the same values in less time; what it does not give, OpenImageIO reads.

    Raises
    ------
    RoamError
        when it is no image, damaged, cut short, larger than `measure.MAX_PIXELS`, or has no such layer. Of an `area`,
        where that is damaged.
    """
    source, layers = _open(file)
    chosen = _seek(file, source, layers, layer)
    stored = stored_area(source, area)
    pixels = _scanlines(file, source, chosen.part, chosen.channels, stored, scanlines)
    if pixels is None:
        pixels = _channels(file, source, chosen.part, chosen.channels, stored)
    return in_display_window(pixels, source, stored, area)


def size_in_areas(file: Path, layer: str = "", scanlines: ScanlineReader | None = None) -> tuple[int, int] | None:
    """The picture's (width, height) where an area of a layer is read in less time than all of it; None where not.

    Raises
    ------
    RoamError
        as `read_image` does; of the pixels only the last row is looked at, which a file that is cut short has not.
    """
    source, layers = _open(file)
    chosen = _seek(file, source, layers, layer)
    if not _has_areas(source):
        return None
    width, height = source.spec().width, source.spec().height
    last_row, channel = Area(height - 1, height, 0, width), chosen.channels[:1]
    if _scanlines(file, source, chosen.part, channel, last_row, scanlines) is None:
        _channels(file, source, chosen.part, channel, last_row)
    return display_size(source)


def read_channels(file: Path) -> Image | None:
    """The channels `(h, w, n)` of an image's display window, in the type they are stored in; None for none, or damaged.

    Of an EXR those that tell a mask (`layers.mask_channels`). Raises `RoamError` for more than `MOST_BYTES` of pixels.
    """
    source = opened_image(file)
    if source is not None and _bytes_told(source.spec()) > MOST_BYTES:
        told_of = {"file": file, "most": MOST_BYTES >> 20}
        raise RoamError(sentence("{file} holds more than {most} MiB of pixels; give a mask of one channel.", **told_of))
    told = mask_channels(_parts(source)) if source is not None and is_exr(source) else None
    part = 0 if told is None else told.part
    is_there = source is not None and source.seek_subimage(part, 0)
    pixels = source.read_image(part, 0, 0, MOST_CHANNELS, "unknown") if is_there else None
    if (source or oiio).geterror() or pixels is None:  # fetched, or it is said on the terminal later
        return None
    picked = np.asarray(pixels)
    if told is not None:
        picked = picked[..., told.colours if told.alpha is None else (*told.colours, told.alpha)]
    return in_display_window(picked, source, stored_area(source, None), None)


def has_several_images(file: Path) -> bool:
    """Whether a file holds more than one picture: the pages or frames of `_WITH_PAGES`; False for what is no image.

    A further one of another size, such as a thumbnail, does not count.
    """
    source = opened_image(file)
    several = False
    if source is not None and source.format_name() in _WITH_PAGES:
        size = display_size(source)
        several = bool(source.seek_subimage(1, 0)) and display_size(source) == size
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
        when it is no file, larger than `measure.MAX_PIXELS` (the pixels that are stored, or the window around them), or
        a TIFF with tiles of 64-bit values, for which OpenImageIO gives others.
    """
    require_regular(file)
    require_told_size(file)
    with plain_name(file) as name:
        source = oiio.ImageInput.open(name, config or oiio.ImageSpec())
    if source is not None:
        _require_size(file, source)
        if source.spec().tile_width and source.spec().format.basetype == oiio.DOUBLE:  # see `_has_areas`
            raise RoamError(sentence("{file} has tiles of 64-bit values; save it with 32 bits.", file=file))
    return source


def _open(file: Path) -> tuple[Any, tuple[ImageLayer, ...]]:
    """OpenImageIO's reader of a file, and the layers that it holds."""
    # Without this OpenImageIO multiplies PNG colour by its alpha, and rounds it to 8 bits again.
    as_stored = oiio.ImageSpec()
    as_stored.attribute("oiio:UnassociatedAlpha", 1)
    source = opened_image(file, as_stored)
    if source is None:
        raise RoamError(
            sentence(
                "{file} is no image that can be read ({reason}); replace it or take it out of the plate.",
                file=file,
                reason=_reason(oiio),
            )
        )
    layers = layers_of(_parts(source))
    if not layers:
        raise RoamError(sentence("{file} holds deep pixels and no picture; flatten it to one.", file=file))
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
        if not is_exr(source):
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
        told = {"file": file, "name": name, "layers": listed(layers)}
        raise RoamError(sentence("{file} has no layer {name!r}; it has {layers}.", **told))
    chosen = named[name] if name else colour_layer(layers)
    if not source.seek_subimage(chosen.part, 0):
        raise _damaged(file, source)
    _require_size(file, source)
    return chosen


def _scanlines(
    file: Path, source: Any, part: int, channels: Sequence[int], area: Area, scanlines: ScanlineReader | None
) -> Image | None:
    """Channels of an area of what is stored, `(rows, columns, n)`; None where they are no scanlines that are given."""
    spec, kind = source.spec(), _kind(source)
    if scanlines is None or not is_exr(source) or part != 0 or spec.tile_width or area.is_empty:
        return None
    if any(spec.channelformat(channel).basetype not in (oiio.HALF, oiio.FLOAT) for channel in channels):
        return None
    return scanlines.read(file, spec, [spec.channelnames[channel] for channel in channels], kind, area)


def _channels(file: Path, source: Any, part: int, channels: Sequence[int], area: Area) -> Image:
    """Channels of an area of what is stored, `(rows, columns, n)`."""
    first, end = min(channels), max(channels) + 1
    if end - first > WIDEST_SPAN:  # what lies between is not read: it may be a thousand channels
        return np.dstack([_pixels(file, source, part, (channel, channel + 1), area) for channel in channels])
    pixels = _pixels(file, source, part, (first, end), area)
    picked = [channel - first for channel in channels]
    return pixels if picked == list(range(end - first)) else np.ascontiguousarray(pixels[..., picked])


def _pixels(file: Path, source: Any, part: int, channels: tuple[int, int], area: Area) -> Image:
    """The channels from the first to before the second of an area of what is stored, `(rows, columns, n)`."""
    spec, kind = source.spec(), _kind(source)
    top = left = 0
    if area.is_empty:
        return np.zeros((area.rows, area.columns, channels[1] - channels[0]), _TYPES[kind])
    if area == all_of(spec) or not _has_areas(source):
        pixels = source.read_image(part, 0, *channels, kind)
    elif spec.tile_height:
        top, end = _whole_tiles(area.top, area.end, spec.tile_height, spec.height)
        left, right = _whole_tiles(area.left, area.right, spec.tile_width, spec.width)
        box = spec.x + left, spec.x + right, spec.y + top, spec.y + end
        pixels = source.read_tiles(part, 0, *box, 0, 1, *channels, kind)
    else:
        top = area.top
        pixels = source.read_scanlines(part, 0, spec.y + top, spec.y + area.end, 0, *channels, kind)
    # A JPEG that is cut short still gives pixels (grey below the cut) beside its error.
    if pixels is None or source.has_error:
        raise _damaged(file, source)
    return area.cut_from(np.asarray(pixels), top, left)


def _has_areas(source: Any) -> bool:
    """Whether an area is read without what lies before it.

    Of a TIFF with 64-bit values it is not: for rows that begin within a strip OpenImageIO gives others.
    """
    return source.format_name() in _WITH_AREAS and source.spec().format.basetype != oiio.DOUBLE


def _whole_tiles(low: int, high: int, side: int, most: int) -> tuple[int, int]:
    """From the least multiple of `side` to the one, or the edge at `most`, that hold all from `low` to `high`."""
    return low - low % side, min(high + -high % side, most)


def _damaged(file: Path, source: Any) -> RoamError:
    return RoamError(
        sentence(
            "{file} cannot be read; it is damaged or cut short ({reason}). Render it again.",
            file=file,
            reason=_reason(source),
        )
    )


def _kind(source: Any) -> str:
    """The type that the pixels are read as: the smallest of four that holds them."""
    return _KINDS.get(source.spec().format.basetype, "float")


def _require_size(file: Path, source: Any) -> None:
    """Refuse what is too large: the pixels of a part, or its picture."""
    require_size(file, source.spec().width, source.spec().height)
    require_size(file, *display_size(source))


def _bytes_told(spec: Any) -> int:
    return int(max(spec.image_pixels(), spec.full_width * spec.full_height) * spec.pixel_bytes())


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
        if rate := _number(value, *SPEEDS, 0.0):
            return rate
    return USUAL_SPEED


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
    is_float = spec.format.basetype in (oiio.HALF, oiio.FLOAT, oiio.DOUBLE)
    says_itself = source.format_name() != "pnm" or not is_float  # OpenImageIO says sRGB of a PFM, which says nothing
    if space := space_by_rule(file) or (_said_space(spec) if says_itself else None):
        return space
    if is_float:
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
    told = ""
    with suppress(UnicodeDecodeError):  # the message quotes bytes of the damaged file
        told = " ".join(speaker.geterror().split())
    return told or sentence("no reason given")
