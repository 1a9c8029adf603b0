"""The log-likelihood ratio of every pixel near the object: local and global colour, the key frame, the last region."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import cv2
import numpy as np

from roam_core.appearance.global_model import GlobalModel
from roam_core.appearance.texture_model import TextureModel
from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid, signed_distance
from roam_core.features.texture import texture
from roam_core.kernels.diffusion import diffuse
from roam_core.kernels.local_match import log_ratio, nearest_colours
from roam_core.params import RegionParams
from roam_core.proposal.cues.background import Background, LaterView
from roam_core.proposal.cues.exposure import UNCHANGED, Light
from roam_core.proposal.cues.key_view import KeyFlow, KeyView, lab, trimap
from roam_core.proposal.cues.label_propagation import LabelPropagation
from roam_core.proposal.cues.patch_sides import PatchSides
from roam_core.threads import beside

SURE = 4.0
"""Nats given to pixels too deep inside or too far outside to be in doubt."""


@dataclass(frozen=True, eq=False)
class Field:
    """A signed field on a grid, positive inside: the region is where it is above zero."""

    grid: Grid
    values: Float32

    @classmethod
    def of_coverage(cls, grid: Grid, coverage: Float32) -> Field:
        """The region that covers these shares `(rows, columns)` of the cells: sure where they are whole or none."""
        return cls(grid, (2.0 * SURE * (coverage - 0.5)).astype(np.float32))

    @property
    def inside(self) -> Bools:
        return np.asarray(self.values > 0)

    def on(self, grid: Grid, transform: Array | None = None) -> Float32:
        """Coverage `(rows, columns)` in [0, 1] of the region on another grid, carried by `transform (3, 3)` first."""
        carry = np.eye(3) if transform is None else transform
        return np.asarray(grid.warped(self.inside.astype(np.float32), carry @ self.grid.map_to_image))

    def continued_on(self, grid: Grid, transform: Array, size: tuple[int, int]) -> Float32:
        """The same as if, beyond the edge of its picture, of `size` (h, w), the region went on as it is at the edge."""
        region, (height, width) = self.grid.region, size
        left, top = int(region.x0 > 0), int(region.y0 > 0)
        right, below = int(region.x1 < width), int(region.y1 < height)
        framed = np.pad(self.inside.astype(np.float32), ((top, below), (left, right)))
        corner = np.array([[1.0, 0.0, -left], [0.0, 1.0, -top], [0.0, 0.0, 1.0]])
        carry = transform @ self.grid.map_to_image @ corner
        return np.asarray(grid.warped(framed, carry, is_continued=True))

    def nats_on(self, grid: Grid) -> Float32:
        """The field itself `(rows, columns)` on another grid, clipped to +-SURE; surely outside beyond its own."""
        clipped = np.clip(self.values, -SURE, SURE) + np.float32(SURE)
        return np.asarray(grid.warped(clipped, self.grid.map_to_image) - np.float32(SURE), dtype=np.float32)


@dataclass(frozen=True, eq=False)
class KeyMemory:
    """The artist's key, never forgotten: its picture, its region, its colours, and the way from it to the present.

    Attributes
    ----------
    to_now, surroundings : (3, 3) similarities, of the image, by which the object and what lay around it went since.
    light : what has become of the picture's since.
    neither : closed polylines `(K, 2)` on the key of what need not be background, though it is not the object's: what
        lay before it, and its holes.
    later : what came into sight around the object since.
    """

    frame: PreparedFrame
    region: Field
    colours: GlobalModel
    to_now: Array
    surroundings: Array
    neither: tuple[Array, ...] = ()
    later: tuple[LaterView, ...] = ()
    light: Light = UNCHANGED

    def in_its_light(self, frame: PreparedFrame) -> PreparedFrame:
        """A frame as it would be if the light had not changed since the key."""
        return self.light.removed(frame)

    def behind(self, grid: Grid) -> KeyView:
        """The key in the cells of `grid`, carried by the motion of its surroundings."""
        return KeyView(self.frame, self.surroundings, grid, self.region.on(grid, self.surroundings))

    def background(self, grid: Grid) -> Background:
        """What it knows to lie behind the object in the cells of `grid`."""
        return self.behind_it(self.behind(grid))

    def behind_it(self, view: KeyView) -> Background:
        """The same in the cells of a `view` of it, carried by the motion of its surroundings."""
        return Background.of(view, self.neither, self.later)

    def with_surroundings_moved(self, by: Array) -> KeyMemory:
        """It with all that lay around the object moved on by `by (3, 3)`."""
        later = tuple(replace(each, carried=by @ each.carried) for each in self.later)
        return replace(self, surroundings=by @ self.surroundings, later=later)

    def with_view(self, grid: Grid, frame: PreparedFrame, clear: Bools) -> KeyMemory:
        """It with what a frame shows, in the cells `(rows, columns)` of `grid` that are `clear` of the object."""
        known = np.where(clear, np.uint8(255), np.uint8(0))
        return replace(self, later=(*self.later, LaterView(grid, grid.colours_of(frame), known, np.eye(3))))


@dataclass(frozen=True, eq=False)
class Expectation:
    """Where the object should be on the new frame's grid, `(rows, columns)` each.

    `last` is its coverage on the frame before, where it was; `rigid` and `fluid` the region carried by the similarity
    and by the flow (while tracking `best`: what the picture cut off goes on there as at its edge); `remembered` the
    coverage of the key's region, carried all the way; `left_behind` what moves with the surroundings and not with the
    object.
    """

    last: Float32
    rigid: Bools
    fluid: Bools
    remembered: Float32
    left_behind: Bools

    @property
    def possible(self) -> Bools:
        """Where any of the three puts the object."""
        return np.asarray(self.rigid | self.fluid | (self.remembered > 0.5))

    @property
    def likely(self) -> Bools:
        """Where either the last frame or the key puts it as a whole, but for what is left behind."""
        return np.asarray((self.rigid | (self.remembered > 0.5)) & ~self.left_behind)

    @property
    def certain(self) -> Bools:
        """Where all three do."""
        return np.asarray(self.rigid & self.fluid & (self.remembered > 0.5))


def uncertain_band(certain: Bools, possible: Bools, reach: int) -> Bools:
    """Pixels within `reach` cells of the border of a region known only to lie between two bounds."""
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * reach + 1, 2 * reach + 1))
    outer = cv2.dilate(possible.astype(np.uint8), disc)
    inner = cv2.erode(certain.astype(np.uint8), disc, borderType=cv2.BORDER_CONSTANT, borderValue=1)
    return np.asarray((outer > 0) & (inner == 0))


@dataclass(frozen=True, eq=False)
class Sources:
    """What the cues of one frame are drawn from.

    Attributes
    ----------
    before, after : (rows, columns, 3) RGB of the last and of the new frame, in the cells of `grid`.
    backward : (rows, columns, 2) flow from `after` to `before` in cells. motion : (rows, columns) its log-ratio.
    key, colours : the artist's key, and the global colours as they have become since.
    band_reach : cells to both sides of the expected outline in which pixels are in doubt.
    label_propagation : what the cells bring along from the frame before; None where that is not asked.
    patches : on which side the key's patches have them; None where there are none. background : what the key shows
        around the object, carried by the motion of that; None where it is not asked. texture : what tells the object's
        texture from that of its surroundings; None where it is not asked.
    """

    before: UInt8
    after: UInt8
    grid: Grid
    expected: Expectation
    backward: Float32
    key: KeyMemory
    colours: GlobalModel
    motion: Float32
    band_reach: int
    label_propagation: LabelPropagation | None = None
    patches: PatchSides | None = None
    background: Background | None = None
    texture: TextureModel | None = None

    @cached_property
    def lab(self) -> UInt8:
        """The new frame in CIE Lab."""
        return lab(self.after)

    @cached_property
    def texture_around(self) -> Float32:
        """The new frame's texture `(F, rows, columns)` around each cell; only where it is asked."""
        assert self.texture is not None
        return texture(self.lab, self.texture.params)

    @cached_property
    def reliability(self) -> Float32:
        """How far the side of each cell is the key's word `(rows, columns)`, in [0, 1]; only with label propagation."""
        assert self.label_propagation is not None
        by_flow = self.label_propagation.flow_reliability
        return by_flow if self.patches is None else np.maximum(by_flow, self.patches.inside)

    @cached_property
    def carried(self) -> Bools:
        """Where the similarity or the flow takes the last region."""
        return np.asarray(self.expected.rigid | self.expected.fluid)

    @cached_property
    def band(self) -> Bools:
        """The cells in doubt; all others are taken as expected."""
        return uncertain_band(self.expected.certain, self.expected.possible, self.band_reach)


