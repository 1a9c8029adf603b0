"""The lock beside a project: who holds it is told to the others, and nobody is kept out for good."""

from __future__ import annotations

import json
import os
import platform
import subprocess
import sys
from dataclasses import asdict, replace
from pathlib import Path

import pytest

from roam_core.roto import project_lock
from roam_core.roto.project_lock import MAX_BYTES, TYPE, Holder, holder, lock_path, release, take


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return tmp_path / "shot.roam"


def write(project: Path, other: Holder) -> None:
    lock_path(project).write_text(json.dumps({"type": TYPE, **asdict(other)}), encoding="utf-8")


def test_where_nobody_says_who_this_is_it_is_somebody(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """On Windows a service has no user in its environment, and there is no `pwd`."""
    for name in ("LOGNAME", "USER", "LNAME", "USERNAME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setitem(sys.modules, "pwd", None)
    mine = take(project)
    assert mine is not None
    assert mine.user == "somebody"
    release(project, mine)


ELSEWHERE = Holder("another machine", "ann", 4711, 1.0e9, "mark")
HERE = replace(ELSEWHERE, host=platform.node())


def test_what_this_process_holds_is_held_by_nobody_else_and_goes_with_it(project: Path) -> None:
    mine = take(project)
    assert mine is not None
    assert (mine.process, mine.host) == (os.getpid(), platform.node())
    assert lock_path(project).exists()
    assert holder(project) is None
    release(project, mine)
    assert not lock_path(project).exists()


def test_another_machines_lock_holds_until_it_is_taken_anyway(project: Path) -> None:
    write(project, ELSEWHERE)
    assert holder(project) == ELSEWHERE
    assert take(project) is None
    mine = take(project, anyway=True)
    assert mine is not None
    assert holder(project) is None
    write(project, ELSEWHERE)
    release(project, mine)
    assert holder(project) == ELSEWHERE, "a lock that is another's by now stays"


def test_a_process_of_this_machine_holds_as_long_as_it_runs(project: Path) -> None:
    other = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    try:
        write(project, replace(HERE, process=other.pid))
        assert holder(project) == replace(HERE, process=other.pid)
        assert take(project) is None
    finally:
        other.communicate(b"\n")
    assert holder(project) is None
    assert take(project) is not None


def test_an_older_process_of_our_number_has_ended(project: Path) -> None:
    write(project, replace(HERE, process=os.getpid()))
    assert holder(project) is None


@pytest.mark.parametrize(
    "content", ["", "[]", "{}", '{"host": 1, "user": "x", "process": "many", "since": 0, "mark": ""}', " " * MAX_BYTES],
    ids=["empty", "no object", "no fields", "no number", "too long"],
)  # fmt: skip
def test_what_is_no_lock_keeps_nobody_out(project: Path, content: str) -> None:
    lock_path(project).write_text(content + " ", encoding="utf-8")
    assert holder(project) is None
    assert take(project) is not None


def test_the_lock_lies_beside_the_file_that_a_link_leads_to(tmp_path: Path, project: Path) -> None:
    project.touch()
    (tmp_path / "links").mkdir()
    link = tmp_path / "links" / "other.roam"
    link.symlink_to(project)
    assert lock_path(link) == lock_path(project) == tmp_path / ".shot.roam.lock"


def test_where_no_lock_can_be_written_there_is_none(tmp_path: Path) -> None:
    assert take(tmp_path / "nowhere" / "shot.roam") is None


def test_a_holder_is_told_in_words(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(project_lock.time, "localtime", lambda since: project_lock.time.gmtime(since))
    assert ELSEWHERE.sentence == "open on another machine by ann since 09 Sep, 01:46 (process 4711)"


@pytest.mark.parametrize("since", [1e300, float("inf"), float("nan"), -1.0, 1e12])
def test_a_lock_of_no_time_is_none(project: Path, since: float) -> None:
    """Telling since when somebody has it open ended in an error."""
    write(project, replace(ELSEWHERE, since=since))
    assert holder(project) is None


def test_a_name_that_leaves_no_room_for_more_has_a_lock_of_its_own(tmp_path: Path) -> None:
    long, other = (tmp_path / f"{'n' * 245}{end}.roam" for end in ("a-one", "a-two"))
    mine = take(long)
    assert mine is not None
    write(long, ELSEWHERE)
    assert holder(long) == ELSEWHERE
    assert holder(other) is None


def test_a_link_that_leads_to_itself_is_held_by_nobody(project: Path) -> None:
    project.symlink_to(project.name)
    assert holder(project) is None


def test_a_lock_that_cannot_be_taken_away_is_no_error(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the folder became read-only during a run, the run ended in a traceback."""
    mine = take(project)
    assert mine is not None

    def refused(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "unlink", refused)
    release(project, mine)
