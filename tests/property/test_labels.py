"""Random objects as COCO's instances and back: the same pixels, frames and names, by our reader and by the numbers."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from roam_core.interchange import EXPORTERS, ExportOptions, ImportOptions, read_shapes
from roam_core.interchange.labels.coco import coco_document
from roam_core.interchange.labels.polygons import TOLERANCE, mask_of
from roam_core.matte import render_matte
from roam_core.roto import BlendMode, Clip, Interpolation, Keyframe, Layer, MotionBlur, Project, RotoShape
from tests.judges.scenes import ellipse
from tests.property.strategies import animatables, opacities

SIZE = (96, 64)
FIRST, LAST = 11, 16
CLIP = Clip(Path("/shots/plate.####.png"), FIRST, LAST, SIZE)
CUTTING = (BlendMode.SUBTRACT, BlendMode.INTERSECT)
JOINING = (BlendMode.ADD, BlendMode.PLUS, BlendMode.MAX)


@st.composite
def ellipses(draw: st.DrawFn, modes: tuple[BlendMode, ...] = JOINING) -> RotoShape:
    """A moving ellipse, soft or dim in places, that may come and go."""
    keys = []
    for frame in draw(st.lists(st.integers(FIRST - 3, LAST + 3), min_size=1, max_size=3, unique=True)):
        x, y = draw(st.floats(-20.0, 110.0)), draw(st.floats(-20.0, 80.0))
        points = ellipse(x, y, draw(st.floats(4.0, 40.0)), draw(st.floats(4.0, 40.0)), draw(st.floats(0.0, 90.0)))
        curve = draw(st.sampled_from([None, np.full_like(points, 3.0)]))
        keys.append(Keyframe(frame, points, curve, interpolation=draw(st.sampled_from(Interpolation))))
    start = draw(st.integers(FIRST - 2, LAST))
    return RotoShape(
        f"shape-{draw(st.uuids())}",
        draw(st.text(max_size=9)),
        tuple(keys),
        blend=draw(st.sampled_from(modes)),
        opacity=draw(opacities(0.25, extra=False)),
        feather=draw(animatables(st.floats(-5.0, 5.0), extra=False)),
        motion_blur=draw(st.sampled_from([None, MotionBlur()])),
        lifetime=draw(st.none() | st.just((start, start + draw(st.integers(1, 4))))),
    )


@st.composite
def projects(draw: st.DrawFn, modes: tuple[BlendMode, ...] = JOINING) -> Project:
    inner = draw(st.lists(ellipses(modes), max_size=2))
    layer = Layer("layer-1", draw(st.text(max_size=9)), tuple(inner), invert=draw(st.booleans()) and len(modes) > 3)
    around = (draw(st.lists(ellipses(modes), max_size=2)), [layer], draw(st.lists(ellipses(modes), max_size=2)))
    return Project(CLIP, Layer("root", "Root", tuple(item for some in around for item in some)))


def hard(item: Any) -> Any:
    """What labels hold of a layer or shape: it is there or it is not."""
    if isinstance(item, Layer):
        return replace(item, children=tuple(hard(child) for child in item.children))
    keys = tuple(replace(key, feather=None) for key in item.keys)
    return replace(item, keys=keys, opacity=1.0, feather=0.0, motion_blur=None)


@settings(deadline=None, max_examples=30)
@given(projects(), st.integers(-5, 90))
def test_objects_side_by_side_come_back_as_they_are(project: Project, offset: int) -> None:
    """On every frame, within the tolerance of polygons; and nothing on frames on which they are not."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "objects.json"
        EXPORTERS["coco"].export(project, path, ExportOptions(frame_offset=offset, lossy=True))
        document, _, losses = coco_document(project, ExportOptions(frame_offset=offset))
        made = read_shapes(path, CLIP, ImportOptions(frame_offset=offset)).layer
    assert not losses
    assert [image["frame"] - offset for image in document["images"]] == list(CLIP.frame_range)
    for frame in CLIP.frame_range:
        ours, theirs = (render_matte(layer, frame, SIZE[::-1]) for layer in (hard(project.root), made))
        # Unions of two grey pixels may be one or the other; an edge strays by a tenth of a pixel, a corner by more.
        assert np.abs(ours - theirs).mean() < 0.01
        assert np.abs(ours - theirs).max() < 0.5 + TOLERANCE
    assert {shape.name for shape in made.shapes()} <= {item.name for item in project.root.children}


@settings(deadline=None, max_examples=30)
@given(projects(tuple(BlendMode)))
def test_of_objects_that_are_cut_every_pixel_is_there(project: Project) -> None:
    """Runs are the pixels of an object under all that cuts it; boxes and areas are those of the pixels."""
    document = coco_document(project)[0]
    root = hard(project.root)
    objects = {}
    for place, item in enumerate(root.children):
        if item.blend not in CUTTING:
            above = (other for other in root.children[place + 1 :] if other.blend in CUTTING)
            objects[len(objects) + 1] = Layer("root", "Root", (replace(item, blend=BlendMode.ADD), *above))
    numbers = {image["id"]: image["frame"] for image in document["images"]}
    for row in document["annotations"]:
        found = row["segmentation"]
        if isinstance(found, list):
            continue
        mask = mask_of(found["counts"], *found["size"])
        ours = render_matte(objects[row["track_id"]], numbers[row["image_id"]], SIZE[::-1]) > 0.5
        np.testing.assert_array_equal(mask, ours)
        rows, columns = np.nonzero(mask)
        assert row["area"] == len(rows)
        box = [columns.min(), rows.min(), np.ptp(columns) + 1, np.ptp(rows) + 1]
        assert row["bbox"] == box
