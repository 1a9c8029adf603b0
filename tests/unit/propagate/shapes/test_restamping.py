"""Stamps after an edit of all keys alike: what was fresh is fresh, what was stale is stale, and nothing beyond."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes import restamping
from roam_core.propagate.shapes.provenance import Stamps, clip_stamp, fill_stamp, stamp
from roam_core.propagate.shapes.restamping import renumbered, restamped
from roam_core.roto import Clip, Keyframe, Layer, Origin, Project, RotoShape
from roam_core.roto.imported import IMPORT, import_stamp, is_import, stamped
from roam_core.roto.shifting import shifted

CLIP = Clip(Path("/plates/plate"), 1001, 1012, (160, 120))
PARAMS = CONFIGS[DEFAULT_CONFIG]
SQUARE = polygon_points([(20, 20), (60, 20), (60, 60), (20, 60)])
ALL = range(1001, 1013)


def key(frame: int, inputs: str = "") -> Keyframe:
    origin = Origin.ENGINE if inputs else Origin.ARTIST
    return Keyframe(frame, SQUARE + frame - 1001.0, origin=origin, inputs=inputs)


def tracked() -> RotoShape:
    """The artist's keys on 1003 and 1008; tracked back from the first, filled between, tracked on from the second."""
    drawn = RotoShape("shape-1", "Shape 1", (key(1003), key(1008)))
    clip = clip_stamp(CLIP)
    keys = [key(frame, stamp([drawn], frame, 1003, PARAMS, clip, forward=False)) for frame in (1001, 1002)]
    keys += [key(frame, fill_stamp([drawn], (1003, 1008), PARAMS, clip)) for frame in range(1004, 1008)]
    keys += [key(frame, stamp([drawn], frame, 1008, PARAMS, clip, forward=True)) for frame in (1009, 1010)]
    return drawn.with_keys(keys)


def project(shape: RotoShape) -> Project:
    return Project(CLIP, Layer("root", "Root", (shape,)))


def moved(shape: RotoShape, frames: range) -> RotoShape:
    keys = (replace(each, points=each.points + np.array([5.0, -3.0])) for each in shape.keys if each.frame in frames)
    return shape.with_keys(keys)


def stale(held: Project) -> list[int]:
    stamps, shape = Stamps.of(held.shapes, held.clip), held.shapes[0]
    return [each.frame for each in shape.keys if stamps.is_stale(shape, each)]


def test_where_all_moved_alike_nothing_is_stale() -> None:
    before = project(tracked())
    after = project(moved(tracked(), ALL))
    assert stale(before) == []
    assert len(stale(after)) == 8
    fresh = restamped(before, after, ["shape-1"], ALL)
    assert stale(fresh) == []
    for was, now in zip(after.shapes[0].keys, fresh.shapes[0].keys, strict=True):
        np.testing.assert_array_equal(was.points, now.points)
        assert was.origin is now.origin


def test_what_was_tracked_from_beyond_the_frames_is_stale() -> None:
    frames = range(1003, 1009)
    fresh = restamped(project(tracked()), project(moved(tracked(), frames)), ["shape-1"], frames)
    assert stale(fresh) == [1001, 1002, 1009, 1010]


def test_what_was_stale_before_stays_so() -> None:
    shape = tracked()
    shape = shape.with_key(replace(shape.key_at(1008), points=SQUARE))  # type: ignore[type-var]
    assert (before := stale(project(shape)))
    fresh = restamped(project(shape), project(moved(shape, ALL)), ["shape-1"], ALL)
    assert stale(fresh) == before


def test_keys_between_those_of_a_file_go_along() -> None:
    shape = stamped(RotoShape("shape-1", "Shape 1", (key(1001), key(1002, IMPORT), key(1003))))
    assert isinstance(shape, RotoShape)
    fresh = restamped(project(shape), project(moved(shape, ALL)), ["shape-1"], ALL)
    assert stale(project(moved(shape, ALL))) == [1002]
    assert stale(fresh) == []


