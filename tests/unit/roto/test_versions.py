"""Every field of every object survives its file, and files of every released version open for ever.

`python -m tests.unit.roto.test_versions` stores the project of a new version; those that are there stay as they are.
"""

from __future__ import annotations

import dataclasses
import inspect
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from roam_core.geometry import bezier
from roam_core.matte import render_matte
from roam_core.matte.rasterise import shape_matte
from roam_core.roto import (
    Keyframe,
    Layer,
    LayerTransform,
    Project,
    RotoShape,
    animated,
    file,
    keyframe,
    motion_blur,
    placement,
    project,
    shape,
)
from roam_core.roto.migrate import STEPS, VERSION
from roam_core.roto.shape import Outline
from tests.unit.roto.every_field import first_project, present_project, second_project, third_project

FOLDER = Path("/shots/show")
STORED = Path(__file__).with_name("projects")
EXAMPLES = {1: first_project, 2: second_project, 3: third_project}
"""What the stored project of each version holds."""
NOT_STORED = {(RotoShape, "placement"), (LayerTransform, "_digest")}
"""What follows from the rest."""


def defined_in(*modules: ModuleType) -> set[type]:
    """The dataclasses of these modules that a project is made of."""
    found = {kind for module in modules for _, kind in inspect.getmembers(module, inspect.isclass)}
    ours = {kind for kind in found if kind.__module__ in {module.__name__ for module in modules}} - {Outline}
    return {kind for kind in ours if dataclasses.is_dataclass(kind)}


def objects_in(value: Any) -> Iterator[Any]:
    """The dataclass objects in a project, itself first."""
    if dataclasses.is_dataclass(value):
        yield value
        for field in dataclasses.fields(value):
            yield from objects_in(getattr(value, field.name))
    elif isinstance(value, tuple):
        for item in value:
            yield from objects_in(item)


MODELS = defined_in(keyframe, shape, motion_blur, project, placement, animated)
FIELDS = [
    (kind, field)
    for kind in sorted(MODELS, key=lambda kind: kind.__name__)
    for field in dataclasses.fields(kind)
    if (kind, field.name) not in NOT_STORED
]


def plain(value: Any) -> Any:
    """A field's value in a form that == compares to the last bit."""
    if isinstance(value, np.ndarray):
        return value.shape, value.dtype.str, value.tobytes()
    if dataclasses.is_dataclass(value):
        return [plain(getattr(value, field.name)) for field in dataclasses.fields(value)]
    if isinstance(value, tuple):
        return [plain(item) for item in value]
    return json.dumps(value, sort_keys=True) if isinstance(value, dict) else (type(value).__name__, value)


def default_of(field: dataclasses.Field[Any]) -> Any:
    if field.default_factory is not dataclasses.MISSING:
        return field.default_factory()
    return field.default


@pytest.fixture(scope="module")
def pairs() -> list[tuple[Any, Any]]:
    """Every object of the fullest project, beside what came of it from a file."""
    given = present_project(FOLDER)
    again = file.loads(file.dumps(given, FOLDER), FOLDER)
    return list(zip(objects_in(given), objects_in(again), strict=True))


@pytest.mark.parametrize(("kind", "field"), FIELDS, ids=lambda part: getattr(part, "__name__", None) or part.name)
def test_a_field_survives_its_file(pairs: list[tuple[Any, Any]], kind: type, field: Any) -> None:
    mine = [pair for pair in pairs if type(pair[0]) is kind]
    told = [pair for pair in mine if plain(getattr(pair[0], field.name)) != plain(default_of(field))]
    assert told, f"no {kind.__name__} of the example has a {field.name} away from its default"
    for before, after in mine:
        assert plain(getattr(after, field.name)) == plain(getattr(before, field.name))


@pytest.mark.parametrize("field", [field for kind, field in FIELDS if kind is Keyframe], ids=lambda field: field.name)
def test_both_forms_of_a_key_hold_every_field(field: Any) -> None:
    """A key that is told by itself, and one in a run: each form alone carries the field."""
    tracked = present_project(FOLDER).find("shape-3")
    assert isinstance(tracked, RotoShape)
    document = json.loads(file.dumps(present_project(FOLDER), FOLDER))
    forms = [key["type"] for key in document["root"]["children"][0]["children"][2]["keys"]]
    assert forms == ["Keyframes", "Keyframe"]
    for key in (tracked.keys[0], tracked.keys[-1]):
        assert plain(getattr(key, field.name)) != plain(default_of(field))


