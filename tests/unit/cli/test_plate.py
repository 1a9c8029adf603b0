"""The plate of a command, read by several threads."""

from __future__ import annotations

import pytest

from roam_core.cli.plate import Plate
from roam_core.media.source import Image, MissingFrame
from tests.narrow import Narrow


class Damaged:
    """A plate of one frame that cannot be read; who asks for its frames waits for another to ask, too."""

    colour_space, size, readers = "linear", (8, 6), 1

    def __init__(self, narrow: Narrow) -> None:
        self._narrow = narrow

    @property
    def frames(self) -> tuple[int, ...]:
        self._narrow.passed()
        return (1,)

    def read(self, frame: int) -> Image:
        raise MissingFrame("Frame 1 is damaged.")


def test_a_damaged_frame_is_told_once_however_many_threads_meet_it(capfd: pytest.CaptureFixture[str]) -> None:
    narrow = Narrow()
    source = Damaged(narrow)
    plate = Plate(source)  # type: ignore[arg-type]

    def read() -> None:
        with pytest.raises(MissingFrame):
            plate.read_or_bridge(1)

    assert narrow.passed_by_two(read) == 1
    assert capfd.readouterr().err.count("It is bridged") == 1