@pytest.mark.parametrize("config", ["no such one", ""])
def test_a_stamp_of_another_program_is_left_alone(config: str) -> None:
    shape = RotoShape("shape-1", "Shape 1", (key(1001), key(1002, f"forward:{config}:0123:from=1001")))
    fresh = restamped(project(shape), project(moved(shape, ALL)), ["shape-1"], ALL)
    assert fresh.shapes[0].keys[1].inputs == shape.keys[1].inputs


@pytest.mark.parametrize("forward", [True, False])
def test_tracked_keys_that_are_shifted_below_the_same_pictures_are_stale_until_they_are_shifted_back(
    forward: bool,
) -> None:
    drawn = RotoShape("shape-1", "Shape 1", (key(1005),))  # one key alone: its outline is the same on all frames
    frames = (1006, 1007) if forward else (1003, 1004)
    clip = clip_stamp(CLIP)
    before = project(drawn.with_keys(key(f, stamp([drawn], f, 1005, PARAMS, clip, forward=forward)) for f in frames))
    assert stale(before) == []
    assert stale(shifted(before, 2)) == [frame + 2 for frame in frames]
    assert stale(shifted(before, 2, ["shape-1"])) == [frame + 2 for frame in frames]
    assert stale(shifted(shifted(before, 2), -2)) == []


def test_where_the_plate_is_numbered_anew_what_was_fresh_is_fresh_and_what_was_stale_is_stale() -> None:
    shape = tracked()
    shape = shape.with_key(replace(shape.key_at(1008), points=SQUARE))  # type: ignore[type-var]
    for held in (tracked(), shape):
        clip = replace(CLIP, path=Path("/plates/plate_v2"), first=1, last=12)
        after = renumbered(replace(project(held), clip=clip), CLIP)
        assert after.shapes[0].frames == tuple(frame - 1000 for frame in held.frames)
        assert stale(after) == [frame - 1000 for frame in stale(project(held))]
        assert after.clip == clip


def one_by_one(before: Project, after: Project, frames: range) -> Project:
    """What `restamped` gives of all shapes, each key asked by itself."""
    held, now = Stamps.of(before.shapes, before.clip), Stamps.of(after.shapes, after.clip)
    fresh = []
    for k, (was, shape) in enumerate(zip(before.shapes, after.shapes, strict=True)):
        kept = {
            key.frame
            for key in was.keys
            if key.origin is Origin.ENGINE
            and key.frame in frames
            and restamping._lies_on(key, frames)
            and not held.is_stale(was, key)
        }
        keys = [key for key in shape.keys if key.origin is Origin.ENGINE and key.frame in kept]
        stamps = [import_stamp(shape, e.frame) if is_import(e) else restamping._stamp(now, k, e) for e in keys]
        fresh.append(shape.with_keys(replace(e, inputs=new) for e, new in zip(keys, stamps, strict=True)))
    return after.with_shapes(fresh)


@pytest.mark.parametrize("frames", [ALL, range(1002, 1010), range(1003, 1009)])
def test_keys_that_are_stamped_alike_are_asked_as_one(frames: range, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of 300 shapes each of 500 keys was asked, and made anew, by itself."""
    apart = [key(frame, IMPORT * (frame % 4 > 0)) for frame in range(1001, 1010)]
    read = stamped(RotoShape("shape-2", "Two", tuple(each.but(points=each.points + 90.0) for each in apart)))
    assert isinstance(read, RotoShape)
    one = tracked()
    one = one.with_keys([replace(one.key_at(1006), inputs="forward:best:0123:from=1003")])  # type: ignore[type-var]
    before = Project(CLIP, Layer("root", "Root", (one, read)))
    after = before.with_shapes(moved(shape, frames) for shape in before.shapes)
    wanted = one_by_one(before, after, frames)
    asked, is_stale = list[int](), Stamps.is_stale
    monkeypatch.setattr(Stamps, "is_stale", lambda self, s, k: asked.append(k.frame) or is_stale(self, s, k))
    assert restamped(before, after, ["shape-1", "shape-2"], frames) == wanted
    assert len(asked) <= 8, "once for keys of one stamp from one key of the artist's to the next, of fourteen keys"
