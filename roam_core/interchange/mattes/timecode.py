"""The rate of a clip and the SMPTE time code of its frames, as EXR files hold them.

Sources: SMPTE ST 12-1 for how frames are counted, which numbers are dropped, and that frames above 30 a second are
counted in pairs; `ImfTimeCode.h` of OpenEXR for the bits of the 32 that go into a file (its "TV60 packing").
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

SLOWED = {rate: Fraction(rate * 1000, 1001) for rate in (15, 24, 30, 48, 60, 120)}
"""Rates that video also runs at slower by a thousandth, as 29.97 for 30."""

NEAR = 4e-4
"""Share by which a rate that is written with two decimals, such as 23.98, may miss the exact one."""

MOST = 30
"""Frames a second that the time code has numbers for."""

PAIRED = (48, 50, 60)
"""Rates at which a number stands for two frames, told apart by a bit."""

DROP, SECOND_OF_PAIR = 1 << 6, 1 << 15
"""Bits of the packed time code: that numbers are dropped; that the frame is the later one of its pair."""

DROPPED = 2
"""Numbers that are left out at the beginning of each minute but every tenth, at 29.97 and 59.94 frames a second."""


def rational(fps: float) -> Fraction:
    """Frames a second as the fraction that the number stands for: 23.976 and 23.98 are 24000 / 1001, 12.5 is 25 / 2."""
    slowed = SLOWED.get(round(fps))
    if slowed is not None and abs(fps - slowed) <= NEAR * slowed:
        return slowed
    return Fraction(fps).limit_denominator(1001)


@dataclass(frozen=True)
class Moment:
    """A frame by the number that it has in the files, at `fps` frames a second."""

    frame: int
    fps: float

    @property
    def rate(self) -> Fraction:
        return rational(self.fps)

    def time_code(self) -> int | None:
        """The packed time code; None at rates that the standard cannot count: above 30 but 48, 50 and 60, or broken.

        The frame of number 0 has 00:00:00:00, so that the number and the code say the same; at 24 frames a second frame
        1001 has 00:00:41:17. Days wrap, and so do frames before 0. The code counts 24 numbers a second at 23.976; at
        29.97 and 59.94 it drops numbers, so that it keeps to the clock, and the drop-frame bit is set.
        """
        whole = round(self.fps)
        if self.rate not in (whole, SLOWED.get(whole)) or whole < 1 or (whole > MOST and whole not in PAIRED):
            return None
        number, second_of_pair = divmod(self.frame, 2) if whole in PAIRED else (self.frame, 0)
        counted = whole // 2 if whole in PAIRED else whole
        is_dropping = counted == MOST and self.rate != whole
        if is_dropping:
            number = _with_dropped(number)
        seconds, frames = divmod(number, counted)
        minutes, seconds = divmod(seconds, 60)
        hours, minutes = divmod(minutes, 60)
        packed = sum(
            _decimal(value) << place for value, place in ((frames, 0), (seconds, 8), (minutes, 16), (hours % 24, 24))
        )
        return packed | (DROP if is_dropping else 0) | (SECOND_OF_PAIR if second_of_pair else 0)


def _with_dropped(number: int) -> int:
    """The number of a frame on a count of 30 a second that leaves out two a minute, but none in every tenth."""
    minute = 60 * MOST - DROPPED
    tens, rest = divmod(number, 10 * minute + DROPPED)
    return number + DROPPED * (9 * tens + max(0, rest - DROPPED) // minute)


def _decimal(value: int) -> int:
    """Two decimal digits, four bits each."""
    return value // 10 << 4 | value % 10
