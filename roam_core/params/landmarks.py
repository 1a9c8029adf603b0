"""Parameters of the landmarks and of the filters that know them again."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.params.stamped import later


@dataclass(frozen=True)
class FilterParams:
    """Parameters of the correlation filters (`landmarks.filters`).

    Attributes
    ----------
    least_contrast : grey levels; a patch that varies less is divided by this, so that grain on a flat surface is no
        texture.
    margin : cells around a patch, to each side, that are learned from with it; they tell where the filter's own peak
        lies.
    lobe : cells around the greatest response that count as its own peak, to each side.
    """

    least_contrast: float = 4.0
    margin: int = 2
    lobe: int = 3


FILTERS = FilterParams()


@dataclass(frozen=True)
class LandmarkParams:
    """Parameters of the landmarks. Lengths are pixels of a 480-line image, as in `RoamParams`.

    Attributes
    ----------
    count : upper bound on M, the landmarks of one object.
    window : side of the patch that a correlation filter knows; smaller on small objects.
    target_sigma : width of the Gaussian answer that a filter is trained for.
    ridge : weight of the filter's own square in the regression, in units of the patch's mean power.
    adaptation : rate at which filters learn from an accepted frame.
    search : how far from its expected place a landmark is looked for before the pre-warp.
    reach : how far from its pre-warped place it may still move in the alternation; S = (2 reach + 1)^2.
    ambiguity : peak-to-sidelobe ratio below which a landmark is removed.
    neighbours : landmarks that each node is paired with, the nearest ones (equation 8).
    weight : of the filters' answers in equation 6, per landmark.
    star : weight of the springs of equation 7, per landmark and squared pixel.
    joint : weight of equation 9, per pair and squared pixel.
    shift_rate : share by which the shifts mu_nm follow the curve on every frame; 0 is the paper's.
    least_side : cells across the smallest patch that can be told from others; even.
    scarce : share of the landmarks found at the last detection below which new ones are looked for at once.
    few : share of `count` below which they are fewer than wanted.
    apart : how far from each other they lie at least, as a share of the side of the square that each has of the object.
    patch : half the side of a filter's patch, as a share of the root of the object's area.
    patience : frames after which new landmarks are looked for in any case, should there be fewer than wanted.
    least_region : cells; a smaller stable region is grain. whole : share of the object above which a stable region is
        the object rather than a mark on it. inside : share of its cells that must lie inside the object.
    filters : of the correlation filters.
    """

    count: int = 40
    window: int = 32
    target_sigma: float = 0.8
    ridge: float = 1.0
    adaptation: float = 0.1
    search: float = 20.0
    reach: float = 6.0
    ambiguity: float = 4.0
    neighbours: int = 2
    weight: float = 1.0
    star: float = 0.02
    joint: float = 0.01
    shift_rate: float = 0.0
    least_side: int = later(16)
    scarce: float = later(0.4)
    few: float = later(0.8)
    apart: float = later(0.8)
    patch: float = later(0.4)
    patience: int = later(5)
    least_region: int = later(12)
    whole: float = later(0.25)
    inside: float = later(0.9)
    filters: FilterParams = later(FILTERS)
