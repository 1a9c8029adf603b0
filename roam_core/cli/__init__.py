"""The command line: one file a command. `main` is what `roam` and `python -m roam_core` run."""

from roam_core.cli.main import COMMANDS, main

__all__ = ["COMMANDS", "main"]
