"""Held keys for Blender, whose masks move straight from key to key: a mask layer for each stretch between steps.

The opacity of a layer may step. So a shape that steps becomes several, each of which is there until the next step.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from roam_core.interchange.flatten import Branch, takes_part
from roam_core.roto import Clip, Interpolation, Keyframe, RotoShape
from roam_core.translatable import sentence

MOST_STEPS = 24
"""A shape with more steps stays one, and slides during the last frame before each: nobody edits a hundred layers."""


def stepped(branch: Branch, clip: Clip, notes: list[str]) -> Branch:
    """The branch with a shape for each stretch of those that step; `notes` hears of each of them."""
    items: list[RotoShape | Branch] = []
    for item in branch.items:
        if isinstance(item, Branch):
            items.append(stepped(item, clip, notes))
            continue
        steps = _steps(item) if takes_part(item) else []
        if len(steps) > MOST_STEPS:
            notes.append(
                sentence(
                    "Blender's masks slide from key to key: {name!r}, which steps {count} times, does so "
                    "during the last frame before each step.",
                    name=item.name,
                    count=len(steps),
                )
            )
            steps = []
        elif steps:
            notes.append(
                sentence(
                    "Blender's masks slide from key to key: {name!r}, which steps, becomes {layers} layers, "
                    "one for each stretch between steps.",
                    name=item.name,
                    layers=len(steps) + 1,
                )
            )
        items += _stretches(item, steps, clip) if steps else [item]
    return replace(branch, items=tuple(items))


def _steps(shape: RotoShape) -> list[int]:
    """The frames on which the outline jumps from what was held to a key."""
    return [
        after.frame
        for before, after in pairwise(shape.keys)
        if before.interpolation is Interpolation.HOLD and _differ(before, after)
    ]


def _differ(one: Keyframe, other: Keyframe) -> bool:
    if (one.points != other.points).any():
        return True
    if one.feather is None or other.feather is None:
        return any(each.feather is not None and bool(each.feather.any()) for each in (one, other))
    return bool((one.feather != other.feather).any())


def _stretches(shape: RotoShape, steps: list[int], clip: Clip) -> list[RotoShape]:
    start, stop = shape.lifetime or (min(shape.frames[0], clip.first), max(shape.frames[-1], clip.last) + 1)
    result: list[RotoShape] = []
    for number, (first, last) in enumerate(pairwise([-(10**9), *steps, 10**9])):
        begin, end = max(first, start), min(last, stop)
        if begin < end:
            keys = tuple(key for key in shape.keys if first <= key.frame < last)
            result.append(replace(shape, id=f"{shape.id} {number}", keys=keys, lifetime=(begin, end)))
    return result
