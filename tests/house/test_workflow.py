"""The workflow for public forges: it is of the form that they take, and every command in it is one that works here."""

from __future__ import annotations

import re
import shlex
import subprocess
import tomllib
from collections.abc import Iterator
from importlib.util import find_spec
from typing import Any

import pytest

from tests.conftest import ROOT

yaml = pytest.importorskip("yaml", reason="PyYAML is not installed (pip install 'roam-roto[dev]')")

WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
WHAT_A_STEP_HAS = {"name", "id", "if", "uses", "with", "run", "env", "shell", "working-directory"}
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")


def jobs() -> Iterator[tuple[str, dict[str, Any]]]:
    for path in WORKFLOWS:
        yield from yaml.safe_load(path.read_text(encoding="utf-8"))["jobs"].items()


def commands() -> set[str]:
    """Every line that a step runs."""
    steps = [step for _, job in jobs() for step in job["steps"]]
    return {line for step in steps for line in step.get("run", "").splitlines() if line.strip()}


def test_there_is_a_workflow_and_each_job_of_it_does_something() -> None:
    assert WORKFLOWS
    for name, job in jobs():
        assert job["runs-on"], name
        assert job["timeout-minutes"] > 0, name
        for step in job["steps"]:
            assert step.keys() <= WHAT_A_STEP_HAS, name
            assert ("run" in step) != ("uses" in step), name


def test_every_job_that_another_waits_for_is_there() -> None:
    known = dict(jobs())
    for job in known.values():
        needed = job.get("needs", [])
        assert set([needed] if isinstance(needed, str) else needed) <= known.keys()


def test_whatever_a_job_asks_of_its_matrix_is_in_it() -> None:
    for name, job in jobs():
        asked = set(re.findall(r"matrix\.(\w+)", str(job)))
        assert asked <= set(job.get("strategy", {}).get("matrix", {})), name


def test_all_systems_and_every_python_that_the_package_is_for_are_tested() -> None:
    matrix = dict(jobs())["test"]["strategy"]["matrix"]
    assert {system.split("-")[0] for system in matrix["system"]} == {"ubuntu", "macos", "windows"}
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["requires-python"] == f">={matrix['python'][0]}"
    assert matrix["python"] == ["3.11", "3.12", "3.13"]


def test_every_other_action_is_asked_for_by_its_version() -> None:
    used = {step["uses"] for _, job in jobs() for step in job["steps"] if "uses" in step}
    assert used
    assert [action for action in used if not re.fullmatch(r"actions/[a-z-]+@v\d+", action)] == []


@pytest.mark.parametrize("command", sorted(commands()))
def test_every_command_is_one_that_works_here(command: str) -> None:
    words = shlex.split(command)
    if words[0] == "make":
        for target in words[1:]:
            assert re.search(rf"^{target}:", MAKEFILE, flags=re.MULTILINE), target
            dry = subprocess.run(["make", "--dry-run", target], cwd=ROOT, capture_output=True, text=True, check=False)
            assert dry.returncode == 0, dry.stderr
    elif words[:2] == ["python", "-m"]:
        assert find_spec(words[2]) is not None
    else:
        assert f"$(BIN)/{command}" in MAKEFILE, "the Makefile runs it otherwise"


def test_what_is_installed_without_make_is_what_make_installs() -> None:
    made = re.search(r"--editable '(\.\[[a-z,]+\])'", MAKEFILE)
    assert made is not None
    installed = [command for command in commands() if "pip install" in command]
    assert installed
    assert all(shlex.split(command)[-1] == made[1] for command in installed)
    assert all("--constraint constraints.txt" in command for command in installed)
