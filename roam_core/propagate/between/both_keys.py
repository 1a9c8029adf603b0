"""An object between two keys is known by the textures of both; a lone shape by what looks alike on them.

What hides a shape on one of its keys is not its own. Where that hides it on both, a key beyond them tells its look.
"""

from __future__ import annotations

from roam_core.motion.agreement import Drawn, agreed, looking_as_on
from roam_core.propagate.engines.by_regions import RegionEngine
from roam_core.propagate.engines.protocol import Engine


def as_on_both(first: Engine, last: Engine) -> tuple[Engine, Engine]:
    """The engines that were begun on the keys of a span, each with what it knows of the other key.

    That is its textures, and, of a lone shape, that its pose goes only by what both show. In an object in parts, what
    hides each of them is drawn, and nothing is gained by it.
    """
    if not isinstance(first, RegionEngine) or not isinstance(last, RegionEngine):
        return first, last
    first, last = first.knowing(last), last.knowing(first)
    here, there = _drawn(first), _drawn(last)
    if here is None or there is None or len(here.points) != len(there.points):
        return first, last
    ahead, behind = agreed(here, there)
    return first.looking_as(ahead), last.looking_as(behind)


def as_on_another(engine: Engine, other: Engine | None) -> Engine | None:
    """The engine on its key, the pose of its lone shape going by how that looks on another; None where it has none."""
    if not isinstance(engine, RegionEngine) or not isinstance(other, RegionEngine):
        return None
    here, there = _drawn(engine), _drawn(other)
    if here is None or there is None or len(here.points) != len(there.points):
        return None
    return engine.looking_as(looking_as_on(here, there))


def _drawn(engine: RegionEngine) -> Drawn | None:
    """The one solid shape of an object, which then has a pose; None where it has none."""
    pose = engine.state.pose
    if pose is None:
        return None
    [solid] = [part for part in engine.state.drawn if not part.subtracts]
    return Drawn(pose.template, solid.points)
