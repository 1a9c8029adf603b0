"""Tries a packed bundle where nothing of the machine's Python is in reach.

    python -m bundle.check dist/roam-VERSION-SYSTEM-MACHINE.tar.gz [FOLDER]

It is unpacked into FOLDER, which cannot be written to afterwards. On Linux it runs within bubblewrap (`bwrap`), where
that is installed: it then sees the system's libraries, its own folder and an empty home, no network and no other
program. Elsewhere its environment is empty and its home is. What is tried: the version, the demo tracked without a
window, as closely as it must be, with the kernels that are shipped and no others, a process that it starts of itself,
a batch on workers, a job for a farm, and the licences.
"""

from __future__ import annotations

import json
import os
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Sequence
from pathlib import Path

LEAST = 0.9
"""The mean IoU with the demo's true outline that a bundle must reach; a checkout reaches 0.937."""
FEW = 5
"""Kernels that may be compiled for the demo beside those that are shipped."""
LIBRARIES = (
    "lib",
    "lib64",
    "usr/lib/" + (sysconfig.get_config_var("MULTIARCH") or ""),
    "usr/lib64",
    "etc/fonts",
    "usr/share/fonts",
)
"""What of the system a bundle sees within bubblewrap."""


JOBS = """
type: roam.Jobs
version: 1
steps: [{track: {end: 1004}}, render]
jobs: [{name: one, clip: shot, init: demo.roam}, {name: two, clip: shot, init: demo.roam}]
"""
"""A batch of the demo, for two workers."""


class Failed(Exception):
    """The bundle does not do what it must."""


def inside(made: Path) -> Path:
    """The folder of a bundle with its libraries."""
    return made / "Contents" / "Frameworks" if made.suffix == ".app" else made / "_internal"


def program(made: Path) -> Path:
    """The program for commands."""
    if made.suffix == ".app":
        return made / "Contents" / "MacOS" / "roam"
    return made / ("roam.exe" if sys.platform == "win32" else "roam")


def try_archive(archive: Path, folder: Path) -> None:
    """Unpack a bundle and try it; what is wrong is `Failed`."""
    made = unpacked(archive, folder)
    home = folder / "home"
    home.mkdir()
    version = archive.name.split("-")[1]
    said = heard(made, home, ["--version"])
    _require(said.strip() == f"roam {version}", f"--version says {said!r}")
    said = heard(made, home, ["demo", "--headless", "--frames", "shot", "--save", "demo.roam"])
    reached = re.search(r"IoU with the true outline ([0-9.]+) on average", said)
    _require(reached is not None and float(reached[1]) >= LEAST, f"the demo was tracked badly: {said!r}")
    compiled = [path.name for path in home.rglob("*.nbi")]
    if platform.machine() in ("x86_64", "AMD64", "arm64"):
        _require(len(compiled) <= FEW, f"kernels were compiled although they are shipped: {', '.join(compiled)}")
    heard(made, home, ["-m", "roam_core.media.first_picture", "shot/demo.1001.png"])
    heard(made, home, ["export", "demo.roam", "demo.nk", "--to", "nuke"])
    _require((home / "demo.nk").read_text(encoding="utf-8").startswith("#"), "the demo was not exported")
    heard(made, home, ["plugin", "nuke", "scripts"])
    _require((home / "scripts" / "roam" / "menu.py").exists(), "the menu for Nuke was not written")
    (home / "jobs.yaml").write_text(JOBS, encoding="utf-8")
    ended = heard(made, home, ["batch", "jobs.yaml", "--workers", "2", "--json"]).splitlines()
    _require([json.loads(line)["status"] for line in ended] == ["done"] * 4, f"a batch ended badly: {ended}")
    heard(made, home, ["farm", "demo.roam", "--steps", "render"])
    _require(any(made.rglob("LICENCES.txt")), "the licences are missing")
    print(f"The bundle was tried {'within bubblewrap' if _bubblewrap() else 'in an empty environment'}: {said.strip()}")


def unpacked(archive: Path, folder: Path) -> Path:
    """The bundle in a folder that is made anew."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    shutil.unpack_archive(archive, folder, filter=None if archive.suffix == ".zip" else "tar")
    (made,) = folder.iterdir()
    return made / "ROAM.app" if (made / "ROAM.app").exists() else made


def heard(made: Path, home: Path, arguments: Sequence[str]) -> str:
    """What the bundle's program says; what it cannot do is `Failed`."""
    command, environment = confined(made, home, arguments)
    done = subprocess.run(command, cwd=home, env=environment, capture_output=True, text=True, check=False)
    _require(done.returncode == 0, f"roam {' '.join(arguments)} ended with {done.returncode}: {done.stderr}")
    return done.stdout


def confined(
    made: Path, home: Path, arguments: Sequence[str], display: str | None = None
) -> tuple[list[str], dict[str, str]]:
    """The command that runs a bundle's program where nothing else is in reach, and its environment."""
    bubblewrap = _bubblewrap()
    if bubblewrap is None:
        kept = {name: os.environ[name] for name in ("SYSTEMROOT", "TEMP", "TMP") if name in os.environ}
        homes = {"HOME": str(home), "USERPROFILE": str(home), "LOCALAPPDATA": str(home)}
        shown = {"DISPLAY": display} if display else {}
        return [str(program(made)), *arguments], kept | homes | shown
    binds = [word for name in LIBRARIES if (place := Path("/") / name).exists() for word in _bound(place)]
    command = [
        bubblewrap, "--unshare-all", "--die-with-parent", "--clearenv", *binds,
        "--dev", "/dev", "--proc", "/proc", "--tmpfs", "/tmp",
        "--ro-bind", str(made), "/opt/roam", "--bind", str(home), "/home/artist", "--chdir", "/home/artist",
        "--setenv", "HOME", "/home/artist",
    ]  # fmt: skip
    if display is not None:
        socket = f"/tmp/.X11-unix/X{display.lstrip(':')}"
        command += ["--ro-bind", socket, socket, "--setenv", "DISPLAY", display]
    return [*command, "/opt/roam/roam", *arguments], {}


def _bound(place: Path) -> list[str]:
    if place.is_symlink():
        return ["--symlink", str(place.readlink()), str(place)]
    return ["--ro-bind", str(place), str(place)]


def _bubblewrap() -> str | None:
    return shutil.which("bwrap") if sys.platform == "linux" else None


def _require(holds: bool, sentence: str) -> None:
    if not holds:
        raise Failed(sentence)


if __name__ == "__main__":
    try_archive(Path(sys.argv[1]), Path(sys.argv[2] if len(sys.argv) > 2 else "build/bundle/tried"))
