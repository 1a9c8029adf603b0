"""Files of strangers: what is no regular file is never opened, and no more is read than was agreed on."""

from __future__ import annotations

import os
import socket
from pathlib import Path

import pytest

from roam_core.bounded import bounded_bytes, require_regular
from roam_core.errors import RoamError


def test_a_file_within_the_bound_is_read_whole(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"x" * 1024)
    assert bounded_bytes(path, 1024) == b"x" * 1024


def test_a_larger_file_is_refused_with_the_bound(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"x" * 2049)
    with pytest.raises(RoamError, match=r"file is larger than 2 KiB; split it"):
        bounded_bytes(path, 2048)


def test_a_hole_of_a_terabyte_is_refused_before_it_is_read(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.touch()
    os.truncate(path, 1 << 40)
    with pytest.raises(RoamError, match=r"larger than 48 MiB; leave it"):
        bounded_bytes(path, 48 << 20, "leave it")


def test_a_file_without_the_permission_to_read_is_told_as_that(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "file"
    path.touch()
    monkeypatch.setattr(os, "access", lambda place, mode: False)  # the administrator may read all files
    with pytest.raises(RoamError, match=r"file may not be read; give yourself the permission"):
        require_regular(path)


@pytest.mark.parametrize("kind", ["pipe", "socket", "device", "link to a device", "link to a pipe"])
def test_what_is_no_regular_file_is_refused_without_waiting(tmp_path: Path, kind: str) -> None:
    path = tmp_path / "file"
    match kind:
        case "pipe":
            os.mkfifo(path)
        case "socket":
            with socket.socket(socket.AF_UNIX) as end:
                end.bind(str(path))
        case "device":
            path = Path("/dev/zero")
        case "link to a device":
            path.symlink_to("/dev/zero")
        case _:
            os.mkfifo(tmp_path / "pipe")
            path.symlink_to(tmp_path / "pipe")
    with pytest.raises(RoamError, match="is a pipe, a socket or a device"):
        bounded_bytes(path, 100)
    with pytest.raises(RoamError, match="is a pipe, a socket or a device"):
        require_regular(path)


@pytest.mark.parametrize(
    ("name", "told"),
    [("", "is a folder"), ("none", "does not exist"), ("a\0b", "cannot be read"), ("file/below", "cannot be read")],
)
def test_what_is_no_file_is_told(tmp_path: Path, name: str, told: str) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(RoamError, match=told):
        bounded_bytes(tmp_path / name, 100)


def test_a_link_to_a_file_is_followed(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"abc")
    (tmp_path / "link").symlink_to(tmp_path / "file")
    assert bounded_bytes(tmp_path / "link", 100) == b"abc"
