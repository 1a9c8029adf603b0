"""Matching the plate's edge as a job: it is measured on the worker, and shapes are made as soft."""

from __future__ import annotations

from collections.abc import Sequence

from roam_core.roto import Project, RotoShape

from ...translation import N_, tr, translated
from ..runner import Report
from .job import PlateJob, ReadFrame


class Softening(PlateJob):
    """Makes shapes as soft as the plate."""

    KIND = "soften"
    STEP = N_("Match the plate's edge")
    STOPPED = N_("Stopped; no edge was changed.")

    def start(self, shape_ids: Sequence[str]) -> None:
        """Measure the edge of closed shapes on all their keys, then set motion blur and feather."""
        project = self._document.project
        asked = [project.shape(shape_id) for shape_id in shape_ids]
        self._begin(
            asked, lambda report, read: _soften(report, read, project, asked), tr("Looking at the plate's edge …")
        )


def _soften(report: Report, read: ReadFrame, project: Project, asked: Sequence[RotoShape]) -> str:
    """The work, on the worker thread."""
    # OpenCV loads while the window is up already: that must not delay it.
    from roam_core.matte.softening import softened, told
    from roam_core.params import SOFTNESS

    found, soft = softened(read, asked, project.plate_root, SOFTNESS, report.token, report.progress)
    report.partial(soft)
    return translated(told(found, asked, soft))
