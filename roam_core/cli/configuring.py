"""The configuration that a command was asked for, and what is to be said about its name."""

from __future__ import annotations

import sys

from roam_core.params import RoamParams, departed, params_for


def configured(config: str) -> RoamParams:
    """The parameters that `--config` names; that a dial in it is offered no more is said on the standard error.

    Raises
    ------
    RoamError
        when there is no such configuration, dial or parameter.
    """
    params = params_for(config)
    for sentence in departed(config):
        print(f"roam: {sentence}", file=sys.stderr)
    return params
