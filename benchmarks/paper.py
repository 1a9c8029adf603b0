"""The paper's own tables and plots, rerun: ablation, timing of the steps, warping, window of moves, energy by round.

Tables stand beside the paper's; plots go to `out/benchmarks` as PNG. Ablation and warping are measured on restarts
(`benchmarks.restarts`), as one long run is chaotic.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from benchmarks import paper_plots, paper_rows, processes, report, restarts, shots
from benchmarks.restarts import Job
from benchmarks.shots import first_shapes
from benchmarks.stopwatch import Stopwatch
from benchmarks.variants import ABLATION, WARPS, Variant
from roam_core import track
from roam_core.appearance.edge_models import EdgeModels
from roam_core.energy import curve, joint_total
from roam_core.errors import RoamError
from roam_core.inference.landmark_dp import best_star
from roam_core.kernels.cyclic_viterbi import cyclic_viterbi
from roam_core.params import CONFIGS
from roam_core.propagate import warm_up
from roam_core.propagate.curves.reshaping import reshape

STEPS: dict[str, Sequence[Callable[..., Any]]] = {
    "DP contour": (cyclic_viterbi,),
    "DP landmarks": (best_star, joint_total.leaf_table),
    "local models edge terms": (
        EdgeModels.log_densities,
        curve.pairwise_competition,
        curve.pairwise_global,
        curve.pairwise_ribbon,
    ),
    "other terms": (curve.pairwise_gradient, curve.pairwise_l2, joint_total.node_table, joint_total.energies),
    "reparametrisation": (reshape,),
}
"""The steps of the paper's timing table, and what does them here; the global term shares the local models' table."""
REST, ALL = "pre-warp, features, learning", "all of it"
TIMED = 20
"""Frames of each shot that the timing looks at."""
PARTS = ("ablation", "timing", "warping", "window", "energy")
GAP = 40
"""Frames from the start of a run to the next, in the tables made of restarts."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `paper` may be told."""
    parser.add_argument("--parts", metavar="A,B", default=",".join(PARTS), help=f"of {', '.join(PARTS)}")
    parser.add_argument("--shots", metavar="A,B", help="tables: only these shots; plots: of these (default: three)")
    parser.add_argument("--gap", type=int, default=GAP, metavar="N", help="frames from one restart to the next")
    parser.add_argument("--publish", action="store_true", help="put the tables into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Rerun what was asked for."""
    parts = given.parts.split(",")
    if not set(parts) <= set(PARTS):
        raise RoamError(f"--parts {given.parts} is not a list of {', '.join(PARTS)}.")
    chosen = shots.names(given.shots)
    shown = chosen if given.shots else list(paper_plots.SHOWN)
    work: dict[str, Callable[[], tuple[str, dict[str, Any]]]] = {
        "ablation": partial(_ablation, chosen, given.gap),
        "timing": partial(_timing, chosen),
        "warping": partial(_warping, chosen, given.gap),
        "window": partial(paper_plots.windows, shown),
        "energy": partial(paper_plots.energies, shown),
    }
    for part in parts:
        text, result = work[part]()
        name = f"paper {part}" if given.shots is None else f"paper {part} some"
        report.write(name, text, result, publish=given.publish and given.shots is None)


def compared(variants: Sequence[Variant], chosen: Sequence[str], gap: int) -> dict[str, list[tuple[float, float]]]:
    """For each variant its IoU and accuracy on every shot, means over the shot's restarts."""
    jobs = [Job(shot, variant.params, restarts.LENGTH, gap) for variant in variants for shot in chosen]
    found = iter(processes.each(_scored, jobs, unit="run"))
    return {variant.name: [next(found) for _ in chosen] for variant in variants}


def _scored(job: Job) -> tuple[float, float]:
    runs = restarts.scored(shots.load(job.shot), job.config, job.length, job.gap)
    iou, accuracy = np.mean(runs, axis=0)
    return float(iou), float(accuracy)


def _ablation(chosen: Sequence[str], gap: int) -> tuple[str, dict[str, Any]]:
    """Every configuration taken apart; the change against the whole configuration beside it."""
    scores = compared(ABLATION, chosen, gap)
    means = {name: np.mean(values, axis=0) for name, values in scores.items()}
    rows = []
    for variant in ABLATION:
        iou, accuracy = means[variant.name]
        change = f"{iou - means[variant.config][0]:+.3f}" if variant.changes else ""
        theirs = paper_rows.DAVIS.get(variant.name)
        beside = [theirs.training, theirs.validation] if theirs else ["", ""]
        rows.append([variant.name, f"{iou:.3f}", change, f"{accuracy:.3f}", *beside])
    head = ["variant", "IoU", "against the whole", "accuracy", "paper, training", "paper, validation"]
    title = (
        f"Ablation: restarts of {restarts.LENGTH} frames, every {gap} frames, {len(chosen)} shots; the paper's rows "
        f"are whole shots. {report.circumstances()}."
    )
    return f"{title}\n\n{report.table(head, rows)}", {"shots": list(chosen), "scores": scores}


def _warping(chosen: Sequence[str], gap: int) -> tuple[str, dict[str, Any]]:
    """The ways of carrying the curve to the next frame."""
    scores = compared(WARPS, chosen, gap)
    rows = [[name, *(f"{value:.3f}" for value in np.mean(values, axis=0)[::-1])] for name, values in scores.items()]
    rows += [[f"the paper's full model, {name}", accuracy, iou] for name, accuracy, iou in paper_rows.WARPING]
    title = (
        f"Pre-warp under `medium`: restarts of {restarts.LENGTH} frames, every {gap} frames, {len(chosen)} shots. "
        f"{report.circumstances()}."
    )
    text = f"{title}\n\n{report.table(['pre-warp', 'accuracy', 'IoU'], rows)}"
    return text, {"shots": list(chosen), "scores": scores}


def _timing(chosen: Sequence[str]) -> tuple[str, dict[str, Any]]:
    """Seconds of the steps of `full`, least, greatest and mean over shots, beside the paper's mean."""
    laps = processes.each(timed, chosen)
    rows = []
    for step in (*STEPS, REST, ALL):
        means = [float(np.mean([lap.get(step, 0.0) for lap in shot])) for shot in laps]
        theirs = paper_rows.TIMING.get(step, paper_rows.DAVIS["full"].seconds if step == ALL else "-")
        cells = [f"{value:.4f}" for value in (min(means), max(means), np.mean(means))]
        rows.append([step, *cells, theirs])
    title = (
        f"Seconds a frame of the steps of `full`, one thread, {TIMED} frames of {len(chosen)} shots. "
        f"{report.circumstances()}."
    )
    head = ["step", "least shot", "greatest shot", "mean", "paper, mean"]
    return f"{title}\n\n{report.table(head, rows)}", {"shots": list(chosen), "laps": laps}


def timed(name: str, config: str = "full") -> list[dict[str, float]]:
    """Processor seconds by step of every frame of a shot's beginning."""
    assert config in CONFIGS
    warm_up(config)
    shot, watch, laps = shots.load(name), Stopwatch(), list[dict[str, float]]()
    frames = shot.frames[: TIMED + 1]
    with watch.watching(STEPS):
        began = watch.now()
        for _ in track(shot.read, first_shapes(shot), frames, config):
            elapsed, lap = watch.now() - began, watch.lap()
            laps.append(lap | {REST: elapsed - sum(lap.values()), ALL: elapsed})
            began = watch.now()
    return laps
