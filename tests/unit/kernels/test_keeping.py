"""Compiled kernels are kept where that is possible, and compiled again where what was kept is damaged."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from roam_core import temporary
from roam_core.kernels import keeping
from roam_core.kernels.keeping import DIGEST
from roam_core.temporary import is_writable, private_folder
from tests.conftest import ROOT
from tests.unit.kernels.conftest import needs_compiler

KERNEL = """
import roam_core.kernels
from numba import njit

@njit(cache=True)
def twice(number):
    return 2 * number
"""
PROGRAM = """
import kernel
assert kernel.twice(4) == 8
print(sum(kernel.twice.stats.cache_hits.values()), kernel.twice.stats.cache_path)
"""


def run(folder: Path, **environment: str) -> tuple[int, Path]:
    """Call the kernel in a process of its own: how often it was found compiled, and where it is kept."""
    plain = {name: value for name, value in os.environ.items() if not name.startswith(("NUMBA", "XDG"))}
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM],
        cwd=folder,
        env=plain | {"PYTHONPATH": f"{ROOT}{os.pathsep}{folder}"} | environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    hits, _, place = done.stdout.strip().partition(" ")
    return int(hits), Path(place)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "install").mkdir()
    (tmp_path / "install" / "kernel.py").write_text(KERNEL, encoding="utf-8")
    return tmp_path / "install"


DAMAGES: tuple[Callable[[bytes], bytes], ...] = (
    lambda content: b"",
    lambda content: content[: len(content) // 2],
    lambda content: b"\0" * len(content),
    lambda content: content[:-40] + bytes([content[-40] ^ 1]) + content[-39:],
    lambda content: content[:-DIGEST],
)


@needs_compiler
def test_a_damaged_kernel_is_compiled_again(folder: Path) -> None:
    assert run(folder)[0] == 0
    hits, place = run(folder)
    assert hits == 1, "what is whole is used"
    (file,) = place.glob("*.nbc")
    file.write_bytes(file.read_bytes()[:-100])
    assert run(folder)[0] == 0


@pytest.mark.parametrize("damage", DAMAGES)
@pytest.mark.parametrize("suffix", ["nbi", "nbc"])
def test_no_damage_goes_unseen(tmp_path: Path, suffix: str, damage: Callable[[bytes], bytes]) -> None:
    kept = keeping.CheckedFile(str(tmp_path), "kernel", "stamp")
    kept.save("key", ["data"] * 100)
    assert kept.load("key") == ["data"] * 100
    (file,) = tmp_path.glob(f"*.{suffix}")
    file.write_bytes(damage(file.read_bytes()))
    assert kept.load("key") is None
    kept.save("key", "anew")
    assert kept.load("key") == "anew"


@needs_compiler
def test_a_read_only_install_and_home_keep_kernels_in_a_private_folder(folder: Path, tmp_path: Path) -> None:
    (folder / "__pycache__").touch()  # stands in for a folder that cannot be written to, by root either
    (tmp_path / "temporary").mkdir()
    nowhere = {"HOME": str(folder / "kernel.py"), "TMPDIR": str(tmp_path / "temporary")}
    hits, place = run(folder, **nowhere)
    assert hits == 0
    assert place.is_relative_to(tmp_path / "temporary")
    assert run(folder, **nowhere) == (1, place)


def test_a_full_disk_does_not_keep_a_kernel_from_running(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = keeping.CheckedFile(str(tmp_path), "kernel", "stamp")
    kept.save("key", "data")
    assert kept.load("key") == "data"
    monkeypatch.setattr(keeping.CheckedFile, "_save_data", lambda *_: (_ for _ in ()).throw(OSError(28, "full")))
    kept.save("other", "data")
    assert kept.load("other") is None


def test_a_temporary_folder_that_others_may_write_to_is_not_trusted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(temporary.tempfile, "gettempdir", lambda: str(tmp_path))
    monkeypatch.setattr(temporary.tempfile, "tempdir", str(tmp_path))
    folder = private_folder("roam")
    assert folder.stat().st_mode & 0o777 == 0o700
    assert private_folder("roam") == folder
    folder.chmod(0o777)
    assert private_folder("roam") != folder
    folder.rmdir()
    (tmp_path / "elsewhere").mkdir(mode=0o700)
    folder.symlink_to(tmp_path / "elsewhere")
    assert private_folder("roam") != folder


def test_a_folder_is_writable_when_a_file_can_be_made_in_it(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    assert is_writable(tmp_path / "a" / "b")
    assert not is_writable(tmp_path / "file" / "b")


IN_A_BUNDLE = """
import sys
sys.frozen, sys._MEIPASS = True, sys.argv[1]
import kernel
from numba import config
assert kernel.twice(4) == 8
print(sum(kernel.twice.stats.cache_hits.values()), config.CPU_NAME)
"""


def in_a_bundle(folder: Path, bundle: Path, **environment: str) -> list[str]:
    """Call the kernel as a bundle's program does: how often it was found compiled, and for which processor it is."""
    plain = {name: value for name, value in os.environ.items() if not name.startswith(("NUMBA", "XDG"))}
    done = subprocess.run(
        [sys.executable, "-c", IN_A_BUNDLE, str(bundle)],
        cwd=folder,
        env=plain | {"PYTHONPATH": f"{ROOT}{os.pathsep}{folder}"} | environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


@needs_compiler
def test_a_bundle_uses_the_kernels_that_it_was_shipped_with_wherever_it_lies(folder: Path, tmp_path: Path) -> None:
    built, moved, home = tmp_path / "built", tmp_path / "moved", {"XDG_CACHE_HOME": str(tmp_path / "cache")}
    shipped = built / keeping.SHIPPED
    shipped.mkdir(parents=True)
    assert in_a_bundle(folder, built, NUMBA_CACHE_DIR=str(shipped))[0] == "0"
    assert list(shipped.glob("*.nbi"))
    built.rename(moved)
    assert in_a_bundle(folder, moved, **home)[0] == "1"
    assert list(tmp_path.glob("cache/**/*.nbi")) == []


@needs_compiler
@pytest.mark.skipif(sys.platform != "linux", reason="XDG_CACHE_HOME is Linux's")
def test_what_a_bundle_lacks_is_compiled_once_for_its_user(folder: Path, tmp_path: Path) -> None:
    home = {"XDG_CACHE_HOME": str(tmp_path / "cache")}
    (tmp_path / "bundle").mkdir()
    assert in_a_bundle(folder, tmp_path / "bundle", **home)[0] == "0"
    assert list((tmp_path / "cache" / "roam" / keeping.SHIPPED).glob("*.nbi"))
    assert in_a_bundle(folder, tmp_path / "bundle", **home)[0] == "1"


def test_kernels_are_made_for_common_processors_where_this_one_has_all_of_that(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(keeping.config, "CPU_NAME", None)
    monkeypatch.setattr(keeping.config, "CPU_FEATURES", None)
    monkeypatch.setattr(keeping.platform, "machine", lambda: "AMD64")
    monkeypatch.setattr(keeping.llvm, "get_host_cpu_features", lambda: {"avx2": True, "fma": False})
    assert not keeping.compile_for_common_processors()
    assert keeping.config.CPU_NAME is None
    name, needed = keeping.COMMON["x86_64"]
    monkeypatch.setattr(keeping.llvm, "get_host_cpu_features", lambda: dict.fromkeys([*needed, "avx512f"], True))
    assert keeping.compile_for_common_processors()
    chosen = (keeping.config.CPU_NAME, keeping.config.CPU_FEATURES)
    assert chosen == (name, "")
    monkeypatch.setattr(keeping.config, "CPU_NAME", "znver1")
    assert not keeping.compile_for_common_processors()
    assert keeping.config.CPU_NAME == "znver1"
