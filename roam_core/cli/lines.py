"""Lines of JSON on the standard output."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping

from roam_core.errors import RoamError


def print_json(line: Mapping[str, object]) -> None:
    """Print one object as a line.

    Raises
    ------
    BrokenPipeError
        when the reader went away.
    RoamError
        when the line cannot be written for another reason, such as a full disk.
    """
    try:
        print(json.dumps(line), flush=True)
    except BrokenPipeError:
        discard_output()
        raise
    except OSError as error:
        discard_output()
        raise RoamError(f"The standard output cannot be written: {error.strerror}.") from None


def discard_output() -> None:
    """Send what is still to be printed nowhere: the interpreter would fail on it once more when it ends."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)
