"""A part of the frames: pictures of no others, keys on no others, and the motion on them as it was."""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, ImportOptions, KeyChoice, read_shapes, write_shapes
from roam_core.interchange.protocol import exported_keys, readied, within
from roam_core.interchange.timing import value_within
from roam_core.matte import render_matte, shapes_from_mask
from roam_core.proposal.mask_keys.keys import keys_from_mask
from roam_core.roto import Animated, Clip, Interpolation, Layer, MotionBlur, Origin, Project, ValueKey, edit
from roam_core.roto.animated import frames_of
from tests.judges.coverage import overlap
from tests.judges.programs import JUDGES
from tests.judges.scenes import SCENES, blob
from tests.judges.table import Judge
from tests.unit.interchange.conftest import animated


@pytest.mark.parametrize("interpolation", Interpolation)
@pytest.mark.parametrize("frames", [range(1003, 1021), range(1011, 1013), range(1002, 1003), range(990, 1050)])
def test_the_shape_moves_as_it_did_on_the_frames_that_are_written(interpolation: Interpolation, frames: range) -> None:
    shape = animated("Arm", interpolation)
    cut = within(shape, frames)
    assert set(cut.frames) <= set(frames)
    for frame in frames:
        npt.assert_allclose(cut.at(frame).points, shape.at(frame).points, rtol=0, atol=1e-9)


def test_frames_that_hold_all_keys_change_nothing() -> None:
    shape = animated("Arm", Interpolation.SMOOTH)
    assert within(shape, range(1001, 1041)) == shape


@pytest.mark.parametrize("frames", [range(1003, 1031), range(1001, 1020), range(1003, 1020)])
def test_smooth_spans_that_are_not_cut_stay_smooth(frames: range) -> None:
    """One cut span made all of them straight between frames: motion blur showed that far from the cut, too."""
    shape = animated("Arm", Interpolation.SMOOTH)
    cut = within(shape, frames)
    whole = [span for span in pairwise(shape.frames) if span[0] >= frames[0] and span[1] <= frames[-1]]
    assert whole
    for first, last in whole:
        assert not set(range(first + 1, last)) & set(cut.frames)
        for moment in np.linspace(first, last, 23):
            npt.assert_allclose(cut.at(moment).points, shape.at(moment).points, rtol=0, atol=1e-9)


def test_beyond_the_keys_the_shape_stands_still() -> None:
    shape = animated("Arm")
    (key,) = within(shape, range(1035, 1041)).keys
    assert key.frame == 1035
    npt.assert_array_equal(key.points, shape.keys[-1].points)


def test_the_artists_keys_are_cut_where_the_artist_saw_them_move() -> None:
    shape = animated("Arm")
    cut = exported_keys(shape, ExportOptions(keys=KeyChoice.ARTIST, frames=range(1005, 1013)), [])
    assert [(key.frame, key.origin) for key in cut.keys] == [(1005, Origin.ARTIST), (1012, Origin.ARTIST)]
    start, stop = shape.at(1001).points, shape.at(1012).points
    npt.assert_allclose(cut.keys[0].points, start + (stop - start) * 4 / 11, rtol=0, atol=1e-9)


@pytest.mark.parametrize("name", [name for name in EXPORTERS if name not in ("mattes", "svg")])
@pytest.mark.parametrize("choice", KeyChoice)
def test_every_format_writes_them(project: Project, tmp_path: Path, name: str, choice: KeyChoice) -> None:
    whole, part = tmp_path / "whole", tmp_path / "part"
    EXPORTERS[name].export(project, whole, ExportOptions(keys=choice, lossy=True))
    EXPORTERS[name].export(project, part, ExportOptions(keys=choice, lossy=True, frames=range(1002, 1010)))
    texts = [[path.read_text() for path in sorted(tmp_path.glob(f"{word}*"))] for word in ("part", "whole")]
    assert all(texts)
    assert texts[0] != texts[1]


@pytest.mark.parametrize("interpolation", [Interpolation.LINEAR, Interpolation.HOLD])
@pytest.mark.parametrize("blur", [MotionBlur(), MotionBlur(2.5, -1.5), MotionBlur(1.0, 0.5), MotionBlur(0.5, 0.0)])
def test_motion_blur_at_both_ends_is_as_it_was(blur: MotionBlur, interpolation: Interpolation) -> None:
    feather = Animated((ValueKey(1001, 0.0), ValueKey(1040, 9.0)))
    shape = replace(animated("Arm", interpolation), motion_blur=blur, feather=feather)
    whole = Project(Clip(Path("/plates/shot"), 1001, 1040, (200, 150)), Layer("root", "Root", (shape,)))
    frames = range(1005, 1013)
    options = ExportOptions(frames=frames)
    (part,) = readied(whole, options).shapes
    part = exported_keys(part, options, [])
    assert set(part.frames) | set(frames_of(part.feather)) <= set(blur.seen_from(frames))
    for frame in (1005, 1012):
        cut = replace(whole, root=replace(whole.root, children=(part,)))
        npt.assert_allclose(render_matte(cut, frame, (150, 200)), render_matte(whole, frame, (150, 200)), atol=1e-5)


