"""The stand-alone bundle as far as it can be judged without building one: its program, licences, and menu entry."""

from __future__ import annotations

import configparser
import json
import runpy
import shutil
import subprocess
import sys
import tarfile
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from xml.etree import ElementTree

import pytest

import roam_core
from bundle import check, entry, licences
from tests.conftest import ROOT

LINUX = ROOT / "bundle" / "linux"


@pytest.mark.parametrize(
    ("licence", "may"),
    [
        ("MIT", True),
        ("LGPL-3.0-only OR GPL-2.0-only OR GPL-3.0-only", True),
        ("GPL-3.0-or-later WITH GCC-exception-3.1", True),
        ("MPL-2.0 AND MIT", True),
        ("GPL-3.0-or-later", False),
        ("GPLv3", False),
        ("AGPL-3.0-only", False),
        ("MIT AND GPL-2.0-only", False),
        ("GNU General Public License v3 (GPLv3)", False),
        ("GNU Lesser General Public License v2.1", True),
        ("MIT OR GPL-2.0-only", True),
    ],
)
def test_what_is_under_the_gpl_alone_may_not_be_shipped(licence: str, may: bool) -> None:
    assert licences.may_be_shipped(licence) is may


def test_all_that_the_system_adds_may_be_shipped() -> None:
    assert licences.SYSTEM
    assert [name for name, licence in licences.SYSTEM.items() if not licences.may_be_shipped(licence)] == []


