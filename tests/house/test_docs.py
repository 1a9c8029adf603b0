"""The documents keep their word: links and paths exist, names resolve, commands are there, the example runs."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from functools import cache
from importlib import import_module
from pathlib import Path

import cv2
import numpy as np
import pytest

from benchmarks import report
from benchmarks.__main__ import BENCHMARKS
from roam_core.cli import COMMANDS, main, program
from roam_core.cli.configuring import configured
from roam_core.params import CONFIGS
from tests.conftest import ROOT

PAGES = [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").glob("*.md"))]
README = (ROOT / "README.md").read_text(encoding="utf-8")
ROOMS = ("app", "benchmarks", "docs", "resources", "roam_core", "scripts", "tests")
OURS = re.compile(rf"(?:{'|'.join(ROOMS)})/[\w./*-]*")
"""How a path of the repository begins when a document names it in code type."""


def name_of(page: Path) -> str:
    return page.name


def in_code_type(page: Path) -> list[str]:
    """What stands between backquotes, outside of blocks."""
    prose = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    return re.findall(r"`([^`\n]+)`", prose)


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_links_lead_somewhere(page: Path) -> None:
    targets = re.findall(r"\]\(([^)#\s]+)[^)]*\)", page.read_text(encoding="utf-8"))
    local = [target for target in targets if not target.startswith(("https://", "http://"))]
    assert [target for target in local if not (page.parent / target).exists()] == []


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_paths_exist(page: Path) -> None:
    paths = [code.partition("::")[0] for code in in_code_type(page) if OURS.fullmatch(code.partition("::")[0])]
    assert [path for path in paths if not (ROOT / path).exists()] == []


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_tests_that_are_named_exist(page: Path) -> None:
    named = [code.split("::") for code in in_code_type(page) if "::" in code]
    missing = [test for path, test in named if f"def {test}(" not in (ROOT / path).read_text(encoding="utf-8")]
    assert missing == []


def test_every_recipe_names_its_tests() -> None:
    recipes = re.split(r"^## ", (ROOT / "docs" / "RECIPES.md").read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]
    assert recipes
    assert [recipe.splitlines()[0] for recipe in recipes if "::test_" not in recipe] == []


def resolves(name: str) -> bool:
    """True for the dotted name of a module, or of what lies in one."""
    parts = name.split(".")
    for cut in range(len(parts), 0, -1):
        try:
            found: object = import_module(".".join(parts[:cut]))
        except ModuleNotFoundError:
            continue
        for attribute in parts[cut:]:
            found = getattr(found, attribute, None)
        return found is not None
    return False


def test_a_name_that_is_not_there_does_not_resolve() -> None:
    assert resolves("roam_core.roto.edit.set_key")
    assert not resolves("roam_core.roto.edit.no_such_verb")
    assert not resolves("roam_core.no_such_room.edit")


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_names_of_the_code_resolve(page: Path) -> None:
    """Those of the engine's rooms are also written without `roam_core`."""
    rooms = "|".join(sorted(folder.parent.name for folder in (ROOT / "roam_core").glob("*/__init__.py")))
    dotted = [code for code in in_code_type(page) if re.fullmatch(rf"(app|roam_core|{rooms})(\.\w+)+", code)]
    names = [name if name.startswith(("app.", "roam_core.")) else f"roam_core.{name}" for name in dotted]
    assert [name for name in names if not resolves(name)] == []


def test_modules_that_the_tables_of_rooms_name_are_there() -> None:
    """The table spoke of `desk` when the module had another name: a name alone resolves nowhere."""
    page = (ROOT / "docs" / "ARCHITECTURE.md").read_text(encoding="utf-8")
    modules = {path.stem for room in ("app", "roam_core") for path in (ROOT / room).rglob("*.py")}
    folders = {path.parent.name for room in ("app", "roam_core") for path in (ROOT / room).rglob("__init__.py")}
    rows = re.findall(r"^\| `(?:app|roam_core|propagate|proposal)/.*$", page, flags=re.MULTILINE)
    named = {name for row in rows for name in re.findall(r"`([a-z_]+)`", row)}
    assert len(named) > 100
    assert sorted(named - modules - folders) == ["full"]  # a configuration


@cache
def words_of_classes() -> dict[str, set[str]]:
    """By the name of a class, in any module, all words that stand in it."""
    words: dict[str, set[str]] = {}
    for path in (path for room in ("app", "roam_core") for path in (ROOT / room).rglob("*.py")):
        for name, body in re.findall(r"^class (\w+)(.*?)(?=^\S|\Z)", path.read_text("utf-8"), re.DOTALL | re.MULTILINE):
            words.setdefault(name, set()).update(re.findall(r"\w+", body))
    return words


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_members_of_classes_are_there(page: Path) -> None:
    """A recipe spoke of `MainWindow._panel_column` when it was gone: without its module a name resolves nowhere."""
    named = {code for code in in_code_type(page) if re.fullmatch(r"[A-Z]\w*[a-z]\w*\.[a-z_]\w*", code)}
    pairs = {name: name.split(".") for name in named}
    assert sorted(name for name, (owner, member) in pairs.items() if member not in words_of_classes()[owner]) == []


def test_the_walk_names_what_it_walks_through() -> None:
    page = (ROOT / "docs" / "ARCHITECTURE.md").read_text(encoding="utf-8")
    assert len(set(re.findall(r"`((?:app|roam_core)(?:\.\w+){2,})`", page))) >= 15


def commands_in(text: str) -> set[str]:
    """The commands of `roam` that a text shows at the beginning of a line or in code type."""
    return set(re.findall(r"(?:^ {4}|`)roam ([a-z]+)(?= |`|$)", text, flags=re.MULTILINE))


