"""`roam configs`: say which configurations and dials there are, and with `--params` every number of one."""

from __future__ import annotations

import argparse

from roam_core.cli.lines import print_json
from roam_core.dials import dials_of
from roam_core.params import CONFIGS, DEFAULT_CONFIG, params_for
from roam_core.params.paths import leaves, meaning


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("config", nargs="?", metavar="NAME", help="only this one, as --config takes it")
    parser.add_argument("--params", action="store_true", help=f"list each number by its path (of {DEFAULT_CONFIG})")
    parser.add_argument("--json", action="store_true", help="print one line of JSON a dial, or a number")


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    if arguments.params:
        _print_numbers(arguments.config or DEFAULT_CONFIG, as_json=arguments.json)
        return 0
    for name in [arguments.config] if arguments.config else CONFIGS:
        _print_dials(name, as_json=arguments.json)
    return 0


def _print_dials(config: str, *, as_json: bool) -> None:
    dials = dials_of(params_for(config))
    if not as_json:
        print(f"{config}{' (the default)' if config == DEFAULT_CONFIG else ''}")
    for dial in dials:
        if as_json:
            bounds = {"low": dial.low, "high": dial.high}
            print_json({"config": config, "dial": dial.name, **bounds, "meaning": dial.sentence})
        else:
            print(f"  +{dial.name}=FACTOR  from {dial.low:g} to {dial.high:g}. {dial.sentence}.")


def _print_numbers(config: str, *, as_json: bool) -> None:
    params = params_for(config)
    for path, value in leaves(params):
        told = meaning(params, path)
        if as_json:
            print_json({"config": config, "path": path, "value": value, "meaning": told})
        else:
            print(f"{path}={_written(value)}  {told}")


def _written(value: object) -> str:
    """A value as a configuration's name takes it."""
    if value is None:
        return "none"
    if isinstance(value, tuple):
        return ",".join(f"{each:g}" for each in value)
    return f"{value:g}" if isinstance(value, float) else str(value)