def local_cues(sources: Sources, params: RegionParams) -> Iterator[tuple[str, Float32]]:
    """The cues by nearest colours, by name with their weighted log-ratios `(rows, columns)`, nats.

    "local": nearest colours of the last frame along the flow and of the key together, where the key's, which is older,
    must be the nearer ones by `key_aged`; "key": those of the key alone, carried by the similarity and, where the two
    are taken together, along the flow that is left.
    """
    expected, band, sigma = sources.expected, sources.band, params.local_sigma
    inside, outside = nearest_colours(
        sources.lab, lab(sources.before), trimap(expected.last), band, sources.backward,
        params.local_radius, params.local_spread,
    )  # fmt: skip
    is_key_asked = params.key_weight > 0 or params.key_aged > 0
    if is_key_asked:
        view = KeyView(sources.key.frame, sources.key.to_now, sources.grid, expected.remembered)
        flow: KeyFlow = "fast" if params.key_aged > 0 else "none"
        there = view.nearest(sources.after, sources.lab, band, params.key_radius, params.key_spread, flow)
    if params.key_aged > 0:
        aged = np.float32(params.key_aged)
        inside, outside = np.minimum(inside, aged * there[0]), np.minimum(outside, aged * there[1])
    yield "local", params.local_weight * log_ratio(inside, outside, sigma, params.clip)
    if is_key_asked:
        yield "key", params.key_weight * log_ratio(*there, params.key_sigma * sigma, params.clip)


