"""COCO's runs where something cuts: the pixels of the joint matte, and no more work than they ask for."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.interchange.labels import coco
from roam_core.interchange.labels.coco import coco_document
from roam_core.interchange.labels.polygons import mask_of, runs_of
from roam_core.matte import render_matte
from roam_core.roto import BlendMode, Layer, RotoShape
from tests.unit.interchange.test_labels import car, project


def test_runs_of_a_part_are_those_of_the_whole_picture() -> None:
    draw = np.random.default_rng(4)
    for place in (np.s_[0:9, 0:12], np.s_[2:7, 3:12], np.s_[0:4, 0:1], np.s_[5:9, 11:12], np.s_[4:4, 2:2]):
        for share in (0.0, 0.3, 0.9, 1.0):
            mask = np.zeros((9, 12), dtype=bool)
            mask[place] = draw.random(mask[place].shape) < share
            flat = mask.ravel(order="F")
            edges = [0, *(np.flatnonzero(np.diff(flat)) + 1).tolist(), flat.size]
            wanted = [0] * bool(flat[0]) + np.diff(edges).tolist()
            assert runs_of(mask) == wanted
            assert runs_of(mask[place], (place[0].start, place[1].start), mask.shape) == wanted


def test_where_something_cuts_coco_fills_each_shape_once_a_frame(monkeypatch: pytest.MonkeyPatch) -> None:
    """It rendered a whole picture of each object, with all that cuts, for every object."""
    objects = [replace(car(), name=f"Car {k}") for k in range(20)]
    cutters = [replace(car(), id=f"cut-{k}", name=f"Cut {k}", blend=BlendMode.SUBTRACT) for k in range(2)]
    filled: list[tuple[str, float]] = []
    fill = coco.shape_patch
    monkeypatch.setattr(coco, "shape_patch", lambda shape, *at: filled.append((shape.id, at[0])) or fill(shape, *at))
    coco_document(project(*objects, Layer("layer-1", "Post", (cutters[0],), blend=BlendMode.SUBTRACT), cutters[1]))
    assert filled
    assert len(filled) == len(set(filled)), "a shape and a frame once"


def test_cocos_runs_are_the_pixels_of_the_joint_matte() -> None:
    draw = np.random.default_rng(8)
    modes = list(BlendMode)
    for _ in range(30):

        def some(k: int) -> RotoShape:
            moved = [replace(key, points=key.points + draw.uniform(-60, 60, 2), feather=None) for key in car().keys]
            values = {"blend": modes[draw.integers(len(modes))], "invert": bool(draw.random() < 0.2)}
            return replace(car(), id=f"shape-{k}", name=f"Shape {k}", keys=tuple(moved), feather=0.0, **values)

        items: list[Layer | RotoShape] = [some(k) for k in range(4)]
        inside = Layer("layer-1", "In", (some(4), some(5)), invert=bool(draw.random() < 0.3), blend=items[0].blend)
        items.insert(int(draw.integers(4)), inside)
        one = project(*items)
        height, width = one.require_clip().size[::-1]
        document = coco_document(one)[0]
        frames = {image["id"]: image["frame"] for image in document["images"]}
        cutting = [k for k, item in enumerate(items) if item.blend in coco.CUTTING]
        objects = [k for k in range(len(items)) if k not in cutting]
        for found in document["annotations"]:
            if not isinstance(found["segmentation"], dict):
                continue
            k = objects[found["track_id"] - 1]
            above = tuple(items[j] for j in cutting if j > k)
            alone = Layer("layer-9", "", (replace(items[k], blend=BlendMode.ADD), *above))
            wanted = render_matte(alone, frames[found["image_id"]], (height, width)) > 0.5
            assert np.array_equal(mask_of(found["segmentation"]["counts"], height, width), wanted)
            rows, columns = np.nonzero(wanted)
            box = [columns.min(), rows.min(), np.ptp(columns) + 1, np.ptp(rows) + 1]
            assert (found["bbox"], found["area"]) == ([int(value) for value in box], int(wanted.sum()))
