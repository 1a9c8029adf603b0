"""Filling between keys: both keys are met, artist keys stay, and what lies between follows the picture."""

from __future__ import annotations

import threading
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace

import numpy as np
import pytest

from roam_core import RoamError, fill_span
from roam_core.arrays import UInt8
from roam_core.cancel import Cancelled, CancelToken
from roam_core.features import PreparedFrame
from roam_core.geometry.bezier import polygon_points
from roam_core.matte.compose import render_matte
from roam_core.media.partial import reading
from roam_core.media.source import MissingFrame
from roam_core.params import CONFIGS
from roam_core.params.steadiness import RESIDUAL
from roam_core.propagate.between.endpoint_consistency import Span
from roam_core.propagate.between.frames_shown import frames_shown, keys_shown
from roam_core.propagate.between.merge import Merged, merged
from roam_core.propagate.between.merged_region import Colours
from roam_core.propagate.between.span import Reader, spans
from roam_core.propagate.shapes import provenance
from roam_core.propagate.steadiness.boil import boil
from roam_core.roto import BlendMode, Keyframe, Origin, RotoShape
from tests.golden.shots import Shot, blob, outline_distance, pose
from tests.narrow import Narrow

FIRST, LAST = 1001, 1009
BETWEEN = range(FIRST + 1, LAST)


@pytest.fixture(scope="module")
def shot() -> Shot:
    """A body on an arc, turning: half way it lies far from the straight line between its ends."""
    bend = [np.sin(np.pi * k / 8.0) for k in range(9)]
    poses = tuple(pose(60.0 + 3.0 * k, 50.0 + 14.0 * bend[k], 6.0 * k) for k in range(9))
    return Shot(blob([26.0, 22.0, 18.0, 24.0, 28.0, 20.0]), poses, drift=(0.4, -0.2))


def pictures(shot: Shot) -> dict[int, UInt8]:
    return {frame: shot.read(frame) for frame in shot.frames}


def keyed(shot: Shot, *frames: int) -> RotoShape:
    return RotoShape("shape-1", "Body", tuple(Keyframe(frame, shot.truth(frame)) for frame in frames))


@pytest.mark.parametrize("config", CONFIGS)
def test_filled_frames_follow_the_picture_and_keys_stay_as_they_were(shot: Shot, config: str) -> None:
    shape = keyed(shot, FIRST, LAST)
    [filled] = fill_span(pictures(shot), [shape], FIRST, LAST, config)
    assert filled.frames == tuple(range(FIRST, LAST + 1))
    assert filled.artist_frames == (FIRST, LAST)
    for frame in (FIRST, LAST):
        assert filled.key_at(frame) == shape.key_at(frame)
    ours = [outline_distance(filled.at(frame).points, shot.truth(frame)) for frame in BETWEEN]
    linear = [outline_distance(shape.at(frame).points, shot.truth(frame)) for frame in BETWEEN]
    assert max(ours) < 1.5
    assert np.mean(ours) < 0.25 * np.mean(linear)


def test_the_same_input_gives_the_same_bits_whatever_the_threads_do(shot: Shot) -> None:
    class Hesitant(dict[int, UInt8]):
        """Pictures that keep one of the two threads waiting now and then."""

        def __getitem__(self, frame: int) -> UInt8:
            threading.Event().wait(0.002 * (frame % 3))
            return super().__getitem__(frame)

    shape = keyed(shot, FIRST, LAST)
    assert fill_span(pictures(shot), [shape], FIRST, LAST) == fill_span(Hesitant(pictures(shot)), [shape], FIRST, LAST)


def test_filling_a_reversed_clip_gives_the_same_outlines(shot: Shot) -> None:
    turned = shot.reversed()
    [one] = fill_span(pictures(shot), [keyed(shot, FIRST, LAST)], FIRST, LAST)
    [other] = fill_span(pictures(turned), [keyed(turned, FIRST, LAST)], FIRST, LAST)
    for frame in BETWEEN:
        assert outline_distance(one.at(frame).points, other.at(FIRST + LAST - frame).points) < 1e-6


def trembling(span: Span, frame: int, alive: Collection[int] | None, colours: Colours | None) -> list[Merged | None]:
    """What is merged, a hundredth larger on every other frame, and as much smaller on the others."""
    factor = 1.01 if frame % 2 else 0.99
    outlines = merged(span, frame, alive, colours)
    middles = [None if each is None else each.points[:, 0].mean(axis=0) for each in outlines]
    return [
        None if each is None else replace(each, points=middle + factor * (each.points - middle))
        for each, middle in zip(outlines, middles, strict=True)
    ]


