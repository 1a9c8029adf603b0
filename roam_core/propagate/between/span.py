"""Between two keys: an object carried from both ends of a span at once, and the two passes merged on every frame."""

from __future__ import annotations

import threading
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import pairwise, product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roam_core.arguments import frame_number, names_of
from roam_core.cancel import CancelToken, Progress
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.features.blank import is_blank
from roam_core.media.partial import Images, PartialPicture, ReadFrame, reading
from roam_core.media.source import MissingFrame
from roam_core.params import DEFAULT_CONFIG, RegionParams, RoamParams, params_for, scale_for
from roam_core.params.steadiness import STEADINESS
from roam_core.propagate.between.both_keys import as_on_another, as_on_both
from roam_core.propagate.between.directional_pass import DirectionalPass, ReadPicture, directional_pass
from roam_core.propagate.between.endpoint_consistency import Key, Span
from roam_core.propagate.between.frames_shown import keys_shown
from roam_core.propagate.between.merge import Merged, merged
from roam_core.propagate.between.merged_region import Colours
from roam_core.propagate.engines.begin import begin
from roam_core.propagate.engines.protocol import Engine
from roam_core.propagate.engines.view import EngineView
from roam_core.propagate.frame.result import Part, engine_key
from roam_core.propagate.shapes import provenance
from roam_core.propagate.shapes.gaps import Gap
from roam_core.propagate.shapes.objects import cuts, near, stacked, units
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.propagate.shapes.taking_part import takes_part
from roam_core.propagate.steadiness.steadied import steadied
from roam_core.roto import BlendMode, Keyframe, Origin, RotoShape, feather
from roam_core.roto.bounds import require_near
from roam_core.roto.edit import set_engine_keys
from roam_core.roto.given import shapes_of
from roam_core.threads import as_on_any_thread, each
from roam_core.translatable import sentence


def fill_span(
    images: Images | Sequence[NDArray[Any]],
    shapes: Sequence[RotoShape],
    start: int,
    stop: int,
    config: str | RoamParams = DEFAULT_CONFIG,
    token: CancelToken | None = None,
    progress: Progress | None = None,
    clip: str = "",
    only: Collection[str] | None = None,
    alone: bool = False,
) -> list[RotoShape]:
    """The shapes with ENGINE keys on the frames between their artist keys, from `start` to `stop`.

    Each gap between two neighbouring artist keys is one span: the object is carried forward from the first and
    backward from the second, each on a thread of its own, and both are merged with the motion of the object as one
    piece, each believed as far as it met the other key (`propagate.between.endpoint_consistency`), and with what the
    colours of both keys say (`proposal.cues.key_colours`). A lone shape is known by what looks alike on both keys
    (`motion.agreement`), and where that brings it to neither, by how it looks on its nearest keys beyond the span. Then
    each outline is drawn to the motion of the picture beside it (`propagate.steadiness.steadied`), the artist's keys
    fixed. Shapes of one object with the same keys are
    filled together. A shape that ends between two keys of its object is carried on from its last key; one that begins
    or ends on a key gets no keys, but tells how much of the object the others do not show there.

    All shapes that are given are filled, also what is locked in a project: that holds for an artist's hand, the window
    and the command line. `only` leaves out what is to stay as it is (`Project.is_locked`).

    Parameters
    ----------
    images : a mapping or function that gives the picture of a frame, (h, w, 3) RGB, uint8 or float32 in [0, 1]; each is
        asked for about four times for every object, in no particular order, by one thread at a time. A `MissingFrame`
        is passed over, and where it is that of a key, what lies beside it is carried from the other key alone. A
        sequence holds one for each frame from `start` to `stop`.
    only : the ids of the shapes that get keys; None: all. The others take part all the same.
    alone : each shape is filled as if there were no others.
    start, stop : the first and the last frame, both of which hold artist keys. Artist keys come back as they were.

    Raises
    ------
    ValueError
        when an argument is not what it should be, such as an id in `only` that no shape has.
    MissingFrame
        when neither key of a gap has a picture.
    RoamError
        when no shape is wanted, or none of them has artist keys on two frames of the range, or one to be filled is
        open, a point, or has a point that lies nowhere near the image.
    Cancelled
        at a safe point after `token` was cancelled.
    """
    shapes, start, stop = shapes_of(shapes), frame_number(start), frame_number(stop)
    if stop < start:
        raise ValueError(f"a span goes from an earlier frame to a later one, not from {start} to {stop}")
    read = reading(_by_frame(images, start, stop))
    only = names_of(only, (shape.id for shape in shapes))
    asked = [only is None or shape.id in only for shape in shapes]
    if not any(asked):
        raise RoamError(sentence("There is no shape to fill; draw one, or select one, first."))
    gaps = [gap for gap in spans(shapes, start, stop) if any(asked[k] for k in gap[2])]
    if not gaps and any(
        _is_keyed_twice(shape, start, stop) for shape, wanted in zip(shapes, asked, strict=True) if wanted
    ):
        return list(shapes)
    if not gaps:
        raise RoamError(
            sentence(
                "There is nothing to fill from frame {start} to {stop}: no shape has two artist keys there. "
                "Set a key on both ends first.",
                start=start,
                stop=stop,
            )
        )
    meter = _Meter(sum(last - first for first, last, _ in gaps), progress)
    filling = Filling(Reader(read), params_for(config), clip, meter, token, alone)
    result = list(shapes)
    for first, last, members in gaps:
        for shape, end in product((shapes[k] for k in members), (first, last)):
            require_near(shape, end, shape.at(end).points)
        for k, keys in filling.filled(shapes, (first, last), [k for k in members if asked[k]]).items():
            result[k] = set_engine_keys(result[k], keys)
    meter.end()
    return result


