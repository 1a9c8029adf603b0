"""Writing the demo shot: whole files only, kept when complete, replaced when not, stopped by its progress call."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from resources import demo
from resources.demo import frames

COUNT = demo.LAST + 1 - demo.FIRST


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The frames that were rendered; a small plain picture stands in for each."""
    calls: list[int] = []

    def plain(frame: int) -> np.ndarray:
        calls.append(frame)
        return np.full((4, 6, 3), (frame % 200, 10, 20), dtype=np.uint8)

    monkeypatch.setattr(frames, "render_frame", plain)
    return calls


def test_every_frame_is_written_under_its_number(tmp_path: Path, drawn: list[int]) -> None:
    folder = tmp_path / "cache" / demo.cache_name()
    demo.write_frames(folder)
    names = sorted(path.name for path in folder.iterdir())
    assert names == [f"demo.{frame}.png" for frame in range(demo.FIRST, demo.LAST + 1)]
    image = cv2.imread(str(folder / "demo.1007.png"))
    np.testing.assert_array_equal(image[0, 0, ::-1], (7, 10, 20))
    assert len(drawn) == COUNT


def test_complete_frames_are_kept_and_torn_ones_replaced(tmp_path: Path, drawn: list[int]) -> None:
    demo.write_frames(tmp_path)
    drawn.clear()
    torn, missing = frames.frame_path(tmp_path, 1003), frames.frame_path(tmp_path, 1040)
    torn.write_bytes(torn.read_bytes()[:-5])
    frames.frame_path(tmp_path, 1020).write_bytes(b"")
    missing.unlink()
    demo.write_frames(tmp_path)
    assert drawn == [1003, 1020, 1040]
    assert cv2.imread(str(torn)) is not None


def test_progress_rises_from_nothing_to_all(tmp_path: Path, drawn: list[int]) -> None:
    told: list[float] = []
    demo.write_frames(tmp_path, lambda share, words: told.append(share) if words else None)
    assert told[0] == 0.0
    assert told[-1] == 1.0
    assert told == sorted(told)
    assert len(told) == COUNT + 1


def test_progress_can_stop_the_work_and_it_goes_on_later(tmp_path: Path, drawn: list[int]) -> None:
    def stop(share: float, _: str) -> None:
        if share > 0.5:
            raise InterruptedError

    with pytest.raises(InterruptedError):
        demo.write_frames(tmp_path, stop)
    kept = len(list(tmp_path.iterdir()))
    assert 0 < kept < COUNT
    demo.write_frames(tmp_path)
    assert len(drawn) == COUNT


def test_nothing_half_written_stays_behind(tmp_path: Path, drawn: list[int], monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_path: Path, _target: Path) -> Path:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(OSError, match="No space"):
        demo.write_frames(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_cache_name_follows_the_version(monkeypatch: pytest.MonkeyPatch) -> None:
    name = demo.cache_name()
    assert name.startswith("demo-")
    assert len(name) == len("demo-") + 8
    monkeypatch.setattr(frames, "VERSION", "another")
    assert demo.cache_name() != name


def test_written_frame_is_the_rendered_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(frames, "LAST", demo.FIRST)
    demo.write_frames(tmp_path)
    image = cv2.imread(str(frames.frame_path(tmp_path, demo.FIRST)))
    np.testing.assert_array_equal(image[..., ::-1], demo.render_frame(demo.FIRST))
