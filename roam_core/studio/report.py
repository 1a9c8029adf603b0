"""What became of a batch: as values, for programs, and as a page with pictures, for those who look after it."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

from roam_core import __version__
from roam_core.atomic_write import write_atomically
from roam_core.studio.driver import Outcome
from roam_core.studio.pictures import seen
from roam_core.studio.tasks import Task

TYPE, VERSION = "roam.BatchReport", 1
JSON_NAME, PAGE_NAME, PICTURES = "report.json", "report.html", "report"
WORST_FIRST = ("failed", "cancelled", "not begun", "skipped", "done", "kept")
"""States of a job, those that want attention first."""
PLOT = (240, 36)
"""Pixels of a plot of confidence."""

STYLE = """
:root { color-scheme: light dark; font: 14px/1.45 system-ui, sans-serif; }
body { margin: 2rem auto; max-width: 72rem; padding: 0 1rem; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; padding: .35rem .6rem; border-bottom: 1px solid #8884; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
figure { display: inline-block; margin: .3rem .6rem .3rem 0; }
figure img { display: block; width: 20rem; max-width: 100%; }
figcaption { font-size: 12px; opacity: .8; }
.failed, .cancelled { color: #d33; font-weight: 600; }
.skipped { opacity: .7; }
pre { white-space: pre-wrap; margin: 0; font-size: 12px; }
svg polyline { fill: none; stroke: currentColor; stroke-width: 1.2; }
svg line { stroke: #8886; }
"""


def report_of(
    jobs: Sequence[Sequence[Task]], outcomes: Sequence[Outcome], seconds: float, workers: int
) -> dict[str, Any]:
    """A batch as values of JSON: of every step how it ended, in how long, how sure it is of its frames.

    `outcomes` are those of `driver.run`; a step without one was not begun.
    """
    known = {(outcome["job"], outcome["step"]): outcome for outcome in outcomes}
    told = [_job(tasks, known) for tasks in jobs if tasks]
    counts = Counter(job["status"] for job in told)
    return {
        "type": TYPE,
        "version": VERSION,
        "program": __version__,
        "seconds": round(seconds, 3),
        "workers": workers,
        "counts": dict(counts),
        "jobs": told,
    }


def write_report(report: dict[str, Any], folder: Path) -> Path:
    """Write a report into the folder of results, as JSON and as a page; where the page is.

    Raises `RoamError` where it cannot be written.
    """
    write_atomically(folder / JSON_NAME, json.dumps(report, indent=1).encode())
    write_atomically(folder / PAGE_NAME, page(report).encode())
    return folder / PAGE_NAME


def page(report: dict[str, Any]) -> str:
    """The page of a report: jobs that want attention first, then by confidence. It loads nothing from elsewhere."""
    jobs = sorted(report["jobs"], key=lambda job: (WORST_FIRST.index(job["status"]), _least(job), job["name"]))
    counts = ", ".join(f"{number} {status}" for status, number in report["counts"].items())
    rows = "\n".join(_row(job) for job in jobs)
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>ROAM batch: {escape(counts)}</title><style>{STYLE}</style></head>
<body><h1>{len(jobs)} job(s): {escape(counts)}</h1>
<p>{report["seconds"]:.0f} s on {report["workers"]} worker(s), ROAM {escape(report["program"])}.
Confidence is the overlap (IoU) to be expected, 0 to 1. Pictures show the frames that are least sure.</p>
<table><thead><tr><th>job</th><th>state</th><th>seconds</th><th>least sure</th><th>confidence by frame</th></tr></thead>
<tbody>
{rows}
</tbody></table></body></html>
"""


def _job(tasks: Sequence[Task], known: dict[tuple[str, str], Outcome]) -> dict[str, Any]:
    steps = [_step(task, known.get((task.job, task.step))) for task in tasks]
    states = [step["status"] for step in steps]
    return {
        "name": tasks[0].job,
        "folder": tasks[0].folder,
        "status": min(states, key=WORST_FIRST.index),
        "seconds": round(sum(step["seconds"] for step in steps), 3),
        "steps": steps,
    }


def _step(task: Task, outcome: Outcome | None) -> dict[str, Any]:
    if outcome is None:
        return {"step": task.step, "status": "not begun", "said": "", "seconds": 0.0, "frames": {}}
    told = {name: outcome.get(name, usual) for name, usual in (("status", ""), ("said", ""), ("seconds", 0.0))}
    rest = {name: outcome[name] for name in ("frames", "outputs", "pictures", "attempts") if outcome.get(name)}
    return {"step": task.step, **told, **rest}


def _least(job: dict[str, Any]) -> float:
    values = [confidence for step in job["steps"] for confidence in seen(step.get("frames", {})).values()]
    return float(min(values, default=1.0))


def _row(job: dict[str, Any]) -> str:
    least, solved = _least(job), [step for step in job["steps"] if step.get("frames")]
    plots = "".join(_plot(step) for step in solved)
    details = "".join(_details(step) for step in job["steps"])
    return (
        f'<tr><td>{escape(job["name"])}</td><td class="{escape(job["status"]).split()[0]}">{escape(job["status"])}</td>'
        f'<td class="number">{job["seconds"]:.1f}</td>'
        f'<td class="number">{f"{least:.2f}" if solved else "-"}</td><td>{plots}{details}</td></tr>'
    )


def _plot(step: dict[str, Any]) -> str:
    """Confidence over the frames of a step, from 0 to 1."""
    rated = list(seen(step["frames"]).items())
    if not rated:
        return ""
    width, height = PLOT
    first, length = rated[0][0], max(1, rated[-1][0] - rated[0][0])
    points = " ".join(f"{(frame - first) * width / length:.1f},{height * (1 - value):.1f}" for frame, value in rated)
    title = f"{step['step']}, frames {first} to {rated[-1][0]}"
    return (
        f'<svg width="{width}" height="{height}" role="img"><title>{escape(title)}</title>'
        f'<line x1="0" y1="{height}" x2="{width}" y2="{height}"/><polyline points="{points}"/></svg> '
    )


def _details(step: dict[str, Any]) -> str:
    figures = "".join(
        f'<figure><img loading="lazy" src="{PICTURES}/{escape(name)}" alt="frame {escape(frame)}"><figcaption>'
        f"{escape(step['step'])}, frame {escape(frame)}: {step['frames'][frame][0]:.2f}</figcaption></figure>"
        for frame, name in step.get("pictures", {}).items()
    )
    is_quiet = step["status"] in ("done", "kept") and not step["said"]
    said = "" if is_quiet else f"<pre>{escape(step['step'])}, {escape(step['status'])}: {escape(step['said'])}</pre>"
    return f"{figures}{said}"


def pictures_in(folder: Path) -> str:
    """Where the pictures of a report lie."""
    return os.fspath(folder / PICTURES)
