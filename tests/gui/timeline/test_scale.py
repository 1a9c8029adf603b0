"""TimeScale: frames to pixels and back, zooming about the pointer, staying inside the clip."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.timeline.scale import TimeScale, whole_frames

scales = st.builds(
    lambda first, length, right, zoom: (
        TimeScale(left=148.0, right=right, clip=(first, first + length)).fitted().zoomed(zoom, 300.0)
    ),
    st.integers(-100, 5000),
    st.integers(1, 3000),
    st.floats(400, 2000),
    st.floats(1.0, 50.0),
)


@given(scales, st.integers(0, 2999))
def test_a_frames_middle_is_that_frame(scale: TimeScale, offset: int) -> None:
    frame = scale.held(scale.clip[0] + offset)
    assert scale.frame(scale.x(frame)) == frame


@given(scales)
def test_the_clip_fills_the_strip_or_is_all_in_sight(scale: TimeScale) -> None:
    first, stop = scale.clip
    assert scale.first >= first - 1e-6
    assert scale.last <= stop + 1e-6 or (stop - first) * scale.pixels <= scale.width + 1e-6


@given(scales, st.floats(148, 400), st.floats(1.0, 4.0))
def test_zooming_in_holds_the_time_under_the_pointer(scale: TimeScale, x: float, factor: float) -> None:
    time = scale.first + (x - scale.left) / scale.pixels
    zoomed = scale.zoomed(factor, x)
    assert zoomed.first + (x - zoomed.left) / zoomed.pixels == pytest.approx(time, abs=1e-6)


@given(scales, st.integers(0, 2999))
def test_showing_a_frame_brings_it_into_sight(scale: TimeScale, offset: int) -> None:
    frame = scale.held(scale.clip[0] + offset)
    shown = scale.showing(frame)
    assert shown.first - 1e-6 <= frame
    assert frame + 1 <= shown.last + 1e-6


@given(scales)
def test_labels_stand_on_round_frames_far_enough_apart(scale: TimeScale) -> None:
    label, tick = scale.steps()
    assert label * scale.pixels >= 56.0
    assert label % tick == 0
    assert str(label).rstrip("0") in {"1", "2", "5"}


def test_a_fitted_scale_stays_fitted_on_a_wider_strip() -> None:
    scale = TimeScale(right=648.0, clip=(1001, 1049)).fitted()
    assert scale.resized(1148.0) == TimeScale(right=1148.0, clip=(1001, 1049)).fitted()


def test_whole_frames_are_all_of_them_or_as_many_as_have_room_with_both_ends() -> None:
    assert whole_frames(1000.5, 1004.2, 100).tolist() == [1000, 1001, 1002, 1003, 1004, 1005]
    few = whole_frames(1.0, 5000.0, 200)
    assert (few[0], few[-1], len(few)) == (1, 5000, 200)
    assert (few == few.round()).all()
    assert whole_frames(7.0, 7.0, 100).tolist() == [7]
    assert whole_frames(1.0, 50.0, 0).tolist() == [1, 50]
