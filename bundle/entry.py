"""What a bundle's program runs: `roam`; and what `python -m` does, for the processes that ROAM starts of itself."""

from __future__ import annotations

import runpy
import sys
from multiprocessing import freeze_support

OURS = "roam_core."


def main() -> int:
    """Run `roam`, or `-m MODULE ...` with a module of the engine. Returns the exit code."""
    freeze_support()
    arguments = sys.argv[1:]
    if len(arguments) > 1 and arguments[0] == "-m" and arguments[1].startswith(OURS):
        sys.argv = arguments[1:]
        runpy.run_module(arguments[1], run_name="__main__", alter_sys=True)
        return 0
    from roam_core.cli.program import main as roam

    return roam()


if __name__ == "__main__":
    sys.exit(main())
