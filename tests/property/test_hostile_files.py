"""Files that somebody damaged or made up: a reader gives sensible shapes or one sentence, and never anything else."""

from __future__ import annotations

import re
import tempfile
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, Imported, read_shapes
from roam_core.interchange.protocol import MAX_FRAMES
from roam_core.interchange.reading import sensible
from roam_core.roto import (
    BlendMode,
    Clip,
    Interpolation,
    Keyframe,
    Layer,
    MotionBlur,
    Project,
    RotoShape,
    Spline,
    control_points,
    edit,
    file,
)
from roam_core.roto.animated import values_of

CLIP = Clip(Path("plate"), 1001, 1040, (640, 480))
WORDS = (
    "nan", "inf", "-inf", "1e999", "-1e308", "1e12", "99999999999999999999", "0", "-0", "1", "-1", "2.5", "", "{", "}",
    "{}", "{{}}", "[", "]", "(", ")", '"', "\\", "<", ">", "&", "&x;", "x7f800000", "x7fc00000", "xffffffff", "True",
    "null", "=exit", "{x 999999999 {1 -}}", "catmullrom", "hold", "M", "A 1 1 1 1 1 1 1", "e", "\0", "\N{HAIRCUT}",
)  # fmt: skip
"""What a word of a file is replaced by."""


@cache
def whole(name: str) -> str:
    """A file of the format with a bit of everything in it."""
    rng = np.random.default_rng(5)

    def keys(kind: Interpolation, feather: float = 0.0) -> tuple[Keyframe, ...]:
        points = [rng.uniform(0, 400, (4, 3, 2)) for _ in range(4)]
        soft = rng.uniform(-feather, feather, (4, 3, 2)) if feather else None
        return tuple(Keyframe(1001 + 7 * k, p, soft, interpolation=kind) for k, p in enumerate(points))

    shapes = (
        RotoShape("a", "Arm", keys(Interpolation.LINEAR, 9.0), feather=3.0, motion_blur=MotionBlur(), lifetime=(3, 9)),
        RotoShape("b", "{b} <&>", keys(Interpolation.SMOOTH), blend=BlendMode.SUBTRACT, invert=True, opacity=0.5),
        control_points.with_spline(RotoShape("c", "Curve", keys(Interpolation.HOLD), closed=False), Spline.BSPLINE),
    )
    root = Layer("root", "Root", (shapes[0], Layer("l", "Inner", shapes[1:], opacity=0.5, locked=True)))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "file"
        options = ExportOptions(lossy=True, frames=range(1001, 1003) if name == "coco" else None)
        EXPORTERS[name].export(Project(CLIP, root), path, options)
        text = min(Path(folder).iterdir()).read_text(encoding="utf-8")
    if name == "silhouette":
        matrix = '<Property id="transform.matrix"><Key frame="0">(1,0,0,0,0,1,0,0,0,0,1,0,0.1,0,0,1)</Key></Property>'
        text = text.replace('interp="linear"', 'interp="catmullrom"').replace("<Properties>", f"<Properties>{matrix}")
    return text


@st.composite
def damaged(draw: st.DrawFn, name: str) -> str:
    """The file with words replaced, parts cut out and parts repeated."""
    text = whole(name)
    for _ in range(draw(st.integers(1, 4))):
        start = draw(st.integers(0, max(len(text) - 1, 0)))
        match draw(st.sampled_from(["word", "word", "word", "cut", "repeat", "insert"])):
            case "word":
                found = re.compile(r"[^\s{}<>\"(),\[\]:]+").search(text, start)
                if found:
                    text = text[: found.start()] + draw(st.sampled_from(WORDS)) + text[found.end() :]
            case "cut":
                text = text[:start] + text[start + draw(st.sampled_from([1, 3, 50, 2000])) :]
            case "repeat":
                stop = start + draw(st.sampled_from([10, 300, 3000]))
                text = text[:stop] + text[start:]
            case _:
                text = text[:start] + draw(st.sampled_from(WORDS)) + text[start:]
    return text


