"""What an installed ROAM is: the wheel's packages, its command, and that it runs away from the repository."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from zipfile import ZipFile

import pytest

import roam_core
from tests.conftest import ROOT

STRANGERS = ("app", "resources")
"""Names that packages of other people may have; in the repository they are folders of ours."""
PACKAGES = ("roam_core", "roam_window")
LOAD_ALL = """
import importlib, pkgutil, sys
for name in {packages}:
    package = importlib.import_module(name)
    for module in pkgutil.walk_packages(package.__path__, name + "."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    print(package.__file__)
print(*{{name.partition(".")[0] for name in sys.modules}} & {{*{strangers}}})
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> ZipFile:
    """The wheel of the working tree, built without a network."""
    pytest.importorskip("hatchling", reason="hatchling is not installed (pip install 'roam-roto[dev]')")
    folder = tmp_path_factory.mktemp("wheel")
    options = ["--no-build-isolation", "--no-deps", "--no-index", "--disable-pip-version-check", "--quiet"]
    command = [sys.executable, "-m", "pip", "wheel", *options, "--wheel-dir", str(folder), str(ROOT)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    (path,) = folder.glob("roam_roto-*.whl")
    return ZipFile(path)


@pytest.fixture(scope="module")
def installed(wheel: ZipFile, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel unpacked, as an installer does it."""
    folder = tmp_path_factory.mktemp("site-packages")
    wheel.extractall(folder)
    return folder


def run(installed: Path, program: str) -> list[str]:
    """The lines that a program prints that finds the wheel before all else, in a folder that is not the repository."""
    environment = os.environ | {"PYTHONPATH": str(installed)}
    command = [sys.executable, "-c", program]
    done = subprocess.run(command, cwd=installed, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def text_of(wheel: ZipFile, name: str) -> str:
    (path,) = [path for path in wheel.namelist() if path.endswith(f".dist-info/{name}")]
    return wheel.read(path).decode("utf-8")


def test_a_wheel_takes_no_name_that_others_may_want(wheel: ZipFile) -> None:
    tops = {path.split("/")[0] for path in wheel.namelist()}
    assert {top for top in tops if not top.endswith(".dist-info")} == {"roam_core", "roam_window"}


def test_a_wheel_holds_all_code_and_all_resources(wheel: ZipFile) -> None:
    held = set(wheel.namelist())
    places = {"roam_core": "roam_core", "app": "roam_window", "resources": "roam_core/resources"}
    for folder, place in places.items():
        files = [path for path in (ROOT / folder).rglob("*") if path.is_file() and "__pycache__" not in path.parts]
        assert len(files) > 20
        assert {f"{place}/{path.relative_to(ROOT / folder).as_posix()}" for path in files} - held == set()
    assert not [path for path in held if path.startswith(("tests/", "benchmarks/", "scripts/", "docs/"))]


def test_the_metadata_say_what_the_program_says(wheel: ZipFile) -> None:
    metadata = text_of(wheel, "METADATA")
    assert f"\nVersion: {roam_core.__version__}\n" in metadata
    assert text_of(wheel, "entry_points.txt").strip() == "[console_scripts]\nroam = roam_core.cli.program:main"
    needed = re.findall(r"^Requires-Dist: ([\w-]+)(?:.*extra == '(\w+)')?", metadata, flags=re.MULTILINE)
    window = {name.casefold() for name, extra in needed if extra == "window"}
    assert window == {"pyside6-essentials", "pyqtgraph"}
    assert window.isdisjoint(name.casefold() for name, extra in needed if extra != "window")


def test_every_module_of_a_wheel_finds_the_others_there(installed: Path) -> None:
    *homes, strangers = run(installed, LOAD_ALL.format(packages=PACKAGES, strangers=STRANGERS))
    assert homes == [str(installed / package / "__init__.py") for package in PACKAGES]
    assert strangers == ""


def test_a_wheel_finds_what_is_shipped_with_it(installed: Path) -> None:
    program = (
        "from roam_core.installation import demo, resource; print(demo.__name__); print(resource('icons', 'eye.svg'))"
    )
    assert run(installed, program) == ["roam_core.resources.demo", str(installed / "roam_core/resources/icons/eye.svg")]
