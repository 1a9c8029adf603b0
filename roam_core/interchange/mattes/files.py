"""Mattes as PNG, TIFF and EXR files, each of which appears under its name only when it is whole."""

from __future__ import annotations

import json
import os
import struct
import zlib
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import OpenImageIO as oiio  # noqa: N813

from roam_core.atomic_write import write_atomically
from roam_core.errors import RoamError
from roam_core.interchange.authorship import SOFTWARE
from roam_core.interchange.matte_style import DataWindow, Depth, MatteFile, MatteStyle
from roam_core.interchange.mattes.timecode import Moment
from roam_core.matte import Matte, Patch
from roam_core.temporary import working_folder
from roam_core.translatable import sentence

LEVELS: dict[int, type[np.unsignedinteger[Any]]] = {8: np.uint8, 16: np.uint16}
KINDS = {Depth.BITS_8: oiio.UINT8, Depth.BITS_16: oiio.UINT16, Depth.HALF: oiio.HALF, Depth.FLOAT: oiio.FLOAT}
PNG_HEADER = 33
"""Bytes of a PNG's signature and first chunk, after which texts may stand."""
JOINT = "A"
"""Channel of the joint matte: alpha."""

NAMES = "roam:names"
"""Attribute of a file with channels: the names of the layers or shapes, as a JSON object by channel."""


def write_picture(
    path: Path,
    channels: Mapping[str, Patch],
    size: tuple[int, int],
    style: MatteStyle,
    aspect: float,
    names: Mapping[str, str],
    moment: Moment | None = None,
) -> None:
    """Write mattes by channel, of pictures of `size` (h, w), to one file in the style that is asked for.

    `aspect` is the pixels'; `names` are those of layers and shapes by channel, kept in the file where it can hold them;
    `moment` is the frame's, for EXR files, which hold the rate and the time code.
    Raises `RoamError` when the file cannot be written.
    """
    if style.file is MatteFile.PNG:
        (patch,) = channels.values()
        write_atomically(path, encode_png(patch.whole(size), int(style.depth_or_own)))
        return
    pixels, spec = _pixels(channels, size, style)
    mark(spec, style, aspect, moment)
    if names:
        spec.attribute(NAMES, json.dumps(dict(names), ensure_ascii=True))
    whole = np.ascontiguousarray(pixels)
    write_atomically(path, encoded(path, spec, style, lambda output: bool(output.write_image(whole))))


def encode_png(matte: Matte, bits: int = 8) -> bytes:
    """A matte `(h, w)` in [0, 1] as a grey PNG, rounded to the nearest of its 256 or 65536 levels, with our mark."""
    if bits not in LEVELS:
        raise RoamError(sentence("Mattes have 8 or 16 bits, not {bits}.", bits=bits))
    written, buffer = cv2.imencode(".png", quantised(matte, bits))
    if not written:
        raise RoamError(
            sentence(
                "A matte of {width} x {height} pixels cannot be encoded as PNG.",
                width=matte.shape[1],
                height=matte.shape[0],
            )
        )
    return signed_png(buffer.tobytes())


def signed_png(content: bytes) -> bytes:
    """A PNG file with the text `Software: ROAM`, by which it is known again as ours."""
    text = b"tEXt" + b"Software\0" + SOFTWARE.encode()
    chunk = struct.pack(">I", len(text) - 4) + text + struct.pack(">I", zlib.crc32(text))
    return content[:PNG_HEADER] + chunk + content[PNG_HEADER:]


def quantised(matte: Matte, bits: int) -> np.ndarray[tuple[int, ...], np.dtype[np.unsignedinteger[Any]]]:
    """A matte `(h, w)` in [0, 1] as whole numbers, rounded to the nearest level."""
    white = float((1 << bits) - 1)
    return np.rint(matte.astype(np.float64) * white).astype(LEVELS[bits])


