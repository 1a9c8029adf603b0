"""Writing files: whole or not at all whatever fails, links followed, read-only files refused, leftovers swept."""

from __future__ import annotations

import errno
import os
import time
from collections.abc import Iterator
from pathlib import Path
from unittest.mock import Mock

import pytest

from roam_core import atomic_write as writing
from roam_core.atomic_write import (
    STALE_SECONDS,
    NameTaken,
    is_alive,
    make_folder,
    sweep,
    temporary_beside,
    write_atomically,
)
from roam_core.errors import RoamError
from tests.unit.roto.faults import each_crash, each_fault, refusing

posix = pytest.mark.skipif(os.name != "posix", reason="needs links, FIFOs and processes of POSIX")
OLD, NEW = b"the old project", b"the new project" * 5000


@pytest.fixture(autouse=True)
def _not_swept_yet() -> Iterator[None]:
    writing._swept.clear()
    yield
    writing._swept.clear()


def names(folder: Path) -> list[str]:
    return sorted(entry.name for entry in folder.iterdir())


def test_content_may_come_in_pieces(tmp_path: Path) -> None:
    write_atomically(tmp_path / "a", (bytes([k]) for k in range(5)))
    assert (tmp_path / "a").read_bytes() == bytes(range(5))


@pytest.mark.parametrize("has_links", [True, False])
def test_a_new_file_takes_no_others_place_not_even_that_of_one_that_came_meanwhile(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, has_links: bool
) -> None:
    def refuse(*_: object) -> None:
        raise PermissionError(1, "Operation not permitted")

    if not has_links:
        monkeypatch.setattr(os, "link", refuse)

    def meanwhile() -> Iterator[bytes]:
        (tmp_path / "b").write_bytes(OLD)
        yield NEW

    write_atomically(tmp_path / "a", NEW, replaces=False)
    for name, content in (("a", OLD), ("b", meanwhile())):
        with pytest.raises(NameTaken, match="is there already"):
            write_atomically(tmp_path / name, content, replaces=False)
    assert ((tmp_path / "a").read_bytes(), (tmp_path / "b").read_bytes()) == (NEW, OLD)
    assert names(tmp_path) == ["a", "b"]


def test_whatever_call_fails_a_new_file_is_whole_or_not_there(tmp_path: Path) -> None:
    path, seen = tmp_path / "a.roam", []

    def prepare() -> None:
        writing._swept.clear()
        path.unlink(missing_ok=True)

    def write() -> None:
        write_atomically(path, NEW, replaces=False)

    for name, work in each_fault(write, prepare, OSError(5, "Input/output error")):
        seen.append(name)
        if name in ("scandir", "link"):  # the latter as on a disk without links
            work()
            assert path.read_bytes() == NEW
        else:
            with pytest.raises(RoamError):
                work()
            assert not path.exists() or path.read_bytes() == NEW
        assert names(tmp_path) in ([], ["a.roam"])
    assert "link" in seen


def test_pieces_that_break_off_leave_the_old_file(tmp_path: Path) -> None:
    def pieces() -> Iterator[bytes]:
        yield b"half"
        raise RoamError("no more.")

    (tmp_path / "a").write_bytes(OLD)
    with pytest.raises(RoamError, match="no more"):
        write_atomically(tmp_path / "a", pieces())
    assert (tmp_path / "a").read_bytes() == OLD
    assert names(tmp_path) == ["a"]


def test_whatever_call_fails_the_file_is_whole_and_nothing_else_is_left(tmp_path: Path) -> None:
    path, seen = tmp_path / "a.roam", []

    def prepare() -> None:
        writing._swept.clear()
        path.write_bytes(OLD)

    for name, work in each_fault(lambda: write_atomically(path, NEW), prepare, OSError(5, "Input/output error")):
        seen.append(name)
        if name == "scandir":  # what cannot be swept stands in nobody's way
            work()
            continue
        stands = seen.count("replace") == 1 and name != "replace"
        told = "is written, but the disk may not keep it" if stands else "cannot be written"
        with pytest.raises(RoamError, match=rf"a\.roam {told}: .*\.$"):
            work()
        assert path.read_bytes() in (OLD, NEW)
        assert (path.read_bytes() == NEW) == stands
        assert names(tmp_path) == ["a.roam"]
    assert {"open", "write", "flush", "fsync", "replace", "stat"} <= set(seen)
    assert seen.count("fsync") == 2  # the file, and the folder


