"""One keyframe on real shots: the true mask of the first frame is given, every later matte is scored against its own.

The shots and the program that scores them lie beside the repository, in `../shared`; neither is part of it.
"""

from __future__ import annotations

import argparse
import importlib.util
import json
import time
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from benchmarks import paper_rows, processes, report, restarts, shots, variants
from benchmarks.contact_sheet import contact_sheet
from roam_core import shapes_from_mask, track
from roam_core.interchange.mattes.exporter import write_matte
from roam_core.media import open_clip
from roam_core.params import CONFIGS
from roam_core.propagate import warm_up

COLUMNS = {"iou": "IoU", "acc": "accuracy", "f": "boundary F", "sec_per_frame": "CPU s a frame"}
RESTARTS = "IoU of restarts"


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `davis` may be told."""
    parser.add_argument("--config", metavar="A,B", help=f"of {', '.join(CONFIGS)} (default: each of them)")
    parser.add_argument("--shots", metavar="A,B", help="only these shots")
    parser.add_argument(
        "--restarts", action="store_true", help=f"short runs from every {restarts.GAP}th frame beside the long one"
    )
    parser.add_argument("--publish", action="store_true", help="put the tables into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Track and score the shots under each configuration, report each, and all of them in one table."""
    configs = variants.chosen(given.config)
    chosen = shots.names(given.shots)
    whole = given.shots is None
    scores = {}
    for config in configs:
        scores[config] = measured(chosen, config, with_restarts=given.restarts)
        text = _table(scores[config], config)
        report.write(_name(config, whole), text, {"config": config, **scores[config]}, publish=given.publish and whole)
    if len(configs) > 1:
        text = _summary(scores)
        means = {config: {"mean": each["mean"], "restarts": each["restarts"]} for config, each in scores.items()}
        report.write(_name("summary", whole), text, {"configs": means}, publish=given.publish and whole)


def measured(chosen: Sequence[str], config: str, *, with_restarts: bool) -> dict[str, Any]:
    """Scores of every shot in their order ("shots"), their "mean", and "restarts" by shot (empty if not asked for)."""
    scores = processes.each(_scored, [(shot, config) for shot in chosen])
    mean = {column: float(np.mean([score[column] for score in scores])) for column in COLUMNS}
    again: dict[str, Any] = {}
    if with_restarts:
        found = processes.each(restarts.of_job, [restarts.Job(shot, config) for shot in chosen])
        again = {shot: restarts.spread(values) for shot, values in zip(chosen, found, strict=True)}
    return {"mean": mean, "shots": scores, "restarts": again}


def _name(what: str, whole: bool) -> str:
    return f"davis {what}" if whole else f"davis {what} some"


def _scored(job: tuple[str, str]) -> dict[str, Any]:
    """Track one shot and score its mattes; the mattes and a contact sheet stay in `out/`."""
    shot, config = job
    folder = report.OUT / "davis" / config / shot
    folder.mkdir(parents=True, exist_ok=True)
    warm_up(config)
    seconds = _tracked(shot, config, folder)
    (folder / "timing.json").write_text(json.dumps({"sec_per_frame": seconds}), encoding="utf-8")
    truth = shots.FOLDER / "Annotations" / shot
    scored: dict[str, Any] = _score().score_seq((shot, str(folder), str(truth), "error"))
    contact_sheet(shots.FOLDER / "JPEGImages" / shot, folder, folder.with_suffix(".jpg"))
    return scored


def _tracked(name: str, config: str, folder: Path) -> float:
    """Write a matte for every frame. Gives the engine's CPU seconds a frame, for all shapes, without decoding."""
    shot, plate = shots.load(name), open_clip(shots.FOLDER / "JPEGImages" / name)
    given = shapes_from_mask(shot.mask(shot.first), shot.first)
    solving = 0.0
    began = time.process_time()
    for result in track(shot.read, given, shot.frames, config):
        solving += time.process_time() - began
        shapes = tuple(each.shape for each in result.results)
        write_matte(shapes, result.frame, folder / f"{plate.frame_name(result.frame)}.png", shot.size)
        began = time.process_time()
    return solving / (len(shot.frames) - 1)


@cache
def _score() -> ModuleType:
    """The scoring program as a module."""
    spec = importlib.util.spec_from_file_location("score", shots.SCORE)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _table(scored: dict[str, Any], config: str) -> str:
    scores, mean, again = scored["shots"], scored["mean"], scored["restarts"]
    rows = [
        [score["seq"], str(score["frames"]), *(f"{score[c]:.3f}" for c in COLUMNS), *_again(again, score["seq"])]
        for score in scores
    ]
    frames = sum(score["frames"] for score in scores)
    overall = [f"**{_over_shots(again)}**"] if again else []
    rows.append([f"**mean of {len(scores)} shots**", str(frames), *(f"**{mean[c]:.3f}**" for c in COLUMNS), *overall])
    theirs, none = paper_rows.beside(config), ["-"] * len(overall)
    accuracy, other = theirs.training_accuracy, theirs.validation_accuracy
    name = f"paper's {theirs.name}"
    rows.append([f"{name}, training set", "30 shots", theirs.training, accuracy, "-", theirs.seconds, *none])
    rows.append([f"{name}, validation set", "20 shots", theirs.validation, other, "-", theirs.seconds, *none])
    title = f"Configuration `{config}`, one keyframe, {processes.PROCESSES} processes of one thread each."
    head = ["shot", "frames", *COLUMNS.values(), *([RESTARTS] if again else [])]
    return f"{title} {report.circumstances()}.\n\n{report.table(head, rows)}"


def _again(again: dict[str, Any], shot: str) -> list[str]:
    """The cell of a shot's restarts: mean and spread over its runs."""
    return [f"{again[shot]['mean']:.3f} ± {again[shot]['spread']:.3f}"] if again else []


def _over_shots(again: dict[str, Any]) -> str:
    """Mean over shots of the restarts' means, and the mean over shots of the spread within a shot."""
    return " ± ".join(f"{np.mean([each[what] for each in again.values()]):.3f}" for what in ("mean", "spread"))


def _summary(scores: dict[str, dict[str, Any]]) -> str:
    """All configurations in one table, the paper's below them."""
    rows = []
    for config, scored in scores.items():
        again = _over_shots(scored["restarts"]) if scored["restarts"] else "-"
        rows.append([f"`{config}`", *(f"{scored['mean'][c]:.3f}" for c in COLUMNS), again])
    for row in (*paper_rows.DAVIS.values(), *paper_rows.OTHERS):
        rows.append([f"paper: {row.name}, training", row.training, row.training_accuracy, "-", row.seconds, "-"])
    for row in (*paper_rows.DAVIS.values(), *paper_rows.OTHERS):
        rows.append([f"paper: {row.name}, validation", row.validation, row.validation_accuracy, "-", row.seconds, "-"])
    count = len(next(iter(scores.values()))["shots"])
    title = (
        f"One keyframe, means over {count} shots. `{RESTARTS}`: runs of {restarts.LENGTH} frames from every "
        f"{restarts.GAP}th frame, and how far the runs of a shot spread."
    )
    return f"{title} {report.circumstances()}.\n\n{report.table(['method', *COLUMNS.values(), RESTARTS], rows)}"
