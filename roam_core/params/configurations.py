"""The named configurations, and those that a longer name tells: dials turned, single numbers changed."""

from __future__ import annotations

import math
import re
from functools import lru_cache

from roam_core.arguments import shown
from roam_core.dials import DIALS, turn
from roam_core.errors import RoamError
from roam_core.params.appearance import AppearanceParams
from roam_core.params.evidence import BackgroundParams, BarsParams, ExposureParams, LevelsParams, TextureParams
from roam_core.params.landmarks import LandmarkParams
from roam_core.params.patches import PatchParams
from roam_core.params.paths import changed, no_such
from roam_core.params.pose import PoseParams
from roam_core.params.proposals import ProposalParams
from roam_core.params.region import RegionParams
from roam_core.params.roam import RoamParams

CONFIGS: dict[str, RoamParams] = {
    "baseline": RoamParams(),
    "lean": RoamParams(config="lean", appearance=AppearanceParams(), lambda_local=0.03, mu=0.6, l2_rest=0.7),
    "medium": RoamParams(
        config="medium",
        appearance=AppearanceParams(),
        lambda_local=0.03,
        mu=0.6,
        l2_rest=0.7,
        warp="landmarks+klt",
        landmarks=LandmarkParams(),
    ),
    "full": RoamParams(
        config="full",
        appearance=AppearanceParams(
            local_kind="both",
            cues=RegionParams(
                motion_weight=0.0,
                uncovered_weight=0.0,
                label_propagation_weight=0.0,
                key_aged=0.0,
                doubted=0.5,
                better=0.3,
                believed=0.6,
            ),
            global_kind="histogram",
        ),
        lambda_local=0.03,
        lambda_global=0.03,
        warp="landmarks+klt",
        landmarks=LandmarkParams(),
        proposals=ProposalParams(least_share=0.7),
    ),
    "best": RoamParams(
        config="best",
        region=RegionParams(
            pose=PoseParams(like=(5.0, 12.0), turned=0.5 * math.pi),
            part=PoseParams(candidates=12),
            patches=PatchParams(),
            background=BackgroundParams(),
            exposure=ExposureParams(),
            levels=LevelsParams(),
            bars=BarsParams(),
            texture=TextureParams(),
        ),
    ),
}
"""Configurations by name. `baseline`: gradient and l2 regulariser (the paper's Baseline); `lean`: local colour models
of the edges beside them (the paper's Lean, as region competition); `medium`: landmarks as well, in the pre-warp and
tied to the curve (the paper's Medium); `full`: the global colour model as well, and proposals by graph cut (the paper's
Full; p_0 as histograms, the local models with the nearest colours, what is lost is looked for again); `best`: all that
proved itself, at present the region proposals."""

DOUBTFUL = 0.75
"""Confidence below which a frame ends as LOW_CONFIDENCE and is offered as worth fixing.

Confidence is an expected IoU. Of the frames below this value in runs of twenty frames on the shared shots, six in seven
were under 0.8, where an edit pays, and they were four in five of all frames under 0.7; above it the mean was .87."""

DEFAULT_CONFIG = "best"


def is_doubtful(confidence: float | None) -> bool:
    """True where a frame, or a vertex, is worth fixing: it was rated, and below `DOUBTFUL`."""
    return confidence is not None and confidence < DOUBTFUL


WORD = re.compile(r"\+(?=[^+=]*=)")
"""What parts the words of a name: a plus before the next `name=`, for a value may hold one (`warp=landmarks+klt`)."""


def params_for(config: str | RoamParams) -> RoamParams:
    """The parameters of a configuration by its name, with what the name changes (`best+reach=1.5+region.band=6`).

    A word with a dial's name turns the dial, one with a parameter's path gives that number its value, one after the
    other. A `RoamParams` is passed through.

    Raises
    ------
    RoamError
        when there is no such configuration, dial or parameter, or the value makes no sense.
    """
    if isinstance(config, RoamParams):
        return config
    if not isinstance(config, str):
        raise ValueError(f"a configuration is a name, such as {DEFAULT_CONFIG!r}, or RoamParams, not {shown(config)}")
    return CONFIGS[config] if config in CONFIGS else _changed(config)


def numbers_in(name: str) -> list[str]:
    """The words of a configuration's name that give parameters values (`window=7`); dials are turned within bounds."""
    dials = {dial.name for dial in DIALS}
    return [word for word in WORD.split(name)[1:] if word.partition("=")[0] not in dials]


def departed(name: str) -> list[str]:
    """A sentence for each dial that a configuration's name turns, though it is offered there no more."""
    base, *words = WORD.split(name)
    turned = {word.partition("=")[0] for word in words}
    gone = [dial for dial in DIALS if dial.name in turned and base in CONFIGS and not dial.is_offered(CONFIGS[base])]
    return [
        f"The dial {dial.name!r} is not offered for {base!r} any more, where it changed results by chance only; "
        f"{name!r} is understood as before."
        for dial in gone
    ]


@lru_cache(maxsize=64)
def _changed(name: str) -> RoamParams:
    """One value for one name: who compares parameters, or keeps something by them, may go by identity."""
    base, *words = WORD.split(name)
    if base not in CONFIGS or not words:
        raise RoamError(f"There is no configuration {base!r}; choose from {', '.join(CONFIGS)}.")
    params, dials = CONFIGS[base], {dial.name: dial for dial in DIALS}
    for word in words:
        what, _, text = word.partition("=")
        if what in dials:
            params = turn(params, dials[what], text)
        elif "." in what or hasattr(params, what):
            params = changed(params, what, text)
        else:
            raise RoamError(no_such(params, what, list(dials)))
    return params.named(name)
