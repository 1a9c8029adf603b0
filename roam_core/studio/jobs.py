"""Jobs as values, read from a file of YAML or JSON, or found in folders of shots."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from roam_core.bounded import bounded_bytes
from roam_core.errors import RoamError
from roam_core.installation import studio_module
from roam_core.studio.fields import FILE_FIELDS, JOB_FIELDS, VERBS, require_fields

TYPE, VERSION = "roam.Jobs", 1
MOST_BYTES = 64 << 20
MOST_JOBS = 100_000
MOST_DEEP = 32
"""Collections within collections."""
SUFFIXES = (".yaml", ".yml", ".json")
_NAME = re.compile(r"[^\W.](?:[\w .+-]*[\w+-])?")
"""Names that are one folder on every system."""


@dataclass(frozen=True)
class Step:
    """A command of a job and what was said of it, by the names of `VERBS`."""

    verb: str
    options: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Job:
    """A shot and its steps. `clip` is None where `init` is a project that names its own; paths are absolute."""

    name: str
    steps: tuple[Step, ...]
    clip: str | None = None
    init: Path | None = None
    layer: str = ""
    colour: str = ""


@dataclass(frozen=True)
class Jobs:
    """All jobs of a batch, and the folder of their results, in which each has one of its own."""

    jobs: tuple[Job, ...]
    out: Path


def read_jobs(path: str | Path) -> Jobs:
    """Read a file of jobs, YAML or JSON by its suffix. Paths in it are taken from the file's folder.

    Raises
    ------
    RoamError
        when it is missing, too large, not of this form (`fields.schema`), or a job cannot be carried out as it stands.
    """
    path = Path(path)
    if not os.path.lexists(path):
        raise RoamError(f"{path} does not exist; give a file of jobs, a folder of shots or an edit (.otio).")
    require_jobs_name(path)
    document = _parsed(path)
    return jobs_of(document, path.absolute().parent, path.name, path.absolute().with_suffix(""))


def require_jobs_name(path: Path) -> None:
    """Raise `RoamError` where a file of that name is not read as jobs."""
    if path.suffix.lower() not in SUFFIXES:
        raise RoamError(f"{path} is no file of jobs; its name has to end in {', '.join(SUFFIXES)}.")


def jobs_of(document: Any, folder: Path, where: str, out: Path) -> Jobs:
    """The jobs of a document as `read_jobs` reads it: plain values, with paths from `folder`.

    `where` names it in sentences; `out` is the folder of results where it names none.
    """
    if not isinstance(document, dict) or document.get("type") != TYPE:
        raise RoamError(f"{where} is no file of jobs; it has to begin with type: {TYPE} and version: {VERSION}.")
    if document.get("version") != VERSION:
        raise RoamError(f"{where} has another version than {VERSION}; read it with a later ROAM.")
    require_fields(document, FILE_FIELDS, where, ("type", "version", "steps", "jobs"))
    given = document.get("jobs")
    if not isinstance(given, list) or not given:
        raise RoamError(f"{where} has no list of jobs.")
    if len(given) > MOST_JOBS:
        raise RoamError(f"{where} has {len(given)} jobs; more than {MOST_JOBS} go into several files.")
    usual = _steps(document["steps"], folder, f"{where}: steps") if "steps" in document else ()
    jobs = tuple(_job(each, usual, folder, f"{where}: jobs[{k}]") for k, each in enumerate(given))
    _require_different(jobs, where)
    return Jobs(jobs, _place(folder, document["out"]) if "out" in document else out)


def as_document(jobs: Jobs) -> dict[str, Any]:
    """The document from which `jobs_of` makes these jobs, with all paths absolute."""
    return {
        "type": TYPE,
        "version": VERSION,
        "out": str(jobs.out),
        "jobs": [
            {
                "name": job.name,
                **({"clip": job.clip} if job.clip else {}),
                **({"init": str(job.init)} if job.init else {}),
                **({"layer": job.layer} if job.layer else {}),
                **({"colour": job.colour} if job.colour else {}),
                "steps": [{step.verb: step.options} if step.options else step.verb for step in job.steps],
            }
            for job in jobs.jobs
        ],
    }


def steps_named(text: str) -> tuple[Step, ...]:
    """Steps in short, `track,render,export:nuke`: what follows a colon is the format of an export.

    Raises `RoamError` for what is no step.
    """
    steps = []
    for word in text.split(","):
        verb, _, more = word.strip().partition(":")
        options = {"to": more} if verb == "export" and more else {}
        if verb not in VERBS or (more and not options):
            raise RoamError(f"{word.strip()!r} is no step; the steps are {', '.join(VERBS)} (export:FORMAT).")
        require_fields(options, VERBS[verb].fields, f"the step {verb}")
        steps.append(Step(verb, options))
    return tuple(steps)


def require_possible(job: Job, where: str) -> None:
    """Raise `RoamError` where the steps of a job cannot follow from what it is given."""
    has_project = job.init is not None and job.init.suffix.lower() == ".roam"
    if job.clip is None and not has_project:
        raise RoamError(f"{where} has no clip; name one, or a .roam project as init.")
    for k, step in enumerate(job.steps):
        can_begin = has_project or (step.verb == "track" and job.init is not None)
        if not (can_begin or step.verb == "import"):
            raise RoamError(
                f"{where}.steps[{k}], {step.verb}, has no shapes to work on; give the job an init, or import first."
            )
        has_project = has_project or VERBS[step.verb].makes_project


def require_name(name: str, where: str) -> None:
    """Raise `RoamError` where a name cannot be that of a folder on every system."""
    if not _NAME.fullmatch(name) or len(name) > 120:
        raise RoamError(f"{where} is {name!r}; a folder is named so: letters, digits, spaces and ._+- only.")


def _parsed(path: Path) -> Any:
    content = bounded_bytes(path, MOST_BYTES)
    try:
        if path.suffix.lower() == ".json":
            return json.loads(content, object_pairs_hook=lambda pairs: _once(pairs, path))
        return _of_yaml(content, path)
    except RecursionError:
        raise RoamError(f"{path} is nested too deeply to be a file of jobs.") from None
    except UnicodeDecodeError as error:
        raise RoamError(f"{path} is no text: {error.reason}.") from None
    except json.JSONDecodeError as error:
        raise RoamError(f"{path} is no JSON: {error.msg} in line {error.lineno}.") from None
    except ValueError as error:  # a date that is none, a number of too many digits
        raise RoamError(f"{path} cannot be read: {error}.") from None


def _of_yaml(content: bytes, path: Path) -> Any:
    """The plain values of a YAML text; no repetition by reference, with which a short text can be endless."""
    yaml = studio_module("yaml")
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)

    class Strict(loader):  # type: ignore[misc, valid-type]
        """Refuses a name that a mapping has twice, of which PyYAML takes the last one."""

        def construct_mapping(self, node: Any, deep: bool = False) -> Any:
            _once([(key.value, None) for key, _ in node.value if isinstance(key, yaml.ScalarNode)], path)
            return super().construct_mapping(node, deep)

    depth = 0
    try:
        for event in yaml.parse(content, Loader=loader):
            if isinstance(event, yaml.AliasEvent):
                raise RoamError(f"{path} repeats a part by reference (*{event.anchor}); write it out.")
            depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)
            if depth > MOST_DEEP:
                raise RecursionError
        return yaml.load(content, Loader=Strict)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        place = f" in line {mark.line + 1}" if mark is not None else ""
        raise RoamError(f"{path} is no YAML: {getattr(error, 'problem', None) or error}{place}.") from None


def _once(pairs: list[tuple[str, Any]], path: Path) -> dict[str, Any]:
    """The mapping of these pairs. Raises `RoamError` where a name stands twice: one of the two would be lost."""
    made: dict[str, Any] = {}
    for name, value in pairs:
        if name in made:
            raise RoamError(f"{path} says {name!r} twice of the same thing; say it once.")
        made[name] = value
    return made


def _job(given: Any, usual: tuple[Step, ...], folder: Path, where: str) -> Job:
    if not isinstance(given, dict):
        raise RoamError(f"{where} is no mapping with a name and a clip.")
    require_fields(given, JOB_FIELDS, where, ("steps",))
    name = given["name"]
    require_name(name, f"{where}.name")
    steps = _steps(given["steps"], folder, f"{where}.steps") if "steps" in given else usual
    if not steps:
        raise RoamError(f"{where} has no steps, and the file has none for all jobs.")
    init, clip = given.get("init"), given.get("clip")
    job = Job(
        name,
        steps,
        None if clip is None else str(_place(folder, clip)),
        None if init is None else _place(folder, init),
        given.get("layer", ""),
        given.get("colour", ""),
    )
    require_possible(job, where)
    return job


def _place(folder: Path, text: str) -> Path:
    """The path that a file of jobs names: no shell has put the user's folder in the place of `~`."""
    try:
        return folder / Path(text).expanduser()
    except RuntimeError:  # of a user whom the system does not know
        return folder / text


