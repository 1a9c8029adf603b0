"""Warming up: the engine compiles on the solver's thread, and a failure there is no drama."""

from __future__ import annotations

import threading
from importlib import import_module

import pytest
from pytestqt.qtbot import QtBot

from app.jobs import warm_up
from app.jobs.runner import Ending, Runner


def test_kernels_are_compiled_on_the_solvers_thread(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    compiled: list[tuple[str, bool]] = []

    def compile_for(config: str) -> None:
        compiled.append((config, threading.current_thread() is threading.main_thread()))

    # By name: the package lends the module's name to its function.
    monkeypatch.setattr(import_module("roam_core.propagate.warm_up"), "warm_up", compile_for)
    runner = Runner("solver")
    with qtbot.waitSignal(warm_up.start(runner, "baseline").ended, timeout=5000) as ended:
        pass
    assert ended.args == [Ending.DONE, ""]
    assert compiled == [("baseline", False)]
    assert runner.close()
