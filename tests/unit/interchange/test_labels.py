"""COCO and CVAT: what is written is what their own code and ours read back."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, Imported, read_shapes
from roam_core.interchange.labels.coco import coco_document
from roam_core.interchange.labels.polygons import clipped, mask_of, runs_of, runs_of_text
from roam_core.interchange.protocol import LossyExport
from roam_core.matte import render_matte
from roam_core.roto import Animated, BlendMode, Clip, Interpolation, Keyframe, Layer, Project, RotoShape, ValueKey
from tests.judges.scenes import blob

SIZE = (320, 240)
CLIP = Clip(Path("/shots/plate.%04d.exr"), 1001, 1012, SIZE)


def project(*items: Layer | RotoShape) -> Project:
    named = [replace(item, id=f"item-{number}") for number, item in enumerate(items)]
    return Project(CLIP, Layer("root", "Root", tuple(named)))


def car(**values: Any) -> RotoShape:
    return blob("Car", 120.0, 120.0, 70.0, 50.0, **values)


def back(name: str, what: Project, folder: Path, options: ExportOptions = ExportOptions()) -> Imported:  # noqa: B008
    path = folder / f"p{EXPORTERS[name].suffix}"
    EXPORTERS[name].export(what, path, options)
    return read_shapes(path, CLIP)


def overlap(a: Any, b: Any) -> float:
    return float((a & b).sum() / (a | b).sum())


# ---- COCO ------------------------------------------------------------------------------------------------------------


def test_what_has_no_opacity_on_a_frame_is_no_object_of_coco_there() -> None:
    """Other programs show and hide shapes so; they were labelled on every frame."""
    held = Interpolation.HOLD
    off = Animated((ValueKey(1001, 1.0, held), ValueKey(1004, 0.0, held), ValueKey(1006, 1.0, held)))
    inside = Layer("l", "Inside", (replace(blob("Other", 60.0, 60.0, 20.0, 20.0), id="o"),), opacity=off)
    beside = replace(blob("Beside", 220.0, 60.0, 20.0, 20.0), id="b")
    nest = Layer("n", "Nest", (replace(inside, id="l2"), beside))
    document, notes, losses = coco_document(project(car(opacity=off), inside, nest))
    labelled = {track: set[int]() for track in (1, 2, 3)}
    for row in document["annotations"]:
        labelled[row["track_id"]].add(row["image_id"] + 1000)
    seen = set(CLIP.frame_range) - {1004, 1005}
    assert labelled == {1: seen, 2: seen, 3: set(CLIP.frame_range)}
    areas = {row["image_id"] + 1000: row["area"] for row in document["annotations"] if row["track_id"] == 3}
    assert areas[1005] < 0.7 * areas[1003]
    assert losses == []
    assert not any("opacity" in note for note in notes)


@pytest.mark.filterwarnings("ignore:__array__ implementation")  # COCO's own, with numpy 2
def test_cocos_own_code_finds_our_pixels() -> None:
    """Polygons where shapes lie side by side, runs where one cuts: both are the matte's pixels."""
    masks = pytest.importorskip("pycocotools.mask", reason="COCO's own code is the judge: install the extra dev")
    hole = blob("Hole", 220.0, 120.0, 20.0, 15.0, blend=BlendMode.SUBTRACT)
    ring = Layer("l", "Ring", (replace(blob("Outer", 220.0, 120.0, 50.0, 60.0), id="o"), replace(hole, id="h")))
    what = project(car(), ring)
    document, _, losses = coco_document(what)
    assert losses == []
    for image in document["images"]:
        ours = render_matte(what, image["frame"], SIZE[::-1]) > 0.5
        theirs = np.zeros(SIZE[::-1], dtype=bool)
        for row in document["annotations"]:
            if row["image_id"] == image["id"]:
                runs = masks.frPyObjects(row["segmentation"], SIZE[1], SIZE[0])
                theirs |= masks.decode(masks.merge(runs) if isinstance(runs, list) else runs).astype(bool)
        assert overlap(ours, theirs) > 0.995  # COCO rasterises in fifths of a pixel
    kinds = {type(row["segmentation"]) for row in document["annotations"]}
    assert kinds == {list, dict}
    assert [category["name"] for category in document["categories"]] == ["Car", "Ring"]


