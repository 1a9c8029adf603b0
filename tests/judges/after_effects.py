"""After Effects as a judge: Node runs the script against objects that remember, and what they hold is composited.

Masks of a layer join from the first to the last as the vendor's help describes their modes; layers of a composition
blend by the formulas of the W3C for the modes of the same names.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from roam_core.arrays import Array
from tests.judges.coverage import filled, filled_polygon, polyline, soft, union
from tests.unit.interchange.node_judge import mask_of, ran

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
            held = mask["properties"]
            width, offset = (self._value(held[f"ADBE Mask {name}"], moment) for name in ("Feather", "Offset"))
            opacity = self._value(held["ADBE Mask Opacity"], moment)
            points = judged.points(moment)
            soft_width = float(np.ravel(width)[0])
            place = (offset - soft_width / 2.0, offset + soft_width / 2.0)
            radii = self._radii(held["ADBE Mask Shape"], moment)
            if radii is not None:
                assert not soft_width, "no judge of feather points and a uniform feather"
                own = squared(points, radii, size)
            else:
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

    def _radii(self, path: dict[str, Any], moment: float) -> Array | None:
        """How far the feather points of a path lie outside of its points."""
        if all(not any(key["value"].get("featherRadii", [])) for key in path["keys"]):
            return None
        keys = [{**key, "value": key["value"]["featherRadii"]} for key in path["keys"]]
        return np.asarray(self._value({"keys": keys}, moment), dtype=np.float64)

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


def squared(points: Array, radii: Array, size: tuple[int, int]) -> Array:
    """The mean coverage of all outlines between an outline and the line square to it at distances that go evenly from
    point to point; outside positive."""
    line = polyline(points)
    following = np.roll(line, -1, axis=0)
    along = following - np.roll(line, 1, axis=0)
    area = (line[:, 0] * following[:, 1] - following[:, 0] * line[:, 1]).sum()
    square = np.stack([along[:, 1], -along[:, 0]], axis=1) * np.sign(area)
    square /= np.maximum(np.hypot(square[:, 0], square[:, 1]), 1e-12)[:, None]
    wide = np.interp(np.arange(len(line)) * len(points) / len(line), np.arange(len(points) + 1), [*radii, radii[0]])
    shares = (np.arange(48) + 0.5) / 48
    return np.asarray(np.mean([filled_polygon(line + s * wide[:, None] * square, size) for s in shares], axis=0))


def matte(text: str, folder: Path, fps: float, frame: float, size: tuple[int, int]) -> Array:
    """The matte `(h, w)` that a script for After Effects makes at one frame."""
    return Scene(text, folder, fps).matte(frame, size)