def test_what_is_filled_is_steadied(shot: Shot, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("roam_core.propagate.between.span.merged", trembling)
    shape = keyed(shot, FIRST, LAST)
    [found] = fill_span(pictures(shot), [replace(shape, id="found")], FIRST, LAST, "best+steadiness=0")
    [steady] = fill_span(pictures(shot), [shape], FIRST, LAST, "best")
    boils = boil(shot.read, [found, steady], range(FIRST, LAST + 1), RESIDUAL)
    before, after = (np.mean([boils[name, frame].pixels for frame in BETWEEN]) for name in ("found", shape.id))
    assert before > 0.3
    assert after < 0.7 * before
    assert [steady.key_at(frame) for frame in (FIRST, LAST)] == list(shape.keys)


def test_what_is_filled_is_steadied_between_its_own_two_keys(shot: Shot) -> None:
    shape = keyed(shot, FIRST, FIRST + 4, LAST)
    [whole] = fill_span(pictures(shot), [shape], FIRST, LAST)
    [half] = fill_span(pictures(shot), [shape], FIRST, FIRST + 4)
    [both] = fill_span(pictures(shot), [half], FIRST + 4, LAST)  # keys of the other gap say nothing
    assert both == whole


@pytest.mark.parametrize("config", CONFIGS)
def test_a_single_point_is_refused(shot: Shot, config: str) -> None:
    dot = replace(keyed(shot, FIRST, LAST).map_points(lambda points: points[:1]), name="Dot")
    with pytest.raises(RoamError, match="'Dot' is a single point; draw an outline"):
        fill_span(pictures(shot), [dot], FIRST, LAST, config)


def test_an_artist_key_inside_divides_the_span(shot: Shot) -> None:
    middle = FIRST + 4
    shape = keyed(shot, FIRST, middle, LAST)
    [filled] = fill_span(pictures(shot), [shape], FIRST, LAST)
    assert filled.key_at(middle) == shape.key_at(middle)
    [first_half] = fill_span(pictures(shot), [shape], FIRST, middle)
    assert first_half.frames == (*range(FIRST, middle + 1), LAST)
    for frame in range(FIRST + 1, middle):
        assert filled.key_at(frame) == first_half.key_at(frame)


def test_a_shape_that_ends_is_carried_to_its_end(shot: Shot) -> None:
    body = keyed(shot, FIRST, LAST)
    spot = replace(keyed(shot, FIRST), id="spot", lifetime=(FIRST, FIRST + 4), blend=BlendMode.SUBTRACT)
    centre = spot.keys[0].points.reshape(-1, 2).mean(axis=0)
    spot = spot.map_points(lambda points: centre + 0.4 * (points - centre))
    filled, ended = fill_span(pictures(shot), [body, spot], FIRST, LAST)
    assert ended.frames == (FIRST, FIRST + 1, FIRST + 2, FIRST + 3)
    assert filled.frames == tuple(range(FIRST, LAST + 1))


def test_a_missing_picture_is_passed_over(shot: Shot) -> None:
    [filled] = fill_span(Lacking(pictures(shot), FIRST + 3), [keyed(shot, FIRST, LAST)], FIRST, LAST)
    assert filled.key_at(FIRST + 3) is None
    assert filled.key_at(FIRST + 4) is not None
    black = pictures(shot) | {FIRST + 3: np.zeros_like(pictures(shot)[FIRST])}
    assert fill_span(black, [keyed(shot, FIRST, LAST)], FIRST, LAST) == [filled]


class Lacking(dict[int, UInt8]):
    """Pictures of a plate that lacks some."""

    def __init__(self, pictures: dict[int, UInt8], *gone: int) -> None:
        super().__init__(pictures)
        self._gone = gone

    def __getitem__(self, frame: int) -> UInt8:
        if frame in self._gone:
            raise MissingFrame(f"frame {frame} is missing")
        return super().__getitem__(frame)


def blacked(pictures: dict[int, UInt8], frame: int) -> dict[int, UInt8]:
    return pictures | {frame: np.zeros_like(pictures[frame])}


@pytest.mark.parametrize("lacking", [Lacking, blacked], ids=["missing", "black"])
@pytest.mark.parametrize("gone", [FIRST, LAST])
def test_a_gap_whose_one_key_shows_nothing_is_filled_from_the_other(
    shot: Shot, lacking: Callable[[dict[int, UInt8], int], dict[int, UInt8]], gone: int
) -> None:
    plate, shape = lacking(pictures(shot), gone), keyed(shot, FIRST, LAST)
    [filled] = fill_span(plate, [shape], FIRST, LAST)
    assert filled.artist_keys == shape.artist_keys
    assert [key.frame for key in filled.keys] == [*range(FIRST, LAST + 1)]
    for frame in BETWEEN:
        assert outline_distance(filled.at(frame).points, shot.truth(frame)) < 1.5
    between = [*BETWEEN]
    assert list(frames_shown(reading(plate), shape, (FIRST, LAST), between, CONFIGS["best"])) == between
    assert list(keys_shown(lambda frame: PreparedFrame(plate[frame]), [shape], (FIRST, LAST), CONFIGS["best"])) == [
        frame for frame in (FIRST, LAST) if frame != gone
    ]


def test_a_gap_without_a_picture_on_either_key_is_refused_with_the_frame(shot: Shot) -> None:
    with pytest.raises(MissingFrame, match=f"frame {LAST} is missing"):
        fill_span(Lacking(pictures(shot), FIRST, LAST), [keyed(shot, FIRST, LAST)], FIRST, LAST)


def test_a_filled_key_is_stale_once_either_of_its_artist_keys_changes(shot: Shot) -> None:
    [filled] = fill_span(pictures(shot), [keyed(shot, FIRST, LAST)], FIRST, LAST)
    key = filled.key_at(FIRST + 2)
    assert key is not None
    assert key.origin is Origin.ENGINE
    assert not provenance.is_stale(filled, key, None)
    for frame in (FIRST, LAST):
        moved = filled.with_key(Keyframe(frame, shot.truth(frame) + 1.0))
        assert provenance.is_stale(moved, key, None)


def test_progress_goes_from_little_to_all_and_cancelling_stops(shot: Shot) -> None:
    seen: list[float] = []
    fill_span(pictures(shot), [keyed(shot, FIRST, LAST)], FIRST, LAST, progress=lambda part, _: seen.append(part))
    assert seen == sorted(seen)
    assert seen[-1] == pytest.approx(1.0)
    token = CancelToken()
    with pytest.raises(Cancelled):
        fill_span(
            pictures(shot),
            [keyed(shot, FIRST, LAST)],
            FIRST,
            LAST,
            token=token,
            progress=lambda part, _: token.cancel() if part > 0.3 else None,
        )


def test_pictures_are_asked_for_by_one_thread_at_a_time(shot: Shot) -> None:
    narrow = Narrow()

    class Plate(dict[int, UInt8]):
        def __getitem__(self, frame: int) -> UInt8:
            narrow.passed()
            return super().__getitem__(frame)

    read = Reader(Plate(pictures(shot)).__getitem__)
    assert narrow.passed_by_two(lambda: read(FIRST)) == 1


def test_progress_is_told_by_one_thread_at_a_time_and_never_goes_back(shot: Shot) -> None:
    narrow, seen = Narrow(), list[float]()

    def progress(part: float, text: str) -> None:
        narrow.passed()
        seen.append(part)

    fill_span(pictures(shot), [keyed(shot, FIRST, LAST)], FIRST, LAST, "baseline", progress=progress)
    assert narrow.most == 1
    assert seen == sorted(set(seen))


@pytest.mark.parametrize("gone", [(), (FIRST + 3, FIRST + 4)], ids=["all there", "two missing"])
def test_progress_is_that_of_all_objects(shot: Shot, gone: tuple[int, ...]) -> None:
    seen: list[float] = []
    shape = keyed(shot, FIRST, LAST)
    ends = replace(keyed(shot, FIRST), id="ends", lifetime=(FIRST, FIRST + 4))  # no pass comes back to it
    apart = [replace(each, link=each.id) for each in (shape, replace(shape, id="another"), ends)]
    fill_span(
        Lacking(pictures(shot), *gone), apart, FIRST, LAST, "baseline", progress=lambda part, _: seen.append(part)
    )
    assert seen == sorted(set(seen))
    assert seen[-1] == pytest.approx(1.0)
    assert np.diff([0.0, *seen]).max() < 0.2


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (lambda shape: replace(shape, keys=shape.keys[:1]), "nothing to fill"),
        (lambda shape: replace(shape, closed=False), "open"),
    ],
)
def test_what_cannot_be_filled_is_refused_with_a_sentence(shot: Shot, change: object, sentence: str) -> None:
    assert callable(change)
    with pytest.raises(RoamError, match=sentence):
        fill_span(pictures(shot), [change(keyed(shot, FIRST, LAST))], FIRST, LAST)


