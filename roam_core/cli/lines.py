"""What goes to the standard output: lines of JSON, and that it really goes there."""

from __future__ import annotations

import errno
import json
import os
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress

from roam_core.errors import RoamError
from roam_core.system_errors import reason_of


def print_json(line: Mapping[str, object]) -> None:
    """Print one object as a line, now. Raises as `flush_output`."""
    with _told():
        print(json.dumps(line), flush=True)


def print_text(text: str) -> None:
    """Print a text that has its own ends of lines, now. Raises as `flush_output`."""
    with _told():
        sys.stdout.write(text)
        sys.stdout.flush()


def flush_output() -> None:
    """Have everything that was printed arrive.

    Raises
    ------
    BrokenPipeError
        when the reader went away.
    RoamError
        when it cannot be written for another reason, such as a full disk.
    """
    with _told():
        sys.stdout.flush()


def open_missing_streams() -> None:
    """Have the null device stand for each standard stream that this process was started without, as some daemons do.

    Otherwise the next files that are opened have their numbers, and what libraries print goes into those files.
    """
    for number, name, mode in ((0, "stdin", "r"), (1, "stdout", "w"), (2, "stderr", "w")):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # has the lowest number that is free: this one
            os.set_inheritable(number, True)
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(number, mode, encoding="utf-8", errors="backslashreplace", closefd=False))


@contextmanager
def _told() -> Iterator[None]:
    try:
        yield
    except OSError as error:
        discard_output()
        if is_unheard(error):
            raise BrokenPipeError from None
        raise RoamError(f"The standard output cannot be written: {reason_of(error)}.") from None


def is_unheard(error: OSError) -> bool:
    """Whether nobody reads the output any more: of a pipe that was closed Windows says "invalid argument"."""
    is_closed = sys.platform == "win32" and error.errno == errno.EINVAL and error.filename is None
    return is_closed or isinstance(error, BrokenPipeError)


def discard_output() -> None:
    """Send what is still to be printed nowhere: the interpreter would fail on it once more when it ends."""
    with suppress(OSError):  # an output that is no file of the system
        output = sys.stdout.fileno()
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, output)
        os.close(nowhere)
