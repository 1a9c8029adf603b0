"""How the tree reads: the first line of each module, its length, its name, and what every parameter means."""

from __future__ import annotations

import ast
import re
from dataclasses import fields
from functools import cache
from pathlib import Path

import pytest

from roam_core.cli import COMMANDS
from roam_core.params import CONFIGS, DEFAULT_CONFIG, RoamParams, configurations
from tests.conftest import ROOT

MOST_LINES = 450
SAYS_NOTHING = re.compile(r"utils?|helpers?|managers?|misc|common|data|info")
"""Names that tell a reader nothing of what is inside."""

PROGRAM = [path for room in ("app", "roam_core", "resources") for path in sorted((ROOT / room).rglob("*.py"))]
TESTS = sorted((ROOT / "tests").rglob("*.py"))


@cache
def trees() -> dict[Path, ast.Module]:
    """All syntax trees; read by the first test that asks, not by every process that collects."""
    return {path.relative_to(ROOT): ast.parse(path.read_text(encoding="utf-8")) for path in PROGRAM + TESTS}


def of(*rooms: str) -> dict[Path, ast.Module]:
    """The syntax trees of some rooms."""
    return {path: tree for path, tree in trees().items() if path.parts[0] in rooms}


def ours() -> dict[Path, ast.Module]:
    """The syntax trees of the program."""
    return of("app", "roam_core", "resources")


def is_command(path: Path) -> bool:
    """A command's module has the command's name: `roam info` is the field's word, and the user's."""
    return path.parent == Path("roam_core/cli") and path.stem in COMMANDS


def lines_of(path: Path) -> list[str]:
    return (ROOT / path).read_text(encoding="utf-8").splitlines()


def test_files_are_short_enough_to_be_read() -> None:
    long = {str(path): len(lines_of(path)) for path in ours() if len(lines_of(path)) > MOST_LINES}
    assert long == {}


def test_a_module_says_in_its_first_line_what_lives_there() -> None:
    silent = [str(path) for path, tree in trees().items() if tree.body and not (ast.get_docstring(tree) or "").strip()]
    assert silent == []


def test_names_of_modules_say_what_is_inside() -> None:
    parts = {part.rstrip("_") for path in ours() if not is_command(path) for part in path.with_suffix("").parts}
    assert [part for part in sorted(parts) if SAYS_NOTHING.fullmatch(part)] == []


def test_names_of_classes_say_what_they_are() -> None:
    classes = [node.name for tree in ours().values() for node in ast.walk(tree) if isinstance(node, ast.ClassDef)]
    assert [name for name in classes if re.search(r"(Manager|Helper|Utils?)$", name)] == []


def test_what_is_public_in_the_engine_is_described() -> None:
    bare = [
        f"{path}: {node.name}"
        for path, tree in of("roam_core").items()
        for node in tree.body
        if isinstance(node, ast.FunctionDef | ast.ClassDef)
        and not node.name.startswith("_")
        and not is_enum(node)
        and not ast.get_docstring(node)
    ]
    assert bare == []


def test_nothing_is_left_for_later() -> None:
    later = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")
    assert [str(path) for path in ours() if any(later.search(line) for line in lines_of(path))] == []


def is_enum(node: ast.AST) -> bool:
    """Enumerations may speak for themselves."""
    bases = node.bases if isinstance(node, ast.ClassDef) else []
    return any(isinstance(base, ast.Name) and base.id.endswith("Enum") for base in bases)


def test_every_parameter_is_described() -> None:
    described = RoamParams.__doc__ or ""
    assert [field.name for field in fields(RoamParams) if not re.search(rf"\b{field.name}\b[^:\n]*:", described)] == []


@pytest.mark.parametrize("config", list(CONFIGS))
def test_every_configuration_is_described_and_knows_its_name(config: str) -> None:
    text = Path(configurations.__file__).read_text(encoding="utf-8")
    described = text[text.index("CONFIGS:") :]
    assert f"`{config}`" in described
    assert CONFIGS[config].config == config


def test_the_default_configuration_exists() -> None:
    assert DEFAULT_CONFIG in CONFIGS
