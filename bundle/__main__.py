"""Builds the stand-alone bundle of this system: `make bundle`, or `python -m bundle`.

The wheel is built, installed with its extras into an environment of its own, and PyInstaller collects what it needs
(`bundle/roam.spec`). The bundle then compiles its kernels, gets the licences of its parts and, on Linux, what a desktop
asks for; it is packed, and what was packed is unpacked elsewhere and tried (`bundle.check`).
"""

from __future__ import annotations

import json
import os
import platform
import shutil
import subprocess
import sys
import tarfile
from collections.abc import Sequence
from pathlib import Path
from time import perf_counter

from bundle import check

ROOT = Path(__file__).parents[1]
WORK = ROOT / "build" / "bundle"
TARGET = ROOT / "dist"
HERE = Path(__file__).parent
ON_WINDOWS = sys.platform == "win32"


def build() -> Path:
    """Build the bundle of this system; the archive that it is packed in."""
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    python = _environment(_wheel())
    _say("Drawing the icons")
    _run(sys.executable, "-m", "bundle.icons", WORK)
    _say("Collecting the program and its libraries")
    places = ["--distpath", WORK / "dist", "--workpath", WORK / "pyinstaller"]
    # Not from the checkout, whose packages would be found before those of the wheel: neither by the folder that this
    # runs in, nor by that of the program, which PyInstaller searches too.
    shutil.copy2(HERE / "entry.py", WORK)
    _run(python, "-m", "PyInstaller", "--noconfirm", "--log-level", "WARN", *places, HERE / "roam.spec", folder=WORK)
    _require_the_wheel()
    made = WORK / "dist" / ("ROAM.app" if sys.platform == "darwin" else "roam")
    _say("Compiling the kernels")
    kernels = check.inside(made) / "kernels"
    kernels.mkdir()
    for command in (["prepare"], ["demo", "--headless", "--frames", WORK / "demo"]):
        _run(check.program(made), *command, environment={"NUMBA_CACHE_DIR": str(kernels)})
    _say("Collecting the licences")
    texts = made / "Contents" / "Resources" if sys.platform == "darwin" else made
    _run(python, "-m", "bundle.licences", WORK / "parts.json", texts / "LICENCES.txt")
    if sys.platform == "linux":
        _add_desktop(made)
    return _packed(made)


def main() -> int:
    """Build, pack, unpack elsewhere, and try what came out. Returns the exit code."""
    began = perf_counter()
    archive = build()
    _say(f"Trying {archive.name}")
    check.try_archive(archive, WORK / "tried")
    print(f"{archive.relative_to(ROOT)}: {archive.stat().st_size / 1e6:.0f} MB, in {perf_counter() - began:.0f} s")
    return 0


def _wheel() -> Path:
    _say("Building the wheel")
    options = ["--no-deps", "--no-build-isolation", "--disable-pip-version-check", "--quiet"]
    _run(sys.executable, "-m", "pip", "wheel", *options, "--wheel-dir", WORK / "wheel", ROOT)
    (wheel,) = (WORK / "wheel").glob("roam_roto-*.whl")
    return wheel


def _environment(wheel: Path) -> Path:
    """The interpreter of an environment with the wheel, its extras and PyInstaller, and nothing of a developer's."""
    _say("Installing it with its libraries")
    folder = WORK / "environment"
    _run(sys.executable, "-m", "venv", folder)
    python = folder / ("Scripts/python.exe" if ON_WINDOWS else "bin/python")
    options = ["--quiet", "--disable-pip-version-check", "--constraint", ROOT / "constraints.txt"]
    _run(python, "-m", "pip", "install", *options, f"{wheel}[window,studio]", "pyinstaller")
    return python


def _add_desktop(made: Path) -> None:
    """The menu entry, the type of `.roam` files, the icons, and what installs them."""
    shutil.copytree(HERE / "linux", made / "desktop", ignore=shutil.ignore_patterns("install"))
    shutil.copy2(HERE / "linux" / "install", made / "install")
    shutil.copy2(HERE / "icon.svg", made / "desktop" / "roam.svg")
    for picture in WORK.glob("roam-*.png"):
        shutil.copy2(picture, made / "desktop")


def _packed(made: Path) -> Path:
    """The archive of the bundle, named by version, system and machine."""
    version = (WORK / "wheel").glob("*.whl").__next__().name.split("-")[1]
    system = {"darwin": "macos", "win32": "windows"}.get(sys.platform, sys.platform)
    name = f"roam-{version}-{system}-{platform.machine().lower()}"
    TARGET.mkdir(exist_ok=True)
    _say(f"Packing {name}")
    if ON_WINDOWS:
        named = made.rename(made.with_name(name))
        return Path(shutil.make_archive(str(TARGET / name), "zip", named.parent, name))
    archive = TARGET / f"{name}.tar.gz"
    with tarfile.open(archive, "w:gz", compresslevel=6) as pack:
        pack.add(made, arcname=f"{name}/{made.name}" if sys.platform == "darwin" else name)
    return archive


def _require_the_wheel() -> None:
    """End where a file of the checkout was collected: it is the wheel that is to run."""
    sources = [Path(source) for _, source in json.loads((WORK / "parts.json").read_text(encoding="utf-8"))]
    if strays := [path for path in sources if path.is_relative_to(ROOT) and not path.is_relative_to(WORK)]:
        sys.exit(f"The bundle was not built: {strays[0]} of the checkout was collected, not the wheel.")


def _run(*command: object, environment: dict[str, str] | None = None, folder: Path = ROOT) -> None:
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"} | (environment or {})
    done = subprocess.run([str(word) for word in command], cwd=folder, env=environment, check=False)
    if done.returncode != 0:
        sys.exit(f"The bundle was not built: {_named(command)} ended with {done.returncode}.")


def _named(command: Sequence[object]) -> str:
    return " ".join(Path(str(word)).name for word in command[:3])


def _say(sentence: str) -> None:
    print(f"{sentence} ...", flush=True)


if __name__ == "__main__":
    sys.exit(main())
