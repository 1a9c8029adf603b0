"""What workers are given: each step of a job as the words of a command, with the files that it reads and writes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from roam_core import __version__
from roam_core.interchange.registry import exporter_for
from roam_core.params import DEFAULT_CONFIG, params_for
from roam_core.propagate.shapes.provenance import REVISION
from roam_core.roto import file
from roam_core.roto.relinking import relinked
from roam_core.studio.fields import VERBS
from roam_core.studio.jobs import Job, Jobs, Step

SOLVING = ("track", "fill")
LOOKING = ("steady", "soften")
CHANGING = (*LOOKING, "shift")
RECORDS = "steps"
"""The folder of a job in which the records of its steps lie."""


@dataclass(frozen=True)
class Task:
    """One step, ready to be carried out: plain values, as they travel to a worker and lie in records.

    Attributes
    ----------
    job, step : its names; `step` begins with its number, such as `1-track`.
    words : the command; where it saves a project it names `part`, which becomes `made` when it is whole.
    folder : of the job's results. reads : files and folders that it reads besides the plate.
    plate, layer : the clip whose pictures decide the result; "" where none does.
    settings : all else that decides the result.
    made : the project that it makes; "". result : where a copy of that goes; "" if a later step makes another.
    can_split : a fill that may be divided among workers first. record : the file that says what was done.
    content : by which the plate is known among other sequences of its folder; "" where no project tells it.
    """

    job: str
    step: str
    words: tuple[str, ...]
    folder: str
    reads: tuple[str, ...] = ()
    plate: str = ""
    layer: str = ""
    settings: dict[str, Any] = field(default_factory=dict)
    part: str = ""
    made: str = ""
    result: str = ""
    can_split: bool = False
    record: str = ""
    content: str = ""

    @property
    def verb(self) -> str:
        return self.words[0]

    def plain(self) -> dict[str, Any]:
        """As values of JSON."""
        return asdict(self)

    @classmethod
    def of(cls, plain: dict[str, Any]) -> Task:
        """From what `plain` gave."""
        return cls(**{**plain, "words": tuple(plain["words"]), "reads": tuple(plain["reads"])})


def tasks_of(jobs: Jobs, *, overwrite: bool = False) -> list[list[Task]]:
    """The tasks of each job, each of which needs the one before it.

    Raises `RoamError` where a project that tells the clip of a job cannot be read, or a configuration or format is not
    known.
    """
    return [_of_job(job, jobs.out / job.name, overwrite) for job in jobs.jobs]


def fill_task(project: Path, folder: Path, config: str, *, alone: bool = False) -> Task:
    """A fill of a project by itself, with results in `folder`."""
    options = {"config": config, **({"alone": True} if alone else {})}
    return _of_job(Job(project.stem, (Step("fill", options),), init=project), folder, overwrite=False)[0]


def pieces(task: Task, parts: Sequence[tuple[tuple[int, int], Sequence[str]]]) -> tuple[list[Task], Task]:
    """A fill divided into gaps and objects: a task for each of `parts`, and the one that puts them together.

    The longest gaps come first, so that none of them begins when the others have ended.
    """
    folder = Path(task.folder) / RECORDS / task.step
    made = []
    for k, ((first, last), shapes) in enumerate(sorted(parts, key=lambda part: part[0][0] - part[0][1])):
        place = folder / f"{k + 1:04d}.roam"
        words = [word for word in task.words[:-2] if not word.startswith("--shape=")]  # the last two say where to save
        words += ["--span", str(first), str(last), *(f"--shape={shape}" for shape in shapes)]
        unfinished = _part_of(place)
        made.append(
            replace(
                task,
                step=f"{task.step} {k + 1}/{len(parts)}, frames {first}-{last}",
                words=(*words, "--save", str(unfinished)),
                settings={**task.settings, "span": [first, last], "shapes": list(shapes)},
                part=str(unfinished),
                made=str(place),
                result="",
                can_split=False,
                record=str(place.with_suffix(".json")),
            )
        )
    return made, replace(task, words=(*task.words, "--take", str(folder)), can_split=False)


def _of_job(job: Job, folder: Path, overwrite: bool) -> list[Task]:
    clip, content = (job.clip, "") if job.clip else _clip_of(job.init)
    project = job.init if job.init is not None and job.init.suffix.lower() == ".roam" else None
    makers = [k for k, step in enumerate(job.steps) if VERBS[step.verb].makes_project]
    tasks: list[Task] = []
    taken: set[str] = set()
    for k, step in enumerate(job.steps):
        name = f"{k + 1}-{step.verb}"
        made = folder / f"{job.name}.{name}.roam" if k in makers else None
        place = made and _part_of(made)
        reads, words = _words(job, step, clip, project, place, folder, taken)
        words[1:1] = ["--overwrite"] if overwrite else []
        solves = step.verb in SOLVING
        config = step.options.get("config", DEFAULT_CONFIG)
        tasks.append(
            Task(
                job.name,
                name,
                tuple(words),
                str(folder),
                tuple(str(path) for path in reads),
                clip if solves or _looks(step) or (step.verb == "import" and project is None) else "",
                job.layer,
                {
                    "program": __version__,
                    "verb": step.verb,
                    "options": {name: value for name, value in step.options.items() if name != "source"},
                    "read": [job.layer, job.colour],
                    **({"revision": REVISION, "params": params_for(config).values()} if solves else {}),
                },
                "" if place is None else str(place),
                "" if made is None else str(made),
                str(folder / f"{job.name}.roam") if makers and k == makers[-1] else "",
                step.verb == "fill",
                str(folder / RECORDS / f"{name}.json"),
                content,
            )
        )
        project = made or project
    return tasks


def _looks(step: Step) -> bool:
    """Whether the plate decides what a step makes of a project that is solved: its pictures, or their numbers."""
    return step.verb in LOOKING or (step.verb == "shift" and "by" not in step.options)


def _words(
    job: Job, step: Step, clip: str, project: Path | None, place: Path | None, folder: Path, taken: set[str]
) -> tuple[list[Path], list[str]]:
    """What a step reads, and its command."""
    options = _options(step)
    if step.verb == "track":
        init = project or job.init
        assert init is not None  # a job that gives nothing to track was refused
        reading = [
            word for name in ("layer", "colour") if (value := getattr(job, name)) for word in (f"--{name}", value)
        ]
        return [init], ["track", clip, "--init", str(init), *reading, *options, "--json", "--save", str(place)]
    if step.verb == "import":
        source = Path(step.options["source"])
        if project is None:
            return [source], ["import", str(source), "--into", str(place), "--clip", clip, *options, "--json"]
        words = ["import", str(source), "--into", str(project), *options, "--json", "--save", str(place)]
        return [source, project], words
    assert project is not None
    if step.verb in ("fill", *CHANGING):
        return [project], [step.verb, str(project), *options, "--json", "--save", str(place)]
    if step.verb == "render":
        return [project], ["render", str(project), "--out", str(folder / _free("mattes", taken)), *options, "--json"]
    out = folder / _free(f"{job.name}{exporter_for(step.options['to']).suffix}", taken)
    return [project], ["export", str(project), str(out), *options, "--json"]


def _options(step: Step) -> list[str]:
    """What was said of a step, as options of its command."""
    words = []
    for name, value in step.options.items():
        if name == "source" or value is False:
            continue
        if value is True:
            words.append(f"--{name}")
        else:
            for each in value if isinstance(value, list) else [value]:
                words.append(f"--{name}={each}")  # in one word: a value may begin with a dash
    return words


def _free(name: str, taken: set[str]) -> str:
    """A name that no other step of the job has: that one, or one with a number."""
    stem, dot, suffix = name.partition(".") if name.startswith("mattes") else name.rpartition(".")
    number, found = 2, name
    while found in taken:
        found, number = f"{stem}-{number}{dot}{suffix}", number + 1
    taken.add(found)
    return found


def _part_of(made: Path) -> Path:
    """Where a project lies while it is being made: beside its place, so that paths in it hold."""
    return made.with_name(f"{made.stem}.part.roam")


def _clip_of(init: Path | None) -> tuple[str, str]:
    """The plate of a project, and the hash by which it is known among others of its folder."""
    assert init is not None  # a job without a clip was refused
    clip = relinked(file.load(init), init.parent).require_clip()
    return str(clip.path), clip.content
