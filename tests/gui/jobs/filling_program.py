"""Fills a project as the window does, in a process of its own: `python -m tests.gui.jobs.filling_program P OUT N`.

`N` processes may be used. What is told of the progress goes to the standard output, the project to `OUT`.
"""

from __future__ import annotations

import sys
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from app.jobs import filling
from app.jobs.propagation import Propagation
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core import load_project, open_clip, save_project, to_engine
from roam_core.propagate.shapes.gaps import gaps_of


def main(given: str, out: str, processes: str) -> int:
    """Fill all gaps of all shapes with `baseline`, and save what came of it. Returns 0 when it is done."""
    application = QCoreApplication([])
    filling.WORTH_PROCESSES = 1
    document, runner = Document(), Runner("solver")
    document.open(load_project(given), None)
    project = document.project
    plate = open_clip(project.require_clip().path)
    propagation = Propagation(
        document, ViewState(), runner, lambda frame: to_engine(plate.read(frame), plate.colour_space)
    )
    propagation.processes = int(processes)
    endings: list[Ending] = []

    def end(ending: Ending, sentence: str) -> None:
        print(sentence)
        endings.append(ending)
        application.quit()

    propagation.progress.connect(lambda _, text: print(text))
    propagation.finished.connect(end)
    propagation.fill([shape.id for shape in project.shapes], gaps_of(project.shapes), "baseline")
    application.exec()
    save_project(document.project, Path(out))
    print(f"{document.undo_stack.count()} step to undo")
    return 0 if runner.close() and endings == [Ending.DONE] else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