def test_coco_comes_back_as_polygons_with_keys_on_every_frame(tmp_path: Path) -> None:
    made = back("coco", project(car(lifetime=(1003, 1008))), tmp_path)
    (shape,) = made.layer.shapes()
    assert shape.name == "Car"
    assert shape.frames == tuple(range(1003, 1008))
    assert shape.lifetime == (1003, 1008)
    for frame in (1003, 1006):
        ours, theirs = (render_matte(layer, frame, SIZE[::-1]) for layer in (project(car()).root, made.layer))
        assert np.abs(ours - theirs).max() < 0.15
        assert np.abs(ours - theirs).mean() < 0.001


def test_cocos_runs_come_back_as_fitted_shapes(tmp_path: Path) -> None:
    what = project(car(), blob("Cut", 120.0, 120.0, 25.0, 20.0, blend=BlendMode.SUBTRACT))
    made = back("coco", what, tmp_path, ExportOptions(frames=range(1001, 1004)))
    for frame in (1001, 1003):
        ours, theirs = (render_matte(layer, frame, SIZE[::-1]) > 0.5 for layer in (what.root, made.layer))
        assert overlap(ours, theirs) > 0.97


def test_a_foreign_data_set_is_read_by_its_names(tmp_path: Path) -> None:
    square = [[10, 10, 50, 10, 50, 50, 10, 50]]
    document = {
        "images": [
            {"id": number, "file_name": f"a/shot_{1001 + 2 * number:04d}.jpg", "width": 640, "height": 480}
            for number in range(3)
        ],
        "categories": [{"id": 7, "name": "Katze"}],
        "annotations": [
            {"id": number, "image_id": number, "category_id": 7, "segmentation": square, "bbox": [10, 10, 40, 40]}
            for number in range(3)
        ],
    }
    path = tmp_path / "labels.json"
    path.write_text(json.dumps(document))
    made = read_shapes(path, CLIP)
    (shape,) = made.layer.shapes()
    assert (shape.name, shape.frames) == ("Katze", (1001, 1003, 1005))
    np.testing.assert_allclose(shape.keys[0].points[0, 0], (5.0, 5.0))
    assert "640 x 480" in made.notes[0]


def test_the_area_of_a_coco_object_counts_what_its_shapes_share_once() -> None:
    """An arm lies over its body in most objects: the areas of both were added."""
    arm, body = (replace(blob(name, 120.0, 120.0, 70.0, 50.0), id=name) for name in ("Arm", "Body"))
    alone, both = (
        coco_document(project(item))[0]["annotations"][0]["area"] for item in (arm, Layer("l", "Man", (body, arm)))
    )
    assert both == pytest.approx(alone, rel=0.005)


def test_runs_of_pixels_go_both_ways() -> None:
    mask = np.random.default_rng(3).random((7, 5)) > 0.5
    np.testing.assert_array_equal(mask_of(runs_of(mask), 7, 5), mask)
    pixels = pytest.importorskip("pycocotools.mask", reason="COCO's own code is the judge: install the extra dev")
    large = np.zeros((300, 200), dtype=np.uint8)
    large[20:280, 30:150] = np.random.default_rng(4).random((260, 120)) > 0.3
    text = pixels.encode(np.asfortranarray(large))["counts"].decode()
    assert runs_of_text(text) == runs_of(large.astype(bool))


def test_masks_of_noise_are_left_out_or_refused(tmp_path: Path) -> None:
    """To fit shapes to specks takes a tenth of a second each."""

    def data(masks: list[Any]) -> Path:
        rows = [
            {"id": k, "image_id": k, "category_id": 1, "segmentation": {"size": [96, 96], "counts": runs_of(mask)}}
            for k, mask in enumerate(masks)
        ]
        document = {"images": [{"id": k, "frame": 1001 + k} for k in range(len(masks))], "annotations": rows}
        path = tmp_path / "noise.json"
        path.write_text(json.dumps(document))
        return path

    specks, few = np.zeros((96, 96), dtype=bool), np.zeros((96, 96), dtype=bool)
    specks[::8, ::8] = True
    few[8:88:16, 8:88:16] = True
    made = read_shapes(data([specks]), CLIP)
    assert any("falls into more than 48 parts and holes" in note for note in made.notes)
    with pytest.raises(RoamError, match="more than 256 parts and holes"):
        read_shapes(data([few] * 11), CLIP)


