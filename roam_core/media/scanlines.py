"""Scanlines of EXR files by OpenEXR's own library, which inflates them in half the time that OpenImageIO takes.

For processes that do nothing else (`roam_core.media.decoding.worker`): its binding holds the interpreter's lock while
it decodes, and says on the terminal what is wrong with a file.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import Imath
import numpy as np
import OpenEXR

from roam_core.arrays import Image
from roam_core.media.area import Area
from roam_core.media.measure import plain_name

ROWS_AT_ONCE = 32
"""Rows that are decoded together: whole chunks of most compressions, and their planes stay in the processor's cache."""
MOST_IN_A_CHUNK = 256
"""Rows in a chunk of the compressions that are not among `SMALL_CHUNKS`; each read decodes whole chunks."""
SMALL_CHUNKS = frozenset({"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa"})
"""Compressions whose chunks have at most `ROWS_AT_ONCE` rows."""
MOST_LOST = 1 << 28
"""Bytes that a reader may lose: the binding does not give back the memory of what it could not decode."""

_KINDS = {
    "half": (Imath.PixelType(Imath.PixelType.HALF), np.float16),
    "float": (Imath.PixelType(Imath.PixelType.FLOAT), np.float32),
}


class ScanlineReader:
    """Reads areas of the first part of EXR files."""

    def __init__(self) -> None:
        self._lost = 0

    def read(self, file: Path, spec: Any, channels: Sequence[str], kind: str, area: Area) -> Image | None:
        """An area `(rows, columns, n)` of some channels as they are stored; None where OpenEXR does not give it.

        Parameters
        ----------
        spec : OpenImageIO's of the part. channels : their names, n of them. kind : `half` or `float`.
        area : of the data window, with at least a pixel.
        """
        # The binding takes names in UTF-8 alone, and one buffer for each.
        names = [name for name in dict.fromkeys(channels) if name.isprintable()]
        if self._lost > MOST_LOST or not set(channels) <= set(names):
            return None
        kind_there, kind_here = _KINDS[kind]
        pixels = np.empty((area.rows, area.columns, len(channels)), kind_here)
        try:
            with plain_name(file) as path:
                opened = OpenEXR.InputFile(path)
        except (OSError, TypeError):
            return None
        try:
            for top, end in _strips(area, spec.get_string_attribute("compression")):
                lost = (end - top) * spec.width * len(names) * pixels.itemsize
                rows = spec.y + top, spec.y + end - 1
                planes = dict(zip(names, opened.channels(names, kind_there, *rows), strict=True))
                lost = 0
                for place, name in enumerate(channels):
                    plane = np.frombuffer(planes[name], kind_here).reshape(end - top, spec.width)
                    pixels[top - area.top : end - area.top, :, place] = plane[:, area.left : area.right]
        except (OSError, TypeError, ValueError):
            self._lost += lost
            return None
        finally:
            opened.close()
        return pixels


def _strips(area: Area, compression: str) -> Iterator[tuple[int, int]]:
    """The first row and that after the last of strips, within an area, that begin and end where chunks do."""
    step = ROWS_AT_ONCE if compression in SMALL_CHUNKS else MOST_IN_A_CHUNK
    for top in range(area.top - area.top % step, area.end, step):
        yield max(top, area.top), min(top + step, area.end)
