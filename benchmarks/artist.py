"""A simulated artist on real shots: edits when tracking forward, keys when filling, keys at regular distances.

Edits: track from the first frame; at the first frame whose matte is under the threshold its true outline is set as the
artist's edit, and tracking goes on from there. Keys: placed greedily, from each the
farthest next one such that every filled frame between meets the threshold (`benchmarks.placement.farthest` states the
search). Both are given per 100 frames; the key that is given on the first frame is no edit, but it is a key. The keys
themselves are the same for every method (`benchmarks.true_keys`).
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks import placement, processes, report, shots
from benchmarks.methods import PEERS, Engine, Method
from benchmarks.shots import Shot
from roam_core.errors import RoamError
from roam_core.params import CONFIGS, DEFAULT_CONFIG, params_for

THRESHOLDS = "0.9,0.8"
GAP = 10
"""Frames from key to key where keys lie at regular distances."""
LENIENCE = 0.05
"""Share of its frames whose own outline may miss the threshold in a shot that is still counted."""

LINEAR = "linear"
SHORT = {"linear interpolation": "linear", "dense flow on the contour": "flow", "GrabCut and box tracker": "GrabCut"}


@dataclass(frozen=True)
class Job:
    """One shot, with every method (by name) under all thresholds."""

    shot: str
    methods: tuple[str, ...]
    thresholds: tuple[float, ...]
    parts: tuple[str, ...]


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `artist` may be told."""
    peers = ", ".join(_short(peer) for peer in PEERS)
    parser.add_argument("--config", metavar="A,B", default=DEFAULT_CONFIG, help=f"of {', '.join(CONFIGS)}")
    parser.add_argument("--peers", metavar="A,B", help=f"of {peers} (default: all; '' for none)")
    parser.add_argument("--shots", metavar="A,B", help="only these shots")
    parser.add_argument("--threshold", metavar="T,U", default=THRESHOLDS, help="IoU that every frame must meet")
    parser.add_argument("--parts", metavar="A,B", default="edits,keys,gap", help="of edits, keys, gap (default: all)")
    parser.add_argument("--publish", action="store_true", help="put the tables into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Let the artist work on every shot with every method, and report."""
    thresholds, parts, methods = _thresholds(given.threshold), _parts(given.parts), _chosen_methods(given)
    chosen = shots.names(given.shots)
    measured = processes.each(_measured, [Job(shot, methods, thresholds, parts) for shot in chosen])
    by_shot = {shot: found for shot, (found, _) in zip(chosen, measured, strict=True)}
    ceilings = {shot: ceiling for shot, (_, ceiling) in zip(chosen, measured, strict=True)}
    result = {"shots": by_shot, "reachable": ceilings}
    reports: dict[str, Callable[[], str]] = {
        "edits": lambda: _counted("edits", by_shot, ceilings, thresholds),
        "keys": lambda: _counted("keys", by_shot, ceilings, thresholds),
        "gap": lambda: _apart(by_shot),
    }
    for part in parts:
        name = f"artist {part}" if given.shots is None else f"artist {part} some"
        report.write(name, reports[part](), result, publish=given.publish and given.shots is None)


def method_of(name: str) -> Method:
    """A peer by its short name, or the engine under the configuration of that name."""
    for peer in PEERS:
        if name == _short(peer):
            return peer
    return Engine(name)


def leaves_out(ceiling: Sequence[float], threshold: float) -> bool:
    """True for a shot whose own outlines miss the threshold on more than `LENIENCE` of its frames."""
    return float(np.mean(np.asarray(ceiling) < threshold)) > LENIENCE


def per_hundred(count: int, frames: int) -> float:
    """A count over that many frames, per 100 frames."""
    return 100.0 * count / frames


def _short(peer: Method) -> str:
    return SHORT.get(peer.name, peer.name.removeprefix("planar, "))


def _chosen_methods(given: argparse.Namespace) -> tuple[str, ...]:
    known = [_short(peer) for peer in PEERS]
    peers = known if given.peers is None else [name for name in given.peers.split(",") if name]
    unknown = sorted(set(peers) - set(known))
    if unknown:
        raise RoamError(f"There is no peer {unknown[0]!r}; choose from {', '.join(known)}.")
    configs = [name for name in given.config.split(",") if name]
    for config in configs:
        params_for(config)
    return (*peers, *configs)


def _thresholds(text: str) -> tuple[float, ...]:
    try:
        values = tuple(float(word) for word in text.split(","))
    except ValueError:
        values = ()
    if not values or not all(0.0 < value <= 1.0 for value in values):
        raise RoamError(f"--threshold {text} is not a list of overlaps between 0 and 1, such as {THRESHOLDS}.")
    return values


def _parts(text: str) -> tuple[str, ...]:
    parts = tuple(text.split(","))
    if not set(parts) <= {"edits", "keys", "gap"}:
        raise RoamError(f"--parts {text} is not a list of edits, keys and gap.")
    return parts


def _measured(job: Job) -> tuple[dict[str, dict[str, Any]], list[float]]:
    """What each method needs on one shot, and what its own outlines can reach."""
    shot = shots.load(job.shot)
    return {name: _needed(method_of(name), shot, job) for name in job.methods}, placement.reachable(shot)


def _needed(method: Method, shot: Shot, job: Job) -> dict[str, Any]:
    """Counts by threshold, the overlaps with regular keys, and the CPU seconds that all of it took."""
    began, found = time.process_time(), dict[str, Any]()
    for threshold in job.thresholds:
        if "edits" in job.parts:
            edits = placement.edits(method, shot, threshold).keys
            found[f"edits {threshold:g}"] = per_hundred(len(edits), len(shot.frames) - 1)
            found[f"edited frames {threshold:g}"] = edits
        if "keys" in job.parts:
            keys = placement.fills(method, shot, threshold).keys
            found[f"keys {threshold:g}"] = per_hundred(len(keys), len(shot.frames))
            found[f"keyed frames {threshold:g}"] = keys
    if "gap" in job.parts:
        frames = placement.every(shot, GAP)
        found["fill"] = placement.filled(method, shot, frames)
        found["forward"] = placement.carried(method, shot, frames, 1)
        found["backward"] = placement.carried(method, shot, frames, -1)
    return found | {"seconds": time.process_time() - began}


def _counted(
    what: str,
    by_shot: dict[str, dict[str, Any]],
    ceilings: dict[str, list[float]],
    thresholds: Sequence[float],
) -> str:
    """Tables of edits or keys per 100 frames, one a threshold: a row a shot, a column a method, the means last."""
    tables = []
    for threshold in thresholds:
        kept = [shot for shot in by_shot if not leaves_out(ceilings[shot], threshold)]
        out = [shot for shot in by_shot if shot not in kept]
        note = f" Left out, as their own outlines miss it on too many frames: {', '.join(out)}." if out else ""
        title = f"{what.capitalize()} per 100 frames, every frame at IoU {threshold:g} or better.{note}"
        methods = list(next(iter(by_shot.values())))
        values = [[by_shot[shot][method][f"{what} {threshold:g}"] for method in methods] for shot in kept]
        tables.append(f"{title}\n\n{_grid(kept, methods, values, '.1f')}" if kept else title)
    return f"{report.circumstances()}.\n\n" + "\n\n".join(tables)


def _apart(by_shot: dict[str, dict[str, Any]]) -> str:
    """The table of keys at regular distances: every method filled; forward and backward means below."""
    methods, chosen = list(next(iter(by_shot.values()))), list(by_shot)
    tables = []
    for way in ("fill", "forward", "backward"):
        values = [[by_shot[shot][method][way] for method in methods] for shot in chosen]
        tables.append(f"{way.capitalize()}:\n\n{_grid(chosen, methods, values, '.3f')}")
    title = f"Keys {GAP} frames apart, mean IoU of the frames between. {report.circumstances()}."
    return "\n\n".join([title, *tables])


def _grid(chosen: Sequence[str], methods: Sequence[str], values: Sequence[Sequence[float]], form: str) -> str:
    rows = [[shot, *(format(value, form) for value in row)] for shot, row in zip(chosen, values, strict=True)]
    means = np.mean(np.asarray(values), axis=0)
    rows.append([f"**mean of {len(chosen)} shots**", *(f"**{format(float(mean), form)}**" for mean in means)])
    if LINEAR in methods:
        rows.append([f"in relation to {LINEAR}", *(f"{mean / means[methods.index(LINEAR)]:.2f}" for mean in means)])
    return report.table(["shot", *methods], rows)
