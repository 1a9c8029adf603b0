"""`make setup`: what it does again, and what it leaves alone."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.conftest import ROOT

pytestmark = pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed")


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A folder with a space in its name in which everything is installed, older than nothing that it came from."""
    folder = tmp_path / "my roam"
    for name in ("Makefile", "pyproject.toml", "constraints.txt", "scripts/system-libraries"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, folder / name)
    python = folder / ".venv" / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.write_text("#!/bin/sh\n", encoding="utf-8")
    python.chmod(0o755)
    (folder / ".venv" / ".ready").write_text(f"{folder.resolve()}\n", encoding="utf-8")
    return folder


def steps(folder: Path) -> str:
    """What make would do; of other makes that run this test it hears nothing."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("MAKE", "MFLAGS"))}
    command = ["make", "--dry-run", "setup", "PYTHON=python3"]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=True)
    return done.stdout


def test_what_is_installed_is_left_alone(checkout: Path) -> None:
    assert "venv" not in steps(checkout)
    (checkout / ".venv" / ".ready").write_text("", encoding="utf-8")  # as it was before it held the folder
    assert "venv" not in steps(checkout)


def test_other_requirements_are_installed_into_the_same_environment(checkout: Path) -> None:
    later = (checkout / ".venv" / ".ready").stat().st_mtime + 60
    os.utime(checkout / "pyproject.toml", (later, later))
    said = steps(checkout)
    assert "pip install" in said
    assert 'test -z "" && test -x .venv/bin/python' in said


def test_in_a_folder_that_was_moved_everything_is_installed_anew(checkout: Path) -> None:
    moved = checkout.rename(checkout.with_name("roam"))
    said = steps(moved)
    assert 'test -z "yes" && test -x .venv/bin/python; } || python3 -m venv --clear .venv' in said
    assert "pip install" in said


@pytest.mark.parametrize("left", ["another release", "nothing"])
def test_where_the_python_is_another_by_now_everything_is_installed_anew(checkout: Path, left: str) -> None:
    """It does not find what was installed for the one before: `make run` ended in a ModuleNotFoundError."""
    python = checkout / ".venv" / "bin" / "python"
    if left == "nothing":
        python.unlink()
        python.symlink_to(checkout / "python3.10")
    else:
        python.write_text('#!/bin/sh\necho "No module named pip" >&2; exit 1\n', encoding="utf-8")
    said = steps(checkout)
    assert 'test -z "yes" && test -x .venv/bin/python; } || python3 -m venv --clear .venv' in said
    assert "pip install" in said


NEEDS_SHELL = pytest.mark.skipif(os.name == "nt", reason="Windows needs no system libraries")


@pytest.fixture
def programs(tmp_path: Path) -> Path:
    """A folder of programs that stand in for those of a Debian machine; apt finds another one at work."""
    folder = tmp_path / "programs"
    folder.mkdir()
    stand_in(folder, "dpkg-query", 'printf "install ok installed"')
    stand_in(folder, "id", "echo 0")
    stand_in(folder, "apt-get", 'echo "E: Could not get lock" >&2; exit 100')
    return folder


def stand_in(folder: Path, name: str, does: str) -> None:
    (folder / name).write_text(f"#!/bin/sh\n{does}\n", encoding="utf-8")
    (folder / name).chmod(0o755)


def system_libraries(programs: Path, *words: str) -> tuple[int, str]:
    """How the script ends, and what it says, with these programs before all others."""
    environment = os.environ | {"PATH": f"{programs}{os.pathsep}{os.environ['PATH']}"}
    command = ["sh", str(ROOT / "scripts" / "system-libraries"), *words]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


@NEEDS_SHELL
@pytest.mark.parametrize("said", ["install ok installed", "install ok installedinstall ok installed"])
def test_libraries_that_are_there_are_no_matter_for_how_many_architectures(programs: Path, said: str) -> None:
    stand_in(programs, "dpkg-query", f'printf "{said}"')
    assert system_libraries(programs, "--test") == (0, "")


@NEEDS_SHELL
@pytest.mark.parametrize("name", ["libglib2.0-0", "libglib2.0-0t64"])
def test_what_qts_core_itself_needs_is_among_them_however_the_release_calls_it(programs: Path, name: str) -> None:
    """A bare Debian has no GLib, and none of the other libraries brings it: the window ended in an ImportError."""
    all_but = 'case " $* " in *" libglib2.0-0 "*) ;; *) printf "install ok installed" ;; esac'
    stand_in(programs, "dpkg-query", all_but)
    assert "--no-install-recommends libglib2.0-0\n" in system_libraries(programs)[1]
    stand_in(programs, "dpkg-query", f'{all_but}\ncase " $* " in *" {name} "*) printf "install ok installed" ;; esac')
    assert system_libraries(programs) == (0, "")


@NEEDS_SHELL
def test_where_libraries_cannot_be_installed_they_are_named_and_setup_goes_on(programs: Path) -> None:
    stand_in(programs, "dpkg-query", 'test "$3" = xdotool || printf "install ok installed"')
    status, said = system_libraries(programs, "--test")
    assert status == 0
    assert "They could not be installed; later:  sudo apt-get install --no-install-recommends xdotool" in said
    assert system_libraries(programs, "--test", "--or-fail") == (1, said)
    assert system_libraries(programs) == (0, "")
