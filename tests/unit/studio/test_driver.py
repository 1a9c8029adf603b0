"""A batch under way, on a scheduler that is another process: order, retries, workers that die, cancelling."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.studio import cluster, driver
from roam_core.studio.tasks import Task
from tests.conftest import ROOT
from tests.unit.studio.conftest import WORKERS
from tests.unit.studio.work import WORK


@pytest.fixture(scope="module")
def client(scheduler: str) -> Iterator[Any]:
    with cluster.named(scheduler) as found:
        found.wait_for_workers(WORKERS)
        yield found


def carried_out(program: str, *folders: Path) -> subprocess.CompletedProcess[str]:
    """A program that ended well in a process of its own, which finds modules in `folders`."""
    found = os.environ | {"PYTHONPATH": os.pathsep.join(map(str, folders))}
    command = [sys.executable, "-c", program]
    return subprocess.run(command, cwd=ROOT, env=found, capture_output=True, text=True, check=True)


def tasks(folder: Path, job: str, *whats: str) -> list[Task]:
    """A job whose steps end as is said."""
    place = folder / job
    place.mkdir(exist_ok=True)
    return [
        Task(
            job, f"{k + 1}-x", ("fill", what, "--save", "x"), str(place), can_split=what == "split", record=f"{job}{k}"
        )
        for k, what in enumerate(whats)
    ]


def ended(client: Any, jobs: list[list[Task]], **options: Any) -> list[tuple[str, str, str]]:
    return [(each["job"], each["step"], each["status"]) for each in driver.run(client, WORK, jobs, **options)]


def attempts(folder: Path, job: str, step: str = "1-x") -> int:
    return len((folder / job / f"{step}.attempts").read_text().splitlines())


def test_steps_of_a_job_follow_one_another_and_jobs_run_beside_each_other(client: Any, tmp_path: Path) -> None:
    found = ended(client, [tasks(tmp_path, job, "ok", "ok", "ok") for job in "abc"])
    assert sorted(found) == [(job, f"{k}-x", "done") for job in "abc" for k in (1, 2, 3)]
    for job in "abc":
        assert [step for name, step, _ in found if name == job] == ["1-x", "2-x", "3-x"]


def test_what_fails_is_tried_again_and_then_its_job_ends(client: Any, tmp_path: Path) -> None:
    jobs = [tasks(tmp_path, "a", "fail", "ok"), tasks(tmp_path, "b", "fail once", "ok"), tasks(tmp_path, "c", "raise")]
    found = ended(client, jobs, retries=2)
    assert sorted(found) == [
        ("a", "1-x", "failed"),
        ("a", "2-x", "skipped"),
        ("b", "1-x", "done"),
        ("b", "2-x", "done"),
        ("c", "1-x", "failed"),
    ]
    assert [attempts(tmp_path, job) for job in "abc"] == [3, 2, 3]


def test_a_worker_that_dies_costs_one_step(client: Any, tmp_path: Path) -> None:
    jobs = [tasks(tmp_path, "dying", "die once", "ok"), *(tasks(tmp_path, f"j{k}", "ok") for k in range(12))]
    found = ended(client, jobs)
    assert {status for _, _, status in found} == {"done"}
    assert attempts(tmp_path, "dying") == 2
    assert [attempts(tmp_path, f"j{k}") for k in range(12)] == [1] * 12
    client.wait_for_workers(WORKERS)  # a nanny starts another one


def test_a_step_that_always_loses_its_worker_is_told_of(client: Any, tmp_path: Path) -> None:
    outcomes = list(driver.run(client, WORK, [tasks(tmp_path, "a", "die", "ok")], retries=0))
    assert [outcome["status"] for outcome in outcomes] == ["failed", "skipped"]
    assert "worker died" in outcomes[0]["said"]
    client.wait_for_workers(WORKERS)


def test_a_fill_is_divided_and_put_together(client: Any, tmp_path: Path) -> None:
    found = ended(client, [tasks(tmp_path, "a", "split", "ok")])
    assert [step for _, step, _ in found][-2:] == ["1-x", "2-x"]
    assert sorted(step for _, step, _ in found)[1:3] == ["1-x 1/2, frames 1-3", "1-x 2/2, frames 3-5"]
    assert {status for _, _, status in found} == {"done"}


def test_cancelling_keeps_what_is_finished_and_stops_what_runs(client: Any, tmp_path: Path, waiting: Path) -> None:
    wait = Task("w", "1-x", ("fill", "wait"), str(waiting), record="w")
    later = [tasks(tmp_path, f"j{k}", "ok") for k in range(3)]
    steps = driver.run(client, WORK, [tasks(tmp_path, "first", "ok"), [wait], *later])
    done = [next(steps)["job"]]
    while not (waiting / "waits").exists():
        time.sleep(0.01)
    steps.close()  # type: ignore[attr-defined]
    assert done == ["first"]
    assert (waiting / "stop").exists()
    assert not client.processing() or not any(client.processing().values())


def test_a_token_cancels_what_runs(client: Any, tmp_path: Path, waiting: Path) -> None:
    for name in ("waits", "stop"):
        (waiting / name).unlink(missing_ok=True)
    token = CancelToken()
    wait = Task("w", "1-x", ("fill", "wait"), str(waiting), record="token")
    steps = driver.run(client, WORK, [tasks(tmp_path, "first", "ok"), [wait]], token=token)
    assert next(steps)["job"] == "first"
    while not (waiting / "waits").exists():
        time.sleep(0.01)
    token.cancel()
    with pytest.raises(Cancelled):
        next(steps)
    assert (waiting / "stop").exists()


@pytest.mark.usefixtures("heard")
def test_workers_of_this_machine_have_loaded_what_they_need_and_hear_nobody_else() -> None:
    program = """
