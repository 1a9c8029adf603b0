"""Cryptomatte: one EXR file a frame, in which every pixel tells what covers it, and how much of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
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

BAND = 64
"""Rows that are worked out at once, a multiple of the sixteen that are packed together: 28 channels of all of a large
picture would fill the memory."""

PREVIEW = ("R", "G", "B")

Numbered = tuple[np.float32, list[Patch]]
"""The number of a name, and what is seen of it."""


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
            pixels = _pixels(ranked, joint[band, columns])
            if not output.write_scanlines(band.start, band.stop, 0, pixels):
                return False
        return True

    write_atomically(path, encoded(path, spec, style, write))
    return has_more


def _channels(manifest: Manifest) -> list[str]:
    """Those of pairs of a number and its coverage, two pairs a layer."""
    return [f"{manifest.name}{layer:02d}.{channel}" for layer in range(RANKS // 2) for channel in "RGBA"]


def _numbered(manifest: Manifest, shares: Sequence[Visible]) -> list[Numbered]:
    """What is seen of each thing that the manifest names."""
    found: dict[str, list[Patch]] = {}
    for share in shares:
        found.setdefault((share.layer if manifest.name == BY_LAYER else share.item).id, []).append(share.patch)
    return [(manifest.number(own), patches) for own, patches in found.items()]


def _in_band(patches: Sequence[Patch], rows: slice, columns: slice) -> Patch:
    """The sum of patches in a part of the picture, told from that part's corner."""
    seen = [part for patch in patches if (part := patch.seen_in(rows, columns)).values.any()]
    if len(seen) < 2:
        return replace(seen[0], values=seen[0].values.copy()) if seen else Patch(0, 0, np.zeros((0, 0), np.float32))
    whole = Patch(0, 0, np.zeros((rows.stop - rows.start, columns.stop - columns.start), dtype=np.float32))
    for part in seen:
        whole.values[part.place] += part.values
    return whole


def _ranked(parts: Sequence[Numbered], rows: slice, columns: slice) -> tuple[Float32, Float32, bool]:
    """Numbers and coverages `(RANKS, h, w)` of a part of the picture, the greatest coverage first.

    Of equal coverages the lower one in the project comes first. Where nothing is both are 0.
    Last comes whether something had no room.
    """
    shape = (RANKS, rows.stop - rows.start, columns.stop - columns.start)
    numbers, coverages = np.zeros(shape, dtype=np.float32), np.zeros(shape, dtype=np.float32)
    has_more = False
    for number, patches in parts:
        seen = _in_band(patches, rows, columns)
        coverage, told = seen.values, np.full(seen.values.shape, number, dtype=np.float32)
        more = np.zeros(coverage.shape, dtype=bool)
        for rank in range(RANKS):
            there = (rank, *seen.place)
            more |= coverage > coverages[there]  # what gave way goes on one rank below, before its equals
            if not more.any():
                continue
            for own, theirs in ((coverage, coverages[there]), (told, numbers[there])):
                own[more], theirs[more] = theirs[more], own[more]
        has_more = has_more or bool(coverage.any())
    return numbers, coverages, has_more


def _pixels(ranked: Sequence[tuple[Float32, Float32, bool]], joint: Matte) -> Float32:
    """The channels `(h, w, C)` of a part of the picture, in the order of the file; most of the ranks are empty."""
    first = len(PREVIEW) + 1
    pixels = np.zeros((*joint.shape, first + 2 * RANKS * len(ranked)), dtype=np.float32)
    pixels[..., first - 1] = joint
    for k, (numbers, coverages, _) in enumerate(ranked):
        for rank in range(RANKS):
            if not coverages[rank].any():
                break
            place = first + 2 * (RANKS * k + rank)
            pixels[..., place], pixels[..., place + 1] = numbers[rank], coverages[rank]
    for channel, colour in enumerate(_preview(*ranked[0][:2])):
        pixels[..., channel] = colour
    return pixels


def _preview(numbers: Float32, coverages: Float32) -> Float32:
    """Colours `(3, h, w)` by the last bits of the numbers, as much of each as it covers."""
    colours = np.zeros((len(PREVIEW), *numbers.shape[1:]), dtype=np.float32)
    for number, coverage in zip(numbers, coverages, strict=True):
        if not coverage.any():
            break
        bits = number.view(np.uint32)
        for k, colour in enumerate(colours):
            colour += (bits >> np.uint32(8 * k) & np.uint32(0xFF)) * (coverage * np.float32(1.0 / 0xFF))
    return colours
