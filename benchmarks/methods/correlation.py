"""A box followed by a linear correlation filter that is learned online (Bolme et al., 2010; Henriques et al., 2015)."""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Array, Float32

Box = tuple[float, float, float, float]

CONTEXT = 2.5
"""How much wider than the box the patch is that the filter sees."""
SIDE = 96
"""Most cells of the patch along a side: a large object is looked at on a coarser grid."""
SHARPNESS = 0.0625
"""Width of the wanted response, as a share of the box's side."""
RATE, RIDGE = 0.075, 0.1
"""Share of each new frame in the filter, and the weight against large filters, of the mean power."""


class BoxTracker:
    """Follows a box `(x0, y0, x1, y1)` by its grey levels; its size stays as it is."""

    def __init__(self, grey: Float32, box: Box) -> None:
        self.box = box
        wide, high = CONTEXT * (box[2] - box[0]), CONTEXT * (box[3] - box[1])
        self._cell = max(wide, high, float(SIDE)) / SIDE
        self._shape = max(int(high / self._cell), 8), max(int(wide / self._cell), 8)
        self._window = np.outer(np.hanning(self._shape[0]), np.hanning(self._shape[1]))
        rows, columns = (np.arange(n) - n // 2 for n in self._shape)
        tall, broad = (max(SHARPNESS * n / CONTEXT, 1.0) for n in self._shape)
        wanted = np.exp(-0.5 * ((rows[:, None] / tall) ** 2 + (columns / broad) ** 2))
        self._wanted = np.fft.rfft2(np.fft.ifftshift(wanted))
        self._learn(grey, 1.0)

    def step(self, grey: Float32) -> tuple[float, float]:
        """Move the box to where the filter answers best on the next picture; gives the shift in pixels."""
        response = np.fft.irfft2(np.fft.rfft2(self._patch(grey)) * self._above / self._below, s=self._shape)
        row, column = np.unravel_index(int(np.argmax(response)), self._shape)
        down, right = (
            float(k - n if k > n // 2 else k) * self._cell
            for k, n in zip((int(row), int(column)), self._shape, strict=True)
        )
        x0, y0, x1, y1 = self.box
        self.box = x0 + right, y0 + down, x1 + right, y1 + down
        self._learn(grey, RATE)
        return right, down

    def _learn(self, grey: Float32, rate: float) -> None:
        seen = np.fft.rfft2(self._patch(grey))
        power = np.abs(seen) ** 2
        above, below = self._wanted * np.conj(seen), power + RIDGE * power.mean()
        if rate == 1.0:
            self._above, self._below = above, below
        else:
            self._above = (1.0 - rate) * self._above + rate * above
            self._below = (1.0 - rate) * self._below + rate * below

    def _patch(self, grey: Float32) -> Array:
        """The normalised, windowed patch around the box; beyond the picture the border goes on."""
        x0, y0, x1, y1 = self.box
        rows, columns = self._shape
        left = (x0 + x1 - columns * self._cell) / 2.0
        top = (y0 + y1 - rows * self._cell) / 2.0
        # The middle of the first cell, in OpenCV's coordinates, where pixel centres lie at integers.
        start = left + 0.5 * self._cell - 0.5, top + 0.5 * self._cell - 0.5
        motion = np.array([[self._cell, 0.0, start[0]], [0.0, self._cell, start[1]]])
        flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
        patch = cv2.warpAffine(grey, motion, (columns, rows), flags=flags, borderMode=cv2.BORDER_REPLICATE)
        patch = patch.astype(np.float64)
        return np.asarray((patch - patch.mean()) / (patch.std() + 1e-3) * self._window)
