"""`--overwrite`: the user's word that files may be written over that are not of ROAM's making."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

from roam_core.interchange.targets import kept_aside
from roam_core.roto import Project, file


def add_overwrite(parser: argparse.ArgumentParser) -> None:
    """Declare the option."""
    parser.add_argument(
        "--overwrite",
        action="store_true",
        help="write over files that ROAM did not make (never over what the command reads)",
    )


def project_writer(target: Path, rewritten: Path | None = None) -> Callable[[Project], None]:
    """A function that writes projects to `target`.

    Another project that is there is kept aside first, once, and the user is told; not so `rewritten`, the project that
    the command works on.
    """
    is_own = rewritten is not None and target.exists() and target.samefile(rewritten)
    is_first = not is_own

    def write(project: Project) -> None:
        nonlocal is_first
        if is_first and (kept := kept_aside(target)) is not None:
            print(f"The project that was {target} is kept as {kept.name}.", file=sys.stderr)
        is_first = False
        file.save(project, target)

    return write
