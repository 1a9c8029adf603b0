"""Files that are made to cost much: each is refused with a sentence before its cost is paid."""

from __future__ import annotations

import os
import zlib
from pathlib import Path

import pytest

from roam_core.errors import RoamError
from roam_core.interchange import read_shapes, reading
from roam_core.interchange.nuke.script import MAX_LISTS
from roam_core.interchange.reading import MAX_ITEMS, MAX_KEYS, MAX_PARTS, MAX_POINTS
from roam_core.interchange.svg.reading import MAX_DRAWING
from roam_core.interchange.svg.words import MAX_TRANSFORMS
from tests.unit.interchange.conftest import CLIP

SVG = '<svg xmlns="http://www.w3.org/2000/svg">{}</svg>'
JSON = '{{"format":"roam-shapes","version":1,"width":9,"height":9,"items":[{}]}}'
FADING = '{{"kind":"layer","items":[],"opacity":[{}]}}'.format(
    ",".join(f'{{"frame":{frame},"value":1}}' for frame in range(600))
)
POINT = "<Point>(0,0),(0,0),(0,0)</Point>"
ATTRIBUTES = " ".join(f'a{number}=""' for number in range(MAX_PARTS // 10))
TWO_POINTS = "{0 0} {{{1 0 0 1 9 1} {190000 5 3 1 0 1}} 1} {0 0} {0 0} {5 5} {0 0}"
MOVING = (
    "Roto {\ncurves {{{v 1} {f 0} {n {layer Root {f 0} {t 0} {a} "
    f"{{curvegroup A 512 bezier {{{{cc {{f 8192}} {{p {TWO_POINTS}}}}} idem}} {{t 0}} {{a}}}}}}}}}}}}\n}}\n"
)


def refused(tmp_path: Path, name: str, content: str | bytes) -> str:
    """What is said of a file."""
    path = tmp_path / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    with pytest.raises(RoamError) as caught:
        read_shapes(path, CLIP)
    assert str(path) in str(caught.value)
    return str(caught.value)


def test_json_that_would_become_millions_of_objects_is_not_taken_apart(tmp_path: Path) -> None:
    assert "lists and objects" in refused(tmp_path, "a.json", "[" + "{}," * MAX_PARTS + "{}]")
    assert "lists and objects" in refused(tmp_path, "a.json", "[" + "0," * (4 * MAX_PARTS + 4) + "0]")


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.json", JSON.format(",".join(['{"kind":"layer","items":[]}'] * (MAX_ITEMS + 1)))),
        ("a.fxs", "<Silhouette>" + "<Layer/>" * (MAX_ITEMS + 1) + "</Silhouette>"),
    ],
)
def test_more_shapes_and_layers_than_a_file_may_hold(tmp_path: Path, name: str, content: str) -> None:
    assert f"more than {MAX_ITEMS} shapes and layers" in refused(tmp_path, name, content)


def test_a_project_that_unpacks_without_end(tmp_path: Path) -> None:
    bomb = zlib.compress(b"<Project>" + bytes(64 << 20), 9)
    assert len(bomb) < 100_000
    assert "unpacks to more than 48 MiB" in refused(tmp_path, "a.sfx", (1 << 20).to_bytes(4, "big") + bomb)


