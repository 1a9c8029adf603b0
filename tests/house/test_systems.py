"""Other systems and other Pythons than this one: what keeps ROAM from being installed, or a module from being loaded.

Nothing here runs on them: what is known of them is held against the code and the pinned releases.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, metadata

import pytest
from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet

from tests.conftest import ROOT

OLDEST = "3.11.0"
"""The oldest Python that `requires-python` lets in; Debian 12 has 3.11.2."""
FOLDERS = ("roam_core", "app", "resources", "benchmarks", "scripts", "tests")
WITHOUT_ON_WINDOWS = {"fcntl", "grp", "pty", "pwd", "resource", "termios", "tty"}
"""Modules of Python that Windows has not."""
UNKNOWN_TO_WINDOWS = {
    "os": {"fchmod", "fork", "getuid", "killpg", "memfd_create", "mkfifo", "setsid", "sched_getaffinity", "sysconf"},
    "signal": {"SIGALRM", "SIGCHLD", "SIGHUP", "SIGKILL", "SIGPIPE", "SIGPROF", "SIGSTOP", "SIGUSR1", "setitimer"},
}
"""Names that modules have elsewhere."""


def pins() -> list[Requirement]:
    lines = (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
    return [Requirement(line.partition("#")[0]) for line in lines if line.partition("#")[0].strip()]


def holds(pin: Requirement, python: str) -> bool:
    """Whether a line of the constraints is meant for a Python."""
    minor = python.rpartition(".")[0]
    return pin.marker is None or pin.marker.evaluate({"python_full_version": python, "python_version": minor})


def test_every_pinned_release_can_be_installed_with_the_oldest_python() -> None:
    """`make run` on Debian 12 ended with ResolutionImpossible: a library of the manual's theme wanted 3.11.5."""
    refused = []
    for pin in (pin for pin in pins() if holds(pin, OLDEST)):
        try:
            told = metadata(pin.name)
        except PackageNotFoundError:
            continue  # of another system, or another Python
        if told["Version"] in pin.specifier and OLDEST not in SpecifierSet(told.get("Requires-Python") or ""):
            refused.append(f"{pin}: {told['Requires-Python']}")
    assert refused == []


@pytest.mark.parametrize("python", [OLDEST, "3.11.2", "3.11.5", "3.12.3", "3.13.0", "3.14.0"])
def test_each_python_finds_one_release_of_every_library(python: str) -> None:
    names = [re.sub(r"[-_.]+", "-", pin.name).lower() for pin in pins() if holds(pin, python)]
    assert len(names) == len(set(names))
    assert set(names) == {re.sub(r"[-_.]+", "-", pin.name).lower() for pin in pins()}


def done_at_once(tree: ast.AST) -> Iterator[ast.AST]:
    """What of a module is run as it is loaded, without what hangs on a condition."""
    for child in ast.iter_child_nodes(tree):
        if isinstance(child, ast.Lambda | ast.If | ast.IfExp | ast.Try):
            continue
        if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef):
            for part in (*child.decorator_list, child.args):
                yield part
                yield from done_at_once(part)
            continue
        yield child
        yield from done_at_once(child)


def of_unix_alone(text: str) -> list[str]:
    """What a module cannot be loaded without, and Windows has not."""
    found = []
    for node in done_at_once(ast.parse(text)):
        match node:
            case ast.Import(names=names):
                found += [alias.name for alias in names if alias.name in WITHOUT_ON_WINDOWS]
            case ast.ImportFrom(module=str(module), level=0) if module in WITHOUT_ON_WINDOWS:
                found.append(module)
            case ast.Attribute(value=ast.Name(id=module), attr=name) if name in UNKNOWN_TO_WINDOWS.get(module, ()):
                found.append(f"{module}.{name}")
    return found


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("import resource", ["resource"]),
        ("from pwd import getpwnam", ["pwd"]),
        ("A = {'pipe': os.mkfifo}", ["os.mkfifo"]),
        ("@mark(signal.SIGKILL)\ndef f(): pass", ["signal.SIGKILL"]),
        ("from resources import demo\ndef f():\n import resource\n os.mkfifo(p)", []),
        ("if sys.platform != 'win32':\n import fcntl", []),
        ("A = lambda path: os.mkfifo(path)", []),
    ],
)
def test_what_windows_lacks_is_found(text: str, found: list[str]) -> None:
    assert of_unix_alone(text) == found


def test_every_module_can_be_loaded_on_windows() -> None:
    """One test that cannot be collected there, and `python -m pytest` runs none."""
    paths = [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*.py"))]
    assert len(paths) > 100
    stuck = {
        path.relative_to(ROOT).as_posix(): found
        for path in paths
        if (found := of_unix_alone(path.read_text(encoding="utf-8")))
    }
    assert stuck == {}
