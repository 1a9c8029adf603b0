"""Leave-one-shot-out tuning: for each shot the parameters that did best on all the others, measured on restarts.

Fields are given by name, with the values to try: `--field mu=.03,.06 --field region.bias=-.3,-.2`. All combinations
are tried, or with `--draws N` so many of them drawn at random (the present parameters are always among them).
"""

from __future__ import annotations

import argparse
import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import numpy as np

from benchmarks import processes, report, restarts, shots
from benchmarks.variants import field_of, with_field
from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.params import CONFIGS, DEFAULT_CONFIG, RoamParams, params_for

Values = Mapping[str, Any]
GAP = 40
"""Frames from the start of a run to the next: fewer runs than `davis --restarts` makes, for there are many trials."""


@dataclass(frozen=True)
class Held:
    """What leave-one-shot-out came to: for each shot which trial was chosen without it, and the mean IoU over shots."""

    chosen: tuple[int, ...]
    mean: float


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `tune` may be told."""
    parser.add_argument("--config", metavar="NAME", default=DEFAULT_CONFIG, help=f"one of {', '.join(CONFIGS)}")
    parser.add_argument(
        "--field", action="append", required=True, metavar="NAME=V,W", help="a field of RoamParams and values to try"
    )
    parser.add_argument("--draws", type=int, metavar="N", help="so many combinations at random instead of all")
    parser.add_argument("--length", type=int, default=restarts.LENGTH, metavar="N", help="frames of a run")
    parser.add_argument("--gap", type=int, default=GAP, metavar="N", help="frames from one start to the next")
    parser.add_argument("--shots", metavar="A,B", help="only these shots")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Try, choose and report."""
    params = params_for(given.config)
    trials = combinations(dict(_field(params, text) for text in given.field), params, given.draws)
    chosen = shots.names(given.shots)
    variants = [reduce(lambda p, item: with_field(p, *item), trial.items(), params) for trial in trials]
    jobs = [restarts.Job(shot, each, given.length, given.gap) for shot in chosen for each in variants]
    found = [float(np.mean(runs)) for runs in processes.each(restarts.of_job, jobs, unit="trial")]
    scores = np.array(found).reshape(len(chosen), len(trials))
    held = leave_one_out(scores)
    text = _table(scores, trials, held, chosen, given.config)
    result = {"trials": trials, "shots": chosen, "scores": scores.tolist(), "chosen": held.chosen, "mean": held.mean}
    report.write(f"tune {given.config}", text, result, publish=given.publish)


def leave_one_out(scores: Array) -> Held:
    """Choose for each row (a shot) of `scores (S, T)` the trial with the best mean over the other rows.

    Of equals the first is chosen: the present parameters, when they come first.
    """
    if len(scores) < 2:
        raise RoamError("Leaving one shot out wants at least two; name more with --shots.")
    others = (scores.sum(axis=0) - scores) / (len(scores) - 1)
    chosen = others.argmax(axis=1)
    return Held(tuple(int(k) for k in chosen), float(scores[np.arange(len(scores)), chosen].mean()))


def combinations(fields: Mapping[str, Sequence[Any]], params: RoamParams, draws: int | None) -> list[dict[str, Any]]:
    """The trials: the present values first, then all other combinations, or `draws` of them (seeded)."""
    present = {name: field_of(params, name) for name in fields}
    every = [dict(zip(fields, values, strict=True)) for values in itertools.product(*fields.values())]
    every = [trial for trial in every if trial != present]
    if draws is not None and draws < len(every):
        picked = np.random.default_rng(0).permutation(len(every))[:draws]
        every = [every[k] for k in sorted(picked)]
    return [present, *every]


def _field(params: RoamParams, text: str) -> tuple[str, list[Any]]:
    """`name=v,w` as the name and its values, of the type that the field has."""
    name, equals, words = text.partition("=")
    present = field_of(params, name)
    if not equals or not isinstance(present, int | float | str):
        raise RoamError(f"--field {text} is not NAME=V,W for a field that holds a number or a word.")
    try:
        return name, [type(present)(word) for word in words.split(",")]
    except ValueError:
        raise RoamError(f"--field {text}: {name} holds a {type(present).__name__}.") from None


def _table(scores: Array, trials: Sequence[Values], held: Held, chosen: Sequence[str], config: str) -> str:
    rows = []
    for k in np.argsort(-scores.mean(axis=0), kind="stable"):
        without = [shot for shot, trial in zip(chosen, held.chosen, strict=True) if trial == k]
        values = [f"{value:g}" if isinstance(value, float) else str(value) for value in trials[k].values()]
        rows.append([*values, f"{scores[:, k].mean():.3f}", str(len(without)), "present" if k == 0 else ""])
    head = [*trials[0], "mean IoU", "shots it was chosen for", ""]
    title = f"Configuration `{config}`, restarts on {len(chosen)} shots, best first. {report.circumstances()}."
    summary = f"Leave-one-shot-out: {held.mean:.3f}; present parameters: {scores[:, 0].mean():.3f}."
    return f"{title}\n\n{report.table(head, rows)}\n\n{summary}"