def test_commands_of_the_readme_are_those_of_the_program(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        program.main(["--help"])
    shown = capsys.readouterr().out
    assert commands_in(README) == set(COMMANDS)
    assert [command for command in COMMANDS if not re.search(rf"^  {command}\b", shown, flags=re.MULTILINE)] == []


@pytest.mark.parametrize("command", list(COMMANDS))
def test_options_of_the_readme_exist(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    lines = [line for line in README.splitlines() if line.startswith(f"    roam {command} ")]
    written = {option for line in lines for option in re.findall(r"--[a-z-]+", line)}
    with pytest.raises(SystemExit):
        main([command, "--help"])
    assert sorted(written - set(re.findall(r"--[a-z-]+", capsys.readouterr().out))) == []


@pytest.mark.parametrize("text", [*PAGES, ROOT / "roam_core/studio/fields.py"], ids=name_of)
def test_dials_that_are_named_are_there(text: Path) -> None:
    config = rf"\b(?:{'|'.join(CONFIGS)})(?:\+[a-z_.]+=[\d.]+)+"
    for named in set(re.findall(config, text.read_text(encoding="utf-8"))):
        configured(named.rstrip("."))


def test_the_targets_of_make_that_documents_name_exist() -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    text = "".join(page.read_text(encoding="utf-8") for page in PAGES)
    named = set(re.findall(r"(?:^ {4}|`)make ([a-z]+)", text, flags=re.MULTILINE))
    assert {"run", "test", "bench"} <= named
    assert [target for target in named if not re.search(rf"^{target}:", makefile, flags=re.MULTILINE)] == []


@pytest.fixture
def shot(tmp_path: Path) -> Path:
    """A folder in which `shot` is a small clip of a gliding disc and `mask.png` its first mask."""
    pictures = tmp_path / "shot"
    pictures.mkdir()
    for frame in range(4):
        mask = np.zeros((60, 80), dtype=np.uint8)
        cv2.circle(mask, (30 + 2 * frame, 28 + frame), 14, 255, -1)
        picture = np.where(mask[..., None] > 0, np.uint8(200), np.uint8(60)).repeat(3, axis=2)
        assert cv2.imwrite(str(pictures / f"plate.{1001 + frame}.png"), picture)
        if frame == 0:
            assert cv2.imwrite(str(tmp_path / "mask.png"), mask)
    return tmp_path


def test_the_example_of_the_python_interface_runs(shot: Path) -> None:
    (example,) = re.findall(r"^```python\n(.*?)^```", README, flags=re.DOTALL | re.MULTILINE)
    command = [sys.executable, "-W", "error", "-c", example]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    result = subprocess.run(command, cwd=shot, env=environment, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    assert [line.split()[0] for line in result.stdout.splitlines()] == ["1002", "1003", "1004"]
    assert (shot / "shot.roam").is_file()
    assert "\nRoto {\n" in (shot / "shot.nk").read_text(encoding="ascii")


def test_every_command_has_an_example_in_python() -> None:
    page = (ROOT / "docs" / "STUDIO.md").read_text(encoding="utf-8")
    examples = "\n".join(re.findall(r"^```python\n(.*?)^```", page, flags=re.DOTALL | re.MULTILINE))
    by_library = {"batch": "driver.run(", "farm": "template_of("}
    shown = {name for name in COMMANDS if by_library.get(name, f'main(["{name}"') in examples}
    assert set(COMMANDS) - shown == {"prepare", "demo"}  # one compiles, the other is there to be looked at
    assert "warm_up(" in page


def test_the_examples_of_the_studio_run(shot: Path) -> None:
    pytest.importorskip("distributed", reason="Dask is not installed (pip install 'roam-roto[studio]')")
    page = (ROOT / "docs" / "STUDIO.md").read_text(encoding="utf-8")
    said = []
    for k, example in enumerate(re.findall(r"^```python\n(.*?)^```", page, flags=re.DOTALL | re.MULTILINE)):
        script = shot / f"example{k}.py"  # a file: workers load it
        script.write_text(example, encoding="utf-8")
        environment = os.environ | {"PYTHONPATH": str(ROOT)}
        command = [sys.executable, str(script)]
        done = subprocess.run(command, cwd=shot, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        said.append(done.stdout.splitlines()[-1:])
    steps = "['1-fill spans', '1-fill join', '2-render']"
    assert said[:3] == [["{'done': 1} report.html"], ["done kept"], [steps]]
    assert said[3] == ["(60, 80, 3)"]
    assert len(said) == 5


def test_tables_are_renewed_in_their_place() -> None:
    page = "a\n<!-- x -->\nold\n<!-- end of x -->\nb\n<!-- x y -->\nkept\n<!-- end of x y -->\n"
    renewed = report.with_block(page, "x", "new")
    assert renewed == page.replace("old", "new")
    assert report.with_block(page, "z", "new") == f"{page}\n<!-- z -->\nnew\n<!-- end of z -->\n"


def test_the_page_of_benchmarks_says_what_each_of_them_measures() -> None:
    listed = report.PAGE.read_text(encoding="utf-8").partition("## Quality")[0]
    assert set(re.findall(r"^\| `(\w+)` \|", listed, flags=re.MULTILINE)) == set(BENCHMARKS)


def test_published_tables_are_of_configurations_that_exist() -> None:
    page = report.PAGE.read_text(encoding="utf-8")
    names = re.findall(r"^<!-- (?!end of )(.+) -->$", page, flags=re.MULTILINE)
    assert sorted(names) == sorted(re.findall(r"^<!-- end of (.+) -->$", page, flags=re.MULTILINE))
    assert {name.split()[0] for name in names} <= set(BENCHMARKS)
    assert {name.split()[1] for name in names if name.split()[0] in ("stages", "davis")} <= {*CONFIGS, "summary"}
