"""Results of a run, held back until the frames after them are known, their outlines then settled between both sides.

While a run goes on only the past is known. So a frame is handed on when `SteadinessParams.reach` more were solved, or
when the run ends: its last frames know fewer, and the stamps of their keys say how many. A run that goes on from there
settles them again, as it would have at once.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from roam_core.params import SteadinessParams, UntyingParams, scale_for
from roam_core.propagate.frame.result import FrameResult
from roam_core.propagate.shapes.provenance import Stamp, Stamps
from roam_core.propagate.steadiness.settle import known_steps, settled
from roam_core.propagate.steadiness.trail import Trail
from roam_core.roto import Keyframe, Origin, RotoShape
from roam_core.roto.edit import set_engine_keys

Trails = Mapping[int, tuple[Trail | None, int]]
"""By the index of a shape the trail that it goes along, and its place there."""


@dataclass(eq=False)
class _Held:
    """A frame that waits.

    `result` is None for one that an earlier run handed on; `indices` are those of its shapes. `keys` are the engine's
    as they were solved, by shape, and `trails` the latest ones that lead over the frame.
    """

    frame: int
    result: FrameResult | None
    indices: tuple[int, ...]
    keys: dict[int, Keyframe]
    trails: dict[int, tuple[Trail, int]] = field(default_factory=dict)

    def lead(self, trails: Trails) -> None:
        """Take the trails of the frame that was solved last, where they lead over this one."""
        for k, (trail, place) in trails.items():
            if trail is not None and any(each.frame == self.frame for each in trail.footprints):
                self.trails[k] = trail, place


class Lag:
    """Holds the results of a run back.

    Parameters
    ----------
    params : how outlines are settled; None: nothing is held back, and nothing changed. untying : how what then crosses
        itself is taken apart.
    shapes : all shapes by index, as they were given. size : (h, w) of the pictures.
    """

    def __init__(
        self,
        params: SteadinessParams | None,
        untying: UntyingParams,
        shapes: Sequence[RotoShape],
        size: tuple[int, int],
    ) -> None:
        self._params, self._untying, self._shapes, self._scale = params, untying, list(shapes), scale_for(size)
        self._held: list[_Held] = []
        self._revised: dict[int, list[Keyframe]] = {}

    def take_up(self, frame: int, trails: Trails, stamps: Stamps) -> None:
        """Hold those frames again that an earlier run, which ended on `frame`, handed on before it knew all around."""
        if self._params is None:
            return
        earlier: dict[int, dict[int, Keyframe]] = {}
        for k, (trail, place) in trails.items():
            for footprint in () if trail is None else trail.around(frame, self._params.reach):
                key = self._shapes[k].key_at(footprint.frame)
                if key is not None and _is_unsettled(key) and not stamps.is_stale(self._shapes[k], key):
                    inputs = str(replace(Stamp.read(key.inputs), ahead=None))
                    solved = replace(key, points=footprint.points[place], inputs=inputs)
                    earlier.setdefault(footprint.frame, {})[k] = solved
        for each in sorted(earlier, key=lambda each: -abs(frame - each)):
            self._held.append(_Held(each, None, tuple(earlier[each]), earlier[each]))
        self._lead(trails)

    def add(self, result: FrameResult, indices: Sequence[int], trails: Trails) -> Iterator[FrameResult]:
        """Take up the frame that was solved, or passed over, last; gives those that need wait no longer."""
        if self._params is None:
            yield result
            return
        engine = {
            k: each.key
            for k, each in zip(indices, result.results, strict=True)
            if each.key is not None and each.key.origin is Origin.ENGINE
        }
        self._held.append(_Held(result.frame, result, tuple(indices), engine))
        self._lead(trails)
        while abs(result.frame - self._held[0].frame) >= self._params.reach:
            yield from self._released(self._held.pop(0), self._params)

    def rest(self) -> Iterator[FrameResult]:
        """What is still held when the run ends."""
        while self._params is not None and self._held:
            yield from self._released(self._held.pop(0), self._params)

    def _lead(self, trails: Trails) -> None:
        for held in self._held:
            held.lead(trails)

    def _released(self, held: _Held, params: SteadinessParams) -> Iterator[FrameResult]:
        """The result of a frame with the shapes' keys as settled; of an earlier run's the next result brings them."""
        for k, key in held.keys.items():
            now = self._settled(held, k, key, params)
            self._shapes[k] = set_engine_keys(self._shapes[k], [now])
            if held.result is None:
                self._revised.setdefault(k, []).append(now)
        if held.result is None:
            return
        pairs = zip(held.indices, held.result.results, strict=True)
        results = tuple(
            replace(each, shape=self._shapes[k], revised=tuple(self._revised.pop(k, ()))) for k, each in pairs
        )
        yield replace(held.result, results=results)

    def _settled(self, held: _Held, k: int, key: Keyframe, params: SteadinessParams) -> Keyframe:
        if k not in held.trails:
            return key
        trail, place = held.trails[k]
        window = trail.around(held.frame, params.reach)
        here = next(n for n, each in enumerate(window) if each.frame == held.frame)
        steps = [each.residuals[place] for each in window]
        before, after = known_steps(steps[here:0:-1]), known_steps(steps[here + 1 :])
        points = settled(key.points, trail.places[place], before, after, params, self._untying, self._scale)
        ahead = abs(window[here + len(after)].frame - held.frame)
        if ahead >= params.reach:
            return replace(key, points=points)
        return replace(key, points=points, inputs=str(replace(Stamp.read(key.inputs), ahead=ahead)))


def _is_unsettled(key: Keyframe) -> bool:
    """Whether a run that made a key knew less of what comes after it than is asked for."""
    return key.origin is Origin.ENGINE and Stamp.read(key.inputs).ahead is not None
