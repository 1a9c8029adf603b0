"""The reference of the library: it is made without a warning, and has every name that `roam_core` offers."""

from __future__ import annotations

import inspect
import runpy
import subprocess
import sys

import pytest

import roam_core
from roam_core import params
from tests.conftest import ROOT

SOURCE = ROOT / "docs" / "reference"


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The HTML of the reference by page, made as `make docs` makes it: a warning is an error."""
    for library in ("sphinx", "furo"):
        pytest.importorskip(library, reason=f"{library} is not installed (pip install 'roam-roto[docs]')")
    folder = tmp_path_factory.mktemp("reference")
    options = ["--quiet", "--fail-on-warning", "--keep-going", "--doctree-dir", str(folder / "read")]
    command = [sys.executable, "-m", "sphinx", *options, str(SOURCE), str(folder / "made")]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return {path.stem: path.read_text(encoding="utf-8") for path in (folder / "made").glob("*.html")}


def test_every_name_that_the_library_offers_is_described(pages: dict[str, str]) -> None:
    offered = [name for name in roam_core.__all__ if name not in ("__version__", "edit")]
    text = "".join(pages.values())
    assert [name for name in offered if f'id="roam_core.{name}"' not in text] == []
    assert 'id="module-roam_core.roto.edit"' in text


def test_every_room_of_the_parameters_is_described(pages: dict[str, str]) -> None:
    rooms = [name for name in params.__all__ if name.endswith("Params")]
    assert [name for name in rooms if f'.{name}">' not in pages["configurations"]] == []


def test_parameters_stand_with_their_meaning_and_errors_with_their_reason(pages: dict[str, str]) -> None:
    text = pages["plates"]
    assert "<strong>tolerance</strong> – pixels by which the spline may stray" in text
    assert "Raises<span" in text
    assert "----" not in text
    assert '<span class="pre">plate.%04d.exr</span>' in text


def test_a_name_in_a_docstring_leads_to_its_own_description(pages: dict[str, str]) -> None:
    assert 'href="#roam_core.Project.shape"' in pages["shapes"]
    assert 'href="tracking.html#roam_core.RoamError"' in pages["files"]


def test_what_a_module_imports_from_python_needs_no_signature() -> None:
    """Of Python 3.12 and later `typing.TypeVar` has none, as `dict` has none in any."""
    pytest.importorskip("sphinx", reason="sphinx is not installed (pip install 'roam-roto[docs]')")
    signature = runpy.run_path(str(SOURCE / "conf.py"))["signature"]
    assert signature(None, "class", "roam_core.params.paths.dict", dict) is None
    assert signature(None, "function", "roam_core.params.params_for", params.params_for) is not None


def test_methods_of_what_is_offered_have_a_docstring_each() -> None:
    bare = [
        f"{name}.{member}"
        for name in roam_core.__all__
        if inspect.isclass(offered := getattr(roam_core, name))
        for member, value in vars(offered).items()
        if not member.startswith("_") and isinstance(value, property | classmethod | type(run_nothing))
        if not inspect.getdoc(value)
    ]
    assert bare == []


def run_nothing() -> None:
    """A plain function, for its type."""
