"""Every kernel has a case that runs."""

from __future__ import annotations

import inspect
import pkgutil
from importlib import import_module

import numpy as np
import pytest
from numba.core.dispatcher import Dispatcher

import roam_core.kernels
from benchmarks.kernel_cases import CASES


def kernels() -> set[str]:
    """The public functions of the modules of `roam_core.kernels` that compile anything."""
    found = set()
    for module in pkgutil.iter_modules(roam_core.kernels.__path__):
        room = import_module(f"roam_core.kernels.{module.name}")
        if not any(isinstance(each, Dispatcher) for each in vars(room).values()):
            continue
        functions = inspect.getmembers(room, inspect.isfunction)
        found |= {name for name, each in functions if not name.startswith("_") and each.__module__ == room.__name__}
    return found


def test_every_kernel_has_its_line() -> None:
    assert kernels() == set(CASES)


@pytest.mark.parametrize("name", list(CASES))
def test_a_case_is_one_that_its_kernel_accepts(name: str) -> None:
    function, args, kwargs = CASES[name]()
    assert function.__name__ == name
    given = [np.copy(each) if isinstance(each, np.ndarray) else each for each in args]
    results = function(*args, **kwargs)
    for each in results if isinstance(results, tuple) else (results,):
        values = np.asarray(0.0 if each is None else each, dtype=np.float64)
        assert values.size == 0 or np.isfinite(values).any()
    for before, after in zip(given, args, strict=True):
        if isinstance(after, np.ndarray):
            assert np.array_equal(before, after)