def black_border(patches: Iterable[Patch], size: tuple[int, int]) -> tuple[slice, slice]:
    """The rectangle outside of which all mattes of pictures `(h, w)` are black; one pixel where nothing is white."""
    rows, columns = np.zeros(size[0], dtype=bool), np.zeros(size[1], dtype=bool)
    for patch in patches:
        if patch.outside != 0.0:
            return slice(0, size[0]), slice(0, size[1])
        across, down = patch.place
        rows[across] |= patch.values.any(axis=1)
        columns[down] |= patch.values.any(axis=0)
    if not rows.any():
        return slice(0, 1), slice(0, 1)
    first, last = ([int(k) for k in line.nonzero()[0][[0, -1]]] for line in (rows, columns))
    return slice(first[0], first[1] + 1), slice(last[0], last[1] + 1)


def _pixels(channels: Mapping[str, Patch], size: tuple[int, int], style: MatteStyle) -> tuple[Any, Any]:
    """Pixels `(h, w, channels)` as OpenImageIO takes them, and what it is to be told about them.

    Only where a shape lies is anything written into them: twenty channels of a large picture are mostly black.
    """
    height, width = size
    depth = style.depth_or_own
    kinds: dict[Depth, Any] = {Depth.HALF: np.float16, Depth.FLOAT: np.float32}
    kinds |= {Depth.BITS_8: np.uint8, Depth.BITS_16: np.uint16}
    pixels = np.zeros((height, width, len(channels)), dtype=kinds[depth])
    for k, patch in enumerate(channels.values()):
        is_whole = depth in (Depth.BITS_8, Depth.BITS_16)
        if patch.outside:
            patch = Patch(0, 0, patch.whole(size))
        pixels[(*patch.place, k)] = quantised(patch.values, int(depth)) if is_whole else patch.values
    is_tight = style.window is DataWindow.TIGHT
    rows, columns = black_border(channels.values(), size) if is_tight else (slice(0, height), slice(0, width))
    pixels = pixels[rows, columns]
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], len(channels), KINDS[depth])
    spec.x, spec.y = columns.start, rows.start
    spec.full_x, spec.full_y, spec.full_width, spec.full_height = 0, 0, width, height
    if style.file is MatteFile.EXR:
        spec.channelnames = tuple(channels)
    return pixels, spec


def mark(spec: Any, style: MatteStyle, aspect: float, moment: Moment | None) -> None:
    """Say what every file of the style says: compression, `aspect` of the pixels, that it is ours, time of EXR."""
    spec.attribute("compression", style.compression_or_own)
    spec.attribute("PixelAspectRatio", float(aspect))
    spec.attribute("Software", SOFTWARE)
    if moment is not None and style.file is MatteFile.EXR:
        _tell_time(spec, moment)


def _tell_time(spec: Any, moment: Moment) -> None:
    """Put the rate and the time code under the names of OpenEXR's standard attributes.

    OpenImageIO translates the name of the time code alone; the other it writes letter by letter, so that its own
    spelling, `FramesPerSecond`, would be unknown to other readers.
    """
    spec.attribute("framesPerSecond", oiio.TypeRational, (moment.rate.numerator, moment.rate.denominator))
    code = moment.time_code()
    if code is not None:
        spec.attribute("smpte:TimeCode", oiio.TypeTimeCode, (code, 0))


def encoded(path: Path, spec: Any, style: MatteStyle, write: Callable[[Any], bool]) -> bytes:
    """The bytes of a file that will be `path`; `write` puts the pixels into the output, and tells if it could.

    OpenImageIO writes by name, so it does that beside the rest of the temporary files.
    Raises `RoamError` where it fails.
    """
    with working_folder("roam-matte") as folder:
        whole = folder / f"matte{style.suffix}"
        output = oiio.ImageOutput.create(str(whole))
        trouble = oiio.geterror() if output is None else ""
        if output is not None:
            is_written = output.open(str(whole), spec) and write(output)
            is_written = output.close() and is_written
            trouble = "" if is_written else output.geterror()
        if trouble or not whole.exists():
            raise RoamError(
                sentence(
                    "{path} cannot be encoded: {reason}.", path=path, reason=" ".join(trouble.split()) or os.strerror(5)
                )
            )
        return whole.read_bytes()
