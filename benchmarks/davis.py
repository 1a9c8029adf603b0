"""One keyframe on real shots: the true mask of the first frame is given, every later matte is scored against its own.

The shots and the program that scores them lie beside the repository, in `../shared`; neither is part of it.
"""

from __future__ import annotations

import importlib.util
import json
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from multiprocessing import get_context
from pathlib import Path
from types import ModuleType
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from tqdm import tqdm

from benchmarks import report
from benchmarks.contact_sheet import contact_sheet
from roam_core import shapes_from_mask, track
from roam_core.errors import RoamError
from roam_core.interchange.mattes import write_matte
from roam_core.matte.vectorise import read_mask
from roam_core.media import open_clip
from roam_core.media.colour import to_engine
from roam_core.propagate import warm_up
from roam_core.roto import Layer

SHARED = report.ROOT.parent / "shared"
SHOTS = SHARED / "data" / "davis2016-train"
SCORE = SHARED / "bench" / "score.py"
ABSENT = (
    "The shots are not here: `python -m benchmarks davis` wants DAVIS 2016 in ../shared/data/davis2016-train "
    "(JPEGImages and Annotations) and the scoring program ../shared/bench/score.py beside the repository."
)
PROCESSES = 2

PAPER = {
    "baseline": ("Baseline", ".385", ".358", ".937", ".930", "0.056"),
    "best": ("Full", ".624", ".583", ".956", ".952", "5.639"),
}
"""The paper's configuration beside one of ours: IoU and accuracy on DAVIS's training and validation set, seconds."""

COLUMNS = {"iou": "IoU", "acc": "accuracy", "f": "boundary F", "sec_per_frame": "CPU s a frame"}


def is_present() -> bool:
    """True where the shots and the scoring program are."""
    return SHOTS.is_dir() and SCORE.is_file()


def run(config: str, shots: Sequence[str] | None, *, publish: bool) -> None:
    """Track and score the shots (all, if none are named) in two processes, and report."""
    if not is_present():
        raise RoamError(ABSENT)
    there = sorted(folder.name for folder in (SHOTS / "JPEGImages").iterdir())
    unknown = sorted(set(shots or ()) - set(there))
    if unknown:
        raise RoamError(f"There is no shot {unknown[0]!r}; choose from {', '.join(there)}.")
    chosen = list(shots or there)
    # Processes are begun afresh: a fork would inherit the threads of OpenCV and numba in the middle of something.
    with ProcessPoolExecutor(PROCESSES, mp_context=get_context("spawn")) as pool:
        work = pool.map(_scored, chosen, [config] * len(chosen))
        scores = list(tqdm(work, total=len(chosen), unit="shot", leave=False, disable=not sys.stderr.isatty()))
    mean = {column: float(np.mean([score[column] for score in scores])) for column in COLUMNS}
    name = f"davis {config}" if len(chosen) == len(there) else f"davis {config} some"
    text = _table(scores, mean, config)
    report.write(
        name, text, {"config": config, "mean": mean, "shots": scores}, publish=publish and name.endswith(config)
    )


def _scored(shot: str, config: str) -> dict[str, Any]:
    """Track one shot and score its mattes; the mattes and a contact sheet stay in `out/`."""
    cv2.setNumThreads(1)
    folder = report.OUT / "davis" / config / shot
    folder.mkdir(parents=True, exist_ok=True)
    warm_up(config)
    seconds = _tracked(shot, config, folder)
    (folder / "timing.json").write_text(json.dumps({"sec_per_frame": seconds}), encoding="utf-8")
    scored: dict[str, Any] = _score().score_seq((shot, str(folder), str(SHOTS / "Annotations" / shot), "error"))
    contact_sheet(SHOTS / "JPEGImages" / shot, folder, folder.with_suffix(".jpg"))
    return scored


def _tracked(shot: str, config: str, folder: Path) -> float:
    """Write a matte for every frame. Gives the engine's CPU seconds a frame, for all shapes, without decoding."""
    plate = open_clip(SHOTS / "JPEGImages" / shot)
    first, size = plate.frames[0], (plate.size[1], plate.size[0])
    mask = read_mask(SHOTS / "Annotations" / shot / f"{plate.frame_name(first)}.png", size)
    layer = Layer("root", "Root", tuple(shapes_from_mask(mask, first)))
    solving = decoding = 0.0

    def read(frame: int) -> NDArray[Any]:
        nonlocal decoding
        began = time.process_time()
        picture = to_engine(plate.read(frame), plate.colour_space)
        decoding += time.process_time() - began
        return picture

    began = time.process_time()
    for result in track(read, tuple(layer.shapes()), range(first, plate.frames[-1] + 1), config):
        solving += time.process_time() - began
        shapes = tuple(each.shape for each in result.results)
        write_matte(shapes, result.frame, folder / f"{plate.frame_name(result.frame)}.png", size)
        began = time.process_time()
    return (solving - decoding) / (len(plate.frames) - 1)


@cache
def _score() -> ModuleType:
    """The scoring program as a module."""
    spec = importlib.util.spec_from_file_location("score", SCORE)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _table(scores: Sequence[dict[str, Any]], mean: dict[str, float], config: str) -> str:
    rows = [[score["seq"], str(score["frames"]), *(f"{score[c]:.3f}" for c in COLUMNS)] for score in scores]
    frames = sum(score["frames"] for score in scores)
    rows.append([f"**mean of {len(scores)} shots**", str(frames), *(f"**{mean[c]:.3f}**" for c in COLUMNS)])
    if config in PAPER:
        theirs, iou, other_iou, accuracy, other_accuracy, seconds = PAPER[config]
        rows.append([f"paper's {theirs}, training set", "30 shots", iou, accuracy, "-", seconds])
        rows.append([f"paper's {theirs}, validation set", "20 shots", other_iou, other_accuracy, "-", seconds])
    title = (
        f"Configuration `{config}`, one keyframe, {PROCESSES} processes of one thread each. {report.circumstances()}."
    )
    return f"{title}\n\n{report.table(['shot', 'frames', *COLUMNS.values()], rows)}"
