"""Compiling kernels and loading formats when the window opens, so that the first track and export need not wait."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module

from ..translation import tr
from .runner import Job, Report, Runner


def use_threads(runner: Runner, count: int) -> Job:
    """Let the engine and the libraries for pictures use so many threads; 0 leaves it to them."""

    def work(report: Report) -> str:
        cv2, oiio = import_module("cv2"), import_module("OpenImageIO")
        cv2.setNumThreads(count or -1)
        oiio.attribute("threads", count)
        return ""

    return runner.start("threads", work)


def load_dialogs(runner: Runner) -> Job:
    """Load what the export and clip dialogs stand on, which takes half a second: they are to open at once.

    Not on the solver's thread, where compiling takes a minute at the first start.
    """

    def work(report: Report) -> str:
        for name in ("roam_core.interchange", "cv2", "OpenImageIO"):
            report.token.check()
            import_module(name)
        return ""

    return runner.start("load dialogs", work)


def start(runner: Runner, config: str) -> Job:
    """Compile on the solver's thread what the configuration needs; a track that is asked for meanwhile waits for it."""

    def work(report: Report) -> str:
        from roam_core.propagate.warming import warm_up, warm_up_parts

        warm_up(config)
        report.token.check()
        warm_up_parts(config)
        return ""

    return runner.start("warm-up", work)


def tell_beginning(runner: Runner, job: Job, tell: Callable[[float, str], object], sentence: str) -> None:
    """Tell that a track or a fill begins, and what it waits for while the engine is still being prepared."""
    if runner.running("warm-up") is None:
        tell(0.0, sentence)
        return
    waits = tr("The engine is prepared first, which may take a minute, once on this machine.")
    tell(0.0, f"{sentence} {waits}")
    job.started.connect(lambda: tell(0.0, sentence))
