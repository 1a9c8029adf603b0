"""Project files that somebody damaged or made up: refused in one sentence, before they take time or memory."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.roto import Animated, Keyframe, Layer, MotionBlur, Origin, Project, RotoShape, ValueKey, file
from roam_core.roto.bounds import MAX_DEPTH, MAX_ITEMS, MAX_KEYS, MAX_SAMPLES, MAX_SPAN
from tests.unit.roto.every_field import CURVE, third_project

FOLDER = Path("/shots/show")
TEXT = file.dumps(third_project(FOLDER), FOLDER)
Document = dict[str, Any]
posix = pytest.mark.skipif(os.name != "posix", reason="needs FIFOs and devices")


def refused(path: Path) -> str:
    """The one short sentence in which `path` is refused."""
    with pytest.raises(RoamError) as caught:
        file.load(path)
    sentence = str(caught.value)
    assert sentence.startswith(str(path))
    assert sentence.endswith(".")
    assert "\n" not in sentence
    assert len(sentence) < len(str(path)) + 300
    return sentence


def damaged(tmp_path: Path, change: Callable[[Document], object]) -> str:
    """The sentence that refuses the fullest project after `change` was made to its document."""
    document = json.loads(TEXT)
    change(document)
    (tmp_path / "a.roam").write_text(json.dumps(document))
    return refused(tmp_path / "a.roam")


def layer(document: Document) -> Document:
    found: Document = document["root"]["children"][0]
    return found


def shape(document: Document) -> Document:
    found: Document = layer(document)["children"][0]
    return found


def bare(document: Document) -> Document:
    """A layer with nothing in it."""
    return {name: [] if name == "children" else value for name, value in layer(document).items() if name not in MORE}


MORE = {"transform", "later"}


def run(document: Document) -> Document:
    found: Document = layer(document)["children"][2]["keys"][0]
    return found


NUMBERS: dict[str, Callable[[Document, Any], object]] = {
    "clip first": lambda d, v: d["clip"].update(first=v),
    "clip last": lambda d, v: d["clip"].update(last=v),
    "clip size": lambda d, v: d["clip"].update(size=[v, v]),
    "clip fps": lambda d, v: d["clip"].update(fps=v),
    "clip pixel_aspect": lambda d, v: d["clip"].update(pixel_aspect=v),
    "mark frame": lambda d, v: d["marks"][0].update(frame=v),
    "layer opacity": lambda d, v: layer(d).update(opacity=v),
    "transform frames": lambda d, v: layer(d)["transform"].update(frames=[v, v]),
    "shape opacity": lambda d, v: shape(d).update(opacity=v),
    "shape feather": lambda d, v: shape(d).update(feather=v),
    "shape colour": lambda d, v: shape(d).update(colour=[v, v, v]),
    "shape lifetime": lambda d, v: shape(d).update(lifetime=[v, v]),
    "shape depth": lambda d, v: shape(d).update(depth=[[v, v]]),
    "blur shutter": lambda d, v: shape(d)["motion_blur"].update(shutter=v),
    "blur phase": lambda d, v: shape(d)["motion_blur"].update(phase=v),
    "blur samples": lambda d, v: shape(d)["motion_blur"].update(samples=v),
    "key frame": lambda d, v: shape(d)["keys"][0].update(frame=v),
    "key confidence": lambda d, v: shape(d)["keys"][0].update(confidence=v),
    "key points": lambda d, v: shape(d)["keys"][0].update(points=[[v] * 6] * 3),
    "key feather": lambda d, v: shape(d)["keys"][0].update(feather=[[v] * 6] * 3),
    "key vertex_confidence": lambda d, v: shape(d)["keys"][0].update(vertex_confidence=[v] * 3),
    "run frames": lambda d, v: run(d).update(frames=[v] * 12),
    "run inputs": lambda d, v: run(d).update(inputs=[[v, "stamp"]]),
}


@pytest.mark.parametrize("value", ["nan", "1", True, None, [1], 1e999], ids=repr)
@pytest.mark.parametrize("field", NUMBERS)
def test_what_is_no_number_is_refused_wherever_one_is_wanted(tmp_path: Path, field: str, value: Any) -> None:
    if field == "key confidence" and value is None:
        return  # an artist's key has none
    text = json.dumps(_with(field, "HERE")).replace('"HERE"', "1e999" if value == 1e999 else json.dumps(value))
    (tmp_path / "a.roam").write_text(text)
    assert ("not valid JSON" if value == 1e999 else "is damaged: ") in refused(tmp_path / "a.roam")


def _with(field: str, value: Any) -> Document:
    document: Document = json.loads(TEXT)
    NUMBERS[field](document, value)
    return document


def test_a_key_without_points_is_refused(tmp_path: Path) -> None:
    """It opened, and ended rendering and exports in a traceback."""
    key = {"type": "Keyframe", "frame": 1001, "points": [], "origin": "artist", "interpolation": "linear"}
    assert "a key has no points" in damaged(tmp_path, lambda d: shape(d).update(keys=[key]))


@pytest.mark.parametrize("name", ["visible", "locked", "invert"])
@pytest.mark.parametrize("where", [layer, shape])
def test_a_flag_is_true_or_false(tmp_path: Path, where: Callable[[Document], Document], name: str) -> None:
    assert f"{name} is neither true nor false" in damaged(tmp_path, lambda d: where(d).update({name: "false"}))


@pytest.mark.parametrize("where", [layer, shape])
def test_a_value_is_a_number_or_an_animated_value(tmp_path: Path, where: Callable[[Document], Document]) -> None:
    value = {"type": "Keyframe", "keys": [{"type": "ValueKey", "frame": 1, "value": 0.5, "interpolation": "linear"}]}
    assert "is no number and no animated value" in damaged(tmp_path, lambda d: where(d).update(opacity=value))
    where_it_is_one = json.loads(TEXT)
    where(where_it_is_one).update(opacity=value | {"type": "Animated"})
    (tmp_path / "b.roam").write_text(json.dumps(where_it_is_one))
    assert file.load(tmp_path / "b.roam").root.children


@pytest.mark.parametrize("name", ["id", "name"])
@pytest.mark.parametrize("where", [layer, shape])
def test_a_text_is_a_text(tmp_path: Path, where: Callable[[Document], Document], name: str) -> None:
    assert "is no text" in damaged(tmp_path, lambda d: where(d).update({name: 7}))


@pytest.mark.parametrize("name", ["path", "absolute"])
def test_a_path_that_no_file_can_have_is_refused(tmp_path: Path, name: str) -> None:
    """It opened, and ended rendering in a traceback."""
    assert "holds a null character" in damaged(tmp_path, lambda d: d["clip"].update({name: "a\0b"}))


# ---- bounds ----------------------------------------------------------------------------------------------------------


def nested(depth: int) -> Project:
    inner = Layer("innermost", "Innermost")
    for number in range(depth - 1):
        inner = Layer(f"layer-{number}", "Layer", (inner,))
    return Project(root=Layer("root", "Root", (inner,)))


def test_layers_lie_as_deep_as_may_be_and_no_deeper(tmp_path: Path) -> None:
    file.save(nested(MAX_DEPTH), tmp_path / "a.roam")
    assert file.load(tmp_path / "a.roam") == nested(MAX_DEPTH)
    with pytest.raises(RoamError, match="cannot be saved: it has more layers in layers than"):
        file.save(nested(MAX_DEPTH + 1), tmp_path / "b.roam")
    assert not (tmp_path / "b.roam").exists()


def test_deeper_layers_are_refused(tmp_path: Path) -> None:
    def deepen(document: Document) -> None:
        inner = dict(layer(document), children=[])
        for number in range(MAX_DEPTH + 1):
            inner = dict(inner, id=f"layer {number}", children=[inner])
        document["root"]["children"] = [inner]

    assert "more layers in layers" in damaged(tmp_path, deepen)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda d: shape(d)["motion_blur"].update(samples=10**9), f"more samples of motion blur than {MAX_SAMPLES}"),
        (lambda d: d["clip"].update(path="a" * 12_000_000), "more letters in the clip's path"),
        (lambda d: d["clip"].update(absolute="a" * 12_000_000), "more letters in the clip's path"),
        (lambda d: d["clip"].update(size=[10**9, 1]), "the clip's width lies not between"),
        (lambda d: d["clip"].update(last=10**8), "more frames in its clip"),
        (lambda d: d["clip"].update(first=9, last=1), "its clip ends, on frame 1, before it begins, on frame 9"),
        (lambda d: d["clip"].update(fps=0), "the clip's fps is 0, not between"),
        (lambda d: shape(d)["keys"][0].update(frame=-(2**31)), "the frame of a key lies not between"),
        (lambda d: shape(d)["keys"][0].update(frame=-MAX_SPAN), "more frames between the keys of"),
        (lambda d: d["root"].update(children=[bare(d)] * MAX_ITEMS), "more layers and shapes"),
    ],
    ids=["samples", "path", "absolute path", "size", "range", "backwards", "fps", "frame", "span", "items"],
)
def test_too_much_is_refused(tmp_path: Path, change: Callable[[Document], object], words: str) -> None:
    assert words in damaged(tmp_path, change)


def test_a_project_opens_whose_shape_ends_before_it_begins(tmp_path: Path) -> None:
    """Nothing else of it is wrong, and the artist's work must not be lost over it."""
    document = json.loads(TEXT)
    shape(document).update(lifetime=[9, 2])
    (tmp_path / "a.roam").write_text(json.dumps(document))
    assert (9, 9) in [each.lifetime for each in file.load(tmp_path / "a.roam").shapes]


