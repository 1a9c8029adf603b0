"""ROAM speaks to no network: no module of it asks for one, and a window at work opens no socket."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import ROOT

NETWORK = {
    "socket", "socketserver", "ssl", "http", "urllib", "urllib3", "ftplib", "smtplib", "poplib", "imaplib", "telnetlib",
    "xmlrpc", "asyncio", "requests", "httpx", "aiohttp", "webbrowser", "QtNetwork", "QtWebSockets", "QtWebEngineCore",
}  # fmt: skip
PROGRAM = [path for room in ("app", "roam_core", "resources") for path in sorted((ROOT / room).rglob("*.py"))]
AT_WORK = """
import sys
opened = []
sys.addaudithook(lambda event, _: opened.append(event) if event.startswith("socket.") else None)
from pathlib import Path
from PySide6.QtWidgets import QApplication
from app.shell.main_window import MainWindow
application = QApplication([])
folder = Path(sys.argv[1])
window = MainWindow(folder / "journal")
window.defects.install()
window.show()
window.files.save(folder / "a.roam")
while not window.saver.is_idle:
    application.processEvents()
window.defects.report_now()
window.recovering.show_all()
while not window.writer.is_idle:
    application.processEvents()
window._leave()
while window.isVisible():
    application.processEvents()
assert (folder / "a.roam").exists()
print(sorted(set(opened)))
"""


def imported(tree: ast.Module) -> set[str]:
    """Every name that the import statements of a module hold, part by part."""
    names: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names |= {part for alias in node.names for part in alias.name.split(".")}
        elif isinstance(node, ast.ImportFrom):
            names |= {*(node.module or "").split("."), *(alias.name for alias in node.names)}
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name | ast.Attribute) and node.args:
            called = node.func.id if isinstance(node.func, ast.Name) else node.func.attr
            if called in ("import_module", "__import__") and isinstance(node.args[0], ast.Constant):
                names |= set(str(node.args[0].value).split("."))
    return names


@pytest.mark.parametrize("line", ["import socket", "from urllib.request import urlopen", "import_module('ssl')"])
def test_an_import_of_the_network_is_seen(line: str) -> None:
    assert imported(ast.parse(line)) & NETWORK


def test_no_module_asks_for_the_network() -> None:
    found = {str(path.relative_to(ROOT)): imported(ast.parse(path.read_text(encoding="utf-8"))) for path in PROGRAM}
    assert {path: names & NETWORK for path, names in found.items() if names & NETWORK} == {}


def test_a_window_at_work_opens_no_socket(tmp_path: Path) -> None:
    environment = os.environ | {"PYTHONPATH": str(ROOT), "QT_QPA_PLATFORM": "offscreen"}
    command = [sys.executable, "-c", AT_WORK, str(tmp_path)]
    result = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120, check=False)
    assert result.returncode == 0, result.stderr
    assert result.stdout.strip() == "[]"
