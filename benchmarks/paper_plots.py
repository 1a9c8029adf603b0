"""The paper's plots: IoU over time under windows of moves from 3x3 to 13x13, and energy against rounds of inference."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from benchmarks import chart, processes, report, shots
from benchmarks.shots import first_shapes
from benchmarks.stopwatch import replaced
from roam_core import track
from roam_core.inference.alternate import alternate
from roam_core.params import CONFIGS, params_for

SHOWN = ("boat", "car-turn", "mallard-water")
"""Shots of the plots; Boat is one of the paper's."""
WINDOWS = (3, 5, 7, 9, 11, 13)
WINDOWED = "full"
"""The configuration whose window is varied."""
TRACED = 12
"""Frames of each shot whose energies are plotted."""


def windows(chosen: Sequence[str]) -> tuple[str, dict[str, Any]]:
    """Plot every configuration over time, with the windows of `WINDOWED` as a shade; tabulate the means."""
    jobs = [(shot, config, 0) for shot in chosen for config in CONFIGS]
    jobs += [(shot, WINDOWED, window) for shot in chosen for window in WINDOWS]
    found = dict(zip(jobs, processes.each(over_time, jobs, unit="run"), strict=True))
    rows = []
    for shot in chosen:
        every = np.array([found[shot, WINDOWED, window] for window in WINDOWS])
        time = np.arange(1, every.shape[1] + 1)
        lines = [chart.line(config, time, found[shot, config, 0]) for config in CONFIGS]
        band = chart.Band(f"{WINDOWED}, 3x3 to 13x13", time.astype(np.float64), every.min(axis=0), every.max(axis=0))
        axes = chart.Axes(f"IoU over time, {shot}", "frame", "IoU", (0.0, 1.0))
        chart.write(report.OUT / f"paper-window-{shot}.png", axes, lines, band)
        rows.append([shot, *(f"{mean:.3f}" for mean in every.mean(axis=1))])
    head = ["shot", *(f"{window}x{window}" for window in WINDOWS)]
    title = (
        f"Mean IoU of `{WINDOWED}` over whole shots by the window of moves; plots of IoU over time in "
        f"`paper-window-SHOT.png`. {report.circumstances()}."
    )
    result = {" ".join(map(str, job)): values for job, values in found.items()}
    return f"{title}\n\n{report.table(head, rows)}", result


def over_time(job: tuple[str, str, int]) -> list[float]:
    """IoU of every frame of a shot under a configuration, with a window of moves of its own unless that is 0."""
    name, config, window = job
    params = params_for(config)
    if window:
        params = replace(params, window=window)
    shot, found = shots.load(name), []
    for result in track(shot.read, first_shapes(shot), shot.frames, params):
        mask = shots.matte([each.shape for each in result.results], result.frame, shot.size)
        found.append(shots.overlap(mask, shot.mask(result.frame)))
    return found


def energies(chosen: Sequence[str]) -> tuple[str, dict[str, Any]]:
    """Plot the joint energy of the alternation against its steps; tabulate how soon it has fallen."""
    found = dict(zip(chosen, processes.each(traces, list(chosen)), strict=True))
    rows = []
    for shot, of_frames in found.items():
        lines = [chart.line(f"frame {k + 1}", np.arange(len(t)), fallen(t)) for k, t in enumerate(of_frames[:8])]
        axes = chart.Axes(f"Joint energy against steps, {shot}", "step", "share of the fall to come", (0.0, 1.0))
        chart.write(report.OUT / f"paper-energy-{shot}.png", axes, lines)
        by_step = [[fallen(t)[min(step, len(t) - 1)] for t in of_frames] for step in (2, 4, 6, 8)]
        rows.append([shot, *(f"{100 * float(np.mean(left)):.1f} %" for left in by_step)])
    head = ["shot", *(f"after {step} steps" for step in (2, 4, 6, 8))]
    title = (
        f"How much of the fall of the joint energy is still to come under `{WINDOWED}`, means over {TRACED} frames; "
        f"a step is one of the landmarks or one of the curve. Plots in `paper-energy-SHOT.png`. "
        f"{report.circumstances()}."
    )
    return f"{title}\n\n{report.table(head, rows)}", found


def traces(name: str) -> list[list[float]]:
    """The joint energy after every step of the alternation, for each frame of the beginning of a shot's first shape."""
    seen: list[list[float]] = []

    def watched(*args: Any, **kwargs: Any) -> Any:
        solution = alternate(*args, **kwargs)
        seen.append([float(energy) for energy in solution.trace])
        return solution

    shot = shots.load(name)
    with replaced({alternate: watched}):
        for _ in track(shot.read, first_shapes(shot)[:1], shot.frames[: TRACED + 1], WINDOWED):
            pass
    return seen


def fallen(trace: Sequence[float]) -> list[float]:
    """Of the whole fall of an energy, the share that is still to come after each step; 0 where it never falls."""
    whole = trace[0] - trace[-1]
    return [(energy - trace[-1]) / whole if whole > 0 else 0.0 for energy in trace]
