"""Mutants: what is changed, and that each change is one that a program can notice."""

from __future__ import annotations

import ast

import pytest

from tests.conftest import ROOT
from tests.mutation.__main__ import ROOMS, draw
from tests.mutation.coverage_map import CoverageMap
from tests.mutation.operators import sites


def mutants(source: str) -> set[str]:
    """All sources that one change makes of a source."""
    return {each.applied(source.encode()).decode() for place in sites("module.py", source.encode()) for each in place}


@pytest.mark.parametrize(
    ("source", "changed"),
    [
        ("x = a < b", {"x = (a <= b)", "x = (a >= b)"}),
        ("x = a + b", {"x = (a - b)"}),
        ("x = a and b", {"x = (a or b)"}),
        ("x = not a", {"x = (a)"}),
        ("x = 3", {"x = 4", "x = 2"}),
        ("x = True", {"x = False"}),
        ("x = 0.0", {"x = 1.0"}),
        ("x = min(a, b)", {"x = (max(a, b))"}),
        ("x = a if b else c", {"x = a if (not b) else c"}),
        ("x += a", {"x -= a", "pass"}),
        ("x[a] = b", {"pass"}),
        ("x = x + a", {"x = (x - a)", "pass"}),
        ("call(a)", {"pass"}),
        ("def f():\n    return a", {"def f():\n    return None"}),
        ("for a in b:\n    break", {"for a in b:\n    continue"}),
    ],
)
def test_what_a_statement_may_become(source: str, changed: set[str]) -> None:
    assert mutants(source) == changed


@pytest.mark.parametrize(
    "source",
    [
        '"""A text."""',
        "x: Literal[3] = a",
        "assert a < 3",
        "log.info(a)",
        "@njit(cache=True)\ndef f(): ...",
        "x = 'a' + b",
        "x = f'{a + 3}'",
        "def f(): return None",
        "x = int | None",
    ],
)
def test_what_no_program_notices_is_left_alone(source: str) -> None:
    assert mutants(source) == set()


@pytest.mark.parametrize("room", sorted(ROOMS))
def test_a_draw_is_the_same_every_time_and_its_mutants_are_programs(room: str) -> None:
    drawn = draw(room, 20, 1)
    assert len(set(drawn)) == 20
    assert drawn[:10] == draw(room, 10, 1) != draw(room, 10, 2)
    for mutant in drawn:
        source = (ROOT / mutant.path).read_bytes()
        assert source[mutant.start : mutant.end].decode() == mutant.before
        assert ast.dump(ast.parse(mutant.applied(source))) != ast.dump(ast.parse(source))


def test_a_mutant_is_judged_by_the_tests_that_run_its_statement_and_an_import_by_those_of_the_module() -> None:
    tests = {"test_other.py::a": 0.1, "test_module.py::b": 0.3, "test_other.py::c": 0.2}
    lines = {"module.py": {1: [], 4: ["test_other.py::c"], 5: ["test_other.py::a", "test_module.py::b"]}}
    covering = CoverageMap.from_json(CoverageMap(tests, [], lines).to_json())
    assert covering.tests_of("module.py", 5, 5) == ["test_module.py::b", "test_other.py::a"]
    assert covering.tests_of("module.py", 4, 6) == ["test_module.py::b", "test_other.py::a", "test_other.py::c"]
    assert covering.tests_of("module.py", 1, 2) == ["test_module.py::b", "test_other.py::a", "test_other.py::c"]
    assert covering.tests_of("module.py", 7, 9) == covering.tests_of("absent.py", 1, 9) == []
