"""How wide an edge is in the picture: an edge of each width is fitted to what lies across the outline."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array
from roam_core.params.softness import SoftnessParams

MOST_ROWS = 20_000
"""Places that are read at once: OpenCV refuses pictures of more rows than a short integer counts."""


def profiles(picture: NDArray[Any], places: Array, normals: Array, params: SoftnessParams) -> Array:
    """Brightness and colour differences `(N, U, 3)` of the picture across an outline, from inside to outside.

    Parameters
    ----------
    picture : (h, w, 3), uint8, or floats in [0, 1]; what comes back are grey values of 255.
    places, normals : (N, 2) on the outline, and unit vectors out of the shape. Beyond the picture its border goes on.
    """
    at = (places[:, None] + offsets(params)[None, :, None] * normals[:, None] - 0.5).astype(np.float32)
    rows = [
        cv2.remap(picture, part[..., 0].copy(), part[..., 1].copy(), cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        for part in np.array_split(at, len(at) // MOST_ROWS + 1)
    ]
    scale = 1.0 if picture.dtype == np.uint8 else 255.0
    red, green, blue = scale * np.moveaxis(np.concatenate(rows).astype(np.float64), 2, 0)
    luma = 0.299 * red + 0.587 * green + 0.114 * blue
    return np.stack([luma, params.chroma * (red - luma), params.chroma * (blue - luma)], axis=2)


def offsets(params: SoftnessParams) -> Array:
    """Where the samples of a profile lie, in pixels outwards: `(U,)`."""
    count = round(params.reach / params.step)
    return params.step * np.arange(-count, count + 1, dtype=np.float64)


def costs(found: Array, params: SoftnessParams) -> Array:
    """What speaks against each of `params.widths` in profiles `(N, U, 3)`: `(N, D)`, 0 for the best of each.

    An edge leads from one colour to another, either of which may change evenly away from it. Its least squares, over
    all places that the edge may have, are compared as variances of the samples, grain added: where there is no
    contrast all widths fit alike, and nothing is said.
    """
    bases, weights = _bases(params)
    samples = (np.sqrt(weights)[:, None] * found).transpose(1, 0, 2).reshape(len(weights), -1)
    total = np.square(samples).sum(axis=0)
    left = np.empty((len(bases), len(found)))
    for index, basis in enumerate(bases):  # (astray, 4, U)
        explained = np.square(basis.reshape(-1, basis.shape[2]) @ samples).reshape(*basis.shape[:2], -1).sum(axis=1)
        left[index] = (total - explained).reshape(len(basis), -1, found.shape[2]).sum(axis=2).min(axis=0)
    grain = params.grain**2 * found.shape[2] * weights.sum()
    says = 0.5 * params.samples * np.log(left + grain)
    return np.asarray(np.minimum(says - says.min(axis=0), params.doubt).T)


@lru_cache(maxsize=8)
def _bases(params: SoftnessParams) -> tuple[list[Array], Array]:
    """For each width orthonormal bases `(A, 4, U)` of edges astray, in samples times root weight; and the weights."""
    across = offsets(params)
    weights = 1.0 / (1.0 + (across / params.near) ** 2)
    astray = np.arange(-params.astray, params.astray + 1e-9, params.step)
    bases = []
    for width in params.widths:
        each = []
        for shift in astray:
            u = across - shift
            inside = edge(u, width, params.spread)
            columns = np.stack([inside, 1.0 - inside, np.minimum(u, 0.0), np.maximum(u, 0.0)], axis=1)
            each.append(np.linalg.qr(np.sqrt(weights)[:, None] * columns)[0].T)
        bases.append(np.stack(each))
    return bases, weights


def edge(across: Array, width: float, spread: float) -> Array:
    """Coverage `across` an edge, in pixels outwards, that falls evenly over `width`, seen through a Gaussian."""
    from scipy.special import erf  # large: a command's help must not wait for it

    def falling(u: Array) -> Array:
        """The integral of the Gaussian's distribution function."""
        z = u / spread
        bell = np.exp(-0.5 * z * z) / np.sqrt(2.0 * np.pi)
        return np.asarray(0.5 * u * (1.0 + erf(z / np.sqrt(2.0))) + spread * bell)

    half = 0.5 * max(width, 1e-2)
    return np.asarray(1.0 - (falling(across + half) - falling(across - half)) / (2.0 * half))
