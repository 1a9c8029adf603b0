"""Paths among the words of a command."""

from __future__ import annotations

import argparse
from pathlib import Path


def path_word(word: str) -> Path:
    """The path that a word names. None for an empty one, as a variable that is not set gives: that is no folder."""
    if not word:
        raise argparse.ArgumentTypeError("it is empty; name a file or folder")
    return Path(word)
