"""What two keys say together of how a part looks: what is alike on both is the part's own.

What hides a part on a key, and was not drawn, passes there for its look. The outlines of the two keys tell where each
place of the one lies on the other; what hid the part on one of them does not look the same there.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.geometry import bezier
from roam_core.motion.pose import Pose, Search, Surroundings
from roam_core.motion.template import Template


@dataclass(frozen=True, eq=False)
class Drawn:
    """A part on a key: what it looks like there, and its outline `(P, 3, 2)`."""

    template: Template
    points: Array


def agreed(first: Drawn, last: Drawn) -> tuple[Template, Template]:
    """The templates of two keys of a part without what is not alike on both.

    They are as they were where too little is alike: then what is may be so by chance.
    """
    ahead, behind = _as_on(first, last), _as_on(last, first)
    if ahead is None or behind is None:
        return first.template, last.template
    return ahead, behind


def looking_as_on(here: Drawn, there: Drawn) -> Template:
    """The template of one key (`here`) with the look of another (`there`), the outlines laid on each other."""
    return there.template.laid_on(here.template, _as_drawn(there, here))


def _as_on(here: Drawn, there: Drawn) -> Template | None:
    """The template of one key where the other looks the same; None where too little does."""
    template, picture, params = here.template, there.template.pyramid, here.template.params
    pose, level = _laid_on(here, there), template.coarsest - 1

    def is_alike(places: Array) -> Bools:
        now = picture.colours(template.chain.carried(pose, places), level)
        apart = ((now - template.pyramid.colours(places, level)) ** 2).sum(axis=1)
        return np.asarray(apart < params.like_roughly**2)

    shares = [is_alike(samples.places[samples.weights > 0]).mean() for samples in template.levels]
    return template.where(is_alike) if min(shares) >= params.alike else None


def _as_drawn(here: Drawn, there: Drawn) -> Array:
    """The pose `(P,)` by which the outline of a part lies as on another key."""
    count, places = len(here.points), here.template.params.places
    segment, t = bezier.even_pairs(np.full(count, places))
    return here.template.chain.brought(*(bezier.evaluate(each.points, segment, t) for each in (here, there)))


def _laid_on(here: Drawn, there: Drawn) -> Array:
    """The pose `(P,)` by which a part lies as on another key: as it was drawn there, and as near as it then matches."""
    template, picture, params = here.template, there.template.pyramid, here.template.params
    drawn = _as_drawn(here, there)
    at = replace(Pose.on_key(template, params), values=drawn, like=params.like_roughly)
    return Search(at, Surroundings(picture, picture.nothing, is_complete=False), params).settled(drawn)