def _by_frame(images: Images | Sequence[NDArray[Any]], start: int, stop: int) -> Images:
    """The pictures of a span by their frames."""
    if isinstance(images, Sequence | np.ndarray) and not isinstance(images, str):
        if len(images) != stop - start + 1:
            raise ValueError(f"there are {len(images)} images for the frames {start} to {stop}; give one for each")
        return dict(zip(range(start, stop + 1), images, strict=True))
    return images


def spans(shapes: Sequence[RotoShape], start: int, stop: int) -> list[tuple[int, int, list[int]]]:
    """`(first, last, which shapes)` for every gap between neighbouring artist keys in the range.

    With the shapes that have keys on both ends go those that end, or begin, there.
    """
    gaps = {
        pair
        for shape in shapes
        for pair in pairwise(frame for frame in shape.artist_frames if start <= frame <= stop)
        if pair[1] - pair[0] > 1 and takes_part(shape, pair)
    }
    return [(*gap, [k for k, shape in enumerate(shapes) if takes_part(shape, gap)]) for gap in sorted(gaps)]


def _is_keyed_twice(shape: RotoShape, start: int, stop: int) -> bool:
    return sum(start <= frame <= stop for frame in shape.artist_frames) > 1


class Reader:
    """Pictures made ready, asked for by one thread at a time; none is kept, for a span may be long and its plate 4K.

    All have the size of the first one that is asked for.
    """

    def __init__(self, read: ReadFrame) -> None:
        self._read = read
        self._lock = threading.Lock()
        self._first: tuple[int, tuple[int, int]] | None = None

    def __call__(self, frame: int) -> PreparedFrame:
        picture = PreparedFrame(self.image(frame))
        self._first = self._first or (frame, picture.size)
        first, (height, width) = self._first
        if picture.size != (height, width):
            raise RoamError(
                sentence(
                    "Frame {frame} is {size}, frame {first} is {other}; all frames of a span must have one size.",
                    frame=frame,
                    size=f"{picture.size[1]}x{picture.size[0]}",
                    first=first,
                    other=f"{width}x{height}",
                )
            )
        return picture

    def image(self, frame: int) -> NDArray[Any] | PartialPicture:
        """The picture as it was given."""
        with self._lock:
            return self._read(frame)


class _Meter:
    """Progress over `total` frames, in parts that follow each other, whichever threads pass their steps."""

    def __init__(self, total: int, progress: Progress | None) -> None:
        self._total, self._progress = total, progress
        self._done = self._until = self._step = 0.0
        self._lock = threading.Lock()

    def begin(self, frames: float, steps: int) -> None:
        """The next part is worth so many frames, and takes so many steps; the one before has ended."""
        with self._lock:
            self._done, self._until = self._until, self._until + frames
            self._step = frames / steps

    def passed(self) -> None:
        """One step more."""
        with self._lock:
            self._done = min(self._done + self._step, self._until)
            self._tell(self._done / self._total)

    def end(self) -> None:
        """All is done, also what took no steps."""
        with self._lock:
            if self._done < self._total:
                self._tell(1.0)

    def _tell(self, share: float) -> None:
        if self._progress is not None:
            self._progress(min(share, 1.0), sentence("Filling between keys"))


