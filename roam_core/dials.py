"""The few numbers of the engine that an artist may turn, each a factor on what a configuration says."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from roam_core.errors import RoamError
from roam_core.translatable import N_, sentence


@dataclass(frozen=True)
class Dial:
    """A number that an artist may turn.

    Attributes
    ----------
    name : its name in that of a configuration, as in `best+reach=1.5`.
    title, sentence : what it is called, and what it does, in an artist's words.
    low, high : bounds of the factor; 1 is what the configuration says.
    turn : from parameters (`RoamParams`) and a factor to the parameters so changed; the very same ones where the
        configuration has nothing for this dial to turn.
    is_offered : whether it is worth turning in parameters. A name that turns it all the same is understood as ever, so
        that keys which were tracked so stay what they are.
    """

    name: str
    title: str
    sentence: str
    low: float
    high: float
    turn: Callable[[Any, float], Any]
    is_offered: Callable[[Any], bool] = lambda params: True


def _reach(params: Any, factor: float) -> Any:
    if params.region is not None:
        # The grid has to reach as far as the outline may go.
        band, margin = max(round(params.region.band * factor), 2), params.region.margin * max(factor, 1.0)
        return replace(params, region=replace(params.region, band=band, margin=margin))
    return replace(params, steps=tuple(step * factor for step in params.steps))


def _firmness(params: Any, factor: float) -> Any:
    if params.region is not None:
        return replace(params, region=replace(params.region, prior_weight=params.region.prior_weight * factor))
    return replace(params, mu=params.mu * factor)


def _smoothness(params: Any, factor: float) -> Any:
    if params.region is not None:
        region = replace(params.region, blur=params.region.blur * factor, diffusion=params.region.diffusion * factor)
        return replace(params, region=region)
    return replace(params, node_spacing=params.node_spacing * factor)


def _learning(params: Any, factor: float) -> Any:
    if params.region is not None:
        rate = min(params.region.adaptation * factor, 1.0)
        return replace(params, region=replace(params.region, adaptation=rate))
    if params.appearance is None:
        return params
    rate = min(params.appearance.adaptation * factor, 1.0)
    return replace(params, appearance=replace(params.appearance, adaptation=rate))


def _key_colours(params: Any, factor: float) -> Any:
    if params.region is not None:
        region = params.region
        aged = region.key_aged / factor if factor > 0 else 0.0  # older the less it counts; 0: off
        texture = None if region.texture is None else replace(region.texture, key=region.texture.key * factor)
        region = replace(region, key_weight=region.key_weight * factor, key_aged=aged, texture=texture)
        return replace(params, region=region)
    if params.appearance is None:
        return params
    share = min(params.appearance.key_share * factor, 0.95)
    return replace(params, appearance=replace(params.appearance, key_share=share))


def _steadiness(params: Any, factor: float) -> Any:
    if params.region is None:
        return params
    strength = min(params.region.span.steadiness * factor, 1.0)
    return replace(params, region=replace(params.region, span=replace(params.region.span, steadiness=strength)))


def _is_curve(params: Any) -> bool:
    """Whether curves are drawn by their own energy: for regions what the dial turns told nothing but chance."""
    return params.region is None


DIALS: tuple[Dial, ...] = (
    Dial(
        "reach", N_("Reach"), N_("How far the outline may go in one frame from where the motion puts it"), 0.25, 4.0,
        _reach,
    ),
    Dial(
        "firmness", N_("Firmness"), N_("How firmly the outline keeps its form from frame to frame"), 0.0, 8.0,
        _firmness, _is_curve,
    ),
    Dial(
        "smoothness", N_("Smoothness"), N_("How smooth the edge is: less follows finer detail"), 0.5, 3.0, _smoothness,
    ),
    Dial(
        "learning", N_("Learning"), N_("How quickly new colours are learned; at 0 never"), 0.0, 4.0, _learning,
        _is_curve,
    ),
    Dial(
        "key", N_("Key colours"), N_("How much your key's colours count beside later ones"), 0.0, 3.0, _key_colours,
    ),
    Dial(
        "steadiness", N_("Steadiness"),
        N_(
            "How strongly what is filled between two keys is drawn to the motion of the picture: as it is, edges boil "
            "less by a tenth on rendered figures; at 0 they stay as they were found"
        ),
        0.0, 2.0, _steadiness,
    ),
)  # fmt: skip


def dials_of(params: Any) -> tuple[Dial, ...]:
    """The dials that are worth turning in these parameters (`RoamParams`)."""
    return tuple(dial for dial in DIALS if dial.is_offered(params) and dial.turn(params, dial.high) != params)


def name_of(config: str, factors: Mapping[str, float]) -> str:
    """The name of a configuration with dials turned: `best+reach=1.5`; dials at 1 are left out."""
    turned = [f"{dial.name}={factors[dial.name]:g}" for dial in DIALS if factors.get(dial.name, 1.0) != 1.0]
    return "+".join([config, *turned])


def turn(params: Any, dial: Dial, text: str) -> Any:
    """The parameters with a dial turned by the factor that a name tells; raises `RoamError` where it makes no sense."""
    return dial.turn(params, _factor(dial, text))


def _factor(dial: Dial, text: str) -> float:
    try:
        factor = float(text)
    except ValueError:
        factor = float("nan")
    if not dial.low <= factor <= dial.high:
        raise RoamError(
            sentence(
                "{name}={text} makes no sense; give a number from {low:g} to {high:g}.",
                name=dial.name,
                text=text,
                low=dial.low,
                high=dial.high,
            )
        )
    return factor