@pytest.mark.parametrize("blur", [MotionBlur(0.0), MotionBlur(samples=1)])
def test_a_shutter_that_shows_no_motion_reaches_no_further(blur: MotionBlur) -> None:
    assert blur.seen_from(range(5, 8)) == range(5, 8)
    assert MotionBlur(1.0, -3.0).seen_from(range(5, 8)) == range(2, 8)


def test_json_holds_no_key_beyond_them_and_what_the_shutter_reaches(project: Project, tmp_path: Path) -> None:
    EXPORTERS["json"].export(project, tmp_path / "p.json", ExportOptions(frames=range(1005, 1013)))
    text = (tmp_path / "p.json").read_text()
    frames = {int(word.split(":")[1].strip(" ,")) for word in text.splitlines() if '"frame":' in word}
    assert frames
    assert frames <= set(MotionBlur().seen_from(range(1005, 1013))) == set(range(1004, 1014))
    assert json.loads(text)["first_frame"] == 1001


def test_pictures_are_of_these_frames(project: Project, tmp_path: Path) -> None:
    options = ExportOptions(frames=range(1005, 1008))
    small = Project(project.require_clip(), project.root)
    EXPORTERS["svg"].export(small, tmp_path / "s.####.svg", options)
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"s.{frame}.svg" for frame in (1005, 1006, 1007)]
    EXPORTERS["svg"].export(small, tmp_path / "one.svg", options)
    assert 'data-roam-frame="1005"' in (tmp_path / "one.svg").read_text()
    EXPORTERS["mattes"].export(small, tmp_path / "mattes", ExportOptions(frames=range(1005, 1006)))
    assert [path.name for path in (tmp_path / "mattes").iterdir()] == ["matte.1005.png"]


@pytest.mark.parametrize("name", EXPORTERS)
def test_frames_that_the_clip_has_not_are_refused(project: Project, tmp_path: Path, name: str) -> None:
    outside, none = "must lie between 1001 and 1040", "lies before the first"
    for frames, told in ((range(1000, 1005), outside), (range(1039, 1042), outside), (range(1005, 1005), none)):
        with pytest.raises(RoamError, match=told):
            EXPORTERS[name].export(project, tmp_path / "p", ExportOptions(frames=frames))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", EXPORTERS)
def test_frames_the_wrong_way_round_are_refused_where_values_move(project: Project, tmp_path: Path, name: str) -> None:
    """The keys of an opacity were looked for on the frames before these were looked at: that was a traceback."""
    fading = Animated((ValueKey(1001, 0.0), ValueKey(1010, 1.0)))
    project = edit.set_properties(project, project.shapes[0].id, opacity=fading, feather=fading)
    with pytest.raises(RoamError, match="lies before the first"):
        EXPORTERS[name].export(project, tmp_path / "p", ExportOptions(frames=range(1010, 1005)))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("offset", [1 << 24, -(1 << 25), 10**30])
@pytest.mark.parametrize("name", EXPORTERS)
def test_absurd_frame_numbers_are_refused(project: Project, tmp_path: Path, name: str, offset: int) -> None:
    with pytest.raises(RoamError, match="would number frames beyond"):
        EXPORTERS[name].export(project, tmp_path / "out", ExportOptions(frame_offset=offset))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("frame", [1000, 1041])
def test_a_still_picture_of_another_frame_is_refused(project: Project, tmp_path: Path, frame: int) -> None:
    with pytest.raises(RoamError, match=f"Frame {frame} lies outside"):
        EXPORTERS["svg"].export(project, tmp_path / "p.svg", ExportOptions(frame=frame))


@pytest.mark.parametrize("interpolation", Interpolation)
@pytest.mark.parametrize("frames", [range(2, 9), range(4, 5), range(10, 12), range(-5, 40), range(-9, -3)])
def test_a_value_is_what_it_was_on_the_frames_that_are_written(interpolation: Interpolation, frames: range) -> None:
    value = Animated((ValueKey(0, 1.0, interpolation), ValueKey(5, 3.0, interpolation), ValueKey(20, 2.0)))
    cut = value_within(value, frames)
    assert set(frames_of(cut)) <= set(frames)
    assert isinstance(cut, Animated)
    for frame in frames:
        assert cut.at(frame) == pytest.approx(value.at(frame))


