"""Runs mutants: each is written into a copy of the tree, and a forked process runs the tests that run its line there.

The first process imports the libraries, and nothing of ours: a fork begins where the imports end.
"""

from __future__ import annotations

import importlib
import os
import shutil
import signal
import sys
import time
import traceback
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

from tests.mutation.coverage_map import OPTIONS, CoverageMap
from tests.mutation.operators import Mutant

COPIED = ("roam_core", "resources", "tests", "benchmarks", "pyproject.toml", "docs", "README.md", "app", "scripts")
LIBRARIES = (
    "numpy", "numba", "cv2", "scipy.ndimage", "scipy.signal", "scipy.optimize", "scipy.spatial", "contourpy",
    "OpenImageIO", "hypothesis", "shapely", "defusedxml.ElementTree", "sklearn.mixture", "coverage",
)  # fmt: skip
MOST_SECONDS = 15.0
"""Of tests for one mutant, by their time on the unchanged tree."""
MEMORY = 6 << 30
"""Bytes of address space for a mutant's tests."""

SAID = "said"
"""The file, beside the copy of the tree, of what the last forked process said."""
KILLED, TIMED_OUT, SURVIVED, UNCOVERED = "killed", "timed out", "survived", "no test"


def copy_tree(root: Path, folder: Path) -> Path:
    """The tree in a folder, without what was compiled."""
    for name in COPIED:
        source = root / name
        if source.is_dir():
            shutil.copytree(source, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
        elif source.exists():
            shutil.copy2(source, folder / name)
    shared = root.parent / "shared"
    if shared.is_dir():
        (folder.parent / "shared").symlink_to(shared)
    return folder


def preload(*, compiled: bool) -> None:
    """Import the libraries that tests need, with or without the compiler, and on one thread."""
    os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    if not compiled:
        os.environ["NUMBA_DISABLE_JIT"] = "1"
    for name in LIBRARIES:
        with suppress(ImportError):
            importlib.import_module(name)


def forked(folder: Path, work: Callable[[], int], seconds: float) -> int | None:
    """What `work` gives in a process of its own, which imports our modules from `folder`; None if it takes longer.

    `seconds` are of the processor's time; by the clock it may take four times as long.
    """
    child = os.fork()
    if child == 0:
        status = 70
        try:
            _settle_in(folder, seconds)
            status = work()
        except BaseException:
            traceback.print_exc()
        finally:
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(status)
    end = time.monotonic() + 4.0 * seconds
    while time.monotonic() < end:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            break
        time.sleep(0.02)
    with suppress(ProcessLookupError):
        os.killpg(child, signal.SIGKILL)
    if not done:
        os.waitpid(child, 0)
        return None
    return os.WEXITSTATUS(status) if os.WIFEXITED(status) else -os.WTERMSIG(status)


def _settle_in(folder: Path, seconds: float) -> None:
    import resource  # not on Windows, which cannot fork either

    os.setsid()
    os.chdir(folder)
    said = os.open(folder.parent / SAID, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    os.dup2(said, 1)
    os.dup2(said, 2)
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    for name in [name for name in sys.modules if name.partition(".")[0] in ("roam_core", "tests", "app", "resources")]:
        del sys.modules[name]
    sys.path[:] = [str(folder), *(each for each in sys.path if each and not Path(each, "roam_core").exists())]
    os.environ["PYTHONPATH"] = os.pathsep.join(sys.path[:1] + os.environ.get("PYTHONPATH", "").split(os.pathsep)[1:])
    importlib.invalidate_caches()


def said(folder: Path) -> str:
    """The end of what the last forked process said."""
    return (folder.parent / SAID).read_text(encoding="utf-8", errors="replace")[-2000:]


@contextmanager
def mutated(folder: Path, mutant: Mutant) -> Iterator[None]:
    """The copy with the mutant in it."""
    path = folder / mutant.path
    source, times = path.read_bytes(), path.stat()
    path.write_bytes(mutant.applied(source))
    try:
        yield
    finally:
        path.write_bytes(source)
        os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))


class Chosen:
    """A plugin of pytest that runs the chosen tests alone, in the order in which they are given."""

    def __init__(self, tests: Collection[str]) -> None:
        self.places = {test: place for place, test in enumerate(tests)}

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        items[:] = sorted(
            (item for item in items if item.nodeid in self.places), key=lambda item: self.places[item.nodeid]
        )


def verdict(folder: Path, mutant: Mutant, covering: CoverageMap) -> str:
    """What became of the mutant."""
    tests: list[str] = []
    total = 0.0
    for test in covering.tests_of(mutant.path, *mutant.lines):
        total += covering.seconds[test]
        if tests and total > MOST_SECONDS:
            break
        tests.append(test)
    if not tests:
        return UNCOVERED
    files = list(dict.fromkeys(test.partition("::")[0] for test in tests))
    chosen = Chosen(tests)

    def run() -> int:
        import resource

        sys.dont_write_bytecode = True
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        return int(pytest.main(["-x", *OPTIONS, *files], plugins=[chosen]))

    with mutated(folder, mutant):
        status = forked(folder, run, 15.0 + 4.0 * min(total, MOST_SECONDS))
    if status is None or status == -signal.SIGXCPU or status == -signal.SIGKILL:
        return TIMED_OUT
    if status == pytest.ExitCode.NO_TESTS_COLLECTED:
        raise RuntimeError(f"no test was collected for {mutant}")
    return SURVIVED if status == pytest.ExitCode.OK else KILLED
