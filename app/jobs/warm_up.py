"""Compiling the engine's kernels when the window opens, so that the first track need not wait for the compiler."""

from __future__ import annotations

from app.jobs.runner import Job, Report, Runner


def start(runner: Runner, config: str) -> Job:
    """Compile on the solver's thread what the configuration needs; a track that is asked for meanwhile waits for it."""

    def work(report: Report) -> str:
        from roam_core.propagate.warm_up import warm_up

        warm_up(config)
        return ""

    return runner.start("warm-up", work)
