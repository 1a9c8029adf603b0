"""One cluster for all tests: a scheduler and two workers, processes of their own, reached by their address."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from tests.conftest import ROOT

WORKERS = 2
SECONDS = 120
"""That the scheduler may take to answer, on a machine with other work."""


@pytest.fixture(scope="session")
def waiting(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which tasks wait until they are cancelled."""
    return tmp_path_factory.mktemp("waiting")


def told_by(path: Path) -> str:
    """The address in a scheduler's file; empty while that is not there, or not yet whole: Dask writes it in place."""
    try:
        return str(json.loads(path.read_text())["address"])
    except (OSError, ValueError):
        return ""


@pytest.fixture(scope="session")
def scheduler(tmp_path_factory: pytest.TempPathFactory, waiting: Path) -> Iterator[str]:
    """The address of a scheduler with two workers of one thread each, started as a studio does."""
    pytest.importorskip("distributed", reason="Dask is not installed (pip install 'roam-roto[studio]')")
    folder = tmp_path_factory.mktemp("cluster")
    told = folder / "scheduler.json"
    environment = os.environ | {"PYTHONPATH": str(ROOT), "ROAM_THREADS": "1", "ROAM_TEST_WAITING": str(waiting)}
    environment["DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES"] = "0"
    environment["DASK_DISTRIBUTED__SCHEDULER__WORKER_SATURATION"] = "1.0"

    def start(*words: str) -> subprocess.Popen[bytes]:
        with (folder / f"{words[0]}.log").open("wb") as log:
            command = [sys.executable, "-m", "dask", *words]
            # A session of its own: what it starts can be ended with it.
            return subprocess.Popen(
                command, cwd=folder, env=environment, stdout=log, stderr=log, start_new_session=True
            )

    bound = ("--host", "127.0.0.1")
    running = [start("scheduler", *bound, "--port", "0", "--no-dashboard", "--scheduler-file", str(told))]
    running += [
        start("worker", *bound, "--nthreads", "1", "--nworkers", str(WORKERS), "--scheduler-file", str(told),
              "--no-dashboard", "--local-directory", str(folder))
    ]  # fmt: skip
    try:
        began = time.monotonic()
        while not (address := told_by(told)):
            assert running[0].poll() is None, (folder / "scheduler.log").read_text()
            assert time.monotonic() - began < SECONDS, "the scheduler does not start"
            time.sleep(0.05)
        yield address
    finally:
        for process in reversed(running):
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait(120)
