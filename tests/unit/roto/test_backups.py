"""Backups: the newest is number 1, the oldest goes, and whatever fails the project is there."""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest

from roam_core.atomic_write import write_atomically
from roam_core.errors import RoamError
from roam_core.roto.backups import backup_path, is_named_as_backup, rotate
from tests.unit.roto.faults import each_crash, each_fault, refusing

posix = pytest.mark.skipif(os.name != "posix", reason="needs links and processes of POSIX")


def saved(path: Path, content: bytes, count: int) -> None:
    """Save as a program does that keeps backups."""
    rotate(path, count)
    write_atomically(path, content)


def held(folder: Path) -> dict[str, bytes]:
    return {entry.name: entry.read_bytes() for entry in sorted(folder.iterdir())}


def test_backups_are_the_files_of_before_the_newest_first(tmp_path: Path) -> None:
    for content in b"12345":
        saved(tmp_path / "a.roam", bytes([content]), 3)
    assert held(tmp_path) == {"a.roam": b"5", "a.roam.1": b"4", "a.roam.2": b"3", "a.roam.3": b"2"}


def test_without_a_file_or_a_number_nothing_is_kept(tmp_path: Path) -> None:
    rotate(tmp_path / "a.roam", 3)
    (tmp_path / "a.roam").write_bytes(b"1")
    rotate(tmp_path / "a.roam", 0)
    assert held(tmp_path) == {"a.roam": b"1"}


def test_a_gap_is_filled_before_an_old_one_goes(tmp_path: Path) -> None:
    for name in ("a.roam", "a.roam.1", "a.roam.3"):
        (tmp_path / name).write_bytes(name.encode())
    rotate(tmp_path / "a.roam", 3)
    assert held(tmp_path) == {
        "a.roam": b"a.roam", "a.roam.1": b"a.roam", "a.roam.2": b"a.roam.1", "a.roam.3": b"a.roam.3",
    }  # fmt: skip


def test_files_of_others_keep_their_names_and_where_all_are_theirs_it_is_said(tmp_path: Path) -> None:
    (tmp_path / "a.roam").write_bytes(b"new")
    (tmp_path / "a.roam.1").write_bytes(b"letter")
    (tmp_path / "a.roam.2").write_bytes(b"old")
    rotate(tmp_path / "a.roam", 3, lambda path: path.read_bytes() != b"letter")
    assert held(tmp_path) == {"a.roam": b"new", "a.roam.1": b"letter", "a.roam.2": b"new", "a.roam.3": b"old"}
    before = held(tmp_path)
    with pytest.raises(RoamError, match="files of others have the names of its backups"):
        rotate(tmp_path / "a.roam", 1, lambda path: path.read_bytes() != b"letter")
    assert held(tmp_path) == before


@posix
def test_the_same_file_is_not_kept_twice(tmp_path: Path) -> None:
    (tmp_path / "a.roam").write_bytes(b"1")
    rotate(tmp_path / "a.roam", 3)
    rotate(tmp_path / "a.roam", 3)
    assert sorted(held(tmp_path)) == ["a.roam", "a.roam.1"]


@posix
def test_of_a_link_the_file_behind_it_is_kept(tmp_path: Path) -> None:
    (tmp_path / "disk").mkdir()
    (tmp_path / "disk" / "real.roam").write_bytes(b"1")
    (tmp_path / "a.roam").symlink_to("disk/real.roam")
    saved(tmp_path / "a.roam", b"2", 2)
    assert held(tmp_path / "disk") == {"real.roam": b"2", "real.roam.1": b"1"}


def test_a_disk_without_links_gets_copies(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(*_: object) -> None:
        raise OSError(95, "Operation not supported")

    monkeypatch.setattr(os, "link", refused)
    (tmp_path / "a.roam").write_bytes(b"1")
    saved(tmp_path / "a.roam", b"2", 2)
    assert held(tmp_path) == {"a.roam": b"2", "a.roam.1": b"1"}


@pytest.mark.parametrize("number", [errno.EPERM, errno.ENOTSUP])
def test_a_disk_without_links_permissions_and_times_has_backups(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    (tmp_path / "a.roam").write_bytes(b"1")
    for name in ("link", "chmod", "utime"):
        monkeypatch.setattr(os, name, refusing(number))
    saved(tmp_path / "a.roam", b"2", 2)
    assert held(tmp_path) == {"a.roam": b"2", "a.roam.1": b"1"}


def test_saves_that_fail_on_a_disk_without_links_push_no_backup_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(*_: object) -> None:
        raise OSError(95, "Operation not supported")

    monkeypatch.setattr(os, "link", refused)
    for content in (b"1", b"2", b"3"):
        saved(tmp_path / "a.roam", content, 2)
    for _ in range(3):
        rotate(tmp_path / "a.roam", 2)
    assert held(tmp_path) == {"a.roam": b"3", "a.roam.1": b"3", "a.roam.2": b"2"}


def test_backups_are_known_by_their_names() -> None:
    assert all(is_named_as_backup(Path(name)) for name in ("a.roam.1", "a b.ROAM.12", "v.1.roam.9"))
    assert not any(is_named_as_backup(Path(name)) for name in ("a.roam", "a.1", ".roam.1", "a.roam.0", "a.roam.1.exr"))


@posix
def test_of_a_link_the_backup_lies_beside_what_it_leads_to(tmp_path: Path) -> None:
    (tmp_path / "disk").mkdir()
    (tmp_path / "a.roam").symlink_to("disk/real.roam")
    assert backup_path(tmp_path / "a.roam", 2) == tmp_path / "disk" / "real.roam.2"


@pytest.mark.parametrize("name", ["a" * 250 + ".roam", "ä" * 125 + ".roam", "aä" * 83 + "a.roam"])
def test_the_longest_names_have_backups(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    for content in b"123":
        saved(path, bytes([content]), 2)
    kept = [backup_path(path, number) for number in (1, 2)]
    assert [each.read_bytes() for each in kept] == [b"2", b"1"]
    assert all(len(os.fsencode(each.name)) <= 255 for each in kept)


def prepared(folder: Path) -> None:
    for entry in folder.iterdir():
        entry.unlink()
    for name in ("a.roam", "a.roam.1", "a.roam.2", "a.roam.3"):
        (folder / name).write_bytes(name.encode())


def require_kept(folder: Path) -> None:
    """The project and all backups but the oldest are there."""
    contents = held(folder)
    assert contents["a.roam"] == b"a.roam"
    assert {b"a.roam.1", b"a.roam.2"} <= set(contents.values())


def test_whatever_call_fails_the_project_is_there_and_only_the_oldest_goes(tmp_path: Path) -> None:
    path, refused, said = tmp_path / "a.roam", [], []
    faults = each_fault(lambda: rotate(path, 3), lambda: prepared(tmp_path), OSError(5, "Input/output error"))
    for name, work in faults:
        try:
            work()
        except RoamError as error:
            refused.append(name)
            said.append(str(error))
        require_kept(tmp_path)
        assert not list(tmp_path.glob(".roam-*"))
    assert refused.count("replace") == 3
    assert {sentence.partition(": ")[0] for sentence in said} == {f"No backup of {path} can be kept"}


@posix
def test_wherever_the_process_dies_the_project_is_there(tmp_path: Path) -> None:
    died = 0
    for _ in each_crash(lambda: rotate(tmp_path / "a.roam", 3), lambda: prepared(tmp_path)):
        require_kept(tmp_path)
        died += 1
    assert died >= 5
