"""A run that decodes no more of its frames than it looks at gives the points of one that decodes all, bit by bit."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from benchmarks.scaling import drawn
from roam_core import edit, fill_span, track
from roam_core.media import open_clip
from roam_core.media.colour import to_engine
from roam_core.media.curves import linear_from_srgb
from roam_core.media.partial import PartialFrames, PartialPicture
from roam_core.media.source import MissingFrame
from roam_core.propagate import Termination
from roam_core.roto import RotoShape
from tests.unit.media.conftest import write_image

WIDTH, HEIGHT, COUNT = 600, 480, 5


@pytest.fixture(scope="module")
def plate(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, RotoShape]:
    folder = tmp_path_factory.mktemp("plate")
    shot, shape = drawn((WIDTH, HEIGHT), 20, COUNT)
    for frame, picture in enumerate(shot.pictures):
        light = linear_from_srgb(picture / 255.0).astype(np.float16)
        write_image(folder / f"p.{frame:04d}.exr", light, "half", compression="zips")
    return folder, shape


class Read:
    """A plate's frames in parts, one after the other; what was looked at of each, and what was told."""

    def __init__(self, folder: Path) -> None:
        self.told: list[int] = []
        self.pictures: dict[int, PartialPicture] = {}
        self.frames = PartialFrames(open_clip(folder), lambda frame, error: self.told.append(frame))

    def __call__(self, frame: int) -> PartialPicture:
        self.pictures[frame] = self.frames.read(frame)
        return self.pictures[frame]

    def all(self) -> Mapping[int, PartialPicture]:
        """The same by frame, as fills ask for them."""
        read = self

        class Pictures(dict[int, PartialPicture]):
            def __missing__(self, frame: int) -> PartialPicture:
                return read(frame)

        return Pictures()


@pytest.mark.parametrize("config", ["best", "full", "lean"])
def test_the_points_are_those_of_whole_pictures(plate: tuple[Path, RotoShape], config: str) -> None:
    folder, shape = plate
    source, read = open_clip(folder), Read(folder)
    whole = list(track(lambda frame: to_engine(source.read(frame), "linear"), [shape], range(COUNT), config))
    parts = list(track(read, [shape], range(COUNT), config))
    for one, other in zip(whole, parts, strict=True):
        np.testing.assert_array_equal(
            one.results[0].shape.at(one.frame).points, other.results[0].shape.at(one.frame).points
        )
        assert one.results[0].confidence == other.results[0].confidence
    if config == "best":
        assert read.pictures[COUNT - 1].nbytes < 0.7 * WIDTH * HEIGHT * 3 * 2


def test_a_fill_looks_at_parts_too(plate: tuple[Path, RotoShape]) -> None:
    folder, shape = plate
    source, read = open_clip(folder), Read(folder)
    ends = keyed_at_both_ends(shape, list(track(read, [shape], range(COUNT), "best"))[-1].results[0].shape)
    whole = {frame: to_engine(source.read(frame), "linear") for frame in range(COUNT)}
    again = Read(folder)
    (by_whole,), (by_parts,) = (fill_span(images, [ends], 0, COUNT - 1) for images in (whole, again.all()))
    assert [key.frame for key in by_parts.keys] == list(range(COUNT))
    for one, other in zip(by_whole.keys, by_parts.keys, strict=True):
        np.testing.assert_array_equal(one.points, other.points)
        assert one.confidence == other.confidence
    assert again.pictures[2].nbytes < 0.7 * WIDTH * HEIGHT * 3 * 2
    assert again.told == []


def test_a_fill_bridges_what_shows_as_damaged_only_where_it_is_looked_at(
    plate: tuple[Path, RotoShape], monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, shape = plate
    read = Read(folder)
    ends = keyed_at_both_ends(shape, list(track(read, [shape], range(COUNT), "best"))[-1].results[0].shape)
    torn, within = Read(folder), PartialPicture.within

    def damaged(self: PartialPicture, *box: int) -> object:
        if self is torn.pictures.get(2):
            raise MissingFrame("torn there")
        return within(self, *box)

    monkeypatch.setattr(PartialPicture, "within", damaged)
    (filled,) = fill_span(torn.all(), [ends], 0, COUNT - 1)
    assert [key.frame for key in filled.keys] == [0, 1, 3, 4]


def keyed_at_both_ends(shape: RotoShape, tracked: RotoShape) -> RotoShape:
    """The shape with artist keys on the first frame and, where a track took it, on the last."""
    return edit.set_key(shape, COUNT - 1, tracked.at(COUNT - 1).points)


def test_what_shows_as_damaged_only_where_it_is_looked_at_is_bridged(
    plate: tuple[Path, RotoShape], monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, shape = plate
    read = Read(folder)
    within = PartialPicture.within

    def torn(self: PartialPicture, top: int, end: int, left: int, right: int) -> object:
        if self is read.pictures.get(2) and left > 0:
            raise MissingFrame("torn there")
        return within(self, top, end, left, right)

    monkeypatch.setattr(PartialPicture, "within", torn)
    ends = {solved.frame: solved.results[0].termination for solved in track(read, [shape], range(COUNT), "best")}
    assert ends[2] is Termination.MISSING_FRAME
    assert Termination.MISSING_FRAME not in (ends[1], ends[3], ends[4])