def test_a_library_of_unknown_licence_ends_the_build(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(licences, "package_of", lambda path: "libreadline8")
    with pytest.raises(licences.Refused, match="libreadline8, whose licence is not known"):
        licences.parts([("libreadline.so.8", "/usr/lib/libreadline.so.8")])


def test_each_text_stands_once_with_all_its_parts() -> None:
    made = licences.document([licences.Part(name, "1", "MIT", ("the text",)) for name in ("one", "two")])
    assert made.count("the text") == 1
    assert "\none, two\n" in made


def test_the_licences_that_parts_do_not_bring_lie_here() -> None:
    names = {name for texts in licences.WITHOUT_TEXT.values() for name in texts} | {"LGPL-2.1.txt"}
    assert all(len((licences.TEXTS / name).read_text(encoding="utf-8")) > 5000 for name in names)


def test_the_program_is_roam(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "argv", ["roam", "--version"])
    with pytest.raises(SystemExit, match="0"):
        entry.main()
    assert capsys.readouterr().out == f"roam {roam_core.__version__}\n"


def test_its_own_processes_run_modules_of_the_engine_and_no_others(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    nothing = tmp_path / "nothing.mp4"
    monkeypatch.setattr(sys, "argv", ["roam", "-m", "roam_core.media.first_picture", str(nothing)])
    assert entry.main() == 0
    monkeypatch.setattr(sys, "argv", ["roam", "-m", "http.server"])
    with pytest.raises(SystemExit, match="2"):
        entry.main()
    assert "usage: roam" in capsys.readouterr().err


@dataclass
class Made:
    """What a specification asks PyInstaller for: each call's named values, by what is called."""

    calls: dict[str, list[dict[str, Any]]]

    @classmethod
    def on(cls, system: str, monkeypatch: pytest.MonkeyPatch, folder: Path) -> Made:
        """Run `bundle/roam.spec` as PyInstaller does on a system, with stand-ins for its classes."""
        made = cls({})

        def stand_in(name: str) -> Any:
            def call(*values: Any, **named: Any) -> Any:
                made.calls.setdefault(name, []).append(named | {"values": values})
                return SimpleNamespace(pure=[("a", "a.py", "PYMODULE")], binaries=[], datas=[], scripts=[])

            return call

        for module, names in {
            "PyInstaller.building.api": ["COLLECT", "EXE", "PYZ"],
            "PyInstaller.building.build_main": ["Analysis"],
            "PyInstaller.building.osx": ["BUNDLE"],
        }.items():
            monkeypatch.setitem(sys.modules, module, SimpleNamespace(**{name: stand_in(name) for name in names}))
        hooks = SimpleNamespace(
            collect_data_files=lambda name, **_: [(name, name)], collect_submodules=lambda name, **_: [f"{name}.*"]
        )
        monkeypatch.setitem(sys.modules, "PyInstaller.utils.hooks", hooks)
        monkeypatch.setitem(sys.modules, "PyInstaller.depend.bindepend", SimpleNamespace(get_imports=lambda path: []))
        monkeypatch.setattr(sys, "path", list(sys.path))
        monkeypatch.setattr(sys, "platform", system)
        spec = ROOT / "bundle" / "roam.spec"
        given = {"SPECPATH": str(spec.parent), "workpath": str(folder / "pyinstaller" / "roam")}
        runpy.run_path(str(spec), given)
        return made


@pytest.mark.parametrize("system", ["linux", "win32", "darwin"])
def test_the_specification_is_one_for_every_system(
    system: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    made = Made.on(system, monkeypatch, tmp_path).calls
    (analysis,) = made["Analysis"]
    assert {"roam_core.*", "roam_window.*", "distributed.*", "openjd.*", "opentimelineio.*"} < {
        *analysis["hiddenimports"]
    }
    assert json.loads((tmp_path / "parts.json").read_text()) == [["a", "a.py"]]
    programs = {each["name"]: each for each in made["EXE"]}
    assert programs["roam"]["console"]
    icon = {"linux": None, "win32": ".ico", "darwin": ".icns"}[system]
    assert {each["icon"] and Path(each["icon"]).suffix for each in programs.values()} == {icon}
    if system == "linux":
        assert set(programs) == {"roam"}
    else:  # what a double click starts opens no console
        assert not programs["roam-window"]["console"]
    bundles = made.get("BUNDLE", [])
    assert len(bundles) == (system == "darwin")
    for each in bundles:
        told = each["info_plist"]
        assert told["CFBundleExecutable"] in programs
        assert told["CFBundleDocumentTypes"][0]["CFBundleTypeExtensions"] == ["roam"]
        assert each["version"] == roam_core.__version__


def test_the_menu_entry_opens_the_type_that_is_declared() -> None:
    desktop = configparser.ConfigParser(interpolation=None)
    desktop.optionxform = str  # type: ignore[assignment,method-assign]
    desktop.read(LINUX / "roam.desktop", encoding="utf-8")
    shown = desktop["Desktop Entry"]
    kind = ElementTree.parse(LINUX / "roam.xml").getroot()[0]
    assert shown["MimeType"].split(";")[0] == kind.get("type")
    assert [glob.get("pattern") for glob in kind.findall("{*}glob")] == ["*.roam"]
    assert (shown["Exec"], shown["Type"], shown["Terminal"]) == ("roam %f", "Application", "false")


@pytest.mark.skipif(sys.platform != "linux", reason="the installer is for Linux desktops")
def test_the_installer_puts_everything_in_place_and_takes_it_away(tmp_path: Path) -> None:
    made, home = tmp_path / "roam-0", tmp_path / "a home"
    shutil.copytree(LINUX, made / "desktop", ignore=shutil.ignore_patterns("install"))
    shutil.copy2(LINUX / "install", made)
    shutil.copy2(ROOT / "bundle" / "icon.svg", made / "desktop" / "roam.svg")
    (made / "desktop" / "roam-32.png").write_bytes(b"")
    (made / "roam").write_text("#!/bin/sh\necho started\n", encoding="utf-8")
    (made / "roam").chmod(0o755)

    def install(*words: str) -> None:
        subprocess.run([str(made / "install"), *words, str(home)], check=True, capture_output=True)

    install()
    install()  # again, over itself
    started = subprocess.run([str(home / "bin" / "roam")], capture_output=True, text=True, check=True)
    assert started.stdout == "started\n"
    entry_text = (home / "share" / "applications" / "roam.desktop").read_text(encoding="utf-8")
    assert f'Exec="{home}/bin/roam" %f' in entry_text
    assert (home / "share" / "icons" / "hicolor" / "32x32" / "apps" / "roam.png").exists()
    install("--remove")
    assert list(home.rglob("*roam*")) == []


@pytest.mark.skipif(sys.platform != "linux", reason="the installer is for Linux desktops")
def test_however_its_folder_is_named_an_installed_bundle_does_not_take_itself_away(tmp_path: Path) -> None:
    home, link = tmp_path / "home", tmp_path / "link"
    installed = home / "lib" / "roam"
    shutil.copytree(LINUX, installed / "desktop", ignore=shutil.ignore_patterns("install"))
    shutil.copy2(LINUX / "install", installed)
    link.symlink_to(home, target_is_directory=True)
    for name in (str(home), f"{home}/", "home", "./home/../home", str(link)):
        done = subprocess.run(
            [str(installed / "install"), name], cwd=tmp_path, capture_output=True, text=True, check=False
        )
        assert (done.returncode, "is installed" in done.stderr) == (1, True)
        assert (installed / "install").exists()


@pytest.mark.skipif(sys.platform != "linux", reason="the installer is for Linux desktops")
def test_the_menu_entry_of_a_relative_folder_leads_there_from_everywhere(tmp_path: Path) -> None:
    made = tmp_path / "roam-0"
    shutil.copytree(LINUX, made / "desktop", ignore=shutil.ignore_patterns("install"))
    shutil.copy2(LINUX / "install", made)
    shutil.copy2(ROOT / "bundle" / "icon.svg", made / "desktop" / "roam.svg")
    (made / "desktop" / "roam-32.png").write_bytes(b"")
    subprocess.run([str(made / "install"), "home"], cwd=tmp_path, capture_output=True, check=True)
    entry = (tmp_path / "home" / "share" / "applications" / "roam.desktop").read_text(encoding="utf-8")
    assert f'Exec="{tmp_path}/home/bin/roam" %f' in entry


def test_a_bundle_that_does_not_do_what_it_must_is_refused(tmp_path: Path) -> None:
    if sys.platform != "linux":
        pytest.skip("the stand-in for a program is a shell script")
    made = tmp_path / "roam-0.1.0-linux-x86_64"
    (made / "_internal").mkdir(parents=True)
    (made / "roam").write_text("#!/bin/sh\necho roam 9.9.9\n", encoding="utf-8")
    (made / "roam").chmod(0o755)
    archive = tmp_path / f"{made.name}.tar.gz"
    with tarfile.open(archive, "w:gz") as pack:
        pack.add(made, arcname=made.name)
    with pytest.raises(check.Failed):
        check.try_archive(archive, tmp_path / "tried")
