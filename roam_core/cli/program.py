"""`roam`: hands commands to the command line, and a clip, a project or nothing to the window, where there is one."""

from __future__ import annotations

import argparse
import os
import signal
import sys
from collections.abc import Sequence
from difflib import get_close_matches
from types import ModuleType

from roam_core import __version__
from roam_core.cli.environment import decoding_apart
from roam_core.cli.lines import open_missing_streams
from roam_core.cli.main import COMMANDS, INTERRUPTED, UNHEARD
from roam_core.cli.main import main as command_line
from roam_core.cli.parser import Parser
from roam_core.errors import RoamError
from roam_core.installation import WINDOW_MISSING, window_module

FAILED, BAD_USAGE, SIGNALLED = 1, 2, 128
NEARLY = 0.8
"""How much of a word alone is a command's before it is taken for that, misspelt."""
EPILOG = """commands that need no window:
{commands}
roam COMMAND --help describes each of them.
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run `roam`. Returns the exit code: 0 done, 1 refused or failed, 2 no window or display.

    Bad usage ends in `SystemExit`.
    """
    if argv is None:
        open_missing_streams()
    arguments = list(sys.argv[1:] if argv is None else argv)
    if arguments != ["demo"] and arguments and arguments[0] in COMMANDS:
        return command(arguments) if argv is not None else command_as_process(arguments)
    try:
        path = _path_in(arguments)
    except RoamError as error:  # help or version that cannot be printed
        _tell(str(error))
        return FAILED
    except BrokenPipeError:
        return UNHEARD
    launch = window_module("shell.launch")
    with decoding_apart():
        return _demo(launch) if arguments == ["demo"] else _window(launch, path)


def command(arguments: Sequence[str]) -> int:
    """Run a command of the command line, its pictures decoded apart. Ctrl-C while it tidies up ends it at once."""
    try:
        with decoding_apart():
            return command_line(arguments)
    except KeyboardInterrupt:
        return INTERRUPTED


def command_as_process(arguments: Sequence[str]) -> int:
    """`command`, as all that this process does: what signals say at its very end is no matter for a traceback."""
    open_missing_streams()
    status = command(arguments)
    if status >= SIGNALLED:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    return status


def _window(launch: ModuleType | None, path: str | None) -> int:
    """Open the window, on a clip or project if one was named."""
    if launch is None:
        _tell(WINDOW_MISSING)
        return BAD_USAGE
    try:
        status: int = launch.open_window(path)
    except RoamError as error:
        _tell(str(error))
        return FAILED
    return status


def _demo(launch: ModuleType | None) -> int:
    """The demo in a window; without one, or without a display, it is tracked on the command line."""
    if launch is not None and launch.has_display():
        status: int = launch.open_demo()
        return status
    missing = "The window is not installed" if launch is None else "There is no display"
    _tell(f"{missing}, so the demo is tracked without a window.")
    return command_line(["demo", "--headless"])


def _path_in(arguments: list[str]) -> str | None:
    """The clip or project that is named for the window; bad usage, a misspelt command too, ends here."""
    parser = _parser()
    given, rest = parser.parse_known_args(arguments)
    path: str | None = given.path
    if path is not None and path not in COMMANDS and not os.path.lexists(path):
        if path in ("help", "version"):
            parser.parse_args([f"--{path}"])  # says it, and ends
        # A word alone may be a folder that is elsewhere: it has to be nearer to a command.
        near = get_close_matches(path, COMMANDS, n=1, cutoff=0.6 if rest else NEARLY)
        if rest or near:
            parser.error(f"there is no command {path}{f'; did you mean {near[0]}?' if near else ''}")
    if rest:
        parser.error(f"unrecognized arguments: {' '.join(rest)}")
    return path


def _parser() -> argparse.ArgumentParser:
    listed = "\n".join(f"  {name:<10} {summary}" for name, summary in COMMANDS.items())
    parser = Parser(
        prog="roam",
        usage="roam [CLIP | PROJECT.roam] | roam demo [--headless] | roam COMMAND ...",
        description="Rotoscoping: editable curves carried through a shot. Without a command the window opens.",
        epilog=EPILOG.format(commands=listed),
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("path", nargs="?", metavar="CLIP | PROJECT.roam", help="what the window opens")
    parser.add_argument("--version", action="version", version=f"roam {__version__}", help="print the version")
    return parser


def _tell(sentence: str) -> None:
    sys.stderr.write(f"roam: {sentence}\n")