def test_polygons_are_cut_at_the_picture() -> None:
    diamond = np.array([[-10.0, 5.0], [5.0, -10.0], [20.0, 5.0], [5.0, 20.0]])
    inside = clipped(diamond, (10, 10))
    assert inside.min() == 0.0
    assert inside.max() == 10.0
    assert len(clipped(diamond + 100.0, (10, 10))) == 0


# ---- CVAT ------------------------------------------------------------------------------------------------------------


def test_cvat_keeps_keys_lifetimes_names_and_labels(tmp_path: Path) -> None:
    arm = replace(blob("Arm", 200.0, 100.0, 40.0, 30.0, lifetime=(1004, 1009)), id="arm")
    made = back("cvat", project(car(), Layer("l", "Man", (arm,))), tmp_path)
    first, second = made.layer.shapes()
    assert [item.name for item in made.layer.children] == ["Car", "Man"]
    assert (first.name, first.frames, first.lifetime) == ("Car", (1001, 1006, 1012), None)
    assert (second.name, second.frames, second.lifetime) == ("Arm", (1004, 1006, 1008), (1004, 1009))
    for frame in range(1001, 1013):
        what = project(car(), arm)
        ours, theirs = (render_matte(layer, frame, SIZE[::-1]) for layer in (what.root, made.layer))
        assert np.abs(ours - theirs).mean() < 0.001


def test_cvat_counts_frames_from_the_clips_first_and_adds_the_offset(tmp_path: Path) -> None:
    EXPORTERS["cvat"].export(
        project(car()), tmp_path / "p.xml", ExportOptions(frames=range(1003, 1006), frame_offset=10)
    )
    text = (tmp_path / "p.xml").read_text()
    for word, number in (("start_frame", 12), ("stop_frame", 14), ("size", 12)):
        assert f"<{word}>{number}</{word}>" in text


def test_cvat_holds_and_smooth_spans_move_as_they_do(tmp_path: Path) -> None:
    for kind in (Interpolation.HOLD, Interpolation.SMOOTH):
        keys = tuple(replace(key, interpolation=kind) for key in car().keys)
        made = back("cvat", project(replace(car(), keys=keys)), tmp_path)
        what = project(replace(car(), keys=keys))
        for frame in (1001, 1003, 1005, 1006, 1010, 1012):
            ours, theirs = (render_matte(layer, frame, SIZE[::-1]) for layer in (what.root, made.layer))
            assert np.abs(ours - theirs).mean() < 0.001


def test_what_cvat_and_mlt_cannot_hold_is_refused_unless_it_is_agreed_to(tmp_path: Path) -> None:
    what = project(car(), blob("Cut", 120.0, 120.0, 20.0, 20.0, blend=BlendMode.DIFFERENCE))
    for name in ("cvat", "mlt"):
        path = tmp_path / f"p{EXPORTERS[name].suffix}"
        with pytest.raises(LossyExport, match="'Cut'"):
            EXPORTERS[name].export(what, path)
        assert not path.exists()
        notes = EXPORTERS[name].export(what, path, ExportOptions(lossy=True))
        assert "'Cut'" in notes[0]


IMAGES = """<?xml version="1.0" encoding="utf-8"?>
<annotations><version>1.1</version>
 <image id="0" name="a.png" width="320" height="240">
  <box label="car" xtl="10" ytl="20" xbr="50" ybr="60" rotation="90" z_order="1"/>
  <polygon label="man" points="1,1;9,1;9,9" z_order="0"/><points label="eye" points="1,1"/>
 </image>
 <image id="4" name="b.png" width="320" height="240"><ellipse label="sun" cx="90" cy="90" rx="9" ry="5"/></image>
</annotations>"""


