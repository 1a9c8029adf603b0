"""Components of a region: to which shape each belongs, and the one outline around all those of a shape.

A closed curve cannot come apart. Where what it encloses does, as behind a post, it is pinched: the components hang
together by bridges, along the shortest ways between them. Nor can it have holes: where a bay of it closes, as between
an arm and the hip, a slit along the shortest way keeps it open.
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from scipy.spatial import KDTree

from roam_core.arrays import Array, Bools, Float32, Indices, Int32
from roam_core.params import ComponentsParams
from roam_core.proposal.cues.evidence import Field
from roam_core.proposal.segment.region import contours


def shares(region: Bools, claims: Sequence[Float32], likely: Bools, params: ComponentsParams) -> list[Bools]:
    """Which components `(rows, columns)` of the region belong to each shape.

    `claims` are the shapes' expected coverages on the grid. Each shape has the component that it claims most of; shapes
    that want the same divide it, each cell to the one whose expected region it lies deepest in. A component that none
    of them wants most goes to the one that claims most of it, or to the nearest, if it lies where the object is
    `likely` to be `(rows, columns)`.
    """
    count, labels, stats, _ = cv2.connectedComponentsWithStats(region.astype(np.uint8), connectivity=4)
    claimed = np.zeros((len(claims), count))
    for number, claim in enumerate(claims):
        window = _window(claim > 0)
        claimed[number] = np.bincount(labels[window].ravel(), weights=claim[window].ravel(), minlength=count)
    claimed[:, 0] = 0.0
    wanted = claimed.argmax(axis=1)  # 0, the outside: nothing
    owner = np.full(region.shape, -1)
    for component in np.unique(wanted[wanted > 0]):
        rivals = np.flatnonzero(wanted == component)
        here = labels == component
        owner[here] = rivals[0] if len(rivals) == 1 else rivals[_deepest([claims[int(k)] for k in rivals])[here]]
    expected = np.bincount(labels[likely], minlength=count) >= params.likely * stats[:, cv2.CC_STAT_AREA]
    loose = np.setdiff1d(np.flatnonzero(expected), [0, *wanted])
    is_claimed = claimed[:, loose].max(axis=0, initial=0.0) > 0.0
    for component in loose[is_claimed]:
        owner[labels == component] = claimed[:, component].argmax()
    if not is_claimed.all() and any((claim > 0.5).any() for claim in claims):
        far, nearest = _nearest(claims)
        for component in loose[~is_claimed]:
            here = labels == component
            owner[here] = nearest[here][far[here].argmin()]
    return [owner == number for number in range(len(claims))]


def ring_around(field: Field, mine: Bools, claim: Float32, longest: float, params: ComponentsParams) -> Array | None:
    """The one outline `(K, 2)`, in pixels, around the components `mine` of a region, which hang together (`joined`).

    It goes into those of its holes that lay outside the shape, whose expected coverage is `claim` (`opened`).
    """
    if not mine.any():
        return None
    window = _window(mine)
    body, bridges = joined(mine[window], longest, params)
    values = np.where(body, field.values[window], np.float32(-1.0))
    values[bridges] = 1.0
    values[opened(body | bridges, claim[window], longest, params)] = -1.0
    rings = contours(values)
    return field.grid.to_image(rings[0][0] + [window[1].start, window[0].start]) if rings else None


def joined(mine: Bools, longest: float, params: ComponentsParams) -> tuple[Bools, Bools]:
    """The components that hang together with the largest, and the bridges, a cell wide, by which they do.

    A component hangs on to what is nearest of all that does already, if the bridge is no longer than `longest` times
    the square root of its area; specks do not.
    """
    count, labels, stats, _ = cv2.connectedComponentsWithStats(mine.astype(np.uint8), connectivity=4)
    if count <= 2:
        return mine, np.zeros_like(mine)
    area = stats[:, cv2.CC_STAT_AREA].astype(np.float64)
    area[0] = 0.0
    largest = int(area.argmax())
    return _hung_on(labels, largest, area >= params.least * area.sum(), longest * np.sqrt(area))


def opened(body: Bools, claim: Float32, longest: float, params: ComponentsParams) -> Bools:
    """The slits `(rows, columns)`, a cell wide, by which holes of a body open to the outside.

    The dual of `joined`, under the same rules. A hole that its shape, expected to cover `claim`, has mostly outside is
    a bay that closed, as between an arm and the hip that it came to rest on: the outline has points that go around it.
    One that it has inside is new, or has a shape of its own; one around which the shape is mostly not expected either
    is ground that a leak encloses.
    """
    outside = np.pad(~body, 1, constant_values=True)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(outside.astype(np.uint8), connectivity=4)
    around = int(labels[0, 0])
    if count <= 2:
        return np.zeros_like(body)
    area = stats[:, cv2.CC_STAT_AREA].astype(np.float64)
    claim = np.pad(claim, 1)
    claimed = np.bincount(labels.ravel(), weights=claim.ravel(), minlength=count)
    is_bay = (claimed <= 0.5 * area) & (area >= params.least * np.count_nonzero(body))
    is_bay[[0, around]] = False
    for hole in np.flatnonzero(is_bay):
        is_bay[hole] = claim[_rim_around(labels == hole)].mean() > 0.5
    _, slits = _hung_on(labels, around, is_bay, longest * np.sqrt(area))
    return slits[1:-1, 1:-1]


def _hung_on(labels: Int32, body: int, loose: Bools, longest: Array) -> tuple[Bools, Bools]:
    """The components that hang together with that labelled `body`, itself too, and the lines by which they do.

    Each of those that are `loose` hangs on to what is nearest of all that does already, by a line no longer than its
    own `longest`, in cells.
    """
    lines = np.zeros(labels.shape, dtype=np.uint8)
    hanging = labels == body
    rims = {int(k): _rim(labels == k) for k in np.flatnonzero(loose) if k != body}
    shore = _rim(hanging)
    while rims:
        tree = KDTree(shore)
        lengths = {k: tree.query(rim) for k, rim in rims.items()}
        near = [k for k, (length, _) in lengths.items() if length.min() <= longest[k]]
        if not near:
            break
        nearest = min(near, key=lambda k: float(lengths[k][0].min()))
        length, to = lengths[nearest]
        rim = rims.pop(nearest)
        start, stop = rim[length.argmin()], shore[to[length.argmin()]]
        cv2.line(lines, start.tolist(), stop.tolist(), 1, 1, cv2.LINE_4)
        hanging |= labels == nearest
        shore = np.vstack([shore, rim])
    return hanging, (lines > 0) & ~hanging


def _rim(component: Bools) -> Indices:
    """The cells of a component that have a neighbour outside, as `(C, 2)` columns and rows."""
    inner = cv2.erode(
        component.astype(np.uint8), np.ones((3, 3), np.uint8), borderType=cv2.BORDER_CONSTANT, borderValue=0
    )
    return np.argwhere(component & (inner == 0))[:, ::-1]


def _rim_around(component: Bools) -> Bools:
    """The cells outside a component that are next to one of it, across corners too."""
    return np.asarray(cv2.dilate(component.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0) & ~component


def _deepest(claims: Sequence[Float32]) -> Indices:
    """For each cell which claim it lies deepest in, or, outside all, is nearest to; the first of equals."""
    _, result = _nearest(claims)
    depth = np.zeros(result.shape, np.float32)
    for number, claim in enumerate(claims):
        window = _window(claim > 0.5, margin=1)
        if claim[window].size == 0:
            continue
        ours = cv2.distanceTransform((claim[window] > 0.5).astype(np.uint8), cv2.DIST_L2, 3)
        deeper = ours > depth[window]
        depth[window][deeper] = ours[deeper]
        result[window][deeper] = number
    return result


def _nearest(claims: Sequence[Float32]) -> tuple[Float32, Indices]:
    """For each cell `(rows, columns)` how far the nearest claim is, in cells, and whose it is."""
    taken = np.full(claims[0].shape, -1)
    for number, claim in reversed(list(enumerate(claims))):
        window = _window(claim > 0.5)
        taken[window][claim[window] > 0.5] = number
    far, source = cv2.distanceTransformWithLabels(
        (taken < 0).astype(np.uint8), cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL
    )
    whose = np.zeros(int(source.max()) + 1, np.intp)
    whose[source[taken >= 0]] = taken[taken >= 0]
    return np.asarray(far), whose[source]


def _window(cells: Bools, margin: int = 0) -> tuple[slice, slice]:
    """The rows and columns that hold all of these cells, and a margin as far as there is one; nothing of none."""
    rows, columns = (np.flatnonzero(cells.any(axis=axis)) for axis in (1, 0))
    if len(rows) == 0:
        return slice(0, 0), slice(0, 0)
    top, left = max(int(rows[0]) - margin, 0), max(int(columns[0]) - margin, 0)
    return slice(top, int(rows[-1]) + margin + 1), slice(left, int(columns[-1]) + margin + 1)
