"""What an element of SVG says of itself: its name, mode, opacity, whether it is locked, and whether it shows."""

from __future__ import annotations

import re
from collections.abc import Mapping
from itertools import islice
from xml.etree.ElementTree import Element

from roam_core.interchange.svg.words import INSENSITIVE, LABEL, numbers, paint_share
from roam_core.interchange.xml import local_name
from roam_core.roto import BlendMode

CONDITIONS = ("requiredExtensions", "systemLanguage")
"""What a child of a `switch` may ask for."""


def name_of(element: Element, default: str) -> str:
    """What an element is called, or its kind."""
    own = own_name(element)
    return default[:1].upper() + default[1:] if own is None else own


def own_name(element: Element) -> str | None:
    """What an element is called, where it says so: by a label, a `data-name`, a title, or its id."""
    if (label := element.get(LABEL)) is not None:
        return label
    title = next((child.text for child in element if local_name(child) == "title" and child.text), None)
    if (told := element.get("data-name") or title) is not None:
        return told
    key = element.get("id")
    return None if not key else re.sub(r"_x([0-9A-Fa-f]{2})_", lambda found: chr(int(found.group(1), 16)), key)


def blend_of(element: Element) -> BlendMode:
    """How one of ours joins what lies under it; others lie on top."""
    blend = element.get("data-roam-blend", "add")
    return BlendMode(blend) if blend in list(BlendMode) else BlendMode.ADD


def share_of(style: Mapping[str, str], word: str) -> float:
    """An opacity, in [0, 1]; 1 where there is none."""
    text = style.get(word, "")
    values = numbers(text)
    return min(max(values[0] / (100.0 if "%" in text else 1.0), 0.0), 1.0) if values else 1.0


def fill_share(style: Mapping[str, str]) -> float:
    """How opaque an outline is painted within, in [0, 1]."""
    return share_of(style, "fill-opacity") * paint_share(style.get("fill", ""))


def is_painted(style: Mapping[str, str]) -> bool:
    """Whether anything is seen of an outline; many drawings hold a frame around all of which nothing is."""
    return paint_share(style.get("fill", "")) > 0.0 or paint_share(style.get("stroke", "none")) > 0.0


def is_locked(element: Element) -> bool:
    """Whether it is locked, in our words or in Inkscape's."""
    return "true" in (element.get("data-roam-locked"), element.get(INSENSITIVE))


def is_shown(style: Mapping[str, str], is_drawn: bool) -> bool:
    """Whether an element shows; a group that is not to be seen may hold what is."""
    hidden = is_drawn and style.get("visibility") in ("hidden", "collapse")
    return style.get("display") != "none" and not hidden


def taken_of_switch(switch: Element) -> list[Element]:
    """The one child of a `switch` that is drawn: the first that asks for nothing which a plain renderer has not."""
    drawn = (child for child in switch if isinstance(child.tag, str) and not any(map(child.get, CONDITIONS)))
    return list(islice(drawn, 1))
