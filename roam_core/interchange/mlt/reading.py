"""Splines of MLT's rotoscoping filter as shapes: the keys that the file has, counted from the clip's first frame."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.interchange.reading import Imported, ShapeReader, brief, sensible
from roam_core.roto import Keyframe, RotoShape
from roam_core.translatable import said_by, sentence


class MltReader(ShapeReader):
    """Turns one spline into one shape."""

    def shapes(self, document: Any) -> Imported:
        """The shape of a spline, animated or not."""
        splines = document if isinstance(document, dict) else {"0": document}
        self.check_points(len(splines), self.path.stem, 0)
        keys: dict[int, Keyframe] = {}
        for word, spline in splines.items():
            try:
                frame = self.frame(float(word)) + self.clip.first
                points = self._points(spline)
            except ValueError as error:
                raise RoamError(
                    sentence(
                        "{path} cannot be read: at {word}, {reason}.",
                        path=self.called,
                        word=brief(str(word)),
                        reason=said_by(error),
                    )
                ) from None
            if keys and len(points) != len(next(iter(keys.values())).points):
                self.note(
                    sentence(
                        "Splines of other numbers of points than the first were left out: no point moves between them."
                    )
                )
                continue
            keys[frame] = Keyframe(frame, points)
        shape = RotoShape(self.fresh_id("shape"), self.path.stem, tuple(keys.values()))
        if not sensible(shape.keys):
            raise RoamError(sentence("{path} cannot be read: a point lies nowhere near the image.", path=self.called))
        return self.finished((shape,))

    def _points(self, spline: Any) -> Array:
        if not isinstance(spline, list) or not spline:
            raise ValueError(sentence("a spline must be a list of points"))
        self.check_points(len(spline), self.path.stem)
        flat = [
            number
            for point in spline
            if isinstance(point, list) and len(point) == 3
            for place in point
            if isinstance(place, list) and len(place) == 2
            for number in place
            if isinstance(number, int | float) and not isinstance(number, bool) and math.isfinite(number)
        ]
        if len(flat) != 6 * len(spline):
            raise ValueError(sentence("each point must be a handle, a point and a handle of two numbers"))
        rows: Array = np.array(flat, dtype=np.float64).reshape(-1, 3, 2)[:, [1, 0, 2]]
        return rows * np.array(self.clip.size, dtype=np.float64)
