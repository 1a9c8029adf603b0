"""The rooms of both packages: their drawings are those of the contracts and of the code, and there is no circle."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable
from functools import cache
from graphlib import CycleError, TopologicalSorter

import grimp
import pytest

from tests.conftest import ROOT

PACKAGES = ("app", "roam_core", "roam_core.propagate", "roam_core.proposal")
MOST_FILES = 15
"""A folder of the window with more modules would tell more as two."""
TOPS = {"app": {"__main__"}, "roam_core": {"__main__"}}
"""What stands above all rooms of a package and in no drawing of them."""


@cache
def code() -> grimp.ImportGraph:
    """Every import of both packages, those for type checking too."""
    return grimp.build_graph("app", "roam_core", cache_dir=None)


def floors(package: str) -> list[set[str]]:
    """The rooms of a package as its contract names them, top floor first."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    layers = [contract for contract in settings["tool"]["importlinter"]["contracts"] if contract["type"] == "layers"]
    (wanted,) = [
        contract["layers"]
        for contract in layers
        if contract.get("containers") == [package] or contract["layers"][0].startswith(f"{package}.")
    ]
    return [{room.strip().removeprefix(f"{package}.") for room in floor.split("|")} for floor in wanted]


def drawing(package: str) -> dict[str, set[str]]:
    """The arrows of a package's drawing in ARCHITECTURE: which rooms each room points to."""
    page = (ROOT / "docs" / "ARCHITECTURE.md").read_text(encoding="utf-8")
    (text,) = [block for block in re.findall(r"```mermaid\n(.*?)```", page, re.DOTALL) if f"%% {package}\n" in block]
    arrows: dict[str, set[str]] = {}
    for start, ends in re.findall(r"^ {4}(\w+)(?: --> (.+))?$", text, re.MULTILINE):
        arrows.setdefault(start, set()).update(ends.split(" & ") if ends else ())
    return arrows


def room_of(module: str, package: str) -> str:
    """The room of a package that a module lies in; empty for the package itself."""
    return module.removeprefix(package).lstrip(".").partition(".")[0]


def arrows_of(package: str) -> dict[str, set[str]]:
    """Which rooms each room of a package imports."""
    arrows: dict[str, set[str]] = {}
    for module in code().find_descendants(package):
        room = room_of(module, package)
        ours = (name for name in code().find_modules_directly_imported_by(module) if name.startswith(f"{package}."))
        if room not in TOPS.get(package, set()):
            others = {room_of(other, package) for other in ours}
            arrows.setdefault(room, set()).update(others - {"", room})
    return arrows


def reached(arrows: dict[str, set[str]], start: str) -> set[str]:
    """Every room that the arrows lead to from one."""
    found: set[str] = set()
    left = [start]
    while left:
        left += (new := arrows.get(left.pop(), set()) - found)
        found |= new
    return found


def circle(arrows: dict[str, set[str]]) -> list[str]:
    """A way along the arrows that comes back to where it began; empty where there is none."""
    try:
        TopologicalSorter(arrows).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


def upward(graph: grimp.ImportGraph, package: str, layers: Iterable[set[str]]) -> bool:
    """True where something imports what lies on a floor above it."""
    found = graph.find_illegal_dependencies_for_layers(
        layers=[grimp.Layer(*rooms, independent=True) for rooms in layers], containers={package}
    )
    return bool(found)


@pytest.mark.parametrize("package", PACKAGES)
def test_the_drawing_has_the_rooms_of_the_contract(package: str) -> None:
    arrows = drawing(package)
    assert set(arrows) | set().union(*arrows.values()) == set().union(*floors(package))


@pytest.mark.parametrize("package", PACKAGES)
def test_every_arrow_of_the_drawing_is_an_import(package: str) -> None:
    imported = arrows_of(package)
    wrong = [f"{start} --> {end}" for start, ends in drawing(package).items() for end in ends - imported[start]]
    assert wrong == []


@pytest.mark.parametrize("package", PACKAGES)
def test_every_import_between_rooms_follows_from_the_drawing(package: str) -> None:
    drawn = drawing(package)
    missing = [f"{a} --> {b}" for a, others in arrows_of(package).items() for b in others - reached(drawn, a)]
    assert missing == []


@pytest.mark.parametrize("package", PACKAGES)
def test_no_module_imports_itself_by_way_of_others(package: str) -> None:
    modules = {package, *code().find_descendants(package)}
    assert circle({module: code().find_modules_directly_imported_by(module) & modules for module in modules}) == []


def test_a_circle_is_found() -> None:
    assert set(circle({"a": {"b"}, "b": {"c"}, "c": {"a"}, "d": {"a"}})) == {"a", "b", "c"}
    assert circle({"a": {"b", "c"}, "b": {"c"}}) == []


@pytest.mark.parametrize(
    ("importer", "imported"),
    [
        ("app.paint.marks", "app.tools.tool"),
        ("app.files.reopening", "app.shell.main_window"),
        ("app.panels.tracker", "app.timeline.timeline"),
        ("app.model.document", "app.jobs.runner"),
    ],
)
def test_an_import_upward_would_break_the_contract(importer: str, imported: str) -> None:
    graph = grimp.build_graph("app", cache_dir=None)
    assert not upward(graph, "app", floors("app"))
    graph.add_import(importer=importer, imported=imported)
    assert upward(graph, "app", floors("app"))


def test_the_tests_of_the_window_lie_in_folders_of_its_rooms() -> None:
    tests = ROOT / "tests" / "gui"
    folders = {path.parent.relative_to(tests) for path in tests.rglob("test_*.py")}
    assert sorted(str(folder) for folder in folders if not (ROOT / "app" / folder).is_dir()) == []


def test_no_folder_of_the_window_is_too_full_to_be_taken_in() -> None:
    folders = [folder for folder in (ROOT / "app", *(ROOT / "app").rglob("*")) if (folder / "__init__.py").is_file()]
    modules = {folder: [path for path in folder.glob("*.py") if path.stem != "__init__"] for folder in folders}
    assert {folder.name: len(held) for folder, held in modules.items() if len(held) > MOST_FILES} == {}
