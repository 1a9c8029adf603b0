"""Steadying outlines as a job: tracked keys are moved on the worker so that they boil less."""

from __future__ import annotations

from collections.abc import Sequence

from roam_core.roto import RotoShape

from ...translation import N_, tr, translated
from ..runner import Report
from .job import PlateJob, ReadFrame


class Steadying(PlateJob):
    """Takes boil off finished keys."""

    KIND = "steady"
    STEP = N_("Steady the outline")
    STOPPED = N_("Stopped; no key was moved.")

    def start(self, shape_ids: Sequence[str], frames: range, strength: float) -> None:
        """Steady the tracked keys of closed shapes in `frames` by `strength`, in [0, 1]."""
        project = self._document.project
        asked = [project.shape(shape_id) for shape_id in shape_ids]
        self._begin(
            asked,
            lambda report, read: _steady(report, read, asked, frames, strength),
            tr("Steadying the outlines …"),
        )


def _steady(report: Report, read: ReadFrame, asked: Sequence[RotoShape], frames: range, strength: float) -> str:
    """The work, on the worker thread."""
    # OpenCV and SciPy load while the window is up already: that must not delay it.
    from roam_core.params.steadiness import RESIDUAL, STEADINESS
    from roam_core.propagate.steadiness.steadying import steadying, told

    found = steadying(read, asked, frames, strength, STEADINESS, RESIDUAL, report.token, report.progress)
    report.partial(found.shapes)
    return translated(told(found))
