"""Packages that load their names on demand offer what they list, and each name is that of its module."""

from __future__ import annotations

import subprocess
import sys
from importlib import import_module
from importlib.util import find_spec

import pytest

PACKAGES = ["roam_core", "roam_core.propagate", "roam_core.interchange"]


@pytest.mark.parametrize("package", PACKAGES)
def test_every_name_that_is_listed_is_there(package: str) -> None:
    module = import_module(package)
    assert set(module.__all__) <= set(dir(module))
    for name in module.__all__:
        assert getattr(module, name) is not None, name


@pytest.mark.parametrize("package", PACKAGES)
def test_no_name_is_that_of_a_module_of_the_package(package: str) -> None:
    """A module that is loaded becomes an attribute of its package, and would hide the name."""
    module = import_module(package)
    assert [name for name in module.__all__ if find_spec(f"{package}.{name}") is not None] == []


def test_an_unknown_name_is_an_error_that_tells_the_package() -> None:
    with pytest.raises(AttributeError, match=r"'roam_core\.propagate' has no attribute 'nonsense'"):
        import_module("roam_core.propagate").nonsense  # noqa: B018


def test_who_asks_for_stamps_does_not_load_the_solver() -> None:
    program = "import sys, roam_core.propagate.shapes.provenance; print('roam_core.propagate.run' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"
