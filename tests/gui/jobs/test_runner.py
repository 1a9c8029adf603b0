"""The runner: one thread, one ending a job, no news of what was superseded, no thread left behind."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from shiboken6 import delete

from app.jobs.runner import Ending, Job, Report, Runner
from roam_core.errors import RoamError
from tests.gui.waiting import WAIT


@pytest.fixture
def runner(qtbot: QtBot) -> Iterator[Runner]:
    runner = Runner("test")
    yield runner
    assert runner.close()


def record(job: Job) -> list[tuple[object, ...]]:
    news: list[tuple[object, ...]] = []
    job.started.connect(lambda: news.append(("started",)))
    job.progress.connect(lambda fraction, text: news.append(("progress", fraction, text)))
    job.partial.connect(lambda result: news.append(("partial", result)))
    job.ended.connect(lambda ending, sentence: news.append(("ended", ending, sentence)))
    return news


def test_news_arrive_in_order_and_in_the_window_thread(qtbot: QtBot, runner: Runner) -> None:
    def work(report: Report) -> str:
        assert threading.current_thread() is not threading.main_thread()
        report.progress(0.5, "half")
        report.partial("a part")
        return "It is done."

    job = runner.start("test", work)
    news = record(job)
    threads: list[threading.Thread] = []
    job.partial.connect(lambda _: threads.append(threading.current_thread()))
    with qtbot.waitSignal(job.ended, timeout=WAIT):
        pass
    done = ("ended", Ending.DONE, "It is done.")
    assert news == [("started",), ("progress", 0.5, "half"), ("partial", "a part"), done]
    assert threads == [threading.main_thread()]
    assert runner.running("test") is None


def test_progress_is_throttled_but_the_end_is_told(qtbot: QtBot, runner: Runner) -> None:
    def work(report: Report) -> str:
        for step in range(1000):
            report.progress(step / 1000, "")
        report.progress(1.0, "all")
        return ""

    job = runner.start("test", work)
    news = record(job)
    with qtbot.waitSignal(job.ended, timeout=WAIT):
        pass
    told = [entry for entry in news if entry[0] == "progress"]
    assert len(told) < 500
    assert told[-1] == ("progress", 1.0, "all")


@pytest.mark.parametrize(
    ("error", "sentence"),
    [(RoamError("The plate is gone."), "The plate is gone."), (ZeroDivisionError("by zero"), "by zero")],
)
def test_a_failure_is_one_sentence(qtbot: QtBot, runner: Runner, error: Exception, sentence: str) -> None:
    def work(report: Report) -> str:
        raise error

    job = runner.start("test", work)
    news = record(job)
    with qtbot.waitSignal(job.ended, timeout=WAIT):
        pass
    assert news[-1][1] is Ending.FAILED
    assert sentence in str(news[-1][2])


def test_cancelling_keeps_what_was_finished(qtbot: QtBot, runner: Runner) -> None:
    part_is_out, go_on = threading.Event(), threading.Event()

    def work(report: Report) -> str:
        report.partial(1)
        part_is_out.set()
        assert go_on.wait(WAIT / 1000)
        report.token.check()
        report.partial(2)
        return ""

    job = runner.start("test", work)
    news = record(job)
    assert part_is_out.wait(WAIT / 1000)
    job.cancel()
    go_on.set()
    with qtbot.waitSignal(job.ended, timeout=WAIT):
        pass
    assert news == [("started",), ("partial", 1), ("ended", Ending.CANCELLED, "")]


def test_a_superseded_job_ends_at_once_and_says_nothing_more(qtbot: QtBot, runner: Runner) -> None:
    running, go_on = threading.Event(), threading.Event()

    def old(report: Report) -> str:
        running.set()
        assert go_on.wait(WAIT / 1000)
        report.partial("too late")
        return "Too late."

    first = runner.start("test", old)
    news = record(first)
    assert running.wait(WAIT / 1000)
    second = runner.start("test", lambda report: "New.")
    assert news == [("ended", Ending.CANCELLED, "")]
    go_on.set()
    with qtbot.waitSignal(second.ended, timeout=WAIT) as ended:
        pass
    assert ended.args == [Ending.DONE, "New."]
    assert news == [("ended", Ending.CANCELLED, "")]


def test_jobs_of_other_kinds_wait_their_turn(qtbot: QtBot, runner: Runner) -> None:
    order: list[str] = []
    jobs = [runner.start(kind, lambda report, kind=kind: order.append(kind) or "") for kind in ("a", "b", "c")]
    with qtbot.waitSignal(jobs[-1].ended, timeout=WAIT):
        pass
    assert order == ["a", "b", "c"]


def test_closing_ends_the_thread_even_amid_work(qtbot: QtBot) -> None:
    runner, running = Runner("closing"), threading.Event()

    def endless(report: Report) -> str:
        running.set()
        while True:
            report.token.check()
            threading.Event().wait(0.01)

    news = record(runner.start("test", endless))
    assert running.wait(WAIT / 1000)
    assert runner.close()
    assert ("ended", Ending.CANCELLED, "") in news


def test_work_that_outlives_a_closed_runner_ends_without_a_word(qapp: QApplication) -> None:
    """As the first compiling of the engine does, where the window is closed meanwhile."""
    runner, go_on, begun = Runner("worker"), threading.Event(), threading.Event()

    def work(_: Report) -> str:
        begun.set()
        assert go_on.wait(WAIT / 1000)
        return "done"

    runner.start("long", work)
    assert begun.wait(WAIT / 1000)
    assert not runner.close(0.0)
    thread = runner._thread
    delete(runner)
    go_on.set()
    thread.join(WAIT / 1000)  # what it raised would fail this test
    assert not thread.is_alive()
