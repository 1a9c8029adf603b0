"""Blender's masks as ROAM's shapes: positions in pixels with y down, keys where an outline does not move straight."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np

from . import roam_bridge

MODES = {
    "MERGE_ADD": "add",
    "ADD": "plus",
    "MERGE_SUBTRACT": "subtract",
    "SUBTRACT": "subtract",
    "MUL": "intersect",
    "DIFFERENCE": "difference",
    "LIGHTEN": "max",
}
LONGEST = 8.0
"""Distances that a point moves at most, where its outline turns sharply."""
HOLD = "roam_mask"
"""A property of the scene that holds the mask meanwhile: Blender moves only masks that something in it refers to."""


def clip_of(context: Any) -> Any:
    """The movie clip that is worked on: that of the editor, of the scene, or the only one."""
    clip = getattr(context.space_data, "clip", None) or context.scene.active_clip
    if clip is None and len(bpy.data.movieclips) == 1:
        clip = bpy.data.movieclips[0]
    if clip is None:
        raise roam_bridge.Trouble("Open the plate as a movie clip, and make it the scene's active clip.")
    return clip


def offset_of(clip: Any, path: str, chosen: str) -> int:
    """What the scene's frame numbers have more than the plate's own.

    For Blender a sequence begins with the picture that was opened, for ROAM with the first that lies there.
    """
    number = roam_bridge.frame_of_file if clip.source == "SEQUENCE" else roam_bridge.first_frame
    start: int = clip.frame_start - clip.frame_offset - number(path, chosen)
    return start


def frames_of(clip: Any) -> range:
    """The scene's frames that show the clip. (A mask's own range is 1 to 100 until somebody sets it.)"""
    return range(clip.frame_start, clip.frame_start + max(clip.frame_duration, 1))


def shapes_of(scene: Any, mask: Any, size: tuple[int, int], frames: range) -> list[dict[str, Any]]:
    """The shapes of a mask as ROAM's JSON has them, bottom first."""
    splines = [(layer, spline) for layer in mask.layers for spline in layer.splines if len(spline.points) > 1]
    rows: list[dict[int, list[list[float]]]] = [{} for _ in splines]
    opacities: list[dict[int, float]] = [{} for _ in splines]
    widths: list[list[float]] = [[] for _ in splines]
    current = scene.frame_current
    scene[HOLD] = mask
    try:
        for frame in frames:
            scene.frame_set(frame)
            for index, (layer, spline) in enumerate(splines):
                rows[index][frame] = [_row(point, size) for point in spline.points]
                opacities[index][frame] = layer.alpha
                if frame == frames[0]:
                    widths[index] = [point.weight * max(size) for point in spline.points]
    finally:
        del scene[HOLD]
        scene.frame_set(current)
    pairs = zip(splines, zip(rows, opacities, widths))  # noqa: B905 - also for Python 3.9
    return [_shape(layer, spline, *read, size) for (layer, spline), read in pairs]


def _shape(
    layer: Any,
    spline: Any,
    rows: dict[int, list[list[float]]],
    alphas: dict[int, float],
    widths: list[float],
    size: tuple[int, int],
) -> dict[str, Any]:
    if spline.use_cyclic and not any(widths):
        rows = {frame: outset(points, size) for frame, points in rows.items()}
    points = roam_bridge.keys_of(rows)
    levels = roam_bridge.keys_of({frame: [[alpha]] for frame, alpha in alphas.items()})
    opacity: Any = [{"frame": key["frame"], "value": key["points"][0][0], "interpolation": "linear"} for key in levels]
    is_steady = all(each["value"] == opacity[0]["value"] for each in opacity)
    return {
        "name": layer.name,
        "closed": spline.use_cyclic,
        "visible": not layer.hide_render,
        "locked": layer.hide_select,
        "blend": MODES.get(layer.blend, "add"),
        "invert": layer.invert,
        "opacity": opacity[0]["value"] if is_steady else opacity,
        "feather": sum(widths) / len(widths),
        "keys": points,
    }


def _row(point: Any, size: tuple[int, int]) -> list[float]:
    """A point and its handles in pixels: the centre of the picture is (0.5, 0.5), its longer side has the length 1."""
    row: list[float] = []
    for x, y in (point.co, point.handle_left, point.handle_right):
        row += [(x - 0.5) * max(size) + size[0] / 2.0, (0.5 - y) * max(size) + size[1] / 2.0]
    return row


def outset(rows: list[list[float]], size: tuple[int, int]) -> list[list[float]]:
    """A closed outline as far outside as Blender lays the edge of one without feather.

    That is half a pixel of the shorter side, in a space in which the picture is a square. Every side of the control
    polygon moves along its normal and every point to where its sides then meet; ROAM's export takes the same way back.
    """
    apart = 0.5 * np.array(size) / min(size)
    loop = (np.array(rows).reshape(-1, 3, 2)[:, [1, 0, 2]] / apart).reshape(-1, 2)
    sides = np.roll(loop, -1, axis=0) - loop
    lengths = np.hypot(sides[:, 0], sides[:, 1])
    long = np.flatnonzero(lengths > 1e-9)
    area = float((loop[:, 0] * np.roll(loop[:, 1], -1) - np.roll(loop[:, 0], -1) * loop[:, 1]).sum())
    if len(long) < 3 or area == 0.0:
        return rows
    normals = np.stack([sides[:, 1], -sides[:, 0]], axis=1)[long] / lengths[long][:, None] * np.sign(area)
    ahead = np.searchsorted(long, np.arange(len(loop))) % len(long)
    both = normals[ahead - 1] + normals[ahead]
    moved = loop + 2.0 * both / np.maximum((both**2).sum(axis=1), 4.0 / LONGEST**2)[:, None]
    result: list[list[float]] = (moved.reshape(-1, 3, 2)[:, [1, 0, 2]] * apart).reshape(-1, 6).tolist()
    return result
