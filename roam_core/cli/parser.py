"""The words of a command, whose help and version arrive."""

from __future__ import annotations

import argparse
import sys
from typing import Any

from roam_core.cli.lines import print_text


class Parser(argparse.ArgumentParser):
    """A parser that tells where its help or version cannot be printed; argparse passes over that, and says all is well.

    What it prints raises as `lines.print_text`.
    """

    def _print_message(self, message: str, file: Any = None) -> None:
        if file is sys.stdout and message:
            print_text(message)
        else:
            super()._print_message(message, file)
