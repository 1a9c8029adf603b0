"""Work that costs nothing, for tests of the run: a task's words say what becomes of it. Workers import this module."""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path
from typing import Any

from roam_core.studio.driver import Work

STOP = "stop"


def perform(batch: str, plain: dict[str, Any], pictures: str) -> dict[str, Any]:
    """Note the attempt in the task's folder, and end as its words say."""
    folder, what = Path(plain["folder"]), plain["words"][1]
    attempts = folder / f"{plain['step'].split()[0].replace('/', '-')}.attempts"
    with attempts.open("a") as file:
        file.write(f"{os.getpid()}\n")
    count = len(attempts.read_text().splitlines())
    told = {"job": plain["job"], "step": plain["step"], "seconds": 0.0, "said": "", "process": os.getpid()}
    if what == "die" or (what == "die once" and count == 1):
        os._exit(1)
    if what == "fail" or (what == "fail once" and count == 1):
        return {**told, "status": "failed", "said": "refused"}
    if what == "raise":
        raise ValueError("a defect")
    if what == "split" and plain["can_split"]:
        return {**told, "status": "split", "pieces": [[[1, 3], ["a"]], [[3, 5], ["b"]]]}
    while what == "wait" and not (folder / STOP).exists():
        (folder / "waits").touch()
        time.sleep(0.01)
    return {**told, "status": "cancelled" if what == "wait" else "done"}


def cancel(batch: str) -> int:
    """Have tasks that wait come to an end."""
    for folder in WAITING:
        (Path(folder) / STOP).touch()
    return 1


def loaded(names: list[str]) -> list[bool]:
    """Which of these modules a worker has loaded."""
    return [name in sys.modules for name in names]


WAITING = tuple(filter(None, os.environ.get("ROAM_TEST_WAITING", "").split(os.pathsep)))
WORK = Work(perform, cancel)