def cues(sources: Sources, params: RegionParams) -> Iterator[tuple[str, Float32]]:
    """Each cue by name with its weighted log-ratio `(rows, columns)`, nats, one after the other.

    "local" and "key": nearest colours of the last and of the key frame; "global": the histograms; "motion", "prior" and
    "bias"; "background", what the key shows around the object; "texture", what the trees say; "lineage", the key's word
    by the flow and its patches, the more the less the others are heard; "patches", what those say of cells outside.
    Only their sum in the band means anything to the region.
    """
    label_propagation, patches = sources.label_propagation, sources.patches
    heard: Float32 | np.float32 = np.float32(1.0)
    if label_propagation is not None:
        heard = np.float32(1.0) - np.float32(1.0 - params.beside_label_propagation) * sources.reliability
    known_and_texture = beside(lambda: tuple(_known_and_texture(sources, params)))
    for name, cue in _own_cues(sources, params):
        yield name, np.asarray(heard * cue)
    yield from known_and_texture()
    if label_propagation is None:
        return
    brought = label_propagation.log_ratio
    if patches is not None:
        brought = brought + patches.inside * (np.float32(1.0) - brought)
        yield "patches", np.float32(-params.patches_outside) * patches.outside
    yield "lineage", np.float32(params.label_propagation_weight) * brought


def _known_and_texture(sources: Sources, params: RegionParams) -> Iterator[tuple[str, Float32]]:
    """What the key shows around the object, and what the trees say."""
    if sources.background is not None and params.background is not None:
        outside = ~(sources.band | sources.expected.possible)
        yield "background", sources.background.log_ratio(sources.lab, outside, params.background)
    if sources.texture is not None:
        told = sources.texture.log_ratio(sources.texture_around, sources.band, params.clip)
        yield "texture", np.float32(params.texture_weight) * told


def _own_cues(sources: Sources, params: RegionParams) -> Iterator[tuple[str, Float32]]:
    """The cues that this frame gives by itself."""
    yield from local_cues(sources, params)
    yield from _other_cues(sources, params)


def _other_cues(sources: Sources, params: RegionParams) -> Iterator[tuple[str, Float32]]:
    """Those that look at no neighbours: histograms, motion, the last region."""
    known = params.clip, params.unseen
    yield "global", params.global_weight * sources.colours.log_ratio(sources.after, *known)
    yield "motion", motion_cue(sources, params)
    yield "prior", params.prior_weight * signed_distance(sources.carried, params.prior_reach)
    yield "bias", np.full(sources.grid.shape, params.bias, dtype=np.float32)


def motion_cue(sources: Sources, params: RegionParams) -> Float32:
    """The weighted motion ratio `(rows, columns)`, nats, as far as it speaks against background, new or uncovered.

    Limbs move in their own ways: where the similarity or the key expects the object it never speaks against what was
    inside already.
    """
    expected = sources.expected
    uncovered = expected.fluid & ~expected.rigid & ~(expected.remembered > 0.5)
    weight = np.where(sources.carried, np.float32(0.0), np.float32(params.motion_weight))
    weight[uncovered] = params.uncovered_weight
    return np.asarray(weight * np.minimum(sources.motion, np.float32(0.0)))


def gathered(sources: Sources, params: RegionParams) -> Field:
    """The smoothed log-ratio on the sources' grid, all cues added; surely in or out beyond the band.

    What label propagation carries on reliably is not smoothed: it is as fine as it was drawn.
    """
    each = cues(sources, params)
    _, ratio = next(each)
    for _, cue in each:
        ratio += cue
    expected, band = sources.expected, sources.band
    sure = np.where(expected.rigid & expected.fluid, np.float32(SURE), np.float32(-SURE))
    blurred = np.where(band, cv2.GaussianBlur(ratio, (0, 0), params.blur), sure).astype(np.float32)
    smoothed = diffuse(blurred, sources.lab, band, params.diffusion, params.contrast, params.sweeps)
    if sources.label_propagation is not None:
        held = np.where(band, sources.reliability, np.float32(0.0))
        smoothed += held * (ratio - smoothed)
    return Field(sources.grid, smoothed)
