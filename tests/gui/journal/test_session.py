"""Sessions: whether the window of one is open still."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QLockFile

from app.journal.session import LOCK, Session, is_held

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs locks and processes of POSIX")


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return tmp_path / "journal"


def killed_session(root: Path) -> Path:
    """The folder of a session whose process was killed: its lock stays, and nobody has it open."""
    program = (
        "import os, sys, pathlib; from app.journal.session import Session; session = Session(pathlib.Path(sys.argv[1]))"
        "; session.new_path(); print(session.folder, flush=True); os.kill(os.getpid(), 9)"
    )
    ended = subprocess.run([sys.executable, "-c", program, str(root)], capture_output=True, text=True, check=False)
    assert ended.returncode == -signal.SIGKILL
    return Path(ended.stdout.strip())


def test_a_crash_is_offered_though_another_process_has_its_number(root: Path) -> None:
    """In a container or a sandbox every window has the same number: the lock of the last one looked like its own."""
    folder = killed_session(root)
    lock = folder / LOCK
    _, *others = lock.read_bytes().split(b"\n")
    lock.write_bytes(b"\n".join((str(os.getpid()).encode(), *others)))
    assert not is_held(folder)
    session = Session(root)
    session.new_path()
    assert session.folder is not None
    assert is_held(session.folder), "one that is open in this very process"
    session.let_go()
    assert not is_held(session.folder)


def test_a_lock_of_another_machine_is_held_whoever_has_it_open(root: Path) -> None:
    """On a home that machines share nobody here knows what runs there."""
    folder = killed_session(root)
    (folder / LOCK).write_bytes(b"1\nroam\nelsewhere\nmachine\nstart\n")
    assert is_held(folder)


def test_a_crash_is_offered_on_a_disk_that_has_no_room(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Qt writes another lock before it takes one away that a killed process left."""
    folder = killed_session(root)
    monkeypatch.setattr(QLockFile, "tryLock", lambda *_: False)
    assert not is_held(folder)


def test_a_lock_that_found_no_room_is_taken_before_the_next_journal(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another window offered what this one was at as a crash; taken there, it was not offered when this one crashed."""
    session = Session(root)
    with monkeypatch.context() as full:
        full.setattr(QLockFile, "tryLock", lambda *_: False)
        session.new_path()
    assert session.folder is not None
    assert not is_held(session.folder)
    session.new_path()
    assert is_held(session.folder)
    session.let_go()
