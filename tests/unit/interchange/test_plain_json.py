"""Plain JSON out and in: number for number, and a sentence with the place for whatever is not of the format."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, Imported, ImportOptions, read_shapes
from roam_core.interchange import reading as limits
from roam_core.interchange.plain_json import json_document
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Clip, Interpolation, Layer, Origin, Project, RotoShape, edit
from tests.unit.interchange.test_other_programs import NAMES

CLIP = Clip(Path("plate"), 1001, 1040, (1920, 1080))


def read(text: str, folder: Path, clip: Clip = CLIP, options: ImportOptions | None = None) -> Imported:
    path = folder / "shapes.json"
    path.write_text(text, encoding="utf-8")
    return read_shapes(path, clip, options) if options else read_shapes(path, clip)


def plain(item: Layer | RotoShape) -> Layer | RotoShape:
    """An item without what a file of another program never says: ids, trust, stamps."""
    if isinstance(item, Layer):
        return replace(item, id="", children=tuple(plain(child) for child in item.children), extra={})
    keys = (replace(k, confidence=None, vertex_confidence=None, inputs="", extra={}) for k in item.keys)
    return replace(item, id="", keys=tuple(keys), extra={})


def test_everything_comes_back_number_for_number(project: Project, tmp_path: Path) -> None:
    EXPORTERS["json"].export(project, tmp_path / "p.json")
    back = read_shapes(tmp_path / "p.json", project.require_clip())
    assert back.notes == ()
    assert [plain(item) for item in back.layer.children] == [plain(item) for item in project.root.children]


def test_compounds_come_back_and_one_that_is_no_text_is_refused(project: Project, tmp_path: Path) -> None:
    shape = project.shapes[0]
    document = json.loads(json_document(project.with_shape(replace(shape, compound="mask-1")))[0])
    assert next(_shapes(document)) == {**next(_shapes(json.loads(json_document(project)[0]))), "compound": "mask-1"}
    back = read(json.dumps(document), tmp_path).layer.shapes()
    assert [each.compound for each in back] == ["mask-1", *[""] * (len(project.shapes) - 1)]
    next(_shapes(document))["compound"] = 1
    with pytest.raises(RoamError, match='"compound" must be a text'):
        read(json.dumps(document), tmp_path)


def test_what_tracking_goes_by_comes_back(project: Project, tmp_path: Path) -> None:
    shape = replace(project.shapes[0], link="object-1", attached=False, depth=((1001, 1), (1010, 0), (1020, -1)))
    text = json_document(project.with_shape(shape), ExportOptions(frame_offset=100))[0]
    document = json.loads(text)
    first = next(_shapes(document))
    assert (first["link"], first["attached"], first["depth"]) == ("object-1", False, [[1101, 1], [1110, 0], [1120, -1]])
    back = list(read(text, tmp_path, options=ImportOptions(frame_offset=100)).layer.shapes())
    assert (back[0].link, back[0].attached, back[0].depth) == (shape.link, shape.attached, shape.depth)
    assert all((each.link, each.attached, each.depth) == ("", True, ()) for each in back[1:])


@pytest.mark.parametrize(
    ("field", "value", "said"),
    [
        ("link", 1, '"link" must be a text'),
        ("attached", 1, '"attached" must be true or false'),
        ("depth", {}, '"depth" must be a list of frames'),
        ("depth", [[1001, 2]], '"depth" must be a list of frames'),
        ("depth", [[1001]], '"depth" must be a list of frames'),
        ("depth", [["1001", 1]], '"depth" must be a list of frames'),
        ("depth", [[1e9, 1]], "is no frame number"),
    ],
)
def test_what_tracking_goes_by_is_refused_where_it_is_none(
    project: Project, tmp_path: Path, field: str, value: Any, said: str
) -> None:
    document = json.loads(json_document(project)[0])
    next(_shapes(document))[field] = value
    with pytest.raises(RoamError, match=said):
        read(json.dumps(document), tmp_path)


def _shapes(item: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """All shapes of a document, or of a layer in it."""
    for child in item["items"]:
        if child["kind"] == "shape":
            yield child
        else:
            yield from _shapes(child)


def test_the_root_becomes_a_layer_where_it_is_not_plain(project: Project, tmp_path: Path) -> None:
    dimmed = replace(project, root=replace(project.root, opacity=0.5, name="Everything"))
    (layer,) = read(json_document(dimmed)[0], tmp_path).layer.children
    assert plain(layer) == plain(dimmed.root)


def test_frames_are_shifted_out_and_in(project: Project, tmp_path: Path) -> None:
    text = json_document(project, ExportOptions(frame_offset=-1000))[0]
    document = json.loads(text)
    assert (document["first_frame"], document["last_frame"]) == (1, 40)
    assert document["items"][0]["keys"][0]["frame"] == 1
    back = read(text, tmp_path, options=ImportOptions(frame_offset=-1000))
    assert [plain(item) for item in back.layer.children] == [plain(item) for item in project.root.children]


def test_keys_of_the_engine_are_out_of_date_when_a_key_around_them_changes(tmp_path: Path) -> None:
    """They came in out of date: all of a tracked shape was marked so, where nothing had changed."""
    keys = [{"frame": 1001 + k, "origin": origin, "points": [[k, 0], [480, k], [480, 270]]}
            for k, origin in enumerate(["artist", "engine", "engine", "artist", "engine"])]  # fmt: skip
    text = json.dumps({"format": "roam-shapes", "version": 2, "width": 1920, "height": 1080,
                       "items": [{"kind": "shape", "keys": keys}]})  # fmt: skip
    project, _ = edit.add_items(Project(CLIP), read(text, tmp_path).layer.children)
    (shape,) = project.shapes
    assert [key.origin.value for key in shape.keys] == ["artist", "engine", "engine", "artist", "engine"]

    def stale(shape: RotoShape) -> list[int]:
        stamps = Stamps.of([shape], CLIP)
        return [key.frame for key in shape.keys if stamps.is_stale(shape, key)]

    assert stale(shape) == []
    assert stale(edit.set_key(shape, 1004, shape.at(1004).points + 5.0)) == [1002, 1003, 1005]


def test_names_come_back_whatever_they_hold(project: Project, tmp_path: Path) -> None:
    names = [*NAMES, "lone \ud800 surrogate"]
    shapes = tuple(replace(project.shapes[0], id=f"shape-{k}", name=name) for k, name in enumerate(names))
    text = json_document(Project(CLIP, Layer("root", "Root", shapes)))[0]
    assert text.isascii()
    assert [shape.name for shape in read(text, tmp_path).layer.shapes()] == names


def test_little_is_enough(tmp_path: Path) -> None:
    """What a script writes by hand: a polygon of two numbers a point, everything else left to its default."""
    text = json.dumps(
        {
            "format": "roam-shapes",
            "version": 1,
            "width": 960,
            "height": 540,
            "items": [{"kind": "shape", "keys": [{"frame": 1003, "points": [[0, 0], [480, 0], [480, 270]]}]}],
            "made_by": "a script",
        }
    )
    made = read(text, tmp_path)
    (shape,) = made.layer.shapes()
    assert "were scaled" in made.notes[0]
    np.testing.assert_array_equal(shape.keys[0].points[1], [[960, 0]] * 3)
    assert (shape.closed, shape.keys[0].origin, shape.keys[0].interpolation, shape.opacity) == (
        True,
        Origin.ARTIST,
        Interpolation.LINEAR,
        1.0,
    )


GOOD: dict[str, Any] = {
    "format": "roam-shapes",
    "version": 1,
    "width": 1920,
    "height": 1080,
    "items": [
        {
            "kind": "layer",
            "name": "Body",
            "items": [
                {
                    "kind": "shape",
                    "name": "Arm",
                    "keys": [{"frame": 1001, "points": [[0, 0], [9, 0], [9, 9]]}],
                }
            ],
        }
    ],
}
SHAPE, KEY = ("items", 0, "items", 0), ("items", 0, "items", 0, "keys", 0)


@pytest.mark.parametrize(
    ("place", "value", "sentence"),
    [
        (("format",), "other", 'has neither a "format" of "roam-shapes"'),
        (("version",), 3, "has version '3' of the format; this program reads up to 2"),
        (("width",), "wide", 'in the file, "width" must be a number'),
        (("height",), 0, "in the file, width and height must be positive"),
        (("items",), {}, 'in the file, "items" must be a list'),
        (("items", 0), 5, 'in item 1 of the file, "kind" must be "layer" or "shape"'),
        ((*SHAPE, "name"), 5, '"name" must be a text'),
        ((*SHAPE, "closed"), 1, "in shape 'Arm' (item 1 of the file, item 1), \"closed\" must be true or false"),
        ((*SHAPE, "opacity"), 1.5, '"opacity" must lie between 0 and 1'),
        ((*SHAPE, "blend"), "glow", '"blend" must be one of add, plus, subtract, intersect, difference, max'),
        ((*SHAPE, "opacity"), [{"frame": 1, "value": 2}], '"value" must lie between 0 and 1'),
        ((*SHAPE, "opacity"), [{"frame": 1, "value": 1}] * 2, "two keys on one frame"),
        ((*SHAPE, "feather"), [5], "feather, a key must be an object"),
        ((*SHAPE, "feather"), [], "an animated value has no key"),
        ((*SHAPE, "blend"), ["add"], '"blend" must be one of'),
        ((*SHAPE, "colour"), [1, 2], '"colour" must be a list of three numbers'),
        ((*SHAPE, "lifetime"), [5], '"lifetime" must be null or a first frame'),
        ((*SHAPE, "lifetime"), [1009, 1002], '"lifetime" must not end before it begins'),
        ((*SHAPE, "motion_blur"), {"shutter": -1001, "phase": 0}, "must have 1 to 1024 samples"),
        ((*SHAPE, "keys"), [], "has no key"),
        ((*KEY, "frame"), 1e12, "is no frame number"),
        ((*KEY, "points"), [], "each point must be a list of two or six numbers"),
        ((*KEY, "points"), [[1, 2, 3]], "key on frame 1001, each point must be a list of two or six numbers"),
        ((*KEY, "points"), [[1e20, 0]], "a point lies nowhere near the image"),
        ((*KEY, "points"), [[float("nan"), 0]], "each point must be a list of two or six numbers"),
        ((*KEY, "feather"), [[1, 2]], "the feather has other points than the outline"),
        ((*KEY, "interpolation"), "cubic", '"interpolation" must be one of linear, smooth, hold'),
        ((*SHAPE, "keys"), [{"frame": 1, "points": [[0, 0]]}, {"frame": 2, "points": [[0, 0], [1, 1]]}], "differ in"),
        ((*SHAPE, "keys"), [{"frame": 1, "points": [[0, 0]]}] * 2, "two keys on one frame"),
    ],
)
def test_what_is_not_of_the_format_is_refused_with_its_place(
    tmp_path: Path, place: tuple[Any, ...], value: Any, sentence: str
) -> None:
    document = copy.deepcopy(GOOD)
    read(json.dumps(document), tmp_path)
    inner: Any = document
    for step in place[:-1]:
        inner = inner[step]
    inner[place[-1]] = value
    with pytest.raises(RoamError) as refused:
        read(json.dumps(document), tmp_path)
    assert sentence in str(refused.value)


@pytest.mark.parametrize("text", ["", "{", "[" * 100_000, "[]", "5", '{"format": 1}'])
def test_other_files_are_refused(tmp_path: Path, text: str) -> None:
    with pytest.raises(RoamError, match=r"is no valid JSON|holds no shapes"):
        read(text, tmp_path)


def test_a_damaged_file_is_told_with_its_place(tmp_path: Path) -> None:
    with pytest.raises(RoamError, match=r"is no valid JSON \(line 2, column 12\)\.$"):
        read('{"format": "roam-shapes",\n"width": 1,5}', tmp_path)


def test_files_beyond_the_limits_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    deep: dict[str, Any] = {"kind": "layer", "items": []}
    for _ in range(250):
        deep = {"kind": "layer", "items": [deep]}
    with pytest.raises(RoamError, match="more than 200 deep"):
        read(json.dumps(GOOD | {"items": [deep]}), tmp_path)
    monkeypatch.setattr(limits, "MAX_POINTS", 2)
    with pytest.raises(RoamError, match="more than 2 points"):
        read(json.dumps(GOOD), tmp_path)


def test_the_file_is_written_in_pieces(project: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Put together at once, 100 shapes with 500 keys of 60 points took 3.5 GB; and the writing did not stop."""
    monkeypatch.setattr("roam_core.interchange.plain_json.WORDS", 64)
    path, text = tmp_path / "shapes.json", json_document(project)[0]
    pieces, _ = EXPORTERS["json"].pieces(project, ExportOptions())  # type: ignore[attr-defined]
    assert max(map(len, pieces)) < len(text) / 4
    EXPORTERS["json"].export(project, path)
    assert path.read_text(encoding="ascii") == text
    token = CancelToken()

    def stopping(done: float, _: str) -> None:
        if done == 1.0:
            token.cancel()

    path.unlink()
    with pytest.raises(Cancelled):
        EXPORTERS["json"].export(project, path, ExportOptions(progress=stopping, token=token))
    assert list(tmp_path.iterdir()) == []
