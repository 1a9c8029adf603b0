"""PlateJobs: the jobs of this room, as the window makes them."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QObject

from ...model.document import Document
from ..runner import Runner
from .job import PlateJob, ReadFrame
from .softening import Softening
from .steadying import Steadying


@dataclass(frozen=True)
class PlateJobs:
    """One of each."""

    softening: Softening
    steadying: Steadying

    @classmethod
    def of(cls, document: Document, runner: Runner, read: ReadFrame, parent: QObject) -> PlateJobs:
        """Jobs on one `runner`, which do not disturb each other; see `PlateJob`."""
        given = document, runner, read, parent
        return cls(Softening(*given), Steadying(*given))

    @property
    def all(self) -> tuple[PlateJob, ...]:
        """All of them."""
        return self.softening, self.steadying
