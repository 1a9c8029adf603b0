"""What an ENGINE key was computed from, as a short stamp, and whether that still holds.

A run solves a whole object (`propagate.shapes.objects`) from keys; which of its shapes get keys of it makes no
difference to any of them. So a stamp covers all that the points depend on: the revision of the engine, the parameters,
the clip, and of every shape of the object its outline on the frame where the run's knowledge begins and each artist key
that it passed since, with how it is drawn, stacked and linked, and which of the shapes are outlines of one thing.
"""

from __future__ import annotations

import bisect
import hashlib
import json
import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from pathlib import Path

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.media.colour_spaces import definition_of
from roam_core.params import RoamParams, params_for
from roam_core.propagate.shapes.gaps import Gap
from roam_core.propagate.shapes.objects import near, objects
from roam_core.propagate.shapes.taking_part import governing_key, is_known, takes_part
from roam_core.roto import BlendMode, Clip, Keyframe, Origin, RotoShape
from roam_core.roto.imported import import_stamp, is_import
from roam_core.roto.sight import is_shut, opened

REVISION = 42
"""Of the engine: another one whenever the same input gives other points (a test tells when that is)."""
FILL = "fill"
"""The direction of a key that was filled from both sides."""
MIN_POINTS = 2
"""Points from which a closed spline encloses anything."""


def clip_stamp(clip: Clip | None) -> str:
    """What identifies a clip's pictures in a stamp: file name, range, size, colours and layer (not where it lies).

    Of a colour space of `$OCIO` what it says counts too, not its name alone.
    """
    if clip is None:
        return ""
    told = [Path(clip.path).name, clip.first, clip.last, list(clip.size), clip.colour_space]
    definition = definition_of(clip.colour_space)
    more = [clip.layer, definition] if definition else [clip.layer] if clip.layer else []
    return json.dumps([*told, *more])


@dataclass(frozen=True)
class Stamp:
    """A stamp, taken apart: `direction:configuration:digest`, then `from=F`, `to=F` and `alone` where they apply.

    One more word, `shifted=N`, is part of no stamp that a run gives: a key that bears it was solved N frames earlier,
    on another picture (`roam_core.roto.shifting`), and is stale.

    Attributes
    ----------
    direction : forward, backward or fill. config : name of the configuration. digest : of all that the key depends on.
    begun : the frame on which what the run knew begins; of a fill that of the key before.
    until : of a fill the frame of the key after. alone : the shape was solved without others. asked_beyond : the
        nearest keys beyond these two were asked how it looks.
    """

    direction: str
    config: str
    digest: str
    begun: int | None = None
    until: int | None = None
    alone: bool = False
    asked_beyond: bool = False

    @classmethod
    def read(cls, text: str) -> Stamp:
        """What a key's `inputs` say; empty where they say nothing."""
        return _read(text)

    def __str__(self) -> str:
        words = [self.direction, self.config, self.digest]
        words += [f"{name}={frame}" for name, frame in (("from", self.begun), ("to", self.until)) if frame is not None]
        words += [word for word, said in (("alone", self.alone), ("beyond", self.asked_beyond)) if said]
        return ":".join(words)

    @property
    def gap(self) -> tuple[int, int] | None:
        """The frames of the keys between which it was filled."""
        return None if self.begun is None or self.until is None else (self.begun, self.until)

    @property
    def forward(self) -> bool:
        return self.direction == "forward"


@lru_cache(maxsize=1024)
def _read(text: str) -> Stamp:
    """One stamp for one text: all keys of a run between two of the artist's bear the same."""
    direction, config, digest, *more = [*text.split(":"), "", ""][: max(3, text.count(":") + 1)]
    begun, until = (_frame(more, name) for name in ("from", "to"))
    return Stamp(direction, config, digest, begun, until, "alone" in more, "beyond" in more)


def _frame(words: Sequence[str], name: str) -> int | None:
    """The frame that `name=F` tells among words; None without it."""
    found = [word.removeprefix(f"{name}=") for word in words if word.startswith(f"{name}=")]
    return int(found[0]) if found and found[0].removeprefix("-").isdecimal() else None


def stamp(
    shapes: Sequence[RotoShape],
    frame: int,
    begun: int,
    params: RoamParams,
    clip: str,
    forward: bool,
    alone: bool = False,
) -> str:
    """The stamp of what a run that knew `shapes`, all of one object, on the frame where it had `begun` gives there."""
    used = tuple(_passed(shape, begun, frame) for shape in shapes)
    direction = "forward" if forward else "backward"
    content = [_said(params, clip, direction, alone), _compounds(shapes)]
    for shape, keys in zip(shapes, used, strict=True):
        content.append(_as_drawn(shape, begun, frame))
        content.append(outline_begun(shape, begun, forward).tobytes())
        content.extend(_as_keyed(key) for key in keys)
    ends = _ends(shapes, {key.frame for keys in used for key in keys}, forward)
    content += [json.dumps(ends).encode()] if any(end is not None for end in ends) else []
    return str(Stamp(direction, params.config, _digest(content), begun, alone=alone))