@pytest.mark.parametrize("name", ["coco", "cvat", "mlt"])
def test_what_varies_outside_of_a_shapes_own_keys_is_told(name: str, tmp_path: Path) -> None:
    """A shape with one key whose feather and opacity have keys later: soft and dim there, so it is said."""
    late = Animated((ValueKey(1001, 0.0), ValueKey(1010, 8.0)))
    dim = Animated((ValueKey(1001, 1.0), ValueKey(1010, 0.5)))
    told = EXPORTERS[name].export(
        project(car(feather=late, opacity=dim)), tmp_path / "p.file", ExportOptions(lossy=True)
    )
    assert any("feather" in sentence and "'Car'" in sentence for sentence in told)
    assert any("opacity" in sentence and "'Car'" in sentence for sentence in told)


@pytest.mark.parametrize(
    ("name", "values", "lost"),
    [
        ("cvat", {"invert": True, "opacity": 0.5}, "loses the inversion."),
        ("mlt", {"invert": True, "opacity": 0.5}, "loses the opacity and the inversion."),
        ("mlt", {"blend": BlendMode.INTERSECT}, "loses the mode 'intersect'."),
    ],
)
def test_only_what_a_layer_has_is_said_to_be_lost(name: str, values: Any, lost: str, tmp_path: Path) -> None:
    inside = (replace(car(), id="one"), replace(blob("Other", 60.0, 60.0), id="other"))
    layered = project(car(), Layer("layer", "Body", inside, **values))
    with pytest.raises(LossyExport) as refusal:
        EXPORTERS[name].export(layered, tmp_path / "p.file")
    assert f"{name.upper()} has no layers of masks: 'Body' {lost}" in refusal.value.losses


@pytest.mark.parametrize(("name", "suffix"), [("coco", "json"), ("cvat", "xml"), ("mlt", "json")])
def test_a_shape_in_a_hidden_layer_is_told_as_a_hidden_one_is(name: str, suffix: str, tmp_path: Path) -> None:
    inner = Layer("l2", "Inner", (car(),))
    one, other = (
        EXPORTERS[name].export(project(made), tmp_path / f"p.{suffix}")
        for made in (replace(car(), visible=False), Layer("l", "Outer", (inner,), visible=False))
    )
    assert len(one) > len(EXPORTERS[name].export(project(car()), tmp_path / f"p.{suffix}"))
    assert set(one) <= set(other)


def test_what_has_no_opacity_on_a_frame_is_outside_in_cvat_there(tmp_path: Path) -> None:
    """Of the shape itself, or of a layer around it; one that is never seen is no track. They were labelled."""
    held = Interpolation.HOLD
    off = Animated((ValueKey(1001, 1.0, held), ValueKey(1004, 0.0, held), ValueKey(1006, 1.0, held)))
    inside = Layer("l", "Inside", (replace(blob("Other", 60.0, 60.0, 20.0, 20.0), id="o"),), opacity=off)
    never = blob("Never", 200.0, 60.0, 20.0, 20.0, opacity=0.0)
    path = tmp_path / "p.xml"
    notes = EXPORTERS["cvat"].export(project(car(opacity=off), inside, never), path)
    made = read_shapes(path, CLIP).layer
    assert [shape.name for shape in made.shapes()] == ["Car", "Car", "Other", "Other"]
    assert [shape.lifetime for shape in made.shapes()] == [(1001, 1004), (1006, 1013)] * 2
    assert not any("opacity" in note for note in notes)
    assert "'Never' does not exist on the frames that are written: it is left out." in notes


@pytest.mark.parametrize("name", ["coco", "cvat"])
def test_labels_tell_the_opacity_of_a_layer_too(name: str, tmp_path: Path) -> None:
    told = EXPORTERS[name].export(project(Layer("l", "Body", (car(),), opacity=0.5)), tmp_path / "p.file")
    assert sum("opacity of 'Body' is left out" in each or "opacity of 'Body'." in each for each in told) == 1


def test_cvat_loses_nothing_of_what_is_hidden(tmp_path: Path) -> None:
    """The difference of a hidden shape, or in a hidden layer, made the export refuse."""
    hidden = car(blend=BlendMode.DIFFERENCE, visible=False)
    off = Layer("l", "Off", (car(invert=True),), invert=True, visible=False)
    told = EXPORTERS["cvat"].export(project(blob("Seen", 200.0, 90.0), hidden, off), tmp_path / "a.xml")
    assert sum("is seen there" in each for each in told) == 1


