"""Linear correlation filters on grey patches: learned, adapted and answered for all landmarks at once.

A filter is the ridge regression of a narrow Gaussian onto all cyclic shifts of a windowed patch, solved in the Fourier
domain: Henriques et al., "High-Speed Tracking with Kernelized Correlation Filters" (PAMI 2015) with a linear kernel on
grey values, which is what the paper uses; averaging numerator and power over frames is Bolme et al., "Visual Object
Tracking using Adaptive Correlation Filters" (CVPR 2010), the exact ridge solution for the weighted frames together.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy import fft

from roam_core.arrays import Array, Bools, Float32, Indices, UInt8
from roam_core.params import FILTERS, FilterParams

Complex = NDArray[np.complex64]


@dataclass(frozen=True, eq=False)
class CorrelationFilters:
    """M filters of one side w.

    Attributes
    ----------
    numerator : (M, w, w // 2 + 1) target times the patch's conjugate, in the Fourier domain.
    power : (M, w, w // 2 + 1) squared modulus of the patch.
    offset : (M, 2) x and y, cells: where between the cells the filter peaks on the frame that it was shown last. The
        window moves with the patch, not with what it shows, so the peak is not quite symmetric; uncorrected a landmark
        would walk a fraction of a pixel a frame.
    side : w, cells. ridge : weight of the filter's own square in the regression, in units of the patch's mean power.
    params : how patches are cut and peaks are told.
    """

    numerator: Complex
    power: Float32
    offset: Array
    side: int
    ridge: float
    params: FilterParams = FILTERS

    @classmethod
    def learned(cls, areas: Float32, sigma: float, ridge: float, params: FilterParams = FILTERS) -> CorrelationFilters:
        """Filters that answer a Gaussian of `sigma` cells, 1 at its centre, to their own patch.

        `areas (M, w + 2 m, w + 2 m)` are the patches with the m cells of `FilterParams.margin` around them.
        """
        numerator, power = _spectra(_middle(areas, params.margin), sigma, params.least_contrast)
        side = areas.shape[1] - 2 * params.margin
        return cls(numerator, power, np.zeros((len(areas), 2)), side, ridge, params)._settled(areas)

    def __len__(self) -> int:
        return len(self.power)

    def adapted(self, areas: Float32, sigma: float, rates: Array) -> CorrelationFilters:
        """Filters that also know newer `areas` (as in `learned`), each with its share `rates (M,)` in [0, 1]."""
        numerator, power = _spectra(_middle(areas, self.params.margin), sigma, self.params.least_contrast)
        rate = rates.astype(np.float32)[:, None, None]
        mixed = replace(
            self,
            numerator=self.numerator + rate * (numerator - self.numerator),
            power=self.power + rate * (power - self.power),
        )
        return mixed._settled(areas)

    def chosen(self, keep: Indices | Bools) -> CorrelationFilters:
        """Some of the filters."""
        return replace(self, numerator=self.numerator[keep], power=self.power[keep], offset=self.offset[keep])

    def joined(self, others: CorrelationFilters) -> CorrelationFilters:
        """These filters and then the others, of the same side."""
        if others.side != self.side:
            raise ValueError(f"filters of side {self.side} and {others.side} do not make one bank")
        return replace(
            self,
            numerator=np.concatenate([self.numerator, others.numerator]),
            power=np.concatenate([self.power, others.power]),
            offset=np.concatenate([self.offset, others.offset]),
        )

    def _settled(self, areas: Float32) -> CorrelationFilters:
        """The same filters, told where they peak on these areas."""
        return replace(self, offset=peaks(self.response(areas), self.params.lobe)[0])

    @cached_property
    def templates(self) -> Float32:
        """`(M, w, w)`: what a patch is multiplied with and summed: the regression's solution times the window."""
        noise = self.ridge * _mean_power(self.power, self.side)[:, None, None]
        spectrum = np.conj(self.numerator / (self.power + noise))
        solution = fft.irfft2(spectrum, s=(self.side, self.side), workers=1)
        return np.asarray(solution * window(self.side), dtype=np.float32)

    def response(self, areas: Float32) -> Float32:
        """The answers at every whole displacement that keeps the patch inside its search area.

        Parameters
        ----------
        areas : (M, w + 2 r, w + 2 r) grey values around the expected centre of each landmark.

        Returns
        -------
        (M, 2 r + 1, 2 r + 1); `[m, r + v, r + u]` belongs to the displacement (u, v) and is what the filter gives for
        the patch there, normalised and windowed like those it was learned from.
        """
        side, size = self.side, areas.shape[1]
        if areas.shape != (len(self), size, size) or size < side:
            raise ValueError(f"search areas of shape {areas.shape} do not serve {len(self)} filters of side {side}")
        places = size - side + 1
        shape = (fft.next_fast_len(size, real=True),) * 2
        spectrum = np.conj(fft.rfft2(self.templates, s=shape, workers=1)) * fft.rfft2(areas, s=shape, workers=1)
        raw = fft.irfft2(spectrum, s=shape, workers=1)[:, :places, :places]
        mean, contrast = _moments(areas, side, places, self.params.least_contrast)
        return np.asarray((raw - mean * self.templates.sum(axis=(1, 2))[:, None, None]) / contrast, dtype=np.float32)


def window(side: int) -> Float32:
    """The cosine window `(w, w)`, which hides that the shifts of the regression are cyclic."""
    hann = np.hanning(side + 2)[1:-1]
    return np.asarray(hann[:, None] * hann, dtype=np.float32)


def normalised(patches: Float32, least_contrast: float = FILTERS.least_contrast) -> Float32:
    """Patches `(M, w, w)` of mean 0 and standard deviation 1 (less where there is hardly any contrast)."""
    mean = patches.mean(axis=(1, 2), keepdims=True)
    contrast = np.maximum(patches.std(axis=(1, 2), keepdims=True), least_contrast)
    return np.asarray((patches - mean) / contrast, dtype=np.float32)


def peaks(response: Float32, lobe: int = FILTERS.lobe) -> tuple[Array, Array]:
    """Where each response `(M, n, n)` is greatest, and how clearly.

    Returns
    -------
    displacement : (M, 2) x and y from the centre, cells; between cells by a parabola through the neighbours.
    sharpness : (M,) peak-to-sidelobe ratio (Bolme et al.): the peak's height over the mean of all that is not within
        `lobe` cells of it, in standard deviations of the latter. Low: the landmark might as well be elsewhere.
    """
    count, size = response.shape[0], response.shape[1]
    best = response.reshape(count, size * size).argmax(axis=1)
    row, column = best // size, best % size
    displacement = np.stack([column, row], axis=1) - size // 2 + between(response, row, column)
    return displacement, sharpness(response, row, column, lobe)


def between(response: Float32, row: Indices, column: Indices) -> Array:
    """How far `(M, 2)`, x and y, within half a cell, each response's top lies from its cell `[row, column]`."""
    which = np.arange(len(response))
    return np.stack([_vertex(response[which, row], column), _vertex(response[which, :, column], row)], axis=1)


def sharpness(response: Float32, row: Indices, column: Indices, lobe: int = FILTERS.lobe) -> Array:
    """Peak-to-sidelobe ratio `(M,)` of the cells `[row, column]` of each response `(M, n, n)`."""
    count, size = response.shape[0], response.shape[1]
    ticks = np.arange(size)
    near_row = np.abs(ticks - row[:, None]) <= lobe
    near_column = np.abs(ticks - column[:, None]) <= lobe
    side = ~(near_row[:, :, None] & near_column[:, None, :])
    members = np.maximum(side.sum(axis=(1, 2)), 1)
    values = np.where(side, response, 0.0)
    mean = values.sum(axis=(1, 2)) / members
    spread = np.sqrt(np.maximum((values**2).sum(axis=(1, 2)) / members - mean**2, 1e-12))
    return np.asarray((response[np.arange(count), row, column] - mean) / spread)


def areas_at(grey: UInt8, centres: Array, size: int) -> Float32:
    """Squares `(M, size, size)` of a picture around `centres (M, 2)`, between pixels where need be.

    The middle is cell `size // 2`, whose own centre lies on the given position (our coordinates). Beyond the picture
    its last row or column goes on.
    """
    # Pixel centres are whole in OpenCV's coordinates; its patch is centred on (size - 1) / 2, ours on cell size // 2.
    shift = (size - 1) / 2.0 - size // 2 - 0.5
    areas = np.empty((len(centres), size, size), dtype=np.float32)
    for area, (x, y) in zip(areas, centres, strict=True):
        cv2.getRectSubPix(grey, (size, size), (x + shift, y + shift), patch=area, patchType=cv2.CV_32F)
    return areas


def _middle(areas: Float32, margin: int) -> Float32:
    inner = slice(margin, areas.shape[1] - margin)
    return np.ascontiguousarray(areas[:, inner, inner])


def _spectra(patches: Float32, sigma: float, least_contrast: float) -> tuple[Complex, Float32]:
    side = patches.shape[1]
    spectrum = fft.rfft2(normalised(patches, least_contrast) * window(side), workers=1)
    target = fft.rfft2(_target(side, sigma), workers=1)
    return np.asarray(target * np.conj(spectrum), dtype=np.complex64), np.asarray(np.abs(spectrum) ** 2, np.float32)


def _target(side: int, sigma: float) -> Float32:
    """A Gaussian around displacement zero, which stands at [0, 0] and goes on from the other ends."""
    away = np.minimum(np.arange(side), side - np.arange(side))
    line = np.exp(-0.5 * (away / sigma) ** 2)
    return np.asarray(line[:, None] * line, dtype=np.float32)


def _mean_power(power: Float32, side: int) -> Float32:
    """Mean `(M,)` over the whole spectrum, of which only half is kept."""
    twice = np.full(power.shape[2], 2.0, dtype=np.float32)
    twice[0] = 1.0
    if side % 2 == 0:
        twice[-1] = 1.0
    return np.asarray((power * twice).sum(axis=(1, 2)) / side**2, dtype=np.float32)


def _moments(areas: Float32, side: int, places: int, least_contrast: float) -> tuple[Float32, Float32]:
    """Mean and standard deviation (at least `least_contrast`) of every patch inside the search areas."""
    centred = areas - areas.mean(axis=(1, 2), keepdims=True)
    mean, square = np.empty((2, len(areas), places, places), dtype=np.float32)
    for m, area in enumerate(centred):
        mean[m] = cv2.boxFilter(area, -1, (side, side), anchor=(0, 0))[:places, :places]
        square[m] = cv2.sqrBoxFilter(area, -1, (side, side), anchor=(0, 0))[:places, :places]
    contrast = np.sqrt(np.maximum(square - mean**2, least_contrast**2))
    return mean + areas.mean(axis=(1, 2), keepdims=True), contrast


def _vertex(lines: Float32, place: Indices) -> Array:
    """Where between -.5 and .5 of `place (M,)` a parabola through three values of each line `(M, n)` has its top."""
    size = lines.shape[1]
    which = np.arange(len(lines))
    before, at, after = (lines[which, np.clip(place + k, 0, size - 1)].astype(np.float64) for k in (-1, 0, 1))
    bend = 2.0 * at - before - after
    inner = (place > 0) & (place < size - 1) & (bend > 1e-9)
    return np.where(inner, np.clip(0.5 * (after - before) / np.where(inner, bend, 1.0), -0.5, 0.5), 0.0)