def test_a_span_that_ends_before_it_begins_is_called_so(shot: Shot) -> None:
    """It was said that the shape had no two keys there, which it has."""
    with pytest.raises(ValueError, match=f"from an earlier frame to a later one, not from {LAST} to {FIRST}"):
        fill_span(pictures(shot), [keyed(shot, FIRST, LAST)], LAST, FIRST)


def test_neighbouring_keys_leave_nothing_to_fill_and_come_back_as_they_are(shot: Shot) -> None:
    shape = keyed(shot, FIRST, FIRST + 1)
    assert fill_span(pictures(shot), [shape], FIRST, FIRST + 1) == [shape]


def test_a_shape_that_subtracts_from_nothing_is_filled_as_one_that_adds(shot: Shot) -> None:
    shape = keyed(shot, FIRST, LAST)
    [adds], [subtracts] = (
        fill_span(pictures(shot), (replace(each, blend=blend) for each in [shape]), FIRST, LAST)
        for blend in (BlendMode.ADD, BlendMode.SUBTRACT)
    )
    for frame in range(FIRST, LAST + 1):
        assert subtracts.at(frame).points.tobytes() == adds.at(frame).points.tobytes()


def test_a_picture_that_is_not_there_is_named(shot: Shot) -> None:
    images: Mapping[int, UInt8] = {f: p for f, p in pictures(shot).items() if f != FIRST + 2}
    with pytest.raises(RoamError, match="1003"):
        fill_span(images, [keyed(shot, FIRST, LAST)], FIRST, LAST)


