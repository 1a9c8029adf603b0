"""The library's calls take an argument for what it plainly means, and refuse what is none in one sentence."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from roam_core import (
    BlendMode,
    Clip,
    ExportOptions,
    KeyChoice,
    Keyframe,
    Layer,
    Origin,
    Project,
    RotoShape,
    Tracker,
    edit,
    fill_span,
    keys_from_mask,
    load_project,
    open_clip,
    read_mask,
    read_shapes,
    render_matte,
    save_project,
    shapes_from_mask,
    to_engine,
    track,
    write_shapes,
)
from roam_core.arguments import frame_number, moment, names_of, picture_of, pixels_of, shown, size_of
from roam_core.errors import RoamError
from roam_core.interchange import MaskOptions
from roam_core.interchange.matte_style import DataWindow, Depth, Gathering, MatteFile, MatteStyle, Parts
from roam_core.roto import Animated, ValueKey
from tests.golden.shots import gliding, square
from tests.unit.media.conftest import write_movie

SHOT = gliding(square(24.0), 4, (40.0, 38.0), (1.5, 0.5), size=(72, 96))
FIRST, LAST = SHOT.frames[0], SHOT.frames[-1]
SIZE = SHOT.size
IMAGES = [SHOT.read(frame) for frame in SHOT.frames]
MASK = SHOT.matte(FIRST)
SHAPE = shapes_from_mask(MASK, FIRST)[0]
KEYED = keys_from_mask([SHAPE], SHOT.matte(LAST), LAST)
NAMED = [replace(SHAPE, id=name) for name in ("shape-1", "shape-12")]


def tracked(image: Any = IMAGES[0], shape: Any = SHAPE, frame: Any = FIRST, following: Any = FIRST + 1) -> RotoShape:
    tracker = Tracker("baseline")
    tracker.start(image, shape, frame)
    return tracker.step(IMAGES[1], following).shape


def carried(
    read: Any = SHOT.read, shapes: Any = SHAPE, frames: Any = (FIRST, FIRST + 1), only: Any = None
) -> list[str]:
    (result,) = track(read, shapes, frames, "baseline", only=only)
    return [each.shape.id for each in result.results]


def filled(images: Any = IMAGES, shapes: Any = KEYED, start: Any = FIRST, stop: Any = LAST) -> list[RotoShape]:
    return fill_span(images, shapes, start, stop, "baseline")


@pytest.mark.parametrize("number", [1002, np.int64(1002), np.uint16(1002), np.float32(1002.0), 1002.0, np.array(1002)])
def test_a_frame_is_a_plain_integer_whatever_type_it_had(number: Any) -> None:
    assert type(frame_number(number)) is int
    assert [type(frame) for frame in tracked(following=number).frames] == [int, int]
    assert tracked(following=number) == tracked()


@pytest.mark.parametrize("number", [1002.5, "1002", None, True, np.nan, [1002], np.bool_(True)])
def test_what_is_no_frame_is_refused(number: Any) -> None:
    calls: list[Callable[[], object]] = [
        lambda: tracked(frame=number),
        lambda: tracked(following=number),
        lambda: shapes_from_mask(MASK, number),
        lambda: keys_from_mask([SHAPE], MASK, number),
        lambda: carried(frames=[FIRST, number]),
        lambda: filled(stop=number),
        lambda: Keyframe(number, SHAPE.keys[0].points),
    ]
    for call in calls:
        with pytest.raises(ValueError, match="a frame is a whole number such as 1001, not"):
            call()


@pytest.mark.parametrize("name", ["p.1001.png", "p.avi"])
def test_a_plate_refuses_what_is_no_frame(tmp_path: Path, name: str) -> None:
    write_movie(tmp_path / "p.avi", "MJPG", 2)
    cv2.imwrite(str(tmp_path / "p.1001.png"), IMAGES[0])
    plate = open_clip(tmp_path / name)
    first = plate.frames[0]
    assert (plate.read(float(first)) == plate.read(np.int64(first))).all()  # type: ignore[arg-type]
    for number in (str(first), first + 0.5, None, [first]):
        with pytest.raises(ValueError, match="a frame is a whole number such as 1001, not"):
            plate.read(number)  # type: ignore[arg-type]


def test_a_clip_is_that_of_a_plate_that_is_open() -> None:
    with pytest.raises(ValueError, match=r"a Clip is that of an open plate, as open_clip gives it, not of 'shot'"):
        Clip.of("shot")  # type: ignore[arg-type]


def test_a_project_of_a_name_that_no_file_can_have_is_refused() -> None:
    with pytest.raises(RoamError, match=r"cannot be read: embedded null byte\.$"):
        load_project("a\0.roam")


@pytest.mark.parametrize("frame", ["1001", None, np.nan, np.inf])
def test_what_is_no_moment_is_refused(frame: Any) -> None:
    assert moment(1001.25) == 1001.25
    with pytest.raises(ValueError, match="a frame is a number such as 1001"):
        render_matte([SHAPE], frame, SIZE)


@pytest.mark.parametrize("tolerance", [-1.0, np.nan])
def test_a_tolerance_is_no_less_than_nothing(tolerance: float) -> None:
    with pytest.raises(ValueError, match="a tolerance is a number of pixels"):
        shapes_from_mask(MASK, FIRST, tolerance)


@pytest.mark.filterwarnings("ignore:the matrix subclass:PendingDeprecationWarning")
def test_lists_and_matrices_are_pictures_and_masks() -> None:
    assert picture_of(np.asmatrix(MASK)).shape == (*MASK.shape, 3)  # a matrix takes no third axis: numpy crashed
    assert tracked(IMAGES[0].tolist()) == tracked()
    assert pixels_of([[0, 256]]).dtype != np.uint8
    hidden = pixels_of(np.ma.masked_array(np.full((1, 2), 9, np.uint8), mask=[[True, False]]))
    assert (type(hidden), hidden.tolist()) == (np.ndarray, [[0, 9]])
    for mask in (MASK.tolist(), (MASK.astype(np.uint8) * 255).tolist(), memoryview(MASK)):
        (made,) = shapes_from_mask(mask, FIRST)  # type: ignore[arg-type]
        assert made.keys == SHAPE.keys
        (keyed,) = keys_from_mask([SHAPE], mask, FIRST)  # type: ignore[arg-type]
        assert keyed.frames == (FIRST,)


@pytest.mark.parametrize(
    ("image", "reason"),
    [
        (None, "not None; read files with"),
        ("plate.png", "not 'plate.png'; read files with"),
        (Path("plate.png"), "read files with"),
        ([[1, 2], [3]], "rows differ in length"),
        (np.full((4, 4), "x"), "holds numbers"),
        (np.zeros((4, 4), complex), "holds numbers"),
    ],
)
def test_what_is_no_picture_is_refused(image: Any, reason: str) -> None:
    for call in (
        tracked,
        shapes_from_mask,
        partial(to_engine, colour_space="sRGB"),
        lambda image: keys_from_mask([SHAPE], image, FIRST),
    ):
        with pytest.raises(ValueError, match=reason):
            call(image)
    with pytest.raises(ValueError, match=reason):
        carried(read=lambda _: image)


@pytest.mark.parametrize("space", ["sRGB", "linear", "log", "ACEScg"])
def test_pictures_of_other_types_and_shapes_are_converted_or_refused(space: str) -> None:
    """Numbers of 64 bits came out white or black, greys and slices ended in an error of OpenColorIO."""
    wanted = to_engine(SHOT.read(FIRST), space)
    picture = np.asarray(SHOT.read(FIRST))
    for kind in (np.int8, np.int16, np.uint32, np.int64):
        with pytest.raises(ValueError, match=f"uint8 or uint16, not {np.dtype(kind)}"):
            to_engine(picture.astype(kind), space)
    for shape in (picture[None], picture[..., :2], picture[..., [0, 1, 2, 0]], picture[0, 0]):
        with pytest.raises(ValueError, match=r"not \(h, w, 3\)"):
            to_engine(shape, space)
    words = picture.astype(np.uint16) * 257
    np.testing.assert_array_equal(to_engine(words.astype(">u2"), space), to_engine(words, space))
    np.testing.assert_array_equal(to_engine(picture[:, ::-1], space), wanted[:, ::-1])
    np.testing.assert_array_equal(to_engine(np.asfortranarray(picture), space), wanted)
    grey = to_engine(picture[..., 0], space)
    np.testing.assert_array_equal(grey, to_engine(picture[..., [0, 0, 0]], space))
    assert grey.shape == picture.shape


@pytest.mark.parametrize("space", [None, 3, b"sRGB"])
def test_a_colour_space_is_a_name(space: Any) -> None:
    with pytest.raises(ValueError, match="a colour space is a name, such as 'sRGB', not "):
        to_engine(IMAGES[0], space)


def test_a_shape_alone_is_a_list_of_one() -> None:
    assert carried(SHOT.read, SHAPE) == carried(SHOT.read, [SHAPE]) == carried(SHOT.read, iter([SHAPE]))
    assert filled(shapes=KEYED[0]) == filled() == filled(shapes=iter(KEYED))
    assert keys_from_mask(SHAPE, MASK, FIRST) == keys_from_mask([SHAPE], MASK, FIRST)  # type: ignore[arg-type]
    np.testing.assert_array_equal(render_matte(SHAPE, FIRST, SIZE), render_matte([SHAPE], FIRST, SIZE))


def test_greys_may_have_one_channel_and_an_alpha_is_to_be_left_out() -> None:
    grey = IMAGES[0].mean(axis=2) / 255.0
    assert tracked(grey[:, :, None]) == tracked(grey)
    np.testing.assert_array_equal(to_engine(grey[:, :, None], "sRGB"), to_engine(grey, "sRGB"))
    for call in (tracked, lambda image: to_engine(image, "sRGB")):
        with pytest.raises(
            ValueError, match=r"\(72, 96, 4\), not \(h, w, 3\); leave out its alpha: image\[\.\.\., :3\]$"
        ):
            call(np.zeros((*SIZE, 4), np.uint8))
        with pytest.raises(ValueError, match=r"\(72, 96, 2\), not \(h, w, 3\)$"):
            call(np.zeros((*SIZE, 2), np.uint8))


@pytest.mark.parametrize("tolerance", ["1", [1.0], np.nan, -0.5])
def test_what_is_no_tolerance_is_refused(tolerance: Any) -> None:
    with pytest.raises(ValueError, match="a tolerance is a number of pixels, 0 or more, not"):
        shapes_from_mask(MASK, FIRST, tolerance)


@pytest.mark.parametrize("shape", [None, "a.roam", [None], SHAPE.keys[0].points, Project()])
def test_what_is_no_shape_is_refused(shape: Any) -> None:
    for call in (carried, filled, lambda shapes: keys_from_mask(shapes, MASK, FIRST)):
        with pytest.raises(ValueError, match="a shape is a RotoShape"):
            call(shapes=shape)
    tracker = Tracker("baseline")
    for argument in (shape, [SHAPE]):
        with pytest.raises(ValueError, match="carries one RotoShape"):
            tracker.start(IMAGES[0], argument, FIRST)
    tracker.start(IMAGES[0], SHAPE, FIRST)
    with pytest.raises(ValueError, match="carries one RotoShape"):
        tracker.correct(shape)
    if not isinstance(shape, Project):
        with pytest.raises(ValueError, match="a shape is a RotoShape"):
            render_matte(shape, FIRST, SIZE)


@pytest.mark.parametrize("place", [np.nan, 1e9, 1e300])
def test_a_point_nowhere_near_the_image_is_named_in_place_of_taking_all_memory(place: float) -> None:
    """A project file may hold such numbers: `roam track` ended in a traceback, or asked for gigabytes."""

    def with_point(shape: RotoShape, frame: int) -> RotoShape:
        points = np.array(shape.at(frame).points)
        points[0, 0, 0] = place
        keys = [replace(key, points=points) if key.frame == frame else key for key in shape.keys]
        return replace(shape, keys=tuple(keys))

    calls: list[tuple[int, Callable[[], object]]] = [
        (FIRST, lambda: tracked(shape=with_point(SHAPE, FIRST))),
        (FIRST, lambda: carried(shapes=with_point(SHAPE, FIRST))),
        (LAST, lambda: filled(shapes=[with_point(shape, LAST) for shape in KEYED])),
    ]
    for frame, call in calls:
        with pytest.raises(RoamError, match=f"'{SHAPE.name}' has a point on frame {frame} that lies nowhere near"):
            call()


def test_a_tracker_that_was_not_started_says_what_to_do() -> None:
    with pytest.raises(RuntimeError, match="call start"):
        Tracker("baseline").step(IMAGES[0], FIRST)
    with pytest.raises(ValueError, match="a configuration is a name, such as 'best'"):
        Tracker(None)  # type: ignore[arg-type]


def test_only_may_be_one_id_and_no_other_than_there_are() -> None:
    for only in ("shape-12", ["shape-12"], iter(["shape-12"])):
        assert carried(shapes=NAMED, only=only) == ["shape-12"]
    assert carried(shapes=NAMED) == ["shape-1", "shape-12"]
    for wrong in ("shape", ["shape-12", "shape-3"], [NAMED[0]]):
        with pytest.raises(ValueError, match=r"ids of the shapes \(shape-1, shape-12\), not"):
            carried(shapes=NAMED, only=wrong)
    two = [replace(KEYED[0], id=name) for name in ("shape-1", "shape-12")]
    first, second = fill_span(IMAGES, two, FIRST, LAST, "baseline", only="shape-12")
    assert first == two[0]
    assert len(second.frames) == len(IMAGES)
    assert names_of(None, ["a"]) is None


def test_frames_and_their_reader_are_what_they_should_be() -> None:
    with pytest.raises(ValueError, match="frames are several numbers"):
        carried(frames=FIRST)
    by_frame = dict(zip(SHOT.frames, IMAGES, strict=True))
    assert carried(read=by_frame) == carried(read=by_frame.__getitem__) == carried()
    for read in (None, IMAGES, "shot"):
        with pytest.raises(ValueError, match="a mapping from frames to pictures, or a function that reads one"):
            carried(read=read)


def test_a_span_is_filled_from_any_sequence_of_its_pictures() -> None:
    by_frame = filled(dict(zip(SHOT.frames, IMAGES, strict=True)))
    assert filled(IMAGES) == filled(tuple(IMAGES)) == filled(np.stack(IMAGES)) == filled(SHOT.read) == by_frame
    assert filled(deque(IMAGES)) == by_frame
    with pytest.raises(RoamError, match=f"no image of frame {FIRST}; give one, or raise MissingFrame"):
        filled({LAST: IMAGES[-1]})
    with pytest.raises(ValueError, match=f"3 images for the frames {FIRST} to {LAST}"):
        filled(IMAGES[1:])
    for images in (None, iter(IMAGES), "shot"):
        with pytest.raises(ValueError, match="a mapping from frames to pictures"):
            filled(images)


@pytest.mark.parametrize("size", [list(SIZE), np.array(SIZE), (np.int32(SIZE[0]), float(SIZE[1]))])
def test_a_size_is_any_pair_of_whole_numbers(size: Any) -> None:
    assert [type(length) for length in size_of(size)] == [int, int]
    np.testing.assert_array_equal(render_matte([SHAPE], FIRST, size), render_matte([SHAPE], FIRST, SIZE))


@pytest.mark.parametrize("size", [(72, 96, 3), (-72, 96), (72.5, 96), 72, None, "ab", ()])
def test_what_is_no_size_is_refused(size: Any) -> None:
    with pytest.raises(ValueError, match=r"a size is \(height, width\)"):
        render_matte([SHAPE], FIRST, size)


def test_words_stand_for_the_kinds_that_they_name() -> None:
    points = SHAPE.keys[0].points
    key = Keyframe(1, points, origin="engine", interpolation="hold")  # type: ignore[arg-type]
    assert key.origin is Origin.ENGINE
    assert RotoShape("a", "A", (key,), blend="subtract").blend is BlendMode.SUBTRACT  # type: ignore[arg-type]
    assert ExportOptions(keys="reduced").keys is KeyChoice.REDUCED  # type: ignore[arg-type]
    assert MaskOptions(keys="every").keys is KeyChoice.EVERY  # type: ignore[arg-type]
    assert Layer("l", "L", (SHAPE,), blend="max").blend is BlendMode.MAX  # type: ignore[arg-type]
    assert Animated((ValueKey(1, 0.0, "hold"), ValueKey(5, 1.0))).at(3) == 0.0  # type: ignore[arg-type]
    style = MatteStyle("exr", "float", parts="layer", gathering="channels", window="tight")  # type: ignore[arg-type]
    assert style == MatteStyle(MatteFile.EXR, Depth.FLOAT, None, Parts.LAYER, Gathering.CHANNELS, DataWindow.TIGHT)
    assert style.window is DataWindow.TIGHT
    for call in (
        lambda: MaskOptions(keys="few"),  # type: ignore[arg-type]
        lambda: Layer("l", "L", blend="cut"),  # type: ignore[arg-type]
        lambda: ValueKey(1, 0.0, "held"),  # type: ignore[arg-type]
        lambda: MatteStyle("gif"),  # type: ignore[arg-type]
        lambda: MatteStyle(depth="12"),  # type: ignore[arg-type]
        lambda: Keyframe(1, points, origin="nobody"),  # type: ignore[arg-type]
        lambda: RotoShape("a", "A", (key,), blend="cut"),  # type: ignore[arg-type]
        lambda: ExportOptions(keys="few"),  # type: ignore[arg-type]
        lambda: ExportOptions(frames=(1, 9)),  # type: ignore[arg-type]
    ):
        with pytest.raises(ValueError, match=r"is not a valid|are a range"):
            call()


@pytest.mark.parametrize("value", [np.nan, np.inf, None, "1", [0.5]])
def test_what_is_no_number_never_becomes_a_value(value: Any) -> None:
    """It went into the files of other programs: nan."""
    for call in (
        lambda: replace(SHAPE, opacity=value),
        lambda: replace(SHAPE, feather=value),
        lambda: Layer("root", "Root", opacity=value),
        lambda: ValueKey(FIRST, value),
    ):
        with pytest.raises(ValueError, match=r"(opacity|feather|value) of .* is a number, not"):
            call()


def test_a_value_is_a_plain_number_and_an_open_lifetime_has_ends(tmp_path: Path) -> None:
    """A number of NumPy's ended the exports as JSON in a TypeError, and so did None in a lifetime all of them."""
    shape = replace(SHAPE, opacity=np.float32(0.5), feather=2, lifetime=(None, LAST))  # type: ignore[arg-type]
    layer = Layer("root", "Root", (shape,), opacity=Animated((ValueKey(FIRST, np.float64(0.5)),)))
    assert (type(shape.opacity), type(shape.feather)) == (float, float)
    assert (shape.exists_at(FIRST - 1000), shape.exists_at(LAST)) == (True, False)
    for name, suffix in (("nuke", ".nk"), ("json", ".json"), ("after-effects", ".jsx")):
        write_shapes(Project(CLIP, layer), tmp_path / f"shapes{suffix}", name)