def test_too_many_keys_are_refused_before_they_are_made(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> None:
        pytest.fail("a key was made")

    monkeypatch.setattr("roam_core.roto.packing.Keyframe", fail)
    frames, none = list(range(MAX_KEYS + 1)), {"type": "Numbers", "shape": [MAX_KEYS + 1, 0, 1, 2], "data": ""}
    shape_of = {"keys": [{**run(json.loads(TEXT)), "frames": frames, "points": none}]}
    assert f"more keys than {MAX_KEYS}" in damaged(tmp_path, lambda d: layer(d).update(children=[shape(d) | shape_of]))


@pytest.mark.parametrize("where", ["layer", "shape"])
def test_keys_of_values_count_as_those_of_outlines(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, where: str) -> None:
    fades = Animated(tuple(ValueKey(frame, 0.01 * frame) for frame in range(1, 60)))
    shape = RotoShape("shape-1", "A", (Keyframe(1, np.zeros((3, 3, 2))),), opacity=fades if where == "shape" else 1.0)
    project = Project(root=Layer("root", "Root", (shape,), opacity=fades if where == "layer" else 1.0))
    file.save(project, tmp_path / "a.roam")
    monkeypatch.setattr("roam_core.roto.bounds.MAX_KEYS", 59)
    with pytest.raises(RoamError, match="cannot be saved: it has more keys than 59"):
        file.save(project, tmp_path / "b.roam")
    with pytest.raises(RoamError, match="it has more keys than 59"):
        file.load(tmp_path / "a.roam")


def test_points_that_were_read_cannot_be_written_to(tmp_path: Path) -> None:
    keys = tuple(Keyframe(k, np.full((3, 3, 2), float(k)), origin=Origin.ENGINE) for k in range(20))
    file.save(Project(root=Layer("root", "Root", (RotoShape("shape-1", "A", keys),))), tmp_path / "a.roam")
    (shape,) = file.load(tmp_path / "a.roam").shapes
    assert not any(key.points.flags.writeable for key in shape.keys)


def test_what_could_not_be_read_again_is_not_saved(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.roam"
    file.save(Project(), path)
    before = path.read_bytes()
    blurred = RotoShape("a", "A", (Keyframe(1, CURVE),), motion_blur=MotionBlur(samples=MAX_SAMPLES + 1))
    for project in (
        Project(root=Layer("root", "Root", (blurred,))),
        Project(root=Layer("root", "Root", (replace(blurred, motion_blur=None),) * MAX_ITEMS)),
    ):
        with pytest.raises(RoamError, match=r"cannot be saved: it has more .* take some away"):
            file.save(project, path)
    for bound in ("MAX_BYTES", "MAX_VALUES", "MAX_NAMES"):
        monkeypatch.setattr(file, bound, 100)
        with pytest.raises(RoamError, match="too large for a file"):
            file.save(third_project(FOLDER), path)
        monkeypatch.undo()
    assert path.read_bytes() == before


# ---- sizes -----------------------------------------------------------------------------------------------------------


def test_a_long_shot_of_many_shapes_is_within_the_bounds() -> None:
    """300 shapes of 60 points, tracked on 500 frames, could not be saved."""
    points, sure = np.random.default_rng(1).normal(size=(500, 60, 3, 2)), np.full((500, 60), 0.7)
    keys = tuple(
        Keyframe(k, points[k], origin=Origin.ENGINE, confidence=0.7, vertex_confidence=sure[k], inputs="track:" * 20)
        for k in range(500)
    )
    project = Project(root=Layer("root", "Root", (RotoShape("a", "A", keys),)))
    content = b"".join(file.contents(project, FOLDER))
    values, names = file._counts(content)
    assert 300 * len(content) <= file.MAX_BYTES
    assert not file._is_too_much(300 * len(content), 300 * values, 300 * names)
    assert file.loads(content.decode(), FOLDER) == project


def test_a_project_is_written_shape_by_shape() -> None:
    """What one shape takes in memory is all that writing takes, beside the project."""
    shapes = tuple(RotoShape(name, name, (Keyframe(1, CURVE),)) for name in "abcdefgh")
    parts = list(file.contents(Project(root=Layer("root", "Root", shapes)), FOLDER))
    assert max(sum(part.count(b'"RotoShape"') for part in [each]) for each in parts) == 1


@pytest.mark.parametrize(
    "text",
    [
        b'{"type": "roam.Project", "version": 1, "x": [' + b"{}," * (file.MAX_VALUES // 2) + b"{}]}",
        b"[" + b"[]," * (file.MAX_VALUES // 2) + b"[]]",
        b"{" + b'"a":1,' * file.MAX_NAMES + b'"a":1,"a":1}',
    ],
    ids=["objects", "lists", "names"],
)
def test_many_small_values_are_refused_before_they_are_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: bytes
) -> None:
    monkeypatch.setattr(json, "loads", lambda *_, **__: pytest.fail("the text was parsed"))
    (tmp_path / "a.roam").write_bytes(text)
    assert "than can be opened" in refused(tmp_path / "a.roam")


def test_many_long_texts_are_refused_before_they_are_made(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(json, "loads", lambda *_, **__: pytest.fail("the text was parsed"))
    monkeypatch.setattr(file, "MAX_MEMORY", 100_000)
    texts = b"[" + b",".join([b'"%s"' % (b"a" * 30)] * 1000) + b"]"
    for content in (texts, b" " * 50_001):
        (tmp_path / "a.roam").write_bytes(content)
        assert "than can be opened" in refused(tmp_path / "a.roam")


def test_a_file_that_is_too_large_is_not_read(tmp_path: Path) -> None:
    with (tmp_path / "a.roam").open("wb") as sparse:
        sparse.truncate(file.MAX_BYTES + 1)
    assert f"is larger than {file.MAX_BYTES >> 20} MiB" in refused(tmp_path / "a.roam")


@posix
def test_only_regular_files_are_read(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.roam")
    (tmp_path / "endless.roam").symlink_to("/dev/zero")
    for name in ("pipe.roam", "endless.roam"):
        assert "is no regular file" in refused(tmp_path / name)


@pytest.mark.parametrize("marks", [["frame"], [7], 7])
def test_what_is_of_another_kind_is_told_in_our_own_words(tmp_path: Path, marks: object) -> None:
    sentence = damaged(tmp_path, lambda document: document.update(marks=marks))
    assert sentence.endswith("is damaged: a value in it is of another kind than it must be.")