@dataclass(frozen=True, eq=False)
class Filling:
    """What all spans of one call share."""

    read: Reader
    params: RoamParams
    clip: str = ""
    meter: _Meter | None = None
    token: CancelToken | None = None
    alone: bool = False

    @as_on_any_thread
    def filled(self, shapes: Sequence[RotoShape], gap: Gap, asked: Sequence[int]) -> dict[int, list[Keyframe]]:
        """The ENGINE keys in one gap of the shapes that are asked for, solved object by object."""
        shown = keys_shown(self.read, [shapes[k] for k in asked], gap, self.params)
        view = EngineView.of_key(next(iter(shown.values())), self.params)
        stamps = Stamps(shapes, self.clip, view.size)
        made: dict[int, list[Keyframe]] = {}
        objects, length = sorted({stamps.filled_with(k, gap, self.alone) for k in asked}), gap[1] - gap[0]
        for members in objects:
            if self.meter is not None:
                self.meter.begin(length / len(objects), 2 * length)
            ours, between = [shapes[k] for k in members], range(gap[0] + 1, gap[1])
            for shape in ours:
                _require_outline(shape)
            if not any(shape.exists_at(frame) for shape in ours for frame in between):
                continue
            span = self.passed(ours, gap, view, shown)
            found = list(zip(between, each(partial(self.solved, span, ours, view), between), strict=True))
            for place, k in enumerate(members):
                inputs = stamps.filled(k, gap, self.params, self.alone, span.asked_beyond) if k in asked else ""
                # Feather goes over from the one artist key to the other.
                drawn = RotoShape(shapes[k].id, shapes[k].name, shapes[k].artist_keys)
                made[k] = [
                    engine_key(frame, outline, feather.between_keys(drawn, frame, outline.points), inputs)
                    for frame, solved in found
                    if (outline := solved[place]) is not None
                ]
            made |= self._steadied({k: shapes[k] for k in members if made[k]}, made, gap)
        return {k: keys for k, keys in made.items() if k in asked}

    def _steadied(
        self, shapes: Mapping[int, RotoShape], made: Mapping[int, list[Keyframe]], gap: Gap
    ) -> dict[int, list[Keyframe]]:
        """The keys that were made for the `shapes` of an object, steadied between the two keys of the gap.

        Those that nobody asked for are among them: the motion of the picture is that beside all of them.
        """
        region = self.params.region
        if region is None:
            return {}
        between, strength = range(gap[0] + 1, gap[1]), region.span.steadiness
        alone = [
            replace(
                shape,
                keys=(*(key for key in shape.artist_keys if key.frame in gap), *made[k]),
                blend=BlendMode.SUBTRACT if is_hole else BlendMode.ADD,
            )
            for (k, shape), is_hole in zip(shapes.items(), cuts(list(shapes.values())), strict=True)
        ]
        moved = steadied(self.read.image, alone, between, strength, STEADINESS, self.token)
        return {k: [key for key in each.keys if key.frame in between] for k, each in zip(shapes, moved, strict=True)}

    @cached_property
    def finer(self) -> RoamParams:
        """The parameters of the passes between keys: finer cells, and poses that the merging may take."""
        region = self.params.region
        if region is None:
            return self.params
        return replace(self.params, region=replace(region, grid_factor=region.fill_factor, pose_kept=True))

    def solved(self, span: Span, shapes: Sequence[RotoShape], view: EngineView, frame: int) -> list[Merged | None]:
        """The outlines of an object's shapes on a frame between its keys; None for those that are not there."""
        if self.token is not None:
            self.token.check()
        alive = [k for k, shape in enumerate(shapes) if shape.exists_at(frame)]
        try:
            colours = self._colours(frame, view) if alive else None
            found = merged(span, frame, alive, colours)
            if colours is not None and self._is_blank(colours.picture, found):
                found = [None if each is None else each.unseen for each in found]
        except MissingFrame:  # where its file is damaged may show only when it is read there
            found = merged(span, frame, alive, None)
        return [None if each is None else replace(each, points=view.back(each.points)) for each in found]

    def _is_blank(self, picture: PreparedFrame, found: Sequence[Merged | None]) -> bool:
        """Whether a picture, as the engine sees it, shows nothing; those of the keys then show nothing either."""
        outlines = [each.points for each in found if each is not None]
        return bool(outlines) and is_blank(picture, outlines, self.params.blank)

    def _colours(self, frame: int, view: EngineView) -> Colours | None:
        """The picture of a frame as something to go by; None where it is missing, or not asked."""
        params = self.finer.region
        if params is None or params.keys_weight == 0:
            return None
        try:
            return Colours(view.picture(self.read(frame)), params)
        except MissingFrame:
            return None

    def passed(self, shapes: Sequence[RotoShape], gap: Gap, view: EngineView, shown: Collection[int]) -> Span:
        """Both passes of one object, side by side, as the engine sees them; from the keys that are `shown`."""
        keys = [_key(shapes, frame, view) for frame in gap]
        engines: Sequence[Engine | None] = each(
            lambda key: self._begun(shapes, key, view) if key.frame in shown else None, keys
        )
        if engines[0] is not None and engines[1] is not None:
            engines = as_on_both(engines[0], engines[1])
        span = self._span(shapes, keys, engines, view).better
        if not span.is_astray:
            return span
        for frame in provenance.keys_beyond(shapes, gap):
            other = self._begun_there(shapes, frame, view)
            looking = [as_on_another(engine, other) for engine in engines if engine is not None]
            again = replace(self, meter=None)._span(shapes, keys, looking, view).posed
            if again is not None and again.has_arrived:
                span = again
                break
        return replace(span, asked_beyond=True)

    def _span(
        self, shapes: Sequence[RotoShape], keys: Sequence[Key], engines: Sequence[Engine | None], view: EngineView
    ) -> Span:
        """Both passes of one object, by engines that were begun on its keys."""
        first, last = keys
        frames = range(first.frame, last.frame + 1)
        ways = list(zip(engines, keys, (frames, frames[::-1]), strict=True))
        ahead, behind = each(lambda way: self._directional_pass(shapes, view, *way), ways)
        scale = scale_for(view.seen)
        return Span(first, last, ahead, behind, view.seen, scale, self.params.region or RegionParams())

    def _begun_there(self, shapes: Sequence[RotoShape], frame: int, view: EngineView) -> Engine | None:
        """The object on a key beyond the span; None where its picture is not to be had, or of another size."""
        try:
            return self._begun(shapes, _key(shapes, frame, view), view)
        except RoamError:
            return None

    def _begun(self, shapes: Sequence[RotoShape], key: Key, view: EngineView) -> Engine | None:
        """The object on one of its keys; None where it has no outline there."""
        if not key.drawn:
            return None
        there = [shapes[k] for k in key.members]
        made, order = units(there, near(view.size)), stacked(there, key.frame)
        return begin(view.picture(self.read(key.frame)), key.drawn, self.finer, made, order)

    def _directional_pass(
        self, shapes: Sequence[RotoShape], view: EngineView, engine: Engine | None, key: Key, frames: range
    ) -> DirectionalPass | None:
        if engine is None:
            return None
        passed = None if self.meter is None else self.meter.passed
        orders = partial(stacked, [shapes[k] for k in key.members])
        read: ReadPicture = lambda frame: view.picture(self.read(frame))  # noqa: E731
        return directional_pass(engine, key.drawn, read, orders, frames, self.finer, self.token, passed)


def _require_outline(shape: RotoShape) -> None:
    if not shape.closed:
        raise RoamError(sentence("{name!r} is open; close it (C) before it can be filled.", name=shape.name))
    if shape.point_count < provenance.MIN_POINTS:
        raise RoamError(
            sentence("{name!r} is a single point; draw an outline around the object to fill it.", name=shape.name)
        )


def _key(shapes: Sequence[RotoShape], frame: int, view: EngineView) -> Key:
    """What the artist drew on a frame, for the engine."""
    drawn = {k: key for k, shape in enumerate(shapes) if (key := shape.key_at(frame)) and key.origin is Origin.ARTIST}
    is_hole = dict(zip(drawn, cuts([shapes[k] for k in drawn]), strict=True))
    parts: list[Part | None] = [None] * len(shapes)
    for k, key in drawn.items():
        parts[k] = Part(view.points(key.points), is_hole[k], shapes[k].attached)
    return Key(frame, tuple(parts))
