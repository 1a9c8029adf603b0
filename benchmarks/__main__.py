"""The command line of the benchmarks: without a command both run, the shots only where they are."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from benchmarks import davis, stages
from roam_core.errors import RoamError
from roam_core.params import CONFIGS, params_for


def main(argv: Sequence[str] | None = None) -> int:
    """Run the benchmarks that were asked for. Returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("--config", help=f"{' | '.join(CONFIGS)} (default: each of them)")
    parser.add_argument("--publish", action="store_true", help="put the tables into docs/BENCHMARKS.md")
    parser.add_argument("--frames", type=int, default=24, metavar="N", help="stages: frames of the demo that are timed")
    parser.add_argument("--shots", metavar="A,B", help="davis: only these shots")
    parser.add_argument("which", nargs="?", choices=["stages", "davis"], help="default: both")
    arguments = parser.parse_args(argv)
    try:
        for config in [arguments.config] if arguments.config else CONFIGS:
            params_for(config)
            if arguments.which != "davis":
                stages.run(config, arguments.frames, publish=arguments.publish)
            if arguments.which == "davis" or (arguments.which is None and davis.is_present()):
                shots = arguments.shots.split(",") if arguments.shots else None
                davis.run(config, shots, publish=arguments.publish)
        if arguments.which is None and not davis.is_present():
            print(f"\n{davis.ABSENT}", file=sys.stderr)
    except RoamError as error:
        print(f"benchmarks: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