def fading(is_soft: bool = True) -> Project:
    """Opacities and feathers of shapes and of a layer that all begin before and end after the frames of the test."""
    scene = SCENES["in time"].project
    others = [item for item in scene.root.children if is_soft or item.name != "Softens"]
    fades = Animated((ValueKey(900, 0.0, Interpolation.SMOOTH), ValueKey(1007, 1.0), ValueKey(1200, 0.3)))
    feather = Animated((ValueKey(900, 1.0), *fades.keys[1:])) if is_soft else 0.0
    inner = blob("Far", 90.0, 200.0, 40.0, 20.0, opacity=fades, feather=feather)
    layer = Layer("layer-9", "Fades", (inner, blob("Cuts", 99.0, 190.0, 9.0, 9.0)), opacity=fades, invert=True)
    return Project(scene.clip, Layer("root", "Root", (*others, layer)))


def test_no_key_of_an_opacity_or_a_feather_lies_beyond_the_frames() -> None:
    frames = range(1004, 1010)
    root = readied(fading(), ExportOptions(frames=frames)).root
    items = [*root.items(), *root.shapes()]
    found = {frame for item in items for frame in frames_of(item.opacity)}
    found |= {frame for shape in root.shapes() for frame in frames_of(shape.feather)}
    assert found
    assert found <= set(frames)


@pytest.mark.parametrize("judge", [judge for judge in JUDGES if not judge.still], ids=lambda judge: judge.exporter)
def test_values_in_time_are_cut_and_counted_as_outlines_are(judge: Judge, tmp_path: Path) -> None:
    if judge.missing:
        pytest.skip(judge.missing)
    project, path = fading(is_soft=judge.exporter != "silhouette"), tmp_path / f"p{EXPORTERS[judge.exporter].suffix}"
    EXPORTERS[judge.exporter].export(project, path, ExportOptions(frames=range(1004, 1010), frame_offset=100))
    clip = project.require_clip()
    for frame in (1004, 1007, 1009):
        ours = render_matte(project, frame, (clip.size[1], clip.size[0]))
        assert overlap(ours, judge.matte(path, clip, frame + 100)) > judge.least, frame


def test_keys_beside_the_clip_are_told_with_the_offset_that_would_bring_them_in(tmp_path: Path) -> None:
    clip = Clip(Path("/plates/shot"), 1001, 1050, (200, 150))
    moving = Project(clip, Layer("root", "Root", (animated("Arm"),)))
    path = tmp_path / "arm.nk"
    EXPORTERS["nuke"].export(moving, path, ExportOptions(frame_offset=-1000))
    (note,) = read_shapes(path, clip).notes
    first = animated("Arm").frames[0] - 1000
    assert note.startswith(f"The keys lie on frames {first} to ")
    assert f"--frame-offset {first - 1001}' would begin" in note
    assert read_shapes(path, clip, ImportOptions(frame_offset=-1000)).notes == ()


@pytest.mark.parametrize(("name", "suffix"), [("nuke", ".nk"), ("silhouette", ".fxs"), ("json", ".json")])
@pytest.mark.parametrize(("first", "offset"), [(1001, 0), (1001, 1_000_000), (1_789_234, -1000)])
def test_a_shape_that_a_mask_began_comes_back_as_it_was(
    tmp_path: Path, name: str, suffix: str, first: int, offset: int
) -> None:
    """Its lifetime is open at one end: that end, too, is a frame that the formats can number."""
    one = np.zeros((90, 120), np.uint8)
    one[20:60, 10:50] = 255
    both = one.copy()
    both[20:60, 70:110] = 255
    shapes = keys_from_mask(shapes_from_mask(one, first), both, first + 3)
    assert [shape.lifetime is None for shape in shapes] == [True, False]
    clip = Clip(tmp_path / "plate", first, first + 6, (120, 90))
    path = tmp_path / f"a{suffix}"
    write_shapes(Project(clip, Layer("root", "Root", tuple(shapes))), path, name, ExportOptions(frame_offset=offset))
    read = read_shapes(path, clip, ImportOptions(frame_offset=offset))
    assert read.notes == ()
    for frame in (first, first + 2, first + 3, first + 6):
        mattes = [render_matte(each, frame, one.shape) for each in (shapes, list(read.layer.shapes()))]
        npt.assert_allclose(*mattes, rtol=0, atol=0.02)
