"""Nodes that Nuke wrote: all are read, what is refused is named, and what is written again has the same geometry."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.interchange import Imported, read_shapes
from roam_core.roto import Clip, Layer, Project
from tests.unit.interchange import nuke_judge, tcl
from tests.unit.interchange.conftest import roto_script

SAMPLES = Path(__file__).parents[3].parent / "shared" / "formats" / "samples" / "nuke"
PATHS = sorted(SAMPLES.glob("*.*")) if SAMPLES.is_dir() else []
CLIP = Clip(Path("plate"), 1, 100, (2048, 1556))

pytestmark = [
    pytest.mark.shared,
    pytest.mark.skipif(not PATHS, reason="the samples of the format notes do not lie beside the repository"),
]

EXPRESSIONS = {"NST_PerspectiveGuide__node0": {"Bezier1", "Bezier2"}, "WLF_SK_breakdownDesignTool__node8": {"qRosso"}}
KEYS = {
    "WLF_smoke__node0": 3,
    "WLF_smoke__node1": 5,
    "WLF_smoke__node2": 6,
    "WLF_smoke__node3": 5,
    "WLF_smoke__node4": 1,
}
SHAPES = {"WLF_CWSlate__node0": 5, "NST_UV_Mapper__node0": 8, "NST_BokehBuilder__node2": 6}


@pytest.fixture
def sample(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[str, Imported]:
    """Name and content of a sample; the one that the notes cut off has another suffix."""
    path: Path = request.param
    script = tmp_path / "sample.nk"
    script.write_bytes(path.read_bytes())
    return path.stem, read_shapes(script, CLIP)


def test_there_are_as_many_as_the_notes_say() -> None:
    assert len(PATHS) == 21


@pytest.mark.parametrize("sample", PATHS, ids=lambda path: path.stem, indirect=True)
def test_a_sample_is_read_and_written_again(sample: tuple[str, Imported]) -> None:
    name, imported = sample
    shapes = list(imported.layer.shapes())
    refused = EXPRESSIONS.get(name, set())
    told = " ".join(note for note in imported.notes if "follows the expression" in note)
    assert {shape for shape in refused if repr(shape) in told} == refused
    assert bool(shapes) is not bool(refused)
    assert len(shapes) == SHAPES.get(name, len(shapes))
    written = nuke_judge.judge(roto_script(Project(CLIP, Layer("root", "Root", imported.layer.children)))).root.shapes()
    for shape, again in zip(reversed(shapes), written, strict=True):
        assert again.name == shape.name
        for frame in np.linspace(shape.frames[0] - 1, shape.frames[-1] + 1, 40):
            np.testing.assert_allclose(again.points(frame), shape.at(frame).points, atol=0.01)


@pytest.mark.parametrize("name", KEYS)
def test_keys_of_a_moving_sample_are_those_of_its_text(name: str, tmp_path: Path) -> None:
    """The values at the keys, taken from the text by Tcl and with nothing of the reader's."""
    text = (SAMPLES / f"{name}.nk").read_text()
    interpreter = tcl.available()
    body = interpreter.split(interpreter.node_body(text.replace("RotoPaint {", "Roto {", 1)))
    knobs = dict(zip(body[::2], body[1::2], strict=False))
    (document,) = interpreter.split(knobs["curves"])
    (root,) = interpreter.split(interpreter.split(document)[-1])[1:]
    group = next(item for item in interpreter.split(root) if item.startswith("curvegroup"))
    outline = interpreter.split(interpreter.split(interpreter.split(group)[4])[0])
    _, times, *points = interpreter.split(outline[-1])
    frames = [nuke_judge.number(time) for time in interpreter.split(times)]
    assert len(frames) == KEYS[name]
    (shape,) = read_shapes(SAMPLES / f"{name}.nk", CLIP).layer.shapes()
    assert list(shape.artist_frames) == frames
    assert all(key.inputs.startswith("import:") for key in shape.keys if key.frame not in frames)
    for index, point in enumerate(points[1::3]):
        for axis, column in enumerate(interpreter.split(point)):
            values = expanded(interpreter, column, len(frames))
            read = [shape.at(frame).points[index, 0, axis] for frame in frames]
            np.testing.assert_allclose(read, values if axis == 0 else CLIP.size[1] - np.array(values), atol=1e-6)


def expanded(interpreter: tcl.Tcl, column: str, count: int) -> list[float]:
    """The values of one coordinate on all keys, run lengths written out."""
    if not column.startswith("{"):
        return [nuke_judge.number(column)] * count
    values: list[float] = []
    for key in interpreter.split(column):
        words = interpreter.split(key)
        copies, words = (int(words[1]), interpreter.split(words[2])) if words[0] == "x" else (1, words)
        values += [nuke_judge.number(words[0])] * copies
    return values * count if len(values) == 1 else values
