"""A step of a batch, carried out where a worker is: the command itself runs in this process, and its record is kept."""

from __future__ import annotations

import io
import json
import os
import threading
import time
from collections.abc import Callable, Mapping
from contextlib import redirect_stderr, redirect_stdout, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from roam_core.atomic_write import write_atomically
from roam_core.cancel import CancelToken
from roam_core.cli.configuring import configured
from roam_core.cli.environment import take_decoder
from roam_core.cli.main import INTERRUPTED, main
from roam_core.cli.picking import NothingToSolve, Picking
from roam_core.cli.plate import loaded, opened
from roam_core.cli.plate_task import asked_shapes
from roam_core.cli.spans import gaps_to_fill, is_filled, pieces_of
from roam_core.cli.steady import tracked_frames
from roam_core.cli.stopping import cancelled_by
from roam_core.cli.track import given_project, initial_project
from roam_core.errors import RoamError
from roam_core.interchange.targets import kept_aside
from roam_core.params import DEFAULT_CONFIG
from roam_core.roto import file
from roam_core.studio import cluster
from roam_core.studio.driver import Work
from roam_core.studio.pictures import write_doubtful
from roam_core.studio.records import Record, Seen, digest_of, inputs_of, is_as_written
from roam_core.studio.tasks import LOOKING, Task

Tell = Callable[[Mapping[str, Any]], None]
PAUSE = 0.5
"""Seconds between two words on how far a step is."""

_alone = threading.Lock()
"""What a command prints belongs to one step: a worker of several threads carries out one after the other."""
_running: dict[str, set[CancelToken]] = {}
_lock = threading.Lock()


def perform(batch: str, plain: dict[str, Any], pictures: str = "", tell: Tell | None = None) -> dict[str, Any]:
    """Carry out a task (`Task.plain`) unless its record says that it is done; what is said of it, as values of JSON.

    `status` is done, kept (it was done before), split (it can be divided: `pieces`), failed or cancelled; `said` is
    what the command told, `frames` its confidence and seconds by frame, `outputs` what it wrote. A step whose
    project leaves it nothing to do hands that on as it is: it is done, and `idle`.

    Parameters
    ----------
    batch : what `cancel` calls the batch. pictures : folder for pictures of doubtful frames; "" for none.
    tell : is told now and then of the frame that is finished.
    """
    task, began = Task.of(plain), time.perf_counter()
    told: dict[str, Any] = {"job": task.job, "step": task.step, "process": os.getpid()}
    try:
        Path(task.record).parent.mkdir(parents=True, exist_ok=True)
        before = Record.read(Path(task.record))
        is_import = task.verb == "import"
        inputs = inputs_of(task.reads, task.plate, task.layer, before, task.content, are_sequences=is_import)
        if before is not None and before.holds(task.settings, inputs, Path(task.folder)):
            before = _with_result(task, before)
            return {**told, **before.outcome, "status": "kept", "outputs": sorted(before.outputs)}
        try:
            _require_work(task)
            if len(pieces := _pieces(task)) > 1:
                return {**told, "status": "split", "pieces": pieces}
            outcome = {**told, **_carried_out(batch, task, before, tell)}
        except NothingToSolve as reason:
            outcome = {**told, **_handed_on(task, before, str(reason))}
        if outcome["status"] == "done":
            outcome |= _kept(task, before, inputs, outcome, pictures, began)
    except (RoamError, OSError) as error:
        outcome = {**told, "status": "failed", "said": str(error)}
    return {**outcome, "seconds": round(time.perf_counter() - began, 3)}


def perform_on_worker(batch: str, plain: dict[str, Any], pictures: str) -> dict[str, Any]:
    """`perform` as Dask's workers call it: the batch hears of the frames."""
    take_decoder()
    return perform(batch, plain, pictures, cluster.tell)


def cancel(batch: str) -> int:
    """Have the steps of a batch that run in this process stop at their next safe point; how many there are."""
    with _lock:
        tokens = list(_running.get(batch, ()))
    for token in tokens:
        token.cancel()
    return len(tokens)


def _require_work(task: Task) -> None:
    """Raise `NothingToSolve` where a step that has to look for its work finds none; of a fill `_pieces` does."""
    path = Path(task.reads[0])
    if task.verb == "track":
        given_project(path)
    elif task.verb in LOOKING:
        asked = asked_shapes(loaded(path), path, task.settings["options"].get("shape"), task.verb)
        if task.verb == "steady":
            tracked_frames(asked, path)


def _pieces(task: Task) -> list[Any]:
    """What of a fill that may be divided is left to do, by gap and object; `NothingToSolve` for no gap."""
    if not task.can_split:
        return []
    project = loaded(Path(task.reads[0]))
    options = task.settings["options"]
    picking = Picking(options.get("shape"), options.get("alone", False))
    params = configured(options.get("config", DEFAULT_CONFIG))
    gaps = gaps_to_fill(project, Path(task.reads[0]), picking)
    with opened(str(project.require_clip().path), project.clip) as plate:
        left = [gap for gap in gaps if not is_filled(project, gap, params, plate, picking)]
    return pieces_of(project, left, picking)


