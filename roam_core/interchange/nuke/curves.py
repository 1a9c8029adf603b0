"""What moves in a Nuke script: animation curves and the transforms made of them, evaluated at any moment."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.geometry import projective
from roam_core.interchange.nuke.script import Nested, decoded
from roam_core.interchange.reading import MAX_NUMBER
from roam_core.translatable import N_, sentence

STEP, STRAIGHT, CUBIC = range(3)
"""Interpolation numbers of a key; all that are not the first two are cubics."""

PIVOT, TRANSLATE, ROTATE, SCALE, SKEW, EXTRA, LENGTH = 0, 3, 6, 9, 12, 19, 35
"""Where the parts of a transform begin in its list of numbers."""

IN_PLANE = (0, 1, 3)
"""Rows and columns of the extra matrix that act on the plane: x, y, and the share of both."""


class FollowsExpressionError(ValueError):
    """A number that an expression gives: it is not run. The message is the expression."""


class FormError(ValueError):
    """A list that is none of the forms that files are known to have."""


@dataclass(frozen=True, eq=False)
class Curve:
    """Keys of one number.

    Attributes
    ----------
    times, values : (n,) one key means a constant.
    left, right : (n, 2) slope per frame and length of the handle, in thirds of the span, on either side.
    kinds : (n,) how it goes on from each key.
    """

    times: Array
    values: Array
    left: Array
    right: Array
    kinds: Indices

    def at(self, moments: Array) -> Array:
        """Values `(T,)`; before the first and after the last key it stands still."""
        return values_at([self], moments)[:, 0]

    @property
    def is_constant(self) -> bool:
        """True when it has one value at all times."""
        slopes = np.concatenate([self.left[1:, 0], self.right[:-1, 0]])
        return bool((self.values == self.values[0]).all() and not slopes.any())


def values_at(curves: Sequence[Curve], moments: Array) -> Array:
    """Values `(T, M)` of M curves; those whose keys have the same times are evaluated at once."""
    groups: dict[bytes, list[int]] = {}
    for index, part in enumerate(curves):
        groups.setdefault(part.times.tobytes() if len(part.times) > 1 else b"", []).append(index)
    result = np.empty((len(moments), len(curves)))
    for stamp, members in groups.items():
        if stamp:
            result[:, members] = _keyed([curves[index] for index in members], moments)
        else:
            result[:, members] = [curves[index].values[0] for index in members]
    return result


def _keyed(curves: Sequence[Curve], moments: Array) -> Array:
    """Values `(T, M)` of curves with several keys at the same times."""
    times = curves[0].times
    inside = np.clip(moments, times[0], times[-1])
    k = np.clip(np.searchsorted(times, inside, side="right") - 1, 0, len(times) - 2)
    span = (times[k + 1] - times[k])[:, None]
    share = (inside - times[k])[:, None] / span
    values = np.stack([part.values for part in curves], axis=1)
    slope_out, reach_out = np.moveaxis(np.stack([part.right for part in curves], axis=1)[k], 2, 0)
    slope_in, reach_in = np.moveaxis(np.stack([part.left for part in curves], axis=1)[k + 1], 2, 0)
    kinds = np.stack([part.kinds for part in curves], axis=1)[k]
    a, b = values[k], values[k + 1]
    u = _parameter(np.broadcast_to(share, a.shape), reach_out / 3.0, 1.0 - reach_in / 3.0)
    cubic = _bezier(u, a, a + slope_out * reach_out * span / 3.0, b - slope_in * reach_in * span / 3.0, b)
    straight = (1.0 - share) * a + share * b
    return np.where(kinds == STEP, np.where(share < 1.0, a, b), np.where(kinds == STRAIGHT, straight, cubic))


def _bezier(u: Array, a: Array, b: Array, c: Array, d: Array) -> Array:
    s = 1.0 - u
    return s * s * s * a + 3.0 * s * s * u * b + 3.0 * s * u * u * c + u * u * u * d


def _parameter(share: Array, first: Array, second: Array) -> Array:
    """The cubic's parameter at a share of the span's time, whose handles end at the shares `first` and `second`."""
    if (first == 1.0 / 3.0).all() and (second == 1.0 - 1.0 / 3.0).all():
        return share
    low, high = np.zeros_like(share), np.ones_like(share)
    first, second = np.clip(first, 0.0, 1.0), np.clip(second, 0.0, 1.0)
    for _ in range(50):
        middle = 0.5 * (low + high)
        before = _bezier(middle, np.zeros_like(share), first, second, np.ones_like(share)) < share
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    return 0.5 * (low + high)


# ---- reading ---------------------------------------------------------------------------------------------------------


def curve(item: str | Nested, times: list[float] | None) -> Curve:
    """One number of a file: plain, or a list of keys.

    `times` are those that the keys share, which then hold none themselves; None when each key begins with its own.

    Raises `FollowsExpressionError`, `FormError`, or `ValueError` for a word that is no number.
    """
    if isinstance(item, str):
        return constant(decoded(item))
    refuse_expression(item)
    table = _plain_table(item) if times is not None and len(item) == len(times) else None
    if table is None:
        keys = [_key(key, times is None) for key in _repeated(item, None if times is None else len(times))]
        if not keys:
            raise FormError(sentence("a list of keys is empty"))
        table = np.array(keys)
    if times is not None and len(table) not in (1, len(times)):
        raise FormError(sentence("{count} keys stand for {times} times", count=len(table), times=len(times)))
    stamps = table[:, 0] if times is None else np.array(times[: len(table)])
    if (np.diff(stamps) <= 0.0).any():
        raise FormError(sentence("keys are not in the order of time"))
    return Curve(stamps, table[:, 1], table[:, 2:4], table[:, 4:6], table[:, 6].astype(np.intp))


def _plain_table(items: Nested) -> Array | None:
    """As rows of `_key`, at once, keys without a time of which each is a value and two slopes; None for any others.

    Almost all keys of a long file are of this form.
    """
    words = [word for item in items for word in item]
    digits = [_DIGITS.get(word) or word[1:] for word in words if isinstance(word, str)]
    if len(digits) != 5 * len(items) or any(len(item) != 5 for item in items) or {len(d) for d in digits} != {8}:
        return None
    if any(word[:1] != "x" and word not in _DIGITS for word in words):
        return None
    try:
        numbers = np.frombuffer(bytes.fromhex("".join(digits)), ">f4").astype(np.float64).reshape(-1, 5)
    except ValueError:
        return None
    if not (np.abs(numbers) <= MAX_NUMBER).all():
        return None
    rest = np.tile([0.0, CUBIC], (len(numbers), 1))
    return np.concatenate([rest[:, :1], numbers, rest[:, 1:]], axis=1)


_DIGITS = {"0": "00000000", "1": "3f800000"}


def refuse_expression(item: Nested) -> None:
    """Raise `FollowsExpressionError` when the list is an expression and its default."""
    if item and isinstance(item[0], str) and item[0].lstrip('"').startswith("="):
        raise FollowsExpressionError(" ".join(word for word in item[:-1] if isinstance(word, str)) or item[0])


def shared_times(item: str | Nested) -> list[float]:
    """The times of a `px` or `tx` list: one, or a list of several."""
    times = [decoded(item)] if isinstance(item, str) else [decoded(_word(word)) for word in item]
    if not times or (np.diff(times) <= 0.0).any():
        raise FormError(sentence("times are missing or not in order"))
    return times


def constant(value: float) -> Curve:
    """A curve that never changes."""
    still = np.array([[0.0, 1.0]])
    return Curve(np.zeros(1), np.array([value]), still, still, np.array([CUBIC], dtype=np.intp))


def _repeated(items: Nested, limit: int | None) -> Iterator[Nested]:
    """The keys of a list, of which `{x N {key}}` stands for N copies of one; at most `limit`."""
    count = 0
    for item in items:
        if isinstance(item, str):
            raise FormError(sentence("a word stands where a key belongs"))
        copies = 1
        if item[:1] == ["x"]:
            _, number, repeated = item
            copies = int(decoded(_word(number)))
            if limit is None or isinstance(repeated, str) or copies < 1:
                raise FormError(sentence("a run of keys has none of the known forms"))
            item = repeated
        count += copies
        if limit is not None and count > limit:
            raise FormError(sentence("more than {limit} keys stand for {limit} times", limit=limit))
        yield from [item] * copies


def _key(item: Nested, is_timed: bool) -> tuple[float, ...]:
    """Time (0 where it has none), value, left slope and length, right slope and length, interpolation."""
    words = [_word(word) for word in item]
    head = 2 if is_timed else 1
    tail = words[head:]
    if len(words) < head or len(tail) > 5:
        raise FormError(sentence("a key has {found} parts", found=len(words)))
    kind = CUBIC
    if tail and tail[-1] != "-" and (len(tail) in (1, 3, 5) or tail[0] == "-"):
        kind = int(decoded(tail.pop())) & 255
    numbers = [decoded(word) for word in words[:head]]
    slopes = [0.0, 1.0, 0.0, 1.0]
    if tail and tail != ["-"]:
        given = [decoded(word) for word in tail]
        slopes[: len(given)] = given
    return (numbers[0] if is_timed else 0.0, numbers[-1], *slopes, float(kind))


def _word(item: str | Nested) -> str:
    if not isinstance(item, str):
        raise FormError(sentence("a list stands where a number belongs"))
    return item


# ---- transforms ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Transform:
    """A layer's or shape's transform: 35 numbers, those that stay at what they are by default left out."""

    parts: dict[int, Curve]

    @property
    def times(self) -> list[float]:
        """Of all keys of what moves."""
        return sorted({time for part in self.parts.values() if not part.is_constant for time in part.times.tolist()})

    @property
    def moves(self) -> bool:
        """False when it has nothing but a pivot, which changes nothing."""
        return bool(self.parts.keys() - {PIVOT, PIVOT + 1, PIVOT + 2})

    @property
    def pivot(self) -> Array | None:
        """The point in the plane `(2,)` about which it turns, y up; None where that is not told, or moves."""
        parts = [self.parts.get(PIVOT), self.parts.get(PIVOT + 1)]
        if any(part is None or not part.is_constant for part in parts):
            return None
        return np.array([part.values[0] for part in parts if part is not None])

    @property
    def unknown(self) -> list[str]:
        """Parts that are set and that this reader leaves out."""
        ranges = {N_("rotation in depth"): (ROTATE, ROTATE + 2), N_("skew"): (SKEW, EXTRA)}
        return [name for name, (start, stop) in ranges.items() if any(i in self.parts for i in range(start, stop))]

    def matrices(self, moments: Array) -> Array:
        """Projective `(T, 3, 3)`, y up: about the pivot first scaled, then turned, moved, and last the extra matrix."""

        def part(index: int) -> Array:
            default = float(index in (SCALE, SCALE + 1))
            return self.parts[index].at(moments) if index in self.parts else np.full(len(moments), default)

        angle = np.radians(part(ROTATE + 2))
        cosine, sine = np.cos(angle), np.sin(angle)
        px, py, sx, sy = part(PIVOT), part(PIVOT + 1), part(SCALE), part(SCALE + 1)
        result = np.zeros((len(moments), 3, 3))
        result[:, 0, 0], result[:, 0, 1] = cosine * sx, -sine * sy
        result[:, 1, 0], result[:, 1, 1] = sine * sx, cosine * sy
        result[:, 0, 2] = px + part(TRANSLATE) - result[:, 0, 0] * px - result[:, 0, 1] * py
        result[:, 1, 2] = py + part(TRANSLATE + 1) - result[:, 1, 0] * px - result[:, 1, 1] * py
        result[:, 2, 2] = 1.0
        return np.asarray(self._extra(moments) @ result)

    def apply(self, positions: Array, moments: Array) -> Array:
        """Positions `(T, ..., 2)`, y up, as they lie at the moments `(T,)`.

        Raises `ValueError` where a perspective sends one to infinity.
        """
        return projective.apply_each(self.matrices(moments), positions)

    def _extra(self, moments: Array) -> Array:
        """The plane's part of the extra 4 x 4 matrix, row by row, with the perspective that a corner pin gives it."""
        result = np.tile(np.eye(3), (len(moments), 1, 1))
        for row, column in product(IN_PLANE, IN_PLANE):
            index = EXTRA + 4 * row + column
            if index in self.parts:
                result[:, min(row, 2), min(column, 2)] = self.parts[index].at(moments)
        return result


def transform(items: Nested) -> Transform:
    """A transform's list, its `t` or `tx` first.

    Raises as `curve`.
    """
    form, *rest = items
    times = None
    if form == "tx":
        times, rest = shared_times(rest[0]), rest[1:]
    elif form != "t":
        raise FormError(sentence("a transform has none of the known forms"))
    curves = {index: curve(item, times) for index, item in enumerate(rest[:LENGTH])}
    return Transform({index: part for index, part in curves.items() if not _is_default(index, part)})


def _is_default(index: int, part: Curve) -> bool:
    is_one = index in (SCALE, SCALE + 1, SCALE + 2) or (index >= EXTRA and (index - EXTRA) % 5 == 0)
    return part.is_constant and part.values[0] == float(is_one)
