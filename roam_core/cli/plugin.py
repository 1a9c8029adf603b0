"""`roam plugin PROGRAM FOLDER`: write the scripts that put a menu ROAM into Nuke, Natron or Blender."""

from __future__ import annotations

import argparse
import shutil
import sys
from importlib.resources.abc import Traversable
from pathlib import Path

from roam_core.atomic_write import make_folder, write_atomically
from roam_core.cli.lines import print_json
from roam_core.cli.paths import path_word
from roam_core.errors import RoamError
from roam_core.installation import BUNDLE, resource

NEXT = {
    "nuke": "Add this line to the file init.py in the folder .nuke of your home: nuke.pluginAddPath({folder!r})",
    "natron": "Add {folder} to the search path of PyPlugs in Natron's preferences, and start Natron again.",
    "blender": "Enable the add-on ROAM in Blender's preferences; FOLDER is scripts/addons of Blender's user folder.",
}
"""By program what the artist does then."""
BRIDGE, NAMED = "roam_bridge.py", "program.txt"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("program", choices=sorted(NEXT))
    parser.add_argument("folder", type=path_word, metavar="FOLDER", help="gets a folder roam with the scripts")
    parser.add_argument("--json", action="store_true", help="print a line of JSON: the files, and what to do next")
    parser.add_argument("--overwrite", action="store_true", help="write over a folder roam that is there")


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    folder = (arguments.folder / "roam").absolute()
    if folder.exists() and not arguments.overwrite:
        raise RoamError(f"{folder} is there already; --overwrite writes the scripts over those in it.")
    contents = {script.name: script.read_bytes() for script in _scripts(arguments.program)}
    if (roam := _own_program()) is not None:
        contents[NAMED] = f"{roam}\n".encode()
    _write(folder, contents)
    then = NEXT[arguments.program].format(folder=folder.as_posix())
    if arguments.json:
        print_json({"files": sorted(str(path) for path in folder.iterdir()), "next": then})
        return 0
    print(f"Wrote the menu for {arguments.program.capitalize()} to {folder}.")
    print(then)
    return 0


def _write(folder: Path, contents: dict[str, bytes]) -> None:
    """Write all files; where one cannot be, a folder that is new goes again: half of them stop the other program."""
    is_new = not folder.exists()
    try:
        make_folder(folder)
        for name, content in contents.items():
            write_atomically(folder / name, content)
    except RoamError:
        if is_new:
            shutil.rmtree(folder, ignore_errors=True)
        raise


def _scripts(program: str) -> list[Traversable]:
    plugins = resource("plugins")
    own = [path for path in plugins.joinpath(program).iterdir() if path.name.endswith(".py")]
    return [*own, plugins.joinpath(BRIDGE)]


def _own_program() -> Path | None:
    """The program that runs: what the scripts are to start."""
    if BUNDLE is not None:
        return Path(sys.executable)
    own = sys.argv[0] if Path(sys.argv[0]).stem == "roam" else ""  # another `roam` may come first on the path
    # On Windows pip's program leaves its `.exe` out of the word, and Python 3.11 does not look for it there.
    found = shutil.which(own) or shutil.which(f"{own}.exe") or shutil.which("roam")
    return Path(found).absolute() if found else None