CLIP = Clip("/plates/plate.%04d.exr", FIRST, LAST, (96, 72))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "project",
    [
        Project(CLIP, Layer("root", "Root", (SHAPE, SHAPE))),
        Project(CLIP, Layer("root", "Root", (replace(SHAPE, id=5),))),  # type: ignore[arg-type]
        Project(CLIP, Layer("root", "Root", (replace(SHAPE, name=5),))),  # type: ignore[arg-type]
        Project(CLIP, Layer("root", "Root", (RotoShape("a", "A", (Keyframe(1, SHAPE.keys[0].points * np.nan),)),))),
        Project(CLIP, Layer("root", "Root", (RotoShape("a", "A", (Keyframe(10**12, SHAPE.keys[0].points),)),))),
        Project(replace(CLIP, first=LAST + 1)),
    ],
    ids=["twice", "id", "name", "nan", "far", "clip"],
)
def test_a_project_that_could_not_be_opened_again_is_not_written(tmp_path: Path, project: Project) -> None:
    path = tmp_path / "p.roam"
    save_project(Project(CLIP, Layer("root", "Root", (SHAPE,))), path)
    before = path.read_bytes()
    with pytest.raises(ValueError, match="could not be opened again: "):
        save_project(project, path)
    assert path.read_bytes() == before
    assert load_project(path).shapes == (SHAPE,)


