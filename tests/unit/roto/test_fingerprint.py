"""What tells whether a file is still the one that was read."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from roam_core.roto.fingerprint import Fingerprint


def test_a_file_is_known_by_its_content(tmp_path: Path) -> None:
    path = tmp_path / "p.roam"
    path.write_bytes(b"one")
    found = Fingerprint.of(path)
    assert found is not None
    os.utime(path, (1, 1))
    assert found.is_of(path)
    path.write_bytes(b"two")
    assert not found.is_of(path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes here")
def test_a_pipe_and_a_device_have_none_and_nobody_waits_for_them(tmp_path: Path) -> None:
    """A command that was given one waited for its other end, or read the device for ever."""
    pipe, endless = tmp_path / "pipe.roam", tmp_path / "endless.roam"
    os.mkfifo(pipe)
    endless.symlink_to("/dev/zero")
    for path in (pipe, endless, tmp_path, tmp_path / "none.roam", Path("a\0b")):
        assert Fingerprint.of(path) is None
