"""Warming up: the engine compiles on the solver's thread, and a failure there is no drama."""

from __future__ import annotations

import threading
from importlib import import_module

import cv2
import pytest
from pytestqt.qtbot import QtBot

from app.jobs import warm_up
from app.jobs.runner import Ending, Job, Runner
from tests.gui.waiting import WAIT


def test_kernels_are_compiled_on_the_solvers_thread(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    compiled: list[tuple[str, bool]] = []

    def compile_for(config: str) -> None:
        compiled.append((config, threading.current_thread() is threading.main_thread()))

    # By name: the package lends the module's name to its function.
    for name in ("warm_up", "warm_up_parts"):
        monkeypatch.setattr(import_module("roam_core.propagate.warming"), name, compile_for)
    runner = Runner("solver")
    with qtbot.waitSignal(warm_up.start(runner, "baseline").ended, timeout=WAIT) as ended:
        pass
    assert ended.args == [Ending.DONE, ""]
    assert compiled == [("baseline", False)] * 2
    assert runner.close()


def test_what_dialogs_stand_on_is_loaded_beside_the_window(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    loaded: list[tuple[str, bool]] = []

    def load(name: str) -> None:
        loaded.append((name, threading.current_thread() is threading.main_thread()))

    monkeypatch.setattr(warm_up, "import_module", load)
    runner = Runner("writer")
    with qtbot.waitSignal(warm_up.load_dialogs(runner).ended, timeout=WAIT) as ended:
        pass
    assert ended.args == [Ending.DONE, ""]
    assert ("roam_core.interchange", False) in loaded
    assert not any(in_window for _, in_window in loaded)
    assert runner.close()


def test_threads_are_set_in_the_libraries_themselves(qtbot: QtBot) -> None:
    runner, before = Runner("solver"), cv2.getNumThreads()
    try:
        with qtbot.waitSignal(warm_up.use_threads(runner, 1).ended, timeout=WAIT) as ended:
            pass
        assert ended.args == [Ending.DONE, ""]
        assert cv2.getNumThreads() == 1
    finally:
        cv2.setNumThreads(before)
        assert runner.close()


def test_what_a_track_waits_for_is_told_until_it_begins(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    is_ready, told = threading.Event(), list[str]()
    monkeypatch.setattr(import_module("roam_core.propagate.warming"), "warm_up", lambda config: is_ready.wait(WAIT))
    runner = Runner("solver")

    def begin() -> Job:
        job = runner.start("track", lambda report: "")
        warm_up.tell_beginning(runner, job, lambda _, sentence: told.append(sentence), "Starting …")
        return job

    warm_up.start(runner, "baseline")
    job = begin()
    waits = "Starting … The engine is prepared first, which may take a minute, once on this machine."
    assert told == [waits]
    with qtbot.waitSignal(job.ended, timeout=WAIT):
        is_ready.set()
    assert told == [waits, "Starting …"]
    with qtbot.waitSignal(begin().ended, timeout=WAIT):
        pass
    assert told == [waits, "Starting …", "Starting …"]
    assert runner.close()
