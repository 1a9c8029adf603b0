"""EditingModes: how edits reach points and keys: auto-key, ripple, soft selection, lasso. Never saved, never undone."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from PySide6.QtCore import QObject, Signal

from roam_core.roto.keying import Keying

LEAST_RADIUS, LARGEST_RADIUS = 2.0, 4000.0
"""Limits of the radii, in heights of an image pixel."""


@dataclass(frozen=True)
class Modes:
    """What is switched on.

    Attributes
    ----------
    auto_key : an edit makes a key on its frame; off, it changes the keys that are there.
    ripple : every key in the in/out range takes the same change.
    point_keys : a key that comes with an edit names the points that it moved; a run may derive the others anew.
    soft : points near the selected ones follow them, the less the farther.
    lasso : a drag on empty background draws a free line in place of a rectangle.
    soft_radius : how far soft selection reaches, heights of an image pixel.
    brush_radius : how far the reshape tool reaches at full pressure, heights of an image pixel.
    """

    auto_key: bool = True
    ripple: bool = False
    point_keys: bool = False
    soft: bool = False
    lasso: bool = False
    soft_radius: float = 60.0
    brush_radius: float = 60.0


class EditingModes(QObject):
    """The modes that are switched on. `changed` carries nothing: listeners pull."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._modes = Modes()

    @property
    def modes(self) -> Modes:
        return self._modes

    def set(self, **values: Any) -> None:
        """Switch modes or set radii, by the names of `Modes`; radii stay within their limits."""
        for name in ("soft_radius", "brush_radius"):
            if name in values:
                values[name] = min(max(values[name], LEAST_RADIUS), LARGEST_RADIUS)
        modes = replace(self._modes, **values)
        if modes != self._modes:
            self._modes = modes
            self.changed.emit()

    @property
    def soft_radius(self) -> float | None:
        """The reach of soft selection in heights of an image pixel, or None while it is off."""
        return self._modes.soft_radius if self._modes.soft else None

    def keying(self, play_range: tuple[int, int]) -> Keying:
        """Where an edit goes; `play_range` is the half-open in/out range in which ripple works."""
        modes = self._modes
        return Keying(modes.auto_key, range(*play_range) if modes.ripple else None, modes.point_keys)