import signal
import psutil
from roam_core.cli.performing import WORK
from roam_core.studio import cluster
from tests.unit.studio.work import loaded

if __name__ == "__main__":
    with cluster.local(cluster.Shares.of(2, 4 << 30), dashboard=False, loading=WORK.modules) as client:
        print(client.run(loaded, ["roam_core.cli.performing", "roam_core.propagate.run", "bokeh"]).values())
        here = psutil.Process()
        listening = [
            connection.laddr.ip
            for each in (here, *here.children(recursive=True))
            for connection in each.net_connections()
            if connection.status == psutil.CONN_LISTEN
        ]
        print(len(listening) > 2, set(listening))
        print(set(client.run(lambda: signal.getsignal(signal.SIGINT) is signal.SIG_IGN).values()))
"""
    loaded, bound, is_ignored = carried_out(program, ROOT).stdout.splitlines()
    if sys.platform == "linux":  # where workers are forks
        assert loaded == "dict_values([[True, True, False], [True, True, False]])"
    assert bound == "True {'127.0.0.1'}"
    assert is_ignored == "{True}"  # a terminal sends Ctrl-C to all: the batch stops them


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere workers are no forks")
def test_ctrl_c_while_the_workers_process_loads_is_no_traceback(tmp_path: Path) -> None:
    (tmp_path / "interrupted.py").write_text(
        "import os, pathlib, signal\n"
        "os.kill(os.getpid(), signal.SIGINT)\n"
        "pathlib.Path(__file__).with_name('loaded').touch()\n"
    )
    program = """
from roam_core.studio import cluster

if __name__ == "__main__":
    with cluster.local(cluster.Shares.of(1, 4 << 30), dashboard=False, loading=["interrupted"]):
        pass
"""
    assert carried_out(program, ROOT, tmp_path).stderr == ""
    assert (tmp_path / "loaded").exists()  # Ctrl-C is for the batch


def test_the_batch_is_told_of_steps_and_of_frames(client: Any, tmp_path: Path) -> None:
    heard: list[Any] = []
    arrived = threading.Event()

    class Listener(driver.Watcher):
        def begun(self, steps: int) -> None:
            heard.append(steps)

        def ended(self, outcome: driver.Outcome) -> None:
            heard.append(outcome["step"])

        def moved(self, message: Any) -> None:
            heard.append(message)
            arrived.set()

    steps = driver.run(client, WORK, [tasks(tmp_path, "a", "ok", "ok")], watcher=Listener())
    next(steps)
    client.log_event(cluster.TOPIC, {"job": "a", "frame": 7})
    assert arrived.wait(120)
    assert list(steps)
    assert {"job": "a", "frame": 7} in heard
    assert [each for each in heard if not isinstance(each, dict)] == [2, "1-x", "2-x"]


def test_an_address_where_nobody_answers_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "CONNECT_SECONDS", 1)
    with pytest.raises(RoamError, match=r"No scheduler answers at tcp://127\.0\.0\.1:9"), cluster.named("127.0.0.1:9"):
        pass


def test_shares_are_of_the_whole_machine() -> None:
    shares = cluster.Shares.of(16, 64 << 30)
    assert (shares.workers, shares.threads, shares.memory, shares.cache) == (16, 1, 4 << 30, 512)
    assert cluster.Shares.of(16, 64 << 30, 4).threads == cluster.ENGINE_THREADS
    assert cluster.Shares.of(2, 1 << 30).cache == 102
    assert shares.environment["ROAM_THREADS"] == "1"


def test_files_of_encryption_have_to_be_there(tmp_path: Path) -> None:
    missing = tmp_path / "ca.pem"
    encryption = cluster.Encryption(missing, missing, missing)
    with pytest.raises(RoamError, match=r"ca\.pem does not exist"), cluster.named("127.0.0.1:9", encryption):
        pass
