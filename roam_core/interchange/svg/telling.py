"""What is told of a drawing as a whole, and how parts of it are called."""

from __future__ import annotations

import re
from xml.etree.ElementTree import Element

import numpy as np

from roam_core.interchange.reading import brief
from roam_core.interchange.svg.outlines import Box
from roam_core.translatable import sentence

PHYSICAL = re.compile(r"[\s\d.eE+-]+(?:mm|cm|in|pt|pc|q)\s*", re.IGNORECASE)


def size_note(root: Element, size: Box, box: Box, clip: tuple[int, int]) -> str:
    """A sentence where a drawing is fitted to another size; "" where its units are the clip's pixels."""
    ratio = np.array(clip) / np.array(size)
    is_even = abs(ratio[0] / ratio[1] - 1.0) < 1e-3
    if np.abs(np.subtract(clip, size)).max() < 0.01 or (is_even and np.abs(np.subtract(clip, box)).max() < 0.01):
        return ""
    wide, high = ((root.get(word) or "").strip()[:20] for word in ("width", "height"))
    if PHYSICAL.fullmatch(wide) and PHYSICAL.fullmatch(high):
        sides = {"wide": wide, "high": high, "clip_width": clip[0], "clip_height": clip[1]}
        if is_even:
            return sentence(
                "The drawing measures {wide} x {high}: it was fitted to the clip's {clip_width} x {clip_height} "
                "pixels.",
                **sides,
            )
        return sentence(
            "The drawing measures {wide} x {high}: it was fitted to the clip's {clip_width} x {clip_height} pixels, "
            "each axis by its own ratio.",
            **sides,
        )
    numbers = {"width": size[0], "height": size[1], "clip_width": clip[0], "clip_height": clip[1]}
    if is_even:
        return sentence(
            "The file speaks of pictures of {width:g} x {height:g} pixels, the clip has {clip_width} x {clip_height}: "
            "the shapes were scaled.",
            **numbers,
        )
    return sentence(
        "The file speaks of pictures of {width:g} x {height:g} pixels, the clip has {clip_width} x {clip_height}: "
        "the shapes were scaled, each axis by its own ratio.",
        **numbers,
    )


def cut_of(what: str, name: str) -> str:
    """What cuts an element, as a sentence calls it."""
    return sentence("'the {what} of {name}'", what=what, name=brief(name)[1:-1])
