"""Which tests run each line of a room, and how long each of them takes without the compiler."""

from __future__ import annotations

import json
import os
import signal
import time
from collections.abc import Generator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType

import pytest

OPTIONS = ("-q", "-p", "no:cacheprovider", "-W", "ignore::pytest.PytestAssertRewriteWarning")
"""Of pytest, in a process that has imported the libraries before it."""
LIMIT = 8.0
"""Seconds of the processor after which a test is given up that runs line by line: it serves no mutant. Compiled ones
are let be: given up while numba compiles, its lock would stay locked."""


class TooSlow(BaseException):
    """A test that took longer than `LIMIT`; no Exception, so that no test takes it for what it expects."""


@dataclass
class CoverageMap:
    """The tests that pass on the unchanged tree.

    Attributes
    ----------
    seconds : of each test, by its node id. left_out : the tests that fail, or take too long, without the compiler.
    lines : by module (its path from the root) and line, the node ids of the tests that run it. Lines that only an
        import runs have none.
    """

    seconds: dict[str, float] = field(default_factory=dict)
    left_out: list[str] = field(default_factory=list)
    lines: dict[str, dict[int, list[str]]] = field(default_factory=dict)

    def to_json(self) -> str:
        """As text, for the process that asked for it."""
        return json.dumps([self.seconds, self.left_out, self.lines])

    @staticmethod
    def from_json(text: str) -> CoverageMap:
        """From `to_json`."""
        seconds, left_out, modules = json.loads(text)
        lines = {path: {int(line): tests for line, tests in module.items()} for path, module in modules.items()}
        return CoverageMap(seconds, left_out, lines)

    def tests_of(self, path: str, first: int, last: int) -> list[str]:
        """The tests that run any of the lines, or, where only an import does, any of the module; quickest first."""
        module = self.lines.get(path, {})
        found = {test for line in range(first, last + 1) for test in module.get(line, ())}
        if not found and not any(line in module for line in range(first, last + 1)):
            return []
        found = found or {test for tests in module.values() for test in tests}
        return sorted(
            found & self.seconds.keys(), key=lambda test: (not _is_named_after(test, path), self.seconds[test])
        )


def _is_named_after(test: str, path: str) -> bool:
    return Path(path).stem in Path(test.partition("::")[0]).stem


def measured(root: Path, room: str, tests: Sequence[str]) -> CoverageMap:
    """Run the tests with coverage; for a process of its own, in which nothing of ours has been imported."""
    from coverage import Coverage  # not needed where mutants are run by a map that was made before

    coverage = Coverage(data_file=None, source=[str(root / "roam_core" / room)], config_file=False)
    recorder = Recorder(coverage)
    coverage.start()
    ended = pytest.main([*OPTIONS, *tests], plugins=[recorder])
    coverage.stop()
    if ended not in (pytest.ExitCode.OK, pytest.ExitCode.TESTS_FAILED):
        raise RuntimeError(f"pytest ended with status {ended}")
    result = recorder.result
    data = coverage.get_data()
    for name in data.measured_files():
        contexts = data.contexts_by_lineno(name)
        path = Path(name).relative_to(root).as_posix()
        result.lines[path] = {line: [each for each in found if each] for line, found in contexts.items()}
    return result


class Recorder:
    """A plugin of pytest: a context of coverage for each test, its time, its end."""

    def __init__(self, coverage: object) -> None:
        self.coverage = coverage
        self.result = CoverageMap()

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Generator[None, object, object]:
        self.coverage.switch_context(item.nodeid)  # type: ignore[attr-defined]
        begun = time.process_time()
        self.failed = False
        done = yield
        self.coverage.switch_context("")  # type: ignore[attr-defined]
        if self.failed:
            self.result.left_out.append(item.nodeid)
        else:
            self.result.seconds[item.nodeid] = time.process_time() - begun
        return done

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_call(self) -> Generator[None, object, object]:
        signal.signal(signal.SIGPROF, _give_up)
        signal.setitimer(signal.ITIMER_PROF, LIMIT if "NUMBA_DISABLE_JIT" in os.environ else 0.0)
        try:
            return (yield)
        except TooSlow:
            self.failed = True
            return None
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0.0)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.failed |= not report.passed


def _give_up(signum: int, frame: FrameType | None) -> None:
    raise TooSlow(f"longer than {LIMIT} s")
