"""Choosing the command, and turning what goes wrong into one sentence and an exit code."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib import import_module
from io import TextIOWrapper
from keyword import iskeyword
from types import ModuleType

from roam_core import __version__
from roam_core.cancel import Cancelled
from roam_core.cli.environment import take_threads
from roam_core.cli.lines import discard_output, flush_output, is_unheard
from roam_core.cli.parser import Parser
from roam_core.cli.stopping import Stopped, raising
from roam_core.errors import RoamError
from roam_core.system_errors import reason_of

COMMANDS: dict[str, str] = {
    "track": "carry shapes through a clip",
    "fill": "fill in shapes between their keys",
    "plane": "follow the surface under shapes",
    "soften": "make shapes as soft as the edge in the plate",
    "steady": "move tracked and filled keys so that their outlines boil less",
    "shift": "put everything of a project on other frames, as its plate was numbered anew",
    "export": "write a project's shapes for another program",
    "import": "read another program's shapes into a project",
    "render": "write a project's mattes",
    "review": "write a movie or contact sheet of a shot; list frames worth a look",
    "explain": "say what each term contributes to a tracked key",
    "info": "say what is in a project or clip",
    "plugin": "write ROAM's menu for Nuke, Natron or Blender",
    "prepare": "compile the engine ahead of the first track",
    "configs": "list the engine's configurations, dials and parameters",
    "batch": "carry out many jobs on many shots, on all cores or on a studio's machines",
    "farm": "write a project's work as a job for a render farm",
    "demo": "track the built-in demo shot",
}
"""Commands and what they do; each lives in the module of its name beside this one (a keyword's ends in `_`)."""

FAILED, INTERRUPTED, UNHEARD = 1, 130, 141
STOPPED = "roam: stopped; what was finished is kept."


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command. Returns the exit code: 0 done, 1 refused or failed; a command that a signal ended gives 128 and
    its number: 130 interrupted, 143 terminated, 129 hung up, 141 output that nobody reads. Bad usage, and a word such
    as `--help`, end in `SystemExit`, of 2 and of 0."""
    # A name of a file may hold what the terminal cannot show: it is escaped, not an error.
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    try:
        with raising():
            status = _run(sys.argv[1:] if argv is None else list(argv))
            flush_output()
            return status
    except RoamError as error:
        print(f"roam: {error}", file=sys.stderr)
        return FAILED
    except (KeyboardInterrupt, Cancelled):
        print(STOPPED, file=sys.stderr)
        return INTERRUPTED
    except Stopped as stopped:
        with suppress(OSError):  # the terminal may be gone
            print(STOPPED, file=sys.stderr)
        return stopped.exit_code
    except OSError as error:
        # What reads and writes files tells of them by itself; what is left is mostly the output of a command.
        discard_output()
        if is_unheard(error):  # the reader of our output went away: nobody is left to be told
            return UNHEARD
        what = f"{error.filename} cannot be used" if error.filename else "The standard output cannot be written"
        print(f"roam: {what}: {reason_of(error)}.", file=sys.stderr)
        return FAILED


def _run(argv: list[str]) -> int:
    if argv and argv[0] in COMMANDS:
        return _run_command(argv[0], argv[1:])
    parser = Parser(prog="roam", description="Rotoscoping: editable curves carried through a shot.")
    parser.add_argument("--version", action="version", version=f"roam {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="command")
    for name, summary in COMMANDS.items():
        commands.add_parser(name, help=summary)
    parser.parse_args(argv)  # says what there is, and ends
    return FAILED


def _run_command(name: str, argv: list[str]) -> int:
    """Run a command. Only its module is loaded: `roam info` does not wait for the solver."""
    module = _module(name)
    summary = COMMANDS[name]
    parser = Parser(prog=f"roam {name}", description=f"{summary[0].upper()}{summary[1:]}.")
    module.add_arguments(parser)
    arguments = parser.words(argv)
    take_threads()
    try:
        status: int = module.run(arguments)
    except (RoamError, Cancelled, OSError):
        raise
    except Exception as error:
        if words := _numbers_in(arguments):
            said = " ".join(str(error).split()) or type(error).__name__
            raise RoamError(
                f"The engine cannot compute with {' and '.join(words)} ({said}). Give other values, or leave them out."
            ) from error
        raise
    return status


def _numbers_in(arguments: argparse.Namespace) -> list[str]:
    """What of the engine's numbers `--config` gives values: each is in its bounds, and may be none to compute with."""
    if not isinstance(config := getattr(arguments, "config", None), str):
        return []
    from roam_core.params import numbers_in  # a command without a configuration does not wait for them

    return numbers_in(config)


def _module(command: str) -> ModuleType:
    return import_module(f"roam_core.cli.{command}{'_' if iskeyword(command) else ''}")