def test_a_task_of_cvats_on_a_part_of_a_film_ends_with_its_last_frame(tmp_path: Path) -> None:
    """Its frames are numbered from the film's first, its size counts its own: each shape lived for one frame."""
    path = tmp_path / "a.xml"
    polygon = '<polygon frame="5" keyframe="1" outside="0" points="10,10;90,10;90,90"/>'
    path.write_text(
        "<annotations><meta><task><size>3</size><start_frame>5</start_frame><stop_frame>7</stop_frame></task></meta>"
        f'<track id="0" label="car">{polygon}</track></annotations>'
    )
    (shape,) = read_shapes(path, CLIP).layer.shapes()
    assert shape.lifetime == (1006, 1009)


def test_images_of_cvat_become_shapes_of_a_frame(tmp_path: Path) -> None:
    path = tmp_path / "a.xml"
    path.write_text(IMAGES)
    made = read_shapes(path, CLIP)
    shapes = {shape.name: shape for shape in made.layer.shapes()}
    assert list(shapes) == ["man", "sun", "car"]
    assert shapes["sun"].lifetime == (1005, 1006)
    np.testing.assert_allclose(np.sort(shapes["car"].keys[0].points[:, 0], axis=0)[[0, -1]], [(10, 20), (50, 60)])
    assert "'points' was left out" in made.notes[0]


def test_masks_of_cvat_are_left_out_with_a_way_to_bring_them_in(tmp_path: Path) -> None:
    """Its tools make masks, and it writes them as runs of pixels, which are read of COCO."""
    path = tmp_path / "a.xml"
    path.write_text(
        '<annotations><image id="0" name="a.png" width="9" height="9">'
        '<mask label="man" rle="0, 4" left="2" top="2" width="2" height="2" z_order="0"/></image></annotations>'
    )
    (note,) = (each for each in read_shapes(path, CLIP).notes if "masks" in each)
    assert note == "CVAT's masks were left out; export the task as COCO, whose masks ROAM reads."


def test_a_cvat_file_without_outlines_is_told_and_one_with_some_is_not(tmp_path: Path) -> None:
    (tmp_path / "a.xml").write_text("<annotations><meta><task><size/></task></meta></annotations>")
    note = "There are no outlines in the file."
    assert read_shapes(tmp_path / "a.xml", CLIP).notes == (note,)
    assert note not in back("cvat", project(car()), tmp_path).notes


def test_a_shape_that_exists_on_no_frame_that_is_written_is_left_out_of_cvat_and_told(tmp_path: Path) -> None:
    gone = replace(car(), id="gone", name="Gone", lifetime=(CLIP.last + 1, CLIP.last + 9))
    notes = EXPORTERS["cvat"].export(project(car(), gone), tmp_path / "p.xml")
    assert "'Gone' does not exist on the frames that are written: it is left out." in notes
    assert [shape.name for shape in read_shapes(tmp_path / "p.xml", CLIP).layer.shapes()] == ["Car"]
    last = replace(gone, lifetime=(CLIP.last, CLIP.last + 9))
    assert not any("left out" in note for note in EXPORTERS["cvat"].export(project(last), tmp_path / "p.xml"))


@pytest.mark.parametrize("size", [None, [96], [96, "96"], [0, 96], [96, 1 << 16]])
def test_a_coco_mask_of_no_size_is_left_out_and_told(tmp_path: Path, size: Any) -> None:
    image = {"id": 1, "file_name": "plate.1001.png", "width": 96, "height": 96}
    mask = {"id": 1, "image_id": 1, "category_id": 1, "segmentation": {"size": size, "counts": [0, 96 * 96]}}
    document = {"images": [image], "annotations": [mask], "categories": [{"id": 1, "name": "man"}]}
    (tmp_path / "a.json").write_text(json.dumps(document))
    made = read_shapes(tmp_path / "a.json", CLIP)
    assert list(made.layer.shapes()) == []
    assert any("its size must be a height and a width" in note for note in made.notes)


# ---- which JSON it is ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("text", ["[]", "{}", "3", '{"a": 1}', '{"images": 3, "annotations": []}', '{"format": "x"}'])
def test_json_of_no_kind_is_refused_in_a_sentence(tmp_path: Path, text: str) -> None:
    path = tmp_path / "a.json"
    path.write_text(text)
    with pytest.raises(RoamError, match=r"holds no shapes: it has neither a \"format\""):
        read_shapes(path, CLIP)


