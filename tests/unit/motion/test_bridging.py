"""What is hidden for a while is waited for: its frames come, bridged, when it is seen again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.media import MissingFrame
from roam_core.motion.bridging import Lost, bridged

HIDDEN, MISSING = {3, 4, 8}, {6}


def look(frame: int) -> str:
    if frame in HIDDEN:
        raise Lost(f"lost on frame {frame}.")
    if frame in MISSING:
        raise MissingFrame(f"no frame {frame}.")
    return f"seen {frame}"


def between(before: str, after: str, frames: Sequence[int]) -> Iterator[str]:
    return (f"{before} ~{frame}~ {after}" for frame in frames)


def test_hidden_frames_come_when_it_is_seen_again_and_missing_ones_are_passed_over() -> None:
    found = list(bridged("key", look, between, range(2, 8), waits=2))
    assert found == ["seen 2", "seen 2 ~3~ seen 5", "seen 2 ~4~ seen 5", "seen 5", "seen 7"]


def test_what_is_hidden_at_first_is_bridged_from_the_key() -> None:
    assert list(bridged("key", look, between, (4, 5), waits=1)) == ["key ~4~ seen 5", "seen 5"]


@pytest.mark.parametrize(("frames", "waits", "kept"), [(range(2, 6), 1, ["seen 2"]), (range(7, 9), 5, ["seen 7"])])
def test_the_first_frame_of_a_loss_is_told_once_it_waits_no_longer(frames: range, waits: int, kept: list[str]) -> None:
    steps = bridged("key", look, between, frames, waits)
    assert [next(steps) for _ in kept] == kept
    with pytest.raises(Lost, match=f"lost on frame {next(frame for frame in frames if frame in HIDDEN)}"):
        next(steps)


def test_it_stops_when_it_is_cancelled() -> None:
    token = CancelToken()
    steps = bridged("key", look, between, range(2, 8), 2, token)
    next(steps)
    token.cancel()
    with pytest.raises(Cancelled):
        next(steps)
