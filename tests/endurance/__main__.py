"""The command line of the endurance tests."""

from __future__ import annotations

import argparse
import sys

from tests.endurance import kill, monkey, plates, soak


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.endurance", description=__doc__)
    commands = parser.add_subparsers(dest="which", required=True)
    for name, module in (("kill", kill), ("monkey", monkey), ("plates", plates), ("soak", soak)):
        command = commands.add_parser(name, help=(module.__doc__ or "").partition("\n")[0])
        module.arguments(command)
        command.set_defaults(run=module.run)
    given = parser.parse_args()
    return int(given.run(given))


if __name__ == "__main__":
    sys.exit(main())
