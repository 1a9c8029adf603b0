"""After Effects as a judge: Node runs the script against objects that remember, and what they hold is composited.

Masks of a layer join from the first to the last as the vendor's help describes their modes; layers of a composition
blend by the formulas of the W3C for the modes of the same names.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.judges.coverage import filled, soft, union
from tests.unit.interchange.node_judge import mask_of, ran

Array = NDArray[np.float64]

BLENDS = {
    "normal": lambda under, above: above,
    "screen": union,
    "difference": lambda under, above: np.abs(under - above),
    "lighten": np.maximum,
    "multiply": lambda under, above: under * above,
    "add": lambda under, above: np.minimum(under + above, 1.0),
}


class Scene:
    """What a script made in an empty project; one composition, whose lowest layer is the one with the matte."""

    def __init__(self, text: str, folder: Path, fps: float) -> None:
        self.made = ran(text, folder)
        self.fps = fps

    def matte(self, frame: float, size: tuple[int, int]) -> Array:
        """The alpha `(h, w)` of the layer at a frame as the composition numbers it."""
        return self._shown(self.made["scene"], frame - self.made["comp"]["displayStartFrame"], size)[1]

    def _shown(self, layer: dict[str, Any], moment: float, size: tuple[int, int]) -> tuple[Array, Array]:
        """Grey and alpha of a layer, `moment` frames after its composition's start."""
        if layer.get("comp"):
            grey, alpha = self._comp(layer["comp"], moment, size)
        else:
            grey, alpha = np.full(size, float(layer["grey"])), self._masks(layer["masks"], moment, size)
        opacity = layer["transform"].get("ADBE Opacity")
        if opacity is not None:
            alpha = alpha * self._value(opacity, moment) / 100.0
        if layer.get("matte"):
            matte = layer["matte"]
            assert (matte["kind"], matte["enabled"], matte["parent"]) == ("luma", False, layer["name"])
            light, cover = self._shown(matte, moment, size)
            alpha = alpha * light * cover
        return grey, alpha

    def _comp(self, comp: dict[str, Any], moment: float, size: tuple[int, int]) -> tuple[Array, Array]:
        assert (comp["height"], comp["width"]) == size
        light, cover = np.zeros(size), np.zeros(size)
        for layer in comp["layers"]:
            grey, alpha = self._shown(layer, moment, size)
            under = np.divide(light, cover, out=np.zeros(size), where=cover > 0.0)
            blended = (1.0 - cover) * grey + cover * BLENDS[layer["blendingMode"]](under, grey)
            light, cover = (1.0 - alpha) * light + alpha * blended, union(cover, alpha)
        return np.divide(light, cover, out=np.zeros(size), where=cover > 0.0), cover

    def _masks(self, masks: list[dict[str, Any]], moment: float, size: tuple[int, int]) -> Array:
        joint: Array | None = None
        for mask in masks:
            judged = mask_of(mask, self.fps, 0, 0.0)
            mode = mask["mode"]
            if mode == "none" or not judged.closed:
                continue
            width, offset, opacity = (
                self._value(mask["properties"][f"ADBE Mask {name}"], moment)
                for name in ("Feather", "Offset", "Opacity")
            )
            points = judged.points(moment)
            soft_width = float(np.ravel(width)[0])
            place = (offset - soft_width / 2.0, offset + soft_width / 2.0)
            own = soft(points, size, *place) if soft_width else filled(points, size)
            own = (1.0 - own if mask["inverted"] else own) * opacity / 100.0
            if joint is None:
                assert mode in ("add", "subtract"), f"what {mode} does as the first mode is not documented"
                joint = np.zeros(size) if mode == "add" else np.ones(size)
            joint = {
                "add": union(joint, own),
                "subtract": joint * (1.0 - own),
                "intersect": joint * own,
                "difference": np.abs(joint - own),
                "lighten": np.maximum(joint, own),
            }[mode]
        return np.ones(size) if joint is None else joint

    def _value(self, held: dict[str, Any], moment: float) -> Any:
        """A property's value: straight from key to key, but for those that hold."""
        keys = held["keys"]
        if not keys:
            return held["value"]
        times = [key["time"] * self.fps for key in keys]
        index = max((k for k, time in enumerate(times) if time <= moment + 1e-6), default=0)
        before, after = keys[index], keys[min(index + 1, len(keys) - 1)]
        if moment <= times[index] or after is before or before["types"][1] == "hold":
            return before["value"]
        u = (moment - times[index]) / (times[index + 1] - times[index])
        return (1.0 - u) * np.array(before["value"]) + u * np.array(after["value"])


def matte(text: str, folder: Path, fps: float, frame: float, size: tuple[int, int]) -> Array:
    """The matte `(h, w)` that a script for After Effects makes at one frame."""
    return Scene(text, folder, fps).matte(frame, size)
