"""The words of a command, whose help and version arrive, and files whose names begin with a dash."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from typing import Any, Never

from roam_core.cli.lines import print_text


class Parser(argparse.ArgumentParser):
    """A parser that tells where its help or version cannot be printed; argparse passes over that, and says all is well.

    What it prints raises as `lines.print_text`.
    """

    _dashed = ""

    def words(self, argv: Sequence[str]) -> argparse.Namespace:
        """What a command is told. What is optional may stand between what is not: `roam review P.roam --sheet OUT`.

        What follows a `--` are no options: argparse forgets that where the two are mixed.
        """
        end = argv.index("--") if "--" in argv else len(argv)
        before, after = list(argv[:end]), argv[end + 1 :]
        self._dashed = next((word for word in before if word.startswith("-") and os.path.lexists(word)), "")
        return self.parse_intermixed_args([*before, *(f"./{word}" if word.startswith("-") else word for word in after)])

    def error(self, message: str) -> Never:
        """End with the usage and what is wrong; with how a file is given that was taken for an option."""
        hint = f"; give the file {self._dashed} as ./{self._dashed}" if self._dashed else ""
        super().error(message + hint)

    def _print_message(self, message: str, file: Any = None) -> None:
        if file is sys.stdout and message:
            print_text(message)
        else:
            super()._print_message(message, file)