def test_what_may_not_take_long_is_not_flushed_to_the_disk_and_is_whole_all_the_same(tmp_path: Path) -> None:
    path, seen = tmp_path / "settings.json", []
    path.write_bytes(OLD)
    for name, work in each_fault(
        lambda: write_atomically(path, NEW, flushes=False), writing._swept.clear, OSError(28, "No space left on device")
    ):
        seen.append(name)
        if name == "scandir":
            work()
            continue
        with pytest.raises(RoamError, match=r"settings\.json cannot be written: .*\.$"):
            work()
        assert path.read_bytes() in (OLD, NEW)
        assert names(tmp_path) == ["settings.json"]
    assert "write" in seen
    assert "fsync" not in seen


@posix
def test_wherever_the_process_dies_the_file_is_whole_and_the_rest_is_swept(tmp_path: Path) -> None:
    path = tmp_path / "a.roam"

    def prepare() -> None:
        writing._swept.clear()
        path.write_bytes(OLD)

    for _ in each_crash(lambda: write_atomically(path, NEW), prepare):
        assert path.read_bytes() in (OLD, NEW)
        for left in tmp_path.glob(".roam-*"):
            os.utime(left, (0, 0))
        sweep(tmp_path)
        assert names(tmp_path) == ["a.roam"]


@posix
def test_a_link_stays_and_what_it_points_to_is_replaced(tmp_path: Path) -> None:
    (tmp_path / "disk").mkdir()
    target, link = tmp_path / "disk" / "real.roam", tmp_path / "a.roam"
    target.write_bytes(OLD)
    link.symlink_to(Path("disk") / "real.roam")
    write_atomically(link, NEW)
    assert link.is_symlink()
    assert target.read_bytes() == NEW
    assert names(tmp_path / "disk") == ["real.roam"]


@posix
def test_a_link_to_nothing_makes_its_target_and_one_to_itself_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a").symlink_to("b")
    write_atomically(tmp_path / "a", NEW)
    assert (tmp_path / "b").read_bytes() == NEW
    (tmp_path / "c").symlink_to("c")
    with pytest.raises(RoamError, match=r"cannot be written: .*\.$"):
        write_atomically(tmp_path / "c", NEW)


def test_a_read_only_file_is_refused_and_stays(tmp_path: Path) -> None:
    path = tmp_path / "a.roam"
    path.write_bytes(OLD)
    path.chmod(0o444)
    with pytest.raises(RoamError, match="read-only; change its permissions, or save elsewhere"):
        write_atomically(path, NEW)
    assert path.read_bytes() == OLD


@posix
def test_what_is_no_regular_file_is_refused(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "null").symlink_to(os.devnull)
    for name in ("pipe", "null"):
        with pytest.raises(RoamError, match="no regular file"):
            write_atomically(tmp_path / name, NEW)
    assert not Path(os.devnull).is_file()


@pytest.mark.parametrize("name", ["a" * 250 + ".roam", "ä" * 125 + ".roam"])
def test_the_longest_names_are_written(tmp_path: Path, name: str) -> None:
    assert len(os.fsencode(name)) == 255
    write_atomically(tmp_path / name, NEW)
    assert names(tmp_path) == [name]


