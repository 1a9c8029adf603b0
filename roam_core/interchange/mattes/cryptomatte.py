"""Cryptomatte: one EXR file a frame, in which every pixel tells what covers it, and how much of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813

from roam_core.arrays import Float32, Matte
from roam_core.atomic_write import write_atomically
from roam_core.interchange.matte_style import DataWindow, MatteStyle
from roam_core.interchange.mattes.files import JOINT, black_border, encoded, mark
from roam_core.interchange.mattes.manifest import BY_LAYER, Manifest
from roam_core.interchange.mattes.timecode import Moment
from roam_core.matte import Patch
from roam_core.matte.visible import Visible

RANKS = 6
"""Shapes that a pixel can tell, in three layers of channels: what the specification suggests. Files of a sequence must
have the same number."""

BAND = 256
"""Rows that are worked out at once: sixteen channels of a large picture would fill the memory."""

PREVIEW = ("R", "G", "B")


def write_cryptomatte(
    path: Path,
    manifests: Sequence[Manifest],
    shares: Sequence[Visible],
    joint: Matte,
    style: MatteStyle,
    aspect: float,
    moment: Moment | None,
) -> bool:
    """Write what is seen of shapes and layers to one file, and the joint matte `(h, w)` as its alpha.

    `aspect` is the pixels', `moment` the frame's. R, G and B show each shape in a colour of its own, for people.

    Returns
    -------
    Whether some pixel shows more than `RANKS` of them, the least of which are left out.

    Raises
    ------
    RoamError
        when the file cannot be written.
    """
    height, width = joint.shape
    numbered = [_numbered(manifest, shares) for manifest in manifests]
    is_tight = style.window is DataWindow.TIGHT
    rows, columns = slice(0, height), slice(0, width)
    if is_tight:
        rows, columns = black_border([share.patch for share in shares], (height, width))
    channels = (*PREVIEW, JOINT, *(channel for manifest in manifests for channel in _channels(manifest)))
    spec = oiio.ImageSpec(columns.stop - columns.start, rows.stop - rows.start, len(channels), oiio.FLOAT)
    spec.x, spec.y = columns.start, rows.start
    spec.full_x, spec.full_y, spec.full_width, spec.full_height = 0, 0, width, height
    spec.channelnames = channels
    mark(spec, style, aspect, moment)
    for manifest in manifests:
        for name, value in manifest.attributes().items():
            spec.attribute(name, value)
    has_more = False

    def write(output: Any) -> bool:
        nonlocal has_more
        for start in range(rows.start, rows.stop, BAND):
            band = slice(start, min(start + BAND, rows.stop))
            ranked = [_ranked(parts, band, columns) for parts in numbered]
            has_more = has_more or any(more for _, _, more in ranked)
            pixels = np.stack(list(_pixels(ranked, joint[band, columns])), axis=-1)
            if not output.write_scanlines(band.start, band.stop, 0, pixels):
                return False
        return True

    write_atomically(path, encoded(path, spec, style, write))
    return has_more


def _channels(manifest: Manifest) -> list[str]:
    """Those of pairs of a number and its coverage, two pairs a layer."""
    return [f"{manifest.name}{layer:02d}.{channel}" for layer in range(RANKS // 2) for channel in "RGBA"]


def _numbered(manifest: Manifest, shares: Sequence[Visible]) -> list[tuple[np.float32, Patch]]:
    """What is seen of each thing that the manifest names."""
    if manifest.name != BY_LAYER:
        return [(manifest.number(share.item.id), share.patch) for share in shares]
    by_layer: dict[str, list[Patch]] = {}
    for share in shares:
        by_layer.setdefault(share.layer.id, []).append(share.patch)
    return [(manifest.number(layer), _sum(patches)) for layer, patches in by_layer.items()]


def _sum(patches: Sequence[Patch]) -> Patch:
    """Patches that are black beside their values, added up."""
    if len(patches) == 1:
        return patches[0]
    top, left = (min(patch.place[axis].start for patch in patches) for axis in (0, 1))
    bottom, right = (max(patch.place[axis].stop for patch in patches) for axis in (0, 1))
    total = Patch(top, left, np.zeros((bottom - top, right - left), dtype=np.float32))
    for patch in patches:
        seen = total.seen_in(*patch.place)
        np.add(seen.values, patch.values, out=seen.values)
    return total


def _ranked(parts: Sequence[tuple[np.float32, Patch]], rows: slice, columns: slice) -> tuple[Float32, Float32, bool]:
    """Numbers and coverages `(RANKS, h, w)` of a part of the picture, the greatest coverage first.

    Of equal coverages the lower one in the project comes first. Where nothing is both are 0.
    Last comes whether something had no room.
    """
    shape = (RANKS, rows.stop - rows.start, columns.stop - columns.start)
    numbers, coverages = np.zeros(shape, dtype=np.float32), np.zeros(shape, dtype=np.float32)
    has_more = False
    for number, patch in parts:
        seen = patch.seen_in(rows, columns)
        coverage, told = seen.values.copy(), np.full(seen.values.shape, number, dtype=np.float32)
        for rank in range(RANKS):
            there = (rank, *seen.place)
            more = coverage > coverages[there]
            if not more.any():
                continue
            for own, theirs in ((coverage, coverages[there]), (told, numbers[there])):
                own[more], theirs[more] = theirs[more], own[more]
        has_more = has_more or bool(coverage.any())
    return numbers, coverages, has_more


def _pixels(ranked: Sequence[tuple[Float32, Float32, bool]], joint: Matte) -> Iterator[Matte]:
    """The channels of a part of the picture, in the order of the file."""
    numbers, coverages, _ = ranked[0]
    bits = numbers.view(np.uint32)
    for k in range(len(PREVIEW)):
        yield ((bits >> np.uint32(8 * k) & np.uint32(0xFF)) / np.float32(0xFF) * coverages).sum(
            axis=0, dtype=np.float32
        )
    yield joint
    for numbers, coverages, _ in ranked:
        for rank in range(RANKS):
            yield numbers[rank]
            yield coverages[rank]
