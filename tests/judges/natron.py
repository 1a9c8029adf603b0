"""Natron as a judge: a script runs against objects that remember, and its nodes are merged by Natron's formulas."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from tests.judges.coverage import between, filled, soft, union
from tests.unit.interchange.judged import JudgedMask
from tests.unit.interchange.natron_judge import Node, masks_of, nodes_of

OPERATIONS = {
    "over": union,
    "plus": lambda under, own: under + own,
    "stencil": lambda under, own: under * (1.0 - own),
    "mask": lambda under, own: under * own,
    "difference": lambda under, own: np.abs(under - own),
    "max": np.maximum,
    "min": np.minimum,
}
"""What becomes of the alphas of B, which lies under, and of A."""


def matte(text: str, frame: float, size: tuple[int, int]) -> Array:
    """The alpha `(h, w)` of the node that no other one takes, cut off above 1 as a picture of whole numbers does."""
    nodes = nodes_of(text)
    used = {id(node) for each in nodes for node in each.inputs.values()}
    (last,) = (node for node in nodes if id(node) not in used)
    return np.minimum(_alpha(last, frame, size), 1.0)


def _alpha(node: Node, frame: float, size: tuple[int, int]) -> Array:
    if node.plugin.endswith("Roto"):
        return _drawn(masks_of(node, size[0]), frame, size)
    under = _alpha(node.inputs[0], frame, size) if 0 in node.inputs else np.zeros(size)
    above = _alpha(node.inputs[1], frame, size)
    mix = node.params["mix"].at(frame)
    return (1.0 - mix) * under + mix * OPERATIONS[node.params["operation"].value](under, above)


def _drawn(masks: list[JudgedMask], frame: float, size: tuple[int, int]) -> Array:
    matte = np.zeros(size)
    for mask in masks:
        item = mask.values["item"]
        states = [is_active for time, is_active in sorted(item.activated.items()) if time <= frame]
        if not item.visible or not item.closed or (item.activated and not (states and states[-1])):
            continue
        width = item.distance.at(frame)
        points = mask.points(frame)
        curve = JudgedMask(mask.name, mask.closed, mask.values["feather"]).points(frame)
        if np.abs(curve - points).max() > 1e-6:
            assert not width, "Natron adds a feather curve and a uniform feather; there is no judge of both"
            own = between(points, curve, size)
        else:
            own = soft(points, size, min(width, 0.0), max(width, 0.0)) if width else filled(points, size)
        own = 1.0 - own if item.params["inverted"].value else own
        matte = OPERATIONS[item.operator.lower()](matte, own * item.opacity.at(frame))
    return matte
