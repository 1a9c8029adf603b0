"""The command line of the benchmarks: one command a benchmark; without one the window, the stages and the shots."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from types import ModuleType

from benchmarks import (
    altered,
    artist,
    batch,
    coming_in,
    composites,
    confidence,
    davis,
    drift,
    fewest_keys,
    first_start,
    kernels,
    key_optimum,
    masks_in,
    mattes,
    paper,
    part_sheets,
    parts,
    pieces,
    plates,
    saving,
    scaling,
    shots,
    sizes,
    speed,
    stages,
    tune,
    window,
)
from roam_core.errors import RoamError
from roam_core.params import DEFAULT_CONFIG

BENCHMARKS: dict[str, ModuleType] = {
    "stages": stages,
    "speed": speed,
    "davis": davis,
    "artist": artist,
    "drift": drift,
    "sizes": sizes,
    "confidence": confidence,
    "tune": tune,
    "paper": paper,
    "scaling": scaling,
    "kernels": kernels,
    "parts": parts,
    "part_sheets": part_sheets,
    "pieces": pieces,
    "coming_in": coming_in,
    "altered": altered,
    "composites": composites,
    "plates": plates,
    "mattes": mattes,
    "keys": fewest_keys,
    "key_optimum": key_optimum,
    "masks_in": masks_in,
    "window": window,
    "first_start": first_start,
    "saving": saving,
    "batch": batch,
}
"""Each module has `arguments(parser)` and `run(arguments)`; the first line of its text is its help."""

USUAL = (("window",), ("stages",), ("davis", "--config", DEFAULT_CONFIG))
"""What runs without a command: some six minutes with the shots."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the benchmark that was asked for. Returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("--publish", action="store_true", help="without a command: renew the tables of the page")
    commands = parser.add_subparsers(dest="which", metavar="BENCHMARK")
    for name, module in BENCHMARKS.items():
        purpose = (module.__doc__ or "").partition("\n")[0]
        module.arguments(commands.add_parser(name, help=purpose, description=module.__doc__))
    given = parser.parse_args(argv)
    try:
        if given.which is not None:
            BENCHMARKS[given.which].run(given)
            return 0
        for words in USUAL:
            if words[0] == "davis" and not shots.is_present():
                print(f"\n{shots.ABSENT}", file=sys.stderr)
                continue
            BENCHMARKS[words[0]].run(parser.parse_args([*words, *(["--publish"] if given.publish else [])]))
    except RoamError as error:
        print(f"benchmarks: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