def _steps(given: Any, folder: Path, where: str) -> tuple[Step, ...]:
    if not isinstance(given, list) or not given:
        raise RoamError(f"{where} is no list of steps.")
    return tuple(_step(each, folder, f"{where}[{k}]") for k, each in enumerate(given))


def _step(given: Any, folder: Path, where: str) -> Step:
    pair = {given: {}} if isinstance(given, str) else given
    if not isinstance(pair, dict) or len(pair) != 1:
        raise RoamError(f"{where} is no step: a name such as render, or a name with what is said of it.")
    ((verb, options),) = pair.items()
    options = {} if options is None else options
    if not isinstance(verb, str) or verb not in VERBS:
        raise RoamError(f"{where} is {verb!r}; the steps are {', '.join(VERBS)}.")
    if not isinstance(options, dict):
        raise RoamError(f"{where}.{verb} has to be a mapping, such as {{{VERBS[verb].fields[0].name}: ...}}.")
    require_fields(options, VERBS[verb].fields, f"{where}.{verb}")
    if verb == "import":
        options = {**options, "source": str(_place(folder, options["source"]))}
    return Step(verb, options)


def _require_different(jobs: Sequence[Job], where: str) -> None:
    seen: set[str] = set()
    for job in jobs:
        if job.name.casefold() in seen:
            raise RoamError(f"{where} has two jobs named {job.name!r}; their results would lie in one folder.")
        seen.add(job.name.casefold())