def test_shapes_of_one_id_are_named_where_a_project_with_them_is_not_written(tmp_path: Path) -> None:
    twins = replace(SHAPE, name="Arm"), replace(SHAPE, name="Leg")
    with pytest.raises(ValueError, match="'Arm' and 'Leg' have one id"):
        save_project(Project(CLIP, Layer("root", "Root", twins)), tmp_path / "p.roam")


def test_files_are_made_of_projects_and_read_for_clips(tmp_path: Path) -> None:
    for call in (save_project, lambda shapes, path: write_shapes(shapes, path, "nuke")):
        with pytest.raises(ValueError, match="Project"):
            call([SHAPE], tmp_path / "p.nk")
    with pytest.raises(ValueError, match=r"such as Clip\.of"):
        read_shapes(tmp_path / "p.nk", "plates")  # type: ignore[arg-type]
    for options in ({"lossy": True}, None, "lossy"):
        with pytest.raises(ValueError, match=r"options are ExportOptions\(\.\.\.\), not "):
            write_shapes(Project(CLIP), tmp_path / "p.nk", "nuke", options)  # type: ignore[arg-type]
        with pytest.raises(ValueError, match=r"options are ImportOptions\(\.\.\.\), not "):
            read_shapes(tmp_path / "p.nk", CLIP, options)  # type: ignore[arg-type]
    assert list(tmp_path.iterdir()) == []


