"""Fusion as a judge: Lua evaluates a setting, and its masks are joined by the paint modes of the vendor's manual."""

from __future__ import annotations

from typing import Any

import numpy as np

from roam_core.arrays import Array
from tests.judges.coverage import filled, soft, union
from tests.unit.interchange.lua_judge import evaluated, keys_of, mask_of

PAINT_MODES = {
    "Merge": union,
    "Add": lambda under, own: np.minimum(under + own, 1.0),
    "Subtract": lambda under, own: np.maximum(under - own, 0.0),
    "Minimum": np.minimum,
    "Maximum": np.maximum,
    "Multiply": lambda under, own: under * own,
    "Invert": lambda under, own: under * (1.0 - own) + (1.0 - under) * own,
}
"""How a mask joins the one of its effect mask input; grey areas of the new one invert in part."""


class Flow:
    """The tools of a setting; one of its masks is used by none of the others."""

    def __init__(self, text: str) -> None:
        self.tools = evaluated(text)
        links = [made.get("SourceOp") for tool in self.tools.values() for made in tool.get("Inputs", {}).values()]
        masks = [name for name, tool in self.tools.items() if tool["kind"] in ("PolylineMask", "BitmapMask")]
        self.last = [name for name in masks if name not in links and self._shows(name)]
        assert len(self.last) <= 1, self.last

    def matte(self, frame: float, size: tuple[int, int]) -> Array:
        """The mask `(h, w)` at the end of the chain."""
        return self._mask(self.last[0], frame, size) if self.last else np.zeros(size)

    def _shows(self, name: str) -> bool:
        tool = self.tools[name]
        if "PassThrough" in tool:
            return False
        return tool["kind"] == "BitmapMask" or mask_of(name, tool, self.tools).closed

    def _mask(self, name: str, frame: float, size: tuple[int, int]) -> Array:
        tool = self.tools[name]
        inputs = tool["Inputs"]
        values = {key: made.get("Value") for key, made in inputs.items()}
        assert (values["MaskHeight"], values["MaskWidth"]) == size
        own = self._polygon(name, frame, size) if tool["kind"] == "PolylineMask" else self._bitmap(tool, frame, size)
        level = self._number("Level", tool, frame, 1.0)
        if values["Invert"]:
            assert "Level" not in inputs, "which comes first, Invert or Level, is not documented"
            own = 1.0 - own
        own = own * level
        below = inputs.get("EffectMask")
        if below is None:
            return own
        assert below["Source"] == "Mask"
        return PAINT_MODES[values["PaintMode"][1]](self._mask(below["SourceOp"], frame, size), own)

    def _polygon(self, name: str, frame: float, size: tuple[int, int]) -> Array:
        tool = self.tools[name]
        points = mask_of(name, tool, self.tools).points(frame)
        width = self._number("SoftEdge", tool, frame, 0.0) * size[1]
        border = self._number("BorderWidth", tool, frame, 0.0) * size[1]
        return soft(points, size, border - width / 2.0, border + width / 2.0) if width else filled(points, size)

    def _bitmap(self, tool: dict[str, Any], frame: float, size: tuple[int, int]) -> Array:
        assert tool["Inputs"]["Channel"]["Value"][1] == "Alpha"
        picture = self.tools[tool["Inputs"]["Image"]["SourceOp"]]
        assert picture["kind"] == "Background"
        assert (picture["Inputs"]["Height"]["Value"], picture["Inputs"]["Width"]["Value"]) == size
        assert picture["Inputs"]["TopLeftAlpha"]["Value"] == 1
        return self._mask(picture["Inputs"]["EffectMask"]["SourceOp"], frame, size)

    def _number(self, name: str, tool: dict[str, Any], frame: float, standard: float) -> float:
        keys = keys_of(name, tool, self.tools)
        if not keys:
            return float(tool["Inputs"].get(name, {}).get("Value", standard))
        frames = sorted(keys)
        return float(np.interp(frame, frames, [keys[each] for each in frames]))


def matte(text: str, frame: float, size: tuple[int, int]) -> Array:
    """The matte `(h, w)` of a setting at one frame."""
    return Flow(text).matte(frame, size)