def fill_stamp(
    shapes: Sequence[RotoShape],
    gap: Gap,
    params: RoamParams,
    clip: str,
    alone: bool = False,
    asked_beyond: bool = False,
) -> str:
    """The stamp of the frames between the two keys of a gap, where `shapes` are filled together.

    `asked_beyond`: the nearest keys beyond the gap were asked, too.
    """
    content = [_said(params, clip, FILL, alone), _compounds(shapes), f"{gap}".encode()]
    for shape in shapes:
        content.append(_as_drawn(shape, *gap))
        content.extend(_as_keyed(key) for key in shape.artist_keys if key.frame in gap)
    if len(shapes) > 1:  # one that is not there leaves its place to the others
        content.append(json.dumps([_there(shape, gap) for shape in shapes]).encode())
    if asked_beyond:
        content.append(b"beyond")
        frames = keys_beyond(shapes, gap)
        content.extend(_as_keyed(key) for shape in shapes for key in shape.artist_keys if key.frame in frames)
    return str(Stamp(FILL, params.config, _digest(content), *gap, alone, asked_beyond))


def keys_beyond(shapes: Sequence[RotoShape], gap: Gap) -> list[int]:
    """The nearest frames before and after a gap on which all shapes have artist keys, as far as there are any."""
    keyed = sorted(set.intersection(*(set(shape.artist_frames) for shape in shapes)))
    return [*[frame for frame in keyed if frame < gap[0]][-1:], *[frame for frame in keyed if frame > gap[1]][:1]]


def _there(shape: RotoShape, gap: Gap) -> tuple[int, int]:
    """The half-open range of a gap's frames in which a shape exists."""
    first, stop = shape.lifetime or (gap[0], gap[1] + 1)
    return max(first, gap[0]), min(stop, gap[1] + 1)


def outline_begun(shape: RotoShape, frame: int, forward: bool) -> Array:
    """The control points with which a run in this direction begins on a frame.

    Between keys those of the engine that lie ahead do not count: they may be the run's own. What was closed there,
    out of sight, is as drawn, in its place.
    """
    key = shape.key_at(frame)
    if key is None:
        keys = tuple(key for key in shape.keys if key.origin is Origin.ARTIST or (key.frame < frame) == forward)
        return (replace(shape, keys=keys) if keys else shape).at(frame).points
    drawn = source_of(shape, key)
    if drawn is None or shape.blend is BlendMode.SUBTRACT or not is_shut(key.points, drawn.points):
        return key.points
    return opened(key.points, drawn.points)


def _passed(shape: RotoShape, begun: int, frame: int) -> tuple[Keyframe, ...]:
    """The artist's keys that a run passes after the frame where it had `begun`, up to `frame`."""
    low, high = sorted((begun, frame))
    return tuple(key for key in shape.artist_keys if low <= key.frame <= high and key.frame != begun)


def _ends(shapes: Sequence[RotoShape], given: Collection[int], forward: bool) -> list[int | None]:
    """The ends of the shapes that are gone on a frame on which others were given: their last outlines count there."""
    return [
        shape.lifetime[1 if forward else 0] if shape.lifetime and not all(map(shape.exists_at, given)) else None
        for shape in shapes
    ]


@lru_cache(maxsize=16)
def _said(params: RoamParams, clip: str, direction: str, alone: bool) -> bytes:
    """All that is the same for every key of a run."""
    return json.dumps([REVISION, params.values(), clip, direction, alone], sort_keys=True).encode()


def _as_drawn(shape: RotoShape, begun: int, frame: int) -> bytes:
    """How a shape is drawn, linked and, from one frame to the other, stacked."""
    low, high = sorted((begun, frame))
    level = shape.depth_at(low)
    changes = [pair for pair in shape.depth if low < pair[0] <= high]
    depth = [level, *changes] if level else changes
    return json.dumps([shape.closed, shape.blend.value, shape.link, shape.attached, depth]).encode()


def _compounds(shapes: Sequence[RotoShape]) -> bytes:
    """Which of the shapes are the outlines of one thing: for each the place of the first one of its compound.

    Its name tells nothing, nor does a compound of which no other shape is here.
    """
    first: dict[str | int, int] = {}
    return json.dumps([first.setdefault(shape.compound or k, k) for k, shape in enumerate(shapes)]).encode()


def _as_keyed(key: Keyframe) -> bytes:
    return str(key.frame).encode() + key.points.tobytes()


