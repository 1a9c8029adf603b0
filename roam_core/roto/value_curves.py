"""Verbs on keys of values, several at once: moved in time and value, deleted, and the tangents between them."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import replace

from roam_core.roto.animated import (
    Animatable,
    Animated,
    Interpolation,
    Slopes,
    ValueKey,
    cubic_slopes,
    held_within,
    value_keys,
    values_of,
)
from roam_core.roto.project import Layer, Project
from roam_core.roto.shape import RotoShape

ValuePlace = tuple[str, str, int]
"""Where a key of a value lies: (id of the shape or layer, name of the value, frame)."""

BOUNDS: Mapping[str, tuple[float, float]] = {"opacity": (0.0, 1.0)}
"""Values that have bounds; between its keys such a value stays within them, too."""

ROUNDING = 1e-12
"""What a bound may be passed by: a slope that was held comes back so much beside it."""

SLIGHTLY = 1e-4
"""By how much single precision, and what is fitted to it, may move the end of a tangent that lies on a bound."""

SHAPE_VALUES = ("opacity", "feather")
LAYER_VALUES = ("opacity",)
"""The values that may vary with time."""


def values_of_item(item: Layer | RotoShape) -> dict[str, Animatable]:
    """What of a shape or layer may vary with time, by name."""
    names = SHAPE_VALUES if isinstance(item, RotoShape) else LAYER_VALUES
    return {name: getattr(item, name) for name in names}


def value_places(project: Project) -> frozenset[ValuePlace]:
    """Where the keys of all values of a project lie."""
    return frozenset(
        (item.id, name, key.frame)
        for item in project.root.items()
        for name, value in values_of_item(item).items()
        for key in value_keys(value)
    )


# ---- verbs on a project ----------------------------------------------------------------------------------------------


def move_values(project: Project, places: Iterable[ValuePlace], frames: int, amount: float = 0.0) -> Project:
    """The project with the keys at `places` shifted in time, and by `amount` in value; what lies there gives way."""
    return _each_value(project, places, lambda value, own: moved(value, own, frames, amount))


def retime_values(project: Project, places: Iterable[ValuePlace], goes: Mapping[int, int]) -> Project:
    """The project with the keys at `places` on the frames that `goes` tells, by theirs; what lies there gives way.

    Tangents keep the heights of their handles' ends: they are as much flatter as time is longer.
    """
    return _each_value(project, places, lambda value, own: retimed(value, own, goes))


def copy_values(project: Project, places: Iterable[ValuePlace], frames: int) -> Project:
    """The project with copies of the keys at `places`, so many frames on; what lies there gives way."""
    return _each_value(project, places, lambda value, own: pasted(value, _keys_on(value, own), frames))


def paste_values(project: Project, keys: Mapping[tuple[str, str], Iterable[ValueKey]], offset: int = 0) -> Project:
    """The project with keys put into its values, by (id of the shape or layer, name), `offset` frames on.

    What lies there gives way, and a constant varies from then on. Values that are not there are left out.
    """
    for (item_id, name), copied in keys.items():
        value = values_of_item(project.find(item_id)).get(name) if project.has(item_id) else None
        if value is not None:
            after = bounded(pasted(value, copied, offset), name)
            project = project.map_item(item_id, _setting(name, after))
    return project


def keys_at(project: Project, places: Iterable[ValuePlace]) -> dict[tuple[str, str], list[ValueKey]]:
    """The keys at `places`, by (id of the shape or layer, name of the value)."""
    found: dict[tuple[str, str], list[ValueKey]] = {}
    for item_id, name, frame in sorted(places):
        value = values_of_item(project.find(item_id)).get(name) if project.has(item_id) else None
        if isinstance(value, Animated) and (key := value.key_at(frame)) is not None:
            found.setdefault((item_id, name), []).append(key)
    return found


def delete_values(project: Project, places: Iterable[ValuePlace]) -> Project:
    """The project without these keys; a value that loses its last one stays what it was there."""
    return _each_value(project, places, deleted)


def interpolate_values(project: Project, places: Iterable[ValuePlace], interpolation: Interpolation) -> Project:
    """The project with another way to move on from these keys; they lose their tangents."""
    return _each_value(
        project,
        places,
        lambda value, own: _changed(value, own, lambda k: replace(k, interpolation=interpolation, slopes=None)),
    )


def bend_values(project: Project, places: Iterable[ValuePlace]) -> Project:
    """The project with tangents at these keys that run smoothly through them; keys that have some get these anew."""
    return _each_value(project, places, with_tangents)


def set_slopes(project: Project, place: ValuePlace, slopes: Slopes) -> Project:
    """The project with these slopes of the tangents at one key."""
    return _each_value(project, [place], lambda value, own: sloped(value, own, slopes))


def _each_value(
    project: Project,
    places: Iterable[ValuePlace],
    verb: Callable[[Animated, Collection[int]], Animatable],
) -> Project:
    """The project with a verb of each value that has keys at `places`, within its bounds."""
    frames: dict[tuple[str, str], set[int]] = {}
    for item_id, name, frame in places:
        frames.setdefault((item_id, name), set()).add(frame)
    for (item_id, name), own in sorted(frames.items()):
        if not project.has(item_id):
            continue
        value = values_of_item(project.find(item_id)).get(name)
        if isinstance(value, Animated) and own & set(value.frames):
            after = bounded(verb(value, own & set(value.frames)), name)
            if after != value:
                project = project.map_item(item_id, _setting(name, after))
    return project


def _keys_on(value: Animated, frames: Collection[int]) -> list[ValueKey]:
    return [key for key in value.keys if key.frame in frames]


def _setting(name: str, value: Animatable) -> Callable[[Layer | RotoShape], Layer | RotoShape]:
    return lambda item: replace(item, **{name: value})  # type: ignore[arg-type]


# ---- verbs on a value ------------------------------------------------------------------------------------------------


def moved(value: Animated, frames: Collection[int], offset: int, amount: float) -> Animated:
    """The value with its keys on `frames` shifted by frames and an amount; a key where one arrives gives way."""
    going = [replace(k, frame=k.frame + offset, value=k.value + amount) for k in value.keys if k.frame in frames]
    staying = {key.frame: key for key in value.keys if key.frame not in frames}
    return replace(value, keys=tuple((staying | {key.frame: key for key in going}).values()))


def retimed(value: Animated, frames: Collection[int], goes: Mapping[int, int]) -> Animated:
    """The value with its keys on `frames` where `goes` tells, and tangents as much flatter as time is longer."""
    pace = 1.0 if len(goes) < 2 else (max(goes.values()) - min(goes.values())) / (max(goes) - min(goes))

    def gone(key: ValueKey) -> ValueKey:
        slopes = key.slopes and (key.slopes[0] / pace, key.slopes[1] / pace)
        return replace(key, frame=goes.get(key.frame, key.frame), slopes=slopes)

    going = [gone(key) for key in value.keys if key.frame in frames]
    staying = {key.frame: key for key in value.keys if key.frame not in frames}
    return replace(value, keys=tuple((staying | {key.frame: key for key in going}).values()))


def pasted(value: Animatable, keys: Iterable[ValueKey], offset: int) -> Animatable:
    """The value with keys put on frames `offset` on; a key where one arrives gives way."""
    put = {key.frame + offset: replace(key, frame=key.frame + offset) for key in keys}
    if not put:
        return value
    all_keys = tuple(({key.frame: key for key in value_keys(value)} | put).values())
    return replace(value, keys=all_keys) if isinstance(value, Animated) else Animated(all_keys)


def deleted(value: Animated, frames: Collection[int]) -> Animatable:
    """The value without its keys on `frames`; the last one to go leaves its value, which stays for good."""
    kept = tuple(key for key in value.keys if key.frame not in frames)
    return replace(value, keys=kept) if kept else value.keys[0].value


def with_tangents(value: Animated, frames: Collection[int]) -> Animated:
    """The value with tangents at its keys on `frames`: as steep as the line between the keys around, flat at ends.

    They are flat at peaks and valleys too, so that the value goes beyond none of its keys there.
    """
    keys = value.keys
    around = {key.frame: (keys[max(i - 1, 0)], keys[min(i + 1, len(keys) - 1)]) for i, key in enumerate(keys)}

    def bent(key: ValueKey) -> ValueKey:
        before, after = around[key.frame]
        is_turn = (key.value - before.value) * (after.value - key.value) <= 0.0
        slope = 0.0 if is_turn else (after.value - before.value) / (after.frame - before.frame)
        way = Interpolation.LINEAR if key.interpolation is Interpolation.HOLD else key.interpolation
        return replace(key, interpolation=way, slopes=(slope, slope))

    return _changed(value, frames, bent)


def sloped(value: Animated, frames: Collection[int], slopes: Slopes) -> Animated:
    """The value with tangents of these slopes at its keys on `frames`."""
    return _changed(value, frames, lambda key: replace(key, slopes=slopes))


def opacity_as_seen(value: Animatable) -> Animatable:
    """An opacity that lies between none and full everywhere, as mattes take it.

    Tangents that lead beyond by no more than `SLIGHTLY` are bent back; a span that leads farther has a key on every
    frame, held within the bounds.
    """
    if all(-SLIGHTLY <= each <= 1.0 + SLIGHTLY for each in values_of(value)):
        return bounded(value, "opacity")
    return held_within(value, 0.0, 1.0)


def bounded(value: Animatable, name: str) -> Animatable:
    """The value held within the bounds of what is called `name`: its keys, and the ends of its tangents.

    A span lies between the values of its ends and of the ends of its handles, so it stays within the bounds as well.
    """
    if name not in BOUNDS:
        return value
    low, high = BOUNDS[name]

    def held(number: float) -> float:
        return min(max(number, low), high)

    if not isinstance(value, Animated):
        return held(value)
    keys = [replace(key, value=held(key.value)) for key in value.keys]
    for i, key in enumerate(keys):
        if key.slopes is None:
            continue
        arriving, leaving = key.slopes
        if i > 0 and cubic_slopes(keys[i - 1], key) is not None:
            arriving = -_held_slope(key.value, -arriving, (key.frame - keys[i - 1].frame) / 3.0, held)
        if i + 1 < len(keys) and cubic_slopes(key, keys[i + 1]) is not None:
            leaving = _held_slope(key.value, leaving, (keys[i + 1].frame - key.frame) / 3.0, held)
        keys[i] = replace(key, slopes=(arriving, leaving))
    return replace(value, keys=tuple(keys))


def _held_slope(value: float, slope: float, reach: float, held: Callable[[float], float]) -> float:
    """The slope of a handle `reach` frames long whose end lies within bounds."""
    end = value + reach * slope
    return slope if math.isclose(held(end), end, rel_tol=ROUNDING, abs_tol=ROUNDING) else (held(end) - value) / reach


def _changed(value: Animated, frames: Collection[int], change: Callable[[ValueKey], ValueKey]) -> Animated:
    return replace(value, keys=tuple(change(key) if key.frame in frames else key for key in value.keys))
