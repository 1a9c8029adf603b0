"""Seconds a frame of each stage of the engine on the demo shot, at 480p and 1080p, beside OpenCV's fastest flow."""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from benchmarks import demo_shot, report, variants
from benchmarks.stopwatch import Stopwatch
from benchmarks.yardstick import flow_seconds
from resources import demo
from roam_core.appearance.edge_models import EdgeModels
from roam_core.arrays import UInt8
from roam_core.energy import joint_total, total
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.geometry.simple import simplified
from roam_core.inference.landmark_dp import best_star
from roam_core.kernels.colour_bins import bin_counts, looked_up
from roam_core.kernels.cyclic_viterbi import cyclic_viterbi
from roam_core.kernels.diffusion import diffuse
from roam_core.kernels.local_match import nearest_colours
from roam_core.landmarks.pool import Pool
from roam_core.matte import render_matte
from roam_core.media import PlateSource, open_clip
from roam_core.media.colour import to_engine
from roam_core.motion.flow import dense_flow, flow_similarity
from roam_core.motion.klt import similarity_warp
from roam_core.params import CONFIGS
from roam_core.propagate import track, warm_up
from roam_core.propagate.curves.reshaping import reshape
from roam_core.propagate.curves.step import curve_context
from roam_core.propagate.frame.confidence import edge_support, frame_confidence, node_support
from roam_core.propagate.frame.contour_fit import enclosed, fitted
from roam_core.propagate.frame.nodes import NodeMap
from roam_core.propagate.whole.rigid import Rigidity
from roam_core.proposal.cues.evidence import gathered
from roam_core.proposal.cues.label_propagation import label_propagation
from roam_core.proposal.outline.contour import follow
from roam_core.proposal.segment.components import ring_around, shares
from roam_core.proposal.segment.region import cleaned
from roam_core.roto import RotoShape

STAGES: dict[str, Sequence[Callable[..., Any]]] = {
    "preparing the picture": (PreparedFrame.__init__, curve_context),
    "pre-warp": (similarity_warp, dense_flow, flow_similarity),
    "colour models": (EdgeModels.log_densities,),
    "edge tables": (total.pairwise_table,),
    "dynamic programming": (cyclic_viterbi,),
    "landmarks": (Pool.located, Pool.adapted, joint_total.leaf_table, joint_total.node_table, best_star),
    "reparametrisation": (reshape,),
    "fit back to the control points": (NodeMap.points,),
    "one piece": (Rigidity.step,),
    "lineage": (label_propagation,),
    "local colours": (nearest_colours,),
    "smoothing of the evidence": (diffuse,),
    "the other evidence": (gathered,),
    "the region": (cleaned, shares, ring_around),
    "curves along the region": (fitted, follow, simplified),
    "confidence and energies": (node_support, frame_confidence, total.energies, edge_support, enclosed),
    "histograms": (bin_counts, looked_up),
}
"""What a frame's time is spent on: functions that `propagate.curves.step` or `propagate.whole.region` call. A
configuration takes one way or the other; stages that it never enters stay out of its table."""

REST, SUM, MATTE, DECODING, FLOW = "the rest of the step", "tracking, all of it", "matte", "decoding a PNG", "DIS flow"
SETTLING = 2
"""Frames at the beginning that are solved but not counted: memory and caches are still being filled."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `stages` may be told."""
    parser.add_argument("--config", metavar="A,B", help=f"of {', '.join(CONFIGS)} (default: each of them)")
    parser.add_argument("--frames", type=int, default=24, metavar="N", help="frames of the demo that are timed")
    parser.add_argument("--publish", action="store_true", help="put the tables into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Measure both sizes under each configuration and report."""
    configs = variants.chosen(given.config)
    for config in configs:
        _run(config, given.frames, publish=given.publish)


def _run(config: str, count: int, *, publish: bool) -> None:
    last = demo_shot.LONGEST - 1
    if not SETTLING < count <= last:
        raise RoamError(
            f"--frames {count} is not between {SETTLING + 1} and {last}, the frames that the demo can give."
        )
    threads = cv2.getNumThreads()
    # One thread: the figures then say what is computed, not how many cores happened to be free.
    cv2.setNumThreads(1)
    try:
        warm_up(config)
        measured = {name: _medians(size, config, count) for name, size in demo_shot.SIZES.items()}
    finally:
        cv2.setNumThreads(threads)
    report.write(f"stages {config}", _table(measured, config, count), {"seconds": measured}, publish=publish)


def _medians(size: tuple[int, int], config: str, count: int) -> dict[str, float]:
    """The median seconds a frame of every stage, of decoding and of the flow, on pictures resized to `size`."""
    shot = demo_shot.load(size, count + 1)
    with tempfile.TemporaryDirectory() as folder:
        laps = _solved(_written(shot.pictures, Path(folder)), demo_shot.true_shape(demo.FIRST, size), config)
    for lap, seconds in zip(laps, flow_seconds(shot.pictures), strict=True):
        lap[FLOW] = seconds
    return {
        stage: float(np.median([lap.get(stage, 0.0) for lap in laps[SETTLING:]]))
        for stage in {s for lap in laps for s in lap}
    }


def _written(pictures: Sequence[UInt8], folder: Path) -> PlateSource:
    for frame, picture in enumerate(pictures, start=demo.FIRST):
        cv2.imwrite(str(folder / f"demo.{frame}.png"), cv2.cvtColor(picture, cv2.COLOR_RGB2BGR))
    return open_clip(folder)


def _solved(plate: PlateSource, shape: RotoShape, config: str) -> list[dict[str, float]]:
    """Seconds by stage of every tracked frame: the engine's own loop, watched from outside."""
    watch, laps = Stopwatch(), list[dict[str, float]]()
    frames = range(plate.frames[0], plate.frames[-1] + 1)
    decoding = 0.0

    def read(frame: int) -> NDArray[Any]:
        nonlocal decoding
        began = time.thread_time()
        picture = to_engine(plate.read(frame), plate.colour_space)
        decoding = time.thread_time() - began
        return picture

    with watch.watching(STAGES):
        began = time.thread_time()
        for result in track(read, [shape], frames, config):
            elapsed = time.thread_time() - began - decoding
            lap = watch.lap()
            laps.append(lap | {REST: elapsed - sum(lap.values()), SUM: elapsed, DECODING: decoding})
            laps[-1][MATTE] = _matte_seconds(result.results[0].shape, result.frame, plate.size)
            began = time.thread_time()
    return laps


def _matte_seconds(shape: RotoShape, frame: int, size: tuple[int, int]) -> float:
    began = time.thread_time()
    render_matte([shape], frame, (size[1], size[0]))
    return time.thread_time() - began


def _table(measured: dict[str, dict[str, float]], config: str, count: int) -> str:
    head = ["stage", *(f"{name}, {what}" for name in demo_shot.SIZES for what in ("ms", "times DIS"))]
    rows = []
    entered = [stage for stage in STAGES if all(stage in medians for medians in measured.values())]
    for stage in (*entered, REST, SUM, MATTE, DECODING, FLOW):
        name = f"**{stage}**" if stage == SUM else stage
        rows.append([name, *(cell for medians in measured.values() for cell in _cells(medians, stage))])
    title = f"Configuration `{config}`, medians of {count - SETTLING} frames, one thread. {report.circumstances()}."
    return f"{title}\n\n{report.table(head, rows)}"


def _cells(medians: dict[str, float], stage: str) -> tuple[str, str]:
    return f"{1000 * medians[stage]:.2f}", f"{medians[stage] / medians[FLOW]:.2f}"