def _digest(content: Sequence[bytes]) -> str:
    return hashlib.sha256(b"\0".join(content)).hexdigest()[:16]


class Stamps:
    """What would be stamped now, for all shapes of a project.

    Parameters
    ----------
    shapes : all of the project, bottom first, each told by itself where several have one id.
    clip : what identifies the clip (`clip_stamp`). size : (h, w) of it.
    """

    def __init__(self, shapes: Sequence[RotoShape], clip: str = "", size: tuple[int, int] | None = None) -> None:
        self.shapes = tuple(shapes)
        self._clip, self._size = clip, size
        self._places = {id(shape): k for k, shape in enumerate(self.shapes)}
        self._by_id = {shape.id: k for k, shape in enumerate(self.shapes)}
        self._known: dict[tuple[object, ...], str] = {}
        self._solved: dict[tuple[tuple[int, ...], int, bool], tuple[int, ...]] = {}
        self._given: dict[tuple[tuple[int, ...], bool], list[int]] = {}
        self._params: dict[int, RoamParams] = {}
        self._together: dict[tuple[int, ...], tuple[RotoShape, ...]] = {}
        self._borders_of: dict[int, list[int]] = {}

    @classmethod
    def of(cls, shapes: Sequence[RotoShape], clip: Clip | None) -> Stamps:
        """For the shapes of a project with this clip."""
        return cls(shapes, clip_stamp(clip), None if clip is None else (clip.size[1], clip.size[0]))

    @cached_property
    def objects(self) -> dict[int, tuple[int, ...]]:
        """For each shape that can be solved, by its index, the shapes of its object, itself among them."""
        able = [k for k, shape in enumerate(self.shapes) if shape.closed and shape.point_count >= MIN_POINTS]
        found = objects([self.shapes[k] for k in able], near(self._size))
        return {able[k]: tuple(able[j] for j in group) for group in found for k in group}

    def _place(self, shape: RotoShape) -> int | None:
        """The index of a shape, or else of the one that has its id now; None where there is none."""
        return self._places.get(id(shape), self._by_id.get(shape.id))

    def together(self, shape: RotoShape) -> tuple[RotoShape, ...]:
        """A shape and the others of its object, as stacked."""
        k = self._place(shape)
        if k is None:
            return (shape,)
        members = self.objects.get(k, (k,))
        if members not in self._together:
            self._together[members] = tuple(self.shapes[j] for j in members)
        return self._together[members]

    def solved_with(self, k: int, frame: int, forward: bool, alone: bool = False) -> tuple[int, ...]:
        """The shapes of its object with which a shape is solved by a run that begins on `frame`, itself among them.

        Those take part that are there, and that the artist keyed by then.
        """
        together = self.objects.get(k, (k,))
        if alone:
            return (k,)
        if (together, frame, forward) not in self._solved:
            there = tuple(j for j in together if is_known(self.shapes[j], frame, forward))
            self._solved[together, frame, forward] = there
        there = self._solved[together, frame, forward]
        return there if k in there else (k,)

    def filled_with(self, k: int, gap: Gap, alone: bool = False) -> tuple[int, ...]:
        """The shapes of its object with which a shape is filled between two keys, itself among them."""
        if alone:
            return (k,)
        return tuple(j for j in self.objects.get(k, (k,)) if j == k or takes_part(self.shapes[j], gap))

    def tracked(self, k: int, frame: int, begun: int, params: RoamParams, forward: bool, alone: bool = False) -> str:
        """The stamp that a run which had `begun` on a frame gives a shape on `frame`."""
        members = self.solved_with(k, begun, forward, alone)
        counted = bisect.bisect_right if forward else bisect.bisect_left
        passed = counted(self._given_frames(members, forward), frame)
        name = (members, begun, passed, self._number(params), forward, alone)
        if name not in self._known:
            together = [self.shapes[j] for j in members]
            self._known[name] = stamp(together, frame, begun, params, self._clip, forward, alone)
        return self._known[name]

    def _given_frames(self, members: tuple[int, ...], forward: bool) -> list[int]:
        """The frames on which the artist keyed or stacked any of the members, in order: between them stamps are alike.

        A change of depth holds from its frame on: a run backward meets it on the frame before.
        """
        if (members, forward) not in self._given:
            together = [self.shapes[j] for j in members]
            frames = {frame for shape in together for frame in shape.artist_frames}
            frames |= {frame - (not forward) for shape in together for frame, _ in shape.depth}
            self._given[members, forward] = sorted(frames)
        return self._given[members, forward]

    def _number(self, params: RoamParams) -> int:
        """A number for parameters, by their identity: to compare all their fields for every key would take long."""
        self._params[id(params)] = params  # while it lives no other has its identity
        return id(params)

    def filled(self, k: int, gap: Gap, params: RoamParams, alone: bool = False, asked_beyond: bool = False) -> str:
        """The stamp that filling a gap gives a shape, whether or not the keys beyond it were asked."""
        name = (k, gap, self._number(params), alone, asked_beyond)
        if name not in self._known:
            members = [self.shapes[j] for j in self.filled_with(k, gap, alone)]
            self._known[name] = fill_stamp(members, gap, params, self._clip, alone, asked_beyond)
        return self._known[name]

    def is_filled(self, shape: RotoShape, key: Keyframe, gap: Gap, params: RoamParams, alone: bool = False) -> bool:
        """Whether a key of one of the shapes is one that filling a gap would make again."""
        asked_beyond = Stamp.read(key.inputs).asked_beyond
        k = self._place(shape)
        if k is None or key.origin is not Origin.ENGINE:
            return False
        return key.inputs == self.filled(k, gap, params, alone, asked_beyond)

    def is_stale(self, shape: RotoShape, key: Keyframe) -> bool:
        """True for an ENGINE key of one of the shapes when anything that it was computed from has changed since."""
        if key.origin is not Origin.ENGINE:
            return False
        if is_import(key):
            return import_stamp(shape, key.frame) != key.inputs
        made, k = Stamp.read(key.inputs), self._place(shape)
        params = known_params(made.config)
        if params is None or k is None:
            return True
        if made.direction == FILL:
            gap = made.gap
            if gap is None or not takes_part(self.shapes[k], gap):
                return True
            return self.filled(k, gap, params, made.alone, made.asked_beyond) != key.inputs
        if made.begun is None:
            return True
        return self.tracked(k, key.frame, made.begun, params, made.forward, made.alone) != key.inputs

    def stale_frames(self, shape: RotoShape) -> list[int]:
        """The frames of those keys of a shape that are stale, in order; of those that are alike one is asked."""
        return [key.frame for run in self.alike(shape) if self.is_stale(shape, run[0]) for key in run]

    def alike(self, shape: RotoShape) -> Iterator[list[Keyframe]]:
        """The ENGINE keys of a shape in order, those together that hold or fail alike, and would be stamped alike.

        Keys of one stamp are, up to the next frame on which the artist did something.
        """
        borders, run = self._borders(shape), list[Keyframe]()
        low, high = math.inf, -math.inf
        for key in shape.keys:
            if key.origin is not Origin.ENGINE:
                continue
            if run and low < key.frame < high and key.inputs == run[0].inputs:
                run.append(key)
                continue
            if run:
                yield run
            place = bisect.bisect_left(borders, key.frame)
            is_border = place < len(borders) and borders[place] == key.frame
            low = key.frame - 1 if is_border else borders[place - 1] if place else -math.inf
            high = key.frame + 1 if is_border else borders[place] if place < len(borders) else math.inf
            run = [key]
        if run:
            yield run

    def _borders(self, shape: RotoShape) -> list[int]:
        """The frames, in order, on which the artist did something to a shape or to others of its object.

        Told once for all shapes of an object: it may have hundreds.
        """
        k = self._place(shape)
        if k is None:
            return sorted(_given_on((shape,)))
        members = self.objects.get(k, (k,))
        if members[0] not in self._borders_of:
            self._borders_of[members[0]] = sorted(_given_on([self.shapes[j] for j in members]))
        borders = self._borders_of[members[0]]
        return borders if self.shapes[k] is shape else sorted({*borders, *shape.artist_frames})


