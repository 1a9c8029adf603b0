"""Configurations with one thing changed, by name: the rows of the ablation and of the warping table."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import reduce
from typing import Any

from roam_core.errors import RoamError
from roam_core.params import CONFIGS, RoamParams, params_for


@dataclass(frozen=True)
class Variant:
    """A configuration and the fields that differ from it, by name: `mu`, `region.bias`."""

    name: str
    config: str
    changes: Mapping[str, Any] = field(default_factory=dict)

    @property
    def params(self) -> RoamParams:
        """The parameters, under the variant's own name."""
        changed = reduce(lambda params, item: with_field(params, *item), self.changes.items(), params_for(self.config))
        return replace(changed, config=self.name)


SHORT_EDGES: Mapping[str, Any] = {"mu": 0.06, "l2_rest": 0.0}
"""The l2 term of equation 3 as the paper has it: it draws every edge towards length zero."""

ABLATION = (
    Variant("baseline, no pre-warp", "baseline", {"warp": "none"}),
    Variant("baseline", "baseline"),
    Variant("lean, the paper's ribbon", "lean", {"appearance.term": "ribbon", "lambda_local": 0.3} | SHORT_EDGES),
    Variant("lean", "lean"),
    Variant("lean, edges drawn to length zero as in the paper", "lean", SHORT_EDGES),
    Variant("medium, the paper's pre-warp", "medium", {"warp": "landmarks"}),
    Variant("medium, landmarks not tied to the curve", "medium", {"landmarks.joint": 0.0}),
    Variant("medium", "medium"),
    Variant("full without the global model", "full", {"lambda_global": 0.0, "proposals.global_weight": 0.0}),
    Variant("full without proposals", "full", {"proposals": None}),
    Variant("full without re-detection", "full", {"appearance.cues.doubted": 0.0}),
    Variant("full", "full"),
    Variant("best without the last frame's colours", "best", {"region.local_weight": 0.0}),
    Variant("best without the key frame's colours", "best", {"region.key_weight": 0.0, "region.key_aged": 0.0}),
    Variant("best, the key frame's colours by themselves", "best", {"region.key_aged": 0.0}),
    Variant("best without the global model", "best", {"region.global_weight": 0.0}),
    Variant("best without motion", "best", {"region.motion_weight": 0.0, "region.uncovered_weight": 0.0}),
    Variant("best, motion against new background only", "best", {"region.uncovered_weight": 0.0}),
    Variant("best without the last region as prior", "best", {"region.prior_weight": 0.0}),
    Variant("best without label propagation", "best", {"region.label_propagation_weight": 0.0}),
    Variant("best, one piece an outline", "best", {"region.longest_bridge": 0.0}),
    Variant("best, points not held to the key", "best", {"region.kept_shares": 0.0, "region.key_pull": 0.0}),
    Variant("best without patches of the key", "best", {"region.patches": None}),
    Variant("best without the key's background", "best", {"region.background": None}),
    Variant("best without textures", "best", {"region.texture": None}),
    Variant("best without smoothing by contrast", "best", {"region.diffusion": 0.0}),
    Variant("best without adaptation", "best", {"region.adaptation": 0.0}),
    Variant("best without re-detection", "best", {"region.doubted": 0.0}),
    Variant("best without the rigid mode", "best", {"region.rigid": 1.1}),
    Variant("best", "best"),
)
"""The paper's configurations with their steps taken apart, and `best` with one of its cues taken away at a time."""

WARPS = tuple(
    Variant(name, "medium", {"warp": warp})
    for name, warp in (
        ("none", "none"),
        ("similarity of dense flow (the paper: optical flow)", "flow"),
        ("node projection from landmarks (the paper's)", "nodes"),
        ("similarity of landmarks (the paper's choice)", "landmarks"),
        ("similarity of followed points", "klt"),
        ("similarity of landmarks and followed points", "landmarks+klt"),
    )
)
"""Ways of carrying the curve to the next frame, all under `medium`."""


def field_of(params: RoamParams, name: str) -> Any:
    """The value of a field by its name, `mu` or `region.bias`.

    Raises
    ------
    RoamError
        when there is none of that name in this configuration.
    """
    value: Any = params
    for part in name.split("."):
        if not hasattr(value, part):
            raise RoamError(f"The configuration {params.config!r} has no field {name!r}.")
        value = getattr(value, part)
    return value


def with_field(params: RoamParams, name: str, value: Any) -> RoamParams:
    """The parameters with one field changed; a name that they do not have is refused as by `field_of`."""
    field_of(params, name)
    changed: RoamParams = _with(params, name, value)
    return changed


def _with(params: Any, name: str, value: Any) -> Any:
    room, dot, rest = name.partition(".")
    return replace(params, **{room: _with(getattr(params, room), rest, value) if dot else value})


def chosen(text: str | None) -> list[str]:
    """The configurations named in `text` ("a,b"), or all of them.

    Raises
    ------
    RoamError
        when there is none of that name.
    """
    names = text.split(",") if text else list(CONFIGS)
    for name in names:
        params_for(name)
    return names
