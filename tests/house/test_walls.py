"""The walls of the house: who may import whom, and that the engine stands without Qt."""

from __future__ import annotations

import ast
import re
import subprocess
import sys

import pytest

from tests.conftest import ROOT

WITHOUT_WINDOW = """
import sys
{imports}
loaded = sorted(name for name in sys.modules if name.partition(".")[0] in ("PySide6", "shiboken6", "pyqtgraph", "app"))
sys.exit(", ".join(loaded[:5]) or 0)
"""


def run_python(program: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)


def test_the_contracts_of_the_import_linter_hold() -> None:
    program = "import sys; from importlinter.cli import lint_imports_command; sys.exit(lint_imports_command())"
    done = run_python(program)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "0 broken" in done.stdout


@pytest.mark.parametrize(
    "imports",
    [
        "import roam_core",
        "import roam_core; [getattr(roam_core, name) for name in roam_core.__all__]",
        "import importlib, pkgutil, roam_core\n"
        "for module in pkgutil.walk_packages(roam_core.__path__, 'roam_core.'):\n"
        "    if not module.name.endswith('__main__'): importlib.import_module(module.name)",
    ],
    ids=["the package", "its doors", "every module"],
)
def test_the_engine_leaves_qt_unloaded(imports: str) -> None:
    done = run_python(WITHOUT_WINDOW.format(imports=imports))
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("imports", ["import roam_core.roto.file", "from roam_core import Project, edit, load_project"])
def test_reading_a_project_does_not_wait_for_the_solver(imports: str) -> None:
    done = run_python(f"import sys; {imports}; sys.exit(int('numba' in sys.modules or 'cv2' in sys.modules))")
    assert done.returncode == 0, done.stderr


def test_an_unknown_door_is_an_attribute_error() -> None:
    import roam_core

    with pytest.raises(AttributeError, match="no attribute 'Brush'"):
        _ = roam_core.Brush
    assert [name for name in roam_core.__all__ if getattr(roam_core, name, None) is None] == []
    assert set(roam_core.__all__) <= set(dir(roam_core))


@pytest.mark.parametrize("package", ["app", "resources"])
def test_a_package_that_a_wheel_renames_does_not_say_its_own_name(package: str) -> None:
    """Its modules import one another relatively, or the wheel would look for a stranger's package of that name."""
    named = []
    for path in sorted((ROOT / package).rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            modules = [node.module or ""] if isinstance(node, ast.ImportFrom) and node.level == 0 else []
            modules += [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            named += [f"{path}: {name}" for name in modules if name.partition(".")[0] in ("app", "resources")]
    assert named == []


@pytest.mark.parametrize(
    "statement",
    [
        "import pickle; pickle.loads(b'')",
        "import marshal; marshal.loads(b'')",
        "eval('1')",
        "exec('1')",
        "import subprocess; subprocess.run('true', shell=True)",
        "import os; os.system('true')",
    ],
)
@pytest.mark.parametrize("room", ["app", "roam_core", "scripts", "tests"])
def test_the_linter_bans_whatever_would_run_what_a_file_says(statement: str, room: str) -> None:
    command = [sys.executable, "-m", "ruff", "check", "--stdin-filename", f"{room}/made_up.py", "-"]
    done = subprocess.run(command, input=statement + "\n", cwd=ROOT, capture_output=True, text=True, check=False)
    assert re.search(r"\bS[0-9]{3}\b", done.stdout), done.stdout + done.stderr


def test_types_of_arrays_stand_in_one_module() -> None:
    paths = [path for room in ("roam_core", "app", "benchmarks", "tests") for path in (ROOT / room).rglob("*.py")]
    named = re.compile(r"^[A-Z]\w* = NDArray\[(Any|np\.(float|int|uint|bool))", re.MULTILINE)
    own = [str(path.relative_to(ROOT)) for path in paths if named.search(path.read_text(encoding="utf-8"))]
    assert own == ["roam_core/arrays.py"]