def _given_on(together: Sequence[RotoShape]) -> set[int]:
    """The frames on which the artist keyed or stacked any of the shapes, and those before a change of depth."""
    given = {frame for shape in together for frame in shape.artist_frames}
    return given | {frame - back for shape in together for frame, _ in shape.depth for back in (0, 1)}


def is_stale(shape: RotoShape, key: Keyframe, clip: Clip | None, shapes: Sequence[RotoShape] | None = None) -> bool:
    """`Stamps.is_stale` for one key of a shape among the `shapes` of its project; None: there are no others."""
    return Stamps.of([shape] if shapes is None else shapes, clip).is_stale(shape, key)


def source_of(shape: RotoShape, key: Keyframe) -> Keyframe | None:
    """The artist's key that a key goes back to: itself, or the one that its stamp's direction passes (a fill: before).

    None for a shape without artist keys; the one on the other side where there is none on that.
    """
    if key.origin is Origin.ARTIST:
        return key
    forward = Stamp.read(key.inputs).direction != "backward"
    return governing_key(shape, key.frame, forward) or governing_key(shape, key.frame, not forward)


def known_params(config: str) -> RoamParams | None:
    """The parameters of the configuration that a stamp names, or None where this program knows no such one."""
    try:
        return params_for(config)
    except RoamError:
        return None
