"""The words of a command, whose help and version arrive, and files whose names begin with a dash."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Iterator, Sequence
from typing import Any, Never

from roam_core.cli.lines import print_text

FRAMES_BELOW_ZERO = re.compile(r"-\d+[-,x]-?\d[-,x\d]*")
"""Frames of which the first is below 0: `-3--1`, `-3-12x5`, `-3,7`. A number alone argparse knows itself."""


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
        before, after = list(_with_frames(argv[:end])), argv[end + 1 :]
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


def _with_frames(words: Sequence[str]) -> Iterator[str]:
    """Words of which an option and the frames below 0 that follow it are one: argparse takes these for an option."""
    waiting = iter(words)
    for word in waiting:
        follows = next(waiting, None) if word == "--frames" else None
        if follows is None:
            yield word
        elif FRAMES_BELOW_ZERO.fullmatch(follows):
            yield f"{word}={follows}"
        else:
            yield from (word, follows)