@posix
def test_a_new_file_has_the_permissions_of_the_user_s_mask(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        write_atomically(tmp_path / "a", NEW)
    finally:
        os.umask(before)
    assert (tmp_path / "a").stat().st_mode & 0o777 == 0o640


@posix
@pytest.mark.parametrize("number", [errno.EPERM, errno.ENOTSUP, errno.ENOSYS])
def test_a_disk_that_lets_no_permissions_be_set_is_written_to_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    (tmp_path / "a").write_bytes(OLD)
    (tmp_path / "a").chmod(0o600)
    monkeypatch.setattr(os, "chmod", refusing(number))
    write_atomically(tmp_path / "a", NEW)
    assert (tmp_path / "a").read_bytes() == NEW
    assert names(tmp_path) == ["a"]


@pytest.mark.parametrize("number", [errno.EINVAL, errno.ENOTSUP, errno.ENOSYS])
def test_a_disk_that_flushes_nothing_is_written_to(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    """As some shares: `fsync` says that the file does not support it."""
    (tmp_path / "a").write_bytes(OLD)
    monkeypatch.setattr(os, "fsync", refusing(number))
    write_atomically(tmp_path / "a", NEW)
    assert (tmp_path / "a").read_bytes() == NEW
    assert names(tmp_path) == ["a"]


@posix
def test_a_disk_that_fails_as_permissions_are_set_keeps_the_old_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a").write_bytes(OLD)
    (tmp_path / "a").chmod(0o600)
    monkeypatch.setattr(os, "chmod", refusing(errno.EIO))
    with pytest.raises(RoamError, match="cannot be written"):
        write_atomically(tmp_path / "a", NEW)
    assert (tmp_path / "a").read_bytes() == OLD
    assert names(tmp_path) == ["a"]


@posix
def test_only_old_temporary_files_of_dead_processes_are_swept(tmp_path: Path) -> None:
    dead = os.fork()
    if dead == 0:
        os._exit(0)
    os.waitpid(dead, 0)
    mine = temporary_beside(tmp_path / "a").name
    theirs = mine.replace(f"-{os.getpid()}-", f"-{dead}-")
    others = [".roam-notes.tmp", "a.roam", ".a.roam.tmp", f".roam-{dead}-1234.tmp"]
    old = time.time() - STALE_SECONDS - 60.0
    for name in (mine, theirs, *others):
        (tmp_path / name).write_bytes(b"")
        os.utime(tmp_path / name, (old, old))
    young = f"{theirs[:-5]}0.tmp" if theirs[-5] != "0" else f"{theirs[:-5]}1.tmp"
    (tmp_path / young).write_bytes(b"")
    write_atomically(tmp_path / "new", NEW)
    assert names(tmp_path) == sorted([mine, young, "new", *others])


@posix
def test_a_folder_is_named_as_what_it_is(tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="it is a folder"):
        write_atomically(tmp_path, NEW)


@posix
def test_a_process_is_alive_or_not_and_a_group_of_them_is_none() -> None:
    assert is_alive(os.getpid())
    assert not is_alive(0)
    assert not is_alive(-os.getpgid(0))


class Kernel32:
    """What Windows says of its processes: 8 runs, 12 has ended but somebody holds it, 16 is another user's."""

    def __init__(self) -> None:
        self.error, self.held = 0, set[int]()
        self.OpenProcess = Mock(side_effect=self.open)
        self.WaitForSingleObject = Mock(side_effect=lambda handle, _: {8: 0x102, 12: 0}[handle])
        self.CloseHandle = Mock(side_effect=lambda handle: self.held.remove(handle))

    def open(self, access: int, inherits: bool, process: int) -> int | None:
        assert (access, inherits) == (0x100000, False)
        if process in (8, 12):
            self.held.add(process)
            return process
        self.error = 5 if process == 16 else 87
        return None


@pytest.fixture
def windows(monkeypatch: pytest.MonkeyPatch) -> Iterator[Kernel32]:
    """A machine that runs Windows, as far as processes are asked about."""
    kernel = Kernel32()
    monkeypatch.setattr(writing.sys, "platform", "win32")
    monkeypatch.setattr(writing.ctypes, "WinDLL", lambda *_, **__: kernel, raising=False)
    monkeypatch.setattr(writing.ctypes, "get_last_error", lambda: kernel.error, raising=False)
    monkeypatch.setattr(os, "kill", lambda *_: pytest.fail("a signal would end the process"))
    yield kernel
    assert kernel.held == set()


@pytest.mark.parametrize(("process", "alive"), [(8, True), (12, False), (16, True), (20, False), (1 << 40, False)])
@pytest.mark.usefixtures("windows")
def test_windows_is_asked_whether_a_process_runs(process: int, alive: bool) -> None:
    """Every process was one that runs: no native crash was told, and after one the project stayed open by it."""
    assert is_alive(process) is alive


@pytest.mark.usefixtures("windows")
def test_on_windows_what_an_ended_process_left_goes_and_what_a_running_one_writes_stays(tmp_path: Path) -> None:
    old = time.time() - STALE_SECONDS - 60.0
    for process in (8, 12):
        left = tmp_path / f".roam-{process}-{'0' * 16}.tmp"
        left.write_bytes(b"")
        os.utime(left, (old, old))
    sweep(tmp_path)
    assert names(tmp_path) == [f".roam-8-{'0' * 16}.tmp"]


def test_a_folder_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    make_folder(tmp_path / "a" / "b")
    make_folder(tmp_path / "a" / "b")
    assert (tmp_path / "a" / "b").is_dir()
    (tmp_path / "file").write_bytes(NEW)
    for place in ("file", "file/deeper"):
        with pytest.raises(RoamError, match=r"The folder .*file.* cannot be made: [A-Z].*\.$"):
            make_folder(tmp_path / place)
