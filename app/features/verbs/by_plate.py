"""The verbs that change shapes by what the plate shows beside them."""

from __future__ import annotations

from PySide6.QtWidgets import QWidget

from ...jobs.by_plate.jobs import PlateJobs
from ...model.document import Document
from ...model.view_state import ViewState
from .plate_edge import PlateEdge
from .steady import Steady


def plate_verbs(
    window: QWidget, document: Document, view_state: ViewState, jobs: PlateJobs
) -> tuple[PlateEdge, Steady]:
    """One of each; what is asked is asked above `window`."""
    return PlateEdge(document, view_state, jobs.softening), Steady(window, document, view_state, jobs.steadying)