def _carried_out(batch: str, task: Task, before: Record | None, tell: Tell | None) -> dict[str, Any]:
    """Run the command; the project it makes is put in its place when it is whole."""
    part, made = (Path(path) if path else None for path in (task.part, task.made))
    if part is not None:
        part.unlink(missing_ok=True)  # what was left of a worker that died
    said, lines, token = io.StringIO(), _Lines(task, tell), CancelToken()
    with _lock:
        _running.setdefault(batch, set()).add(token)
    try:
        with _alone, redirect_stdout(lines), redirect_stderr(said), cancelled_by(token):
            status = _status_of(task)
    finally:
        with _lock:
            _running[batch].discard(token)
    outcome = {"said": said.getvalue().strip(), "frames": lines.frames}
    if status == INTERRUPTED or (token.is_cancelled and status):
        return {**outcome, "status": "cancelled"}
    if status:
        return {**outcome, "status": "failed"}
    if part is not None and made is not None:
        _put_in_place(task, before)
    outputs = [str(made)] if made is not None else lines.files
    return {**outcome, "status": "done", "outputs": outputs}


def _handed_on(task: Task, before: Record | None, reason: str) -> dict[str, Any]:
    """Make the result of a step with nothing to do: its project as it is, on the plate of the job."""
    init, told = Path(task.reads[0]), io.StringIO()
    project = loaded(init)
    with _alone, redirect_stderr(told):
        if task.verb == "track":
            with opened(task.plate, project.clip, *task.settings["read"]) as plate:
                project = initial_project(init, project, plate, plate.source.frames[0])
        file.save(project, task.part)
    _put_in_place(task, before)
    said = f"{told.getvalue()}{reason} What is left of the job is done with the project as it is."
    return {"said": said, "idle": True, "frames": {}, "status": "done", "outputs": [task.made]}


def _status_of(task: Task) -> int:
    try:
        return main(task.words)
    except SystemExit as refused:  # words that the command does not know
        return int(refused.code or 0)


def _kept(
    task: Task, before: Record | None, inputs: list[Seen], outcome: dict[str, Any], pictures: str, began: float
) -> dict[str, Any]:
    """Record a step that was carried out, with pictures of its doubtful frames, and copy its project as the result."""
    folder = Path(task.folder)
    more: dict[str, Any] = {"pictures": {}}
    if task.made and pictures and outcome["frames"]:
        more["pictures"] = write_doubtful(task.made, outcome["frames"], Path(pictures), f"{task.job}.{task.step}")
    outputs = {os.path.relpath(path, folder): digest_of(Path(path)) for path in outcome["outputs"]}
    told = {name: outcome[name] for name in ("said", "frames", "idle") if name in outcome} | more
    told["seconds"] = round(time.perf_counter() - began, 3)
    if task.result:
        told["result"] = _copied(task, None if before is None else str(before.outcome.get("result", "")))
    Record(task.settings, tuple(inputs), outputs, told).write(Path(task.record))
    return {**more, "outputs": sorted(outputs)}


def _copied(task: Task, known: str | None) -> str:
    """Copy a step's project as the result of its job; the digest of that. Another one than the `known` is kept."""
    result = Path(task.result)
    write_atomically(result, Path(task.made).read_bytes(), before_replacing=lambda: _keep_others(result, known))
    return digest_of(result)


def _with_result(task: Task, before: Record) -> Record:
    """The record of a step that is done, after its project was copied where the result is gone or is another step's."""
    if not task.result:
        return before
    result, made = Path(task.result), Path(task.made)
    there = digest_of(result) if result.exists() else None
    others = {digest_of(each) for each in Path(task.folder).glob(f"{task.job}.*-*.roam") if each != made}
    if there == digest_of(made) or not (there is None or there in others):
        return before  # as it was written, or an artist went on with it
    found = replace(before, outcome={**before.outcome, "result": _copied(task, there)})
    found.write(Path(task.record))
    return found


def _put_in_place(task: Task, before: Record | None) -> None:
    """Give a finished project its name; another one of that name, which no record knows, is kept beside it."""
    made = Path(task.made)
    _keep_others(made, None if before is None else before.outputs.get(os.path.relpath(made, task.folder)))
    Path(task.part).replace(made)


def _keep_others(path: Path, known: str | None) -> None:
    if path.exists() and not (known and is_as_written(path, known)):
        kept_aside(path)


WORK = Work(perform_on_worker, cancel, ("roam_core.propagate.between.span", "roam_core.propagate.run"))
"""What a batch asks of its workers."""


class _Lines(io.StringIO):
    """The output of a command: its lines of JSON, taken apart as they come."""

    def __init__(self, task: Task, tell: Tell | None) -> None:
        super().__init__()
        self.frames: dict[str, list[Any]] = {}
        self.files: list[str] = []
        self._task, self._tell, self._rest, self._due = task, tell, "", 0.0

    def write(self, text: str) -> int:
        *lines, self._rest = (self._rest + text).split("\n")
        for line in lines:
            with suppress(ValueError):
                self._take(json.loads(line))
        return len(text)

    def _take(self, line: Any) -> None:
        if not isinstance(line, dict):
            return
        self.files += line.get("files", [])
        if "confidence" in line:
            self.frames[str(line["frame"])] = [line["confidence"], line["seconds"], line["termination"]]
            if self._tell is not None and time.monotonic() >= self._due:
                self._due = time.monotonic() + PAUSE
                self._tell({"job": self._task.job, "step": self._task.step, "frame": line["frame"]})
