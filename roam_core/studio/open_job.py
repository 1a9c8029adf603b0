"""A project's work as an Open Job Description job: what render farms and their queue managers read."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from roam_core.errors import RoamError
from roam_core.installation import studio_module
from roam_core.studio.jobs import Job, Jobs
from roam_core.studio.tasks import Task, tasks_of

SPECIFICATION = "jobtemplate-2023-09"
MOST_TASKS = 1024
"""Values of a task's parameter that the specification allows."""
SUFFIXES = (".json", ".yaml", ".yml")
COMMAND, PROJECT, CLIP, OUT = "{{Param.Roam}}", "{{Param.Project}}", "{{Param.Clip}}", "{{Param.Out}}"
FIRST, LAST = "{{Task.Param.First}}", "{{Task.Param.Last}}"

Ranges = Sequence[tuple[int, int]]


@dataclass(frozen=True)
class Shares:
    """What a farm's machines are given one by one: the gaps of a fill, and the frames of a chunk of rendering."""

    gaps: Ranges
    frames: range
    chunk: int

    @property
    def chunks(self) -> Ranges:
        """The first and the last frame of each chunk; they are longer where there would be too many."""
        length = max(self.chunk, -(-len(self.frames) // MOST_TASKS))
        starts = self.frames[::length]
        return [(first, min(first + length - 1, self.frames[-1])) for first in starts]


def template_of(job: Job, out: Path, shares: Shares, folder: Path, command: str = "roam") -> dict[str, Any]:
    """The template of a job whose `init` is a project: one step for each of its own, and one to join a fill's spans.

    Parameters
    ----------
    out : folder of the results, which has to be there when the job runs; each file in it has the job's name.
    folder : where the template will lie. What lies in it is a parameter's default; other paths have to be given when
        the job is submitted, for the specification knows no absolute defaults (`to_be_given`).
    command : what runs ROAM on a machine of the farm.

    Raises
    ------
    RoamError
        when a path or a name cannot stand in a template, or there are too many gaps for one job.
    """
    place = out / ".results"  # within OUT, and nothing else: beside the project, and in OUT, a plate may have its name
    (tasks,) = tasks_of(Jobs((job,), place))
    results = str(place / job.name)
    replaced = [(str(job.init), PROJECT), (job.clip or "", CLIP), (results, OUT)]
    replaced.sort(key=lambda pair: -len(pair[0]))  # the plate's folder may hold the results, or they the plate
    for text in (
        str(job.init),
        job.clip or "",
        str(out),
        job.name,
        command,
        *(word for t in tasks for word in t.words),
    ):
        if "{{" in text or "}}" in text:
            raise RoamError(f"{text!r} cannot stand in a job of a farm, where double braces are parameters; rename it.")
    # No one looks after the projects there: each goes to its place at once, the last one by the job's own name.
    places = {task.part: task.result or task.made for task in tasks if task.made}
    places |= {task.made: task.result for task in tasks if task.result}
    steps: list[dict[str, Any]] = []
    for task in tasks:
        words = [_replaced(places.get(word, word), replaced) for word in task.words]
        if task.verb == "fill" and len(shares.gaps) > 1:
            steps += _spread(task, words, shares.gaps, job.name)
        elif task.verb == "render":
            ranged = [word for word in words if not word.startswith(("--start=", "--end="))]
            steps.append(_step(task.step, [*ranged, "--start", FIRST, "--end", LAST], shares.chunks))
        else:
            steps.append(_step(task.step, words))
    for step, before in zip(steps[1:], steps[:-1], strict=True):
        step["dependencies"] = [{"dependsOn": before["name"]}]
    kind = "DIRECTORY" if Path(job.clip or "").is_dir() else "FILE"
    return {
        "specificationVersion": SPECIFICATION,
        "name": f"ROAM {job.name}"[:128],
        "parameterDefinitions": [
            _path("Project", "FILE", "IN", str(job.init), folder),
            *([_path("Clip", kind, "IN", job.clip or "", folder)] if CLIP in json.dumps(steps) else []),
            _path("Out", "DIRECTORY", "OUT", str(out), folder),
            {"name": "Roam", "type": "STRING", "default": command, "description": "the command that runs ROAM there"},
        ],
        "steps": steps,
    }


def to_be_given(template: dict[str, Any]) -> dict[str, str]:
    """The parameters without a default, with the paths that they have on this machine."""
    definitions = template["parameterDefinitions"]
    return {each["name"]: each["description"] for each in definitions if "default" not in each}


def checked(template: dict[str, Any]) -> dict[str, Any]:
    """The template, which the specification's own library has read. Raises `RoamError` where that refuses it."""
    model = studio_module("openjd.model")
    try:
        model.decode_job_template(template=template)
    except model.DecodeValidationError as error:
        raise RoamError(f"The job is not as Open Job Description wants it: {' '.join(str(error).split())}") from None
    return template


def written(template: dict[str, Any], path: Path) -> bytes:
    """The text of a template, JSON or YAML as the name of its file says; `RoamError` for another name."""
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise RoamError(f"A job for a farm is a file of {', '.join(SUFFIXES)}; {path.name} is none.")
    if suffix == ".json":
        return json.dumps(template, indent=1).encode() + b"\n"
    text: str = studio_module("yaml").safe_dump(template, sort_keys=False, allow_unicode=True)
    return text.encode()


def _spread(task: Task, words: list[str], gaps: Ranges, name: str) -> list[dict[str, Any]]:
    """A fill as a task for each gap, and the one that joins what they made."""
    if len(gaps) > MOST_TASKS:
        raise RoamError(f"There are {len(gaps)} gaps; a job of a farm has at most {MOST_TASKS} tasks of a kind.")
    part = f"{OUT}/{name}.{FIRST}-{LAST}.roam"
    spans = _step(f"{task.step} spans", [*words[:-1], part, "--span", FIRST, LAST], gaps)
    return [spans, _step(f"{task.step} join", [*words, "--take", OUT])]


def _step(name: str, words: list[str], ranges: Ranges | None = None) -> dict[str, Any]:
    step: dict[str, Any] = {"name": name}
    if ranges is not None:
        definitions = [
            {"name": label, "type": "INT", "range": [pair[k] for pair in ranges]}
            for k, label in enumerate(("First", "Last"))
        ]
        step["parameterSpace"] = {"taskParameterDefinitions": definitions, "combination": "(First, Last)"}
    run = {"command": COMMAND, "args": words}
    return {**step, "script": {"actions": {"onRun": run}}}


def _path(name: str, kind: str, flow: str, place: str, folder: Path) -> dict[str, str]:
    said = {"name": name, "type": "PATH", "objectType": kind, "dataFlow": flow, "description": place}
    near = Path(place).relative_to(folder) if Path(place).is_relative_to(folder) else None
    is_within = near is not None and ".." not in near.parts  # a default that leaves the folder cannot be submitted
    return {**said, "default": near.as_posix()} if near is not None and is_within else said


def _replaced(word: str, pairs: Sequence[tuple[str, str]]) -> str:
    """A word with the paths of this machine as parameters, which a farm maps to its own."""
    for path, parameter in pairs:
        if path and (word == path or word.startswith((f"{path}/", f"{path}{os.sep}"))):
            return parameter + word[len(path) :].replace(os.sep, "/")
    return word