def test_a_picture_of_another_size_is_named(shot: Shot) -> None:
    cut = {**pictures(shot), FIRST + 2: pictures(shot)[FIRST + 2][:40]}
    with pytest.raises(RoamError, match=r"Frame 1003 is \d+x40, frame 1001 is"):
        fill_span(cut, [keyed(shot, FIRST, LAST)], FIRST, LAST)


def test_spans_are_the_gaps_between_neighbouring_artist_keys(shot: Shot) -> None:
    one, two = keyed(shot, 1001, 1005, 1009), replace(keyed(shot, 1001, 1009), id="other")
    next_door = replace(keyed(shot, 1001, 1002), id="no gap")
    assert spans([one, two, next_door], 1001, 1009) == [(1001, 1005, [0]), (1001, 1009, [1]), (1005, 1009, [0])]
    assert spans([one, two], 1002, 1009) == [(1005, 1009, [0])]
    begins = replace(keyed(shot, 1005), id="begins", lifetime=(1005, 1010))
    assert spans([one, begins], 1001, 1009) == [(1001, 1005, [0, 1]), (1005, 1009, [0])]


CARD, POST = (40.0, 30.0, 112.0, 80.0), (70.0, 84.0)
"""Left, top, right, bottom of a card that lies still; left and right side of what comes before it at the end."""


def behind_a_post(frame: int) -> UInt8:
    rng = np.random.default_rng(7)
    image = rng.integers(50, 90, (110, 160, 3)).astype(np.uint8)
    left, top, right, bottom = (round(side) for side in CARD)
    image[top:bottom, left:right] = rng.integers(150, 230, (bottom - top, right - left, 3))
    if frame == LAST:
        image[:, round(POST[0]) : round(POST[1])] = (30, 60, 200)
    return image


def box(left: float, top: float, right: float, bottom: float, frame: int) -> Keyframe:
    return Keyframe(frame, polygon_points([(left, top), (right, top), (right, bottom), (left, bottom)]))


def test_what_begins_on_a_key_tells_how_much_of_the_object_its_neighbours_are() -> None:
    left, top, right, bottom = CARD
    body = RotoShape("body", "Body", (box(*CARD, FIRST), box(left, top, POST[0], bottom, LAST)), compound="card")
    last = box(POST[1], top, right, bottom, LAST)
    rest = RotoShape("rest", "Rest", (last,), lifetime=(LAST, LAST + 1), compound="card")
    images = {frame: behind_a_post(frame) for frame in range(FIRST, LAST + 1)}
    filled, begun = fill_span(images, [body, rest], FIRST, LAST)
    assert begun == rest
    true = np.zeros((110, 160), dtype=bool)
    true[round(top) : round(bottom), round(left) : round(right)] = True
    for frame in BETWEEN:
        matte = render_matte([filled], frame, (110, 160)) > 0.5
        assert (matte & true).sum() / (matte | true).sum() > 0.8  # without it: .61


@pytest.mark.parametrize("shapes", [0, 1])
def test_that_no_shape_is_wanted_is_said_so(shot: Shot, shapes: int) -> None:
    given = [keyed(shot, FIRST, LAST)][:shapes]
    with pytest.raises(RoamError, match="There is no shape to fill"):
        fill_span(pictures(shot), given, FIRST, LAST, "baseline", only=[])