@pytest.mark.parametrize(
    ("limit", "name", "content"),
    [
        ("MAX_PARTS", "a.fxs", "<Silhouette>" + "<a/>" * 10_000 + "</Silhouette>"),
        ("MAX_PARTS", "a.svg", SVG.format("<b/>" * 10_000)),
        ("MAX_PARTS", "a.svg", SVG.format('<path d="M0 0' + "L1 1" * 10_000 + '"/>')),
        ("MAX_PARTS", "a.svg", SVG.format('<path d="M0 0' + "A9 9 0 011 0" * 10_000 + '"/>')),
        ("MAX_PARTS", "a.svg", SVG.format('<polygon points="' + "1 2 " * 10_000 + '"/>')),
        ("MAX_PARTS", "a.svg", SVG.format('<g transform="' + "scale(1)" * 10_000 + '"/>')),
        ("MAX_PARTS", "a.nk", "a b\n" * 10_000),
        ("MAX_PARTS", "a.nk", "Roto {\ncurves {}\n}\n" * 10_000),
        ("MAX_POINTS", "a.svg", SVG.format('<polygon points="' + "1 2 " * 2_000 + '"/>')),
        ("MAX_KEYS", "a.nk", MOVING),
        ("MAX_KEYS", "a.json", JSON.format(",".join([FADING] * 2))),
    ],
)  # fmt: skip
def test_parts_are_counted_as_they_are_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, limit: str, name: str, content: str
) -> None:
    monkeypatch.setattr(reading, limit, 1_000)
    assert "holds more than 1000 " in refused(tmp_path, name, content)


def test_attributes_are_counted_before_the_tree_is_built(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("roam_core.interchange.xml.MAX_PARTS", MAX_PARTS // 10 - 1)
    assert "attributes" in refused(tmp_path, "a.fxs", f"<Silhouette {ATTRIBUTES}/>")


def test_a_script_of_nothing_but_braces(tmp_path: Path) -> None:
    assert f"more than {MAX_LISTS} lists" in refused(tmp_path, "a.nk", "{}" * (MAX_LISTS + 1))


def test_long_runs_in_a_script_take_no_memory_for_each_character(tmp_path: Path) -> None:
    for run in (";", " ", '"a'):
        assert "holds no Roto" in refused(tmp_path, "a.nk", run * 1_000_000)


def test_a_long_path_is_read_in_a_time_that_grows_with_its_length(tmp_path: Path) -> None:
    """Each of these once copied the rest of the text at every word: 40,000 words were 3 GB of copies."""
    path = tmp_path / "a.svg"
    path.write_text(SVG.format('<path d="M0 0' + "L1 1" * 40_000 + '"/>'), encoding="utf-8")
    (shape,) = read_shapes(path, CLIP).layer.shapes()
    assert shape.point_count == 40_001


def test_a_longer_list_of_transforms_than_any_program_writes_is_left_out(tmp_path: Path) -> None:
    path = tmp_path / "a.svg"
    lists = ("scale(1)" * MAX_TRANSFORMS, "scale(1)" * (MAX_TRANSFORMS + 1))
    drawn = "".join(f'<rect width="9" height="9" transform="{each}"/>' for each in lists)
    path.write_text(SVG.format(drawn), encoding="utf-8")
    imported = read_shapes(path, CLIP)
    assert len(list(imported.layer.shapes())) == 1
    assert f"more than {MAX_TRANSFORMS} transforms" in imported.notes[0]


@pytest.mark.parametrize("name", ["a.json", "a.nk", "a.fxs", "a.sfx", "a.svg"])
def test_no_reader_opens_a_pipe_or_an_endless_device(tmp_path: Path, name: str) -> None:
    os.mkfifo(tmp_path / name)
    (tmp_path / "link").mkdir()
    (tmp_path / "link" / name).symlink_to("/dev/zero")
    for path in (tmp_path / name, tmp_path / "link" / name):
        with pytest.raises(RoamError, match="is a pipe, a socket or a device"):
            read_shapes(path, CLIP)


def test_a_drawing_that_is_too_long_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "a.svg"
    path.touch()
    os.truncate(path, MAX_DRAWING + 1)
    with pytest.raises(RoamError, match="larger than 16 MiB"):
        read_shapes(path, CLIP)


def test_limits_leave_room_for_a_heavy_shot() -> None:
    """Of 100 shapes with 20 points and a key on each of 240 frames."""
    assert MAX_ITEMS > 100
    assert MAX_KEYS > 100 * 240
    assert MAX_POINTS > 100 * 240 * 20