def test_shapes_of_two_masks_come_into_one_project() -> None:
    """Their ids are the same; what is refused says what takes them."""
    project = edit.add_shape(Project(CLIP), SHAPE)
    with pytest.raises(ValueError, match=r"is taken; edit\.add_items gives shapes ids that are free"):
        edit.add_shape(project, SHAPE)
    project, (added,) = edit.add_items(project, [SHAPE])
    assert len(project.shapes) == 2
    assert project.shape(added).keys == SHAPE.keys


@pytest.mark.parametrize("path", [None, 5, ["shot"]])
def test_what_names_no_file_is_refused_by_every_call_that_takes_a_path(path: Any) -> None:
    project = Project(Clip(Path("/plate"), 1, 5, (20, 20)))
    calls: list[Callable[[], object]] = [
        lambda: open_clip(path),
        lambda: read_mask(path),
        lambda: load_project(path),
        lambda: save_project(project, path),
        lambda: read_shapes(path, Clip(Path("/plate"), 1, 5, (20, 20))),
        lambda: write_shapes(project, path, "json"),
    ]
    for call in calls:
        with pytest.raises(ValueError, match="a file is named by a text or a Path, not"):
            call()


def test_a_path_may_be_bytes_as_the_system_has_them(tmp_path: Path) -> None:
    project = Project(Clip(tmp_path / "plate", 1, 5, (20, 20)))
    save_project(project, os.fsencode(tmp_path / "größe.roam"))
    assert load_project(tmp_path / "größe.roam") == project


@pytest.mark.parametrize("number", [np.nan, np.inf, -np.inf])
def test_a_point_that_is_not_finite_has_no_matte(number: float) -> None:
    points = np.full((4, 3, 2), 10.0)
    points[1, 2, 0] = number
    with pytest.raises(ValueError, match="not finite"):
        render_matte(RotoShape("shape-1", "A", (Keyframe(1, points),)), 1, (20, 20))


def test_a_wrong_argument_is_shown_in_few_letters() -> None:
    assert shown(np.zeros((4, 5))) == "an array of shape (4, 5)"
    assert shown("x" * 1000) == "a str"
    assert shown(3) == "3"