def test_every_object_in_a_file_says_its_type() -> None:
    document = json.loads(file.dumps(present_project(FOLDER), FOLDER))
    found: set[str] = set()
    waiting: list[Any] = [document]
    while waiting:
        value = waiting.pop()
        if isinstance(value, dict):
            found.add(value["type"])
            waiting.extend(item for name, item in value.items() if name != "later")
        elif isinstance(value, list):
            waiting.extend(value)
    names = {kind.__name__ for kind in MODELS - {Project}}
    assert found == names | {"roam.Project", "Keyframes", "Numbers"}


# ---- released versions -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("version", range(1, VERSION + 1))
def test_a_file_of_every_version_opens(version: int) -> None:
    text = (STORED / f"version-{version}.roam").read_text(encoding="utf-8")
    assert json.loads(text)["version"] == version
    assert plain(file.loads(text, FOLDER)) == plain(EXAMPLES[version](FOLDER))


def test_files_of_this_version_are_written_as_the_stored_one() -> None:
    """Another form is another version, with a step that leads to it."""
    text = (STORED / f"version-{VERSION}.roam").read_text(encoding="utf-8")
    assert file.dumps(EXAMPLES[VERSION](FOLDER), FOLDER) == text


def test_every_older_version_has_its_step() -> None:
    assert sorted(STEPS) == list(range(1, VERSION))


def test_the_step_to_version_2_packs_the_matrices_of_layers() -> None:
    old = json.loads((STORED / "version-1.roam").read_text(encoding="utf-8"))
    rows = old["root"]["children"][0]["transform"]["matrices"]
    assert [len(row) for row in rows] == [9, 9]
    new = STEPS[1](old)
    packed = new["root"]["children"][0]["transform"]["matrices"]
    assert (packed["type"], packed["shape"]) == ("Numbers", [2, 3, 3])


def test_the_step_to_version_3_keeps_the_sums_that_shapes_were_joined_by() -> None:
    """Only what lies on others: the lowest of a layer joins with nothing, and may be called what it is called now."""
    shapes = [{"type": "RotoShape", "blend": "add"}, {"type": "RotoShape", "blend": "add"}]
    layers = [{"type": "Layer", "children": shapes}, {"type": "Layer", "children": []}]
    new = STEPS[2]({"root": {"type": "Layer", "children": layers}})
    lower, upper = new["root"]["children"]
    assert [child["blend"] for child in lower["children"]] == ["add", "plus"]
    assert ("blend" in lower, upper["blend"]) == (False, "plus")


def test_overlapping_soft_edges_of_an_older_project_render_as_they_did() -> None:
    def edges(version: int) -> Project:
        keys = (Keyframe(1, bezier.polygon_points([(10.0, 10.0), (30.0, 10.0), (30.0, 30.0), (10.0, 30.0)])),)
        left, right = RotoShape("shape-1", "A", keys, feather=8.0), RotoShape("shape-2", "B", keys, feather=8.0)
        layer = Layer("layer-1", "Above", (replace(left, id="shape-3", opacity=0.5),))
        text = file.dumps(Project(None, Layer("root", "Root", (left, right, layer))), FOLDER)
        return file.loads(json.dumps(json.loads(text) | {"version": version}), FOLDER)

    alone = shape_matte(edges(2).shapes[0], 1, (40, 40))
    before = np.minimum(np.minimum(alone + alone, 1.0) + 0.5 * alone, 1.0)
    np.testing.assert_allclose(render_matte(edges(2), 1, (40, 40)), before, atol=1e-6)
    union = 1.0 - (1.0 - alone) ** 2 * (1.0 - 0.5 * alone)
    np.testing.assert_allclose(render_matte(edges(3), 1, (40, 40)), union, atol=1e-6)
    assert np.abs(before - union).max() > 0.2


if __name__ == "__main__":
    with (STORED / f"version-{VERSION}.roam").open("x", encoding="utf-8") as stored:
        stored.write(file.dumps(EXAMPLES[VERSION](FOLDER), FOLDER))
