"""Area: a part of a picture, by the rows and columns that it takes."""

from __future__ import annotations

from typing import NamedTuple

from roam_core.arrays import Image


class Area(NamedTuple):
    """The rows from `top` to before `end` and the columns from `left` to before `right`, in pixels."""

    top: int
    end: int
    left: int
    right: int

    @property
    def rows(self) -> int:
        """How many rows it has."""
        return max(self.end - self.top, 0)

    @property
    def columns(self) -> int:
        """How many columns it has."""
        return max(self.right - self.left, 0)

    @property
    def is_empty(self) -> bool:
        return self.rows == 0 or self.columns == 0

    def spans(self, other: Area) -> bool:
        """Whether another area has no column that this one has not."""
        return self.left <= other.left and other.right <= self.right

    def joined(self, other: Area) -> Area:
        """The least area around this one and another."""
        return Area(
            min(self.top, other.top),
            max(self.end, other.end),
            min(self.left, other.left),
            max(self.right, other.right),
        )

    def of(self, image: Image, top: int = 0, left: int = 0) -> Image:
        """This area `(rows, columns, ...)` of an image whose first pixel is in row `top` and column `left`: a view."""
        return image[self.top - top : self.end - top, self.left - left : self.right - left]

    def cut_from(self, image: Image, top: int = 0, left: int = 0) -> Image:
        """As `of`, the image itself where that is all of it, else a copy: the rest of it is not kept in memory."""
        part = self.of(image, top, left)
        return image if part.shape == image.shape else part.copy()