def check(imported: Imported) -> None:
    """Everything that came is such that a project can hold it, and every note is a short sentence."""
    for shape in imported.layer.shapes():
        assert sensible(shape.keys)
        assert all(abs(frame) <= MAX_FRAMES for frame in shape.frames)
        assert all(0.0 <= value <= 1.0 for value in values_of(shape.opacity))
        assert all(0.0 <= share <= 1.0 for share in shape.colour)
        assert all(abs(value) < 1e30 for value in values_of(shape.feather))
        assert shape.lifetime is None or shape.lifetime[0] < shape.lifetime[1]
    for note in imported.notes:
        assert "\n" not in note
        assert len(note) < 400
    project, _ = edit.add_items(Project(CLIP), imported.layer.children)
    file.dumps(project, Path("/shots"))


@pytest.mark.parametrize("name", ["nuke", "silhouette", "svg", "json", "fusion", "coco", "cvat", "mlt"])
def test_a_damaged_file_gives_sensible_shapes_or_one_sentence(name: str) -> None:
    suffix = EXPORTERS[name].suffix

    @settings(deadline=None, max_examples=80, phases=[Phase.explicit, Phase.reuse, Phase.generate])
    @given(damaged(name))
    def read(text: str) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"file{suffix}"
            path.write_text(text, encoding="utf-8", errors="replace")
            said = ""
            try:
                check(read_shapes(path, CLIP))
            except RoamError as error:
                said = str(error)
            assert "\n" not in said

    read()


def nested_layers(depth: int) -> str:
    """A shape in layers that each blow it up a million million times and turn it."""
    path = "<Point>(0.1,0),(0,0),(0,0)</Point><Point>(1,1),(0,0),(0,0)</Point>"
    body = f'<Shape label="A"><Properties><Property id="path"><Path>{path}</Path></Property></Properties></Shape>'
    grow = '<Property id="transform.scale"><Value>(1e12,1e12)</Value></Property>'
    turn = '<Property id="transform.rotate"><Value>30</Value></Property>'
    for _ in range(depth):
        body = (
            f'<Layer type="Layer"><Properties>{grow}{turn}<Property id="objects">{body}</Property></Properties></Layer>'
        )
    return f'<Silhouette width="640" height="480">{body}</Silhouette>'


def nested_nodes(depth: int) -> str:
    """The same for Nuke."""
    points = "{0 0} {1 1} {0 0} {0 0} {5 5} {0 0} {0 0} {5 1} {0 0}"
    body = f"{{curvegroup A 512 bezier {{{{cc {{f 8192}} {{px 1 {points}}}}} idem}} {{t 0 0}} {{a}}}}"
    for _ in range(depth):
        body = f"{{layer L {{f 0}} {{t 0 0 0 0 0 0 0 0 30 1000000000000 1000000000000 1}} {{a}} {body}}}"
    return f"Roto {{\n curves {{{{{{v 1}} {{f 0}} {{n {body}}}}}}}\n}}\n"


def nested_groups(depth: int) -> str:
    """The same for SVG."""
    groups = '<g transform="scale(1e12) rotate(30)">' * depth
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="640" height="480">{groups}'
        f'<path id="A" d="M 1 1 L 5 5 L 1 5 Z"/>{"</g>" * depth}</svg>'
    )


@pytest.mark.parametrize(
    ("suffix", "text"),
    [(".fxs", nested_layers(30)), (".nk", nested_nodes(40)), (".svg", nested_groups(60))],
    ids=["silhouette", "nuke", "svg"],
)
def test_what_layers_send_beyond_all_numbers_is_named(tmp_path: Path, suffix: str, text: str) -> None:
    path = tmp_path / f"file{suffix}"
    path.write_text(text, encoding="utf-8")
    imported = read_shapes(path, CLIP)
    assert list(imported.layer.shapes()) == []
    assert "lies nowhere near the" in imported.notes[0]