def test_a_still_polygon_without_a_track_is_told_apart_by_its_key() -> None:
    key = Keyframe(1001, blob("x", 9.0, 9.0).keys[0].points)
    document, notes, _ = coco_document(project(RotoShape("s", "Still", (key,), opacity=0.5, feather=3.0)))
    assert len(document["annotations"]) == len(CLIP.frame_range)
    assert any("opacity of 'Still'" in note for note in notes)
    assert any("feather of 'Still'" in note for note in notes)


# ---- the outlines of one thing ---------------------------------------------------------------------------------------


def test_the_polygons_of_a_coco_annotation_are_of_one_compound(tmp_path: Path) -> None:
    near, far = [10, 10, 50, 10, 50, 50, 10, 50], [90, 10, 130, 10, 130, 50, 90, 50]
    document = {
        "images": [{"id": 0, "file_name": "plate_1001.png", "width": SIZE[0], "height": SIZE[1]}],
        "categories": [],
        "annotations": [
            {"id": k, "image_id": 0, "category_id": 1, "segmentation": polygons}
            for k, polygons in enumerate([[near, far], [near], [near, far]])
        ],
    }
    path = tmp_path / "labels.json"
    path.write_text(json.dumps(document))
    shapes = read_shapes(path, CLIP).layer.shapes()
    assert [shape.compound for shape in shapes] == ["compound-1", "compound-1", "", "compound-2", "compound-2"]


def test_a_group_of_cvat_is_a_compound(tmp_path: Path) -> None:
    text = "".join(
        f'<polygon label="Car" points="1,1;9,1;9,9" {group}/>'
        for group in ('group_id="4"', 'group_id="4"', "", 'group_id="0"', 'group_id="7"')
    )
    outline = '<polygon frame="0" points="1,1;9,1;9,9"/>'
    path = tmp_path / "labels.xml"
    path.write_text(
        f'<annotations><image id="0">{text}</image><track label="Van" group_id="7">{outline}</track></annotations>'
    )
    shapes = read_shapes(path, CLIP).layer.shapes()
    assert [shape.compound for shape in shapes] == ["compound-1", "compound-1", "", "", "compound-2", "compound-2"]


def test_cocos_boxes_without_outlines_are_told(tmp_path: Path) -> None:
    outlines: list[dict[str, Any]] = [{"segmentation": [[10, 10, 50, 10, 50, 50]]}, {"segmentation": []}, {}]
    document = {
        "images": [{"id": 1, "frame": 1001, "width": SIZE[0], "height": SIZE[1]}],
        "categories": [{"id": k, "name": name} for k, name in enumerate(("Cat", "Dog", "Cow"))],
        "annotations": [
            {"id": k, "image_id": 1, "category_id": k, "bbox": [5, 5, 90, 90], **row} for k, row in enumerate(outlines)
        ],
    }
    path = tmp_path / "boxes.json"
    path.write_text(json.dumps(document))
    made = read_shapes(path, CLIP)
    assert [shape.name for shape in made.layer.shapes()] == ["Cat"]
    told = [note for note in made.notes if "boxes without outlines" in note]
    assert ["'Cat'" in " ".join(told), "'Dog'" in " ".join(told), "'Cow'" in " ".join(told)] == [False, True, True]


@pytest.mark.parametrize(
    ("place", "told"),
    [
        (("annotations", 0, "image_id"), "Annotations without an image"),
        (("annotations", 0, "category_id"), ""),
        (("categories",), ""),
    ],
)
@pytest.mark.parametrize("value", [[1], {"a": 1}, -7])
def test_parts_of_coco_that_are_of_another_kind_are_none(
    tmp_path: Path, place: tuple[Any, ...], told: str, value: Any
) -> None:
    document = coco_document(project(car()))[0]
    inner: Any = document
    for step in place[:-1]:
        inner = inner[step]
    inner[place[-1]] = value
    (tmp_path / "c.json").write_text(json.dumps(document))
    found = read_shapes(tmp_path / "c.json", CLIP)
    assert len(list(found.layer.shapes())) >= 1
    assert told in " ".join(found.notes)
