"""What every test may ask for."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from roam_core.cli.stopping import STOPPING

OF_A_MACHINE = ("LANG", "LC_", "OCIO", "ROAM_", "QT_SCALE", "QT_SCREEN_SCALE", "QT_FONT_DPI")
# An artist's desktop and a studio's colours are not what is tested: tests are the same in every language, at any scale.
for name in [name for name in os.environ if name.startswith(OF_A_MACHINE)]:
    del os.environ[name]
os.environ["LANG"] = "C.UTF-8"

# No test is timed, and a suite that passes here passes elsewhere: the same examples everywhere.
settings.register_profile("suite", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("suite")

ROOT = Path(__file__).resolve().parent.parent
"""The repository."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--watch",
        action="store_true",
        help="fail tests of the window in which one event takes too long; timed, so not part of make test",
    )


@pytest.fixture(scope="session")
def shared() -> Path:
    """The folder of shots and samples beside the project; a test that wants it is skipped where it is absent."""
    folder = ROOT.parent / "shared"
    if not folder.is_dir():
        pytest.skip("needs the shots and samples in ../shared, which are not part of the repository")
    return folder


@pytest.fixture
def heard() -> Iterator[None]:
    """No signal is ignored, as all are in a process that a script left in the background, and in what it starts."""
    before = {number: signal.signal(number, signal.default_int_handler) for number in STOPPING}
    yield
    for number, was in before.items():
        signal.signal(number, was)
