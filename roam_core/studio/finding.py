"""Jobs wherever they are told: in a file, by folders of shots, or by the clips of an edit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.studio import edits
from roam_core.studio.jobs import Job, Jobs, Step, read_jobs, require_name, require_possible, steps_named

PLATES = ("plate", "plate.mov", "plate.mp4", "plate.mxf", "plate.avi", "plate.mkv")
INITS = ("init.roam", "init.png", "init.exr", "init.tif", "init.tiff", "init.jpg")
MATTES = "mattes"


@dataclass(frozen=True)
class Found:
    """Jobs, and what writes an edit with their mattes to a path (of an edit; others refuse).

    `notes` are sentences about what was passed over.
    """

    jobs: Jobs
    write_timeline: Callable[[Path], None]
    notes: tuple[str, ...] = ()


def jobs_from(
    path: Path, *, steps: str | None = None, handles: int = 0, inits: Path | None = None, out: Path | None = None
) -> Found:
    """The jobs of a file, of a folder of shots (`shots_in`) or of an edit (`edits.jobs_of_edit`).

    `steps`, in short, take the place of the usual ones; of a file of jobs they are what it says. `out` is the folder
    of results in any case.

    Raises `RoamError` where there are none, or they cannot be carried out as they stand.
    """
    wanted = None if steps is None else steps_named(steps)
    if path.suffix.lower() == edits.SUFFIX:
        return _of_edit(path, wanted, handles, inits, out)
    if handles or inits is not None:
        raise RoamError("--handles and --inits are for an edit (.otio).")
    if path.is_dir():
        jobs = shots_in(path, wanted)
    else:
        if wanted is not None:
            raise RoamError(f"{path} says its steps itself; --steps is for folders of shots and edits.")
        jobs = read_jobs(path)
    return Found(_into(jobs, out), _no_timeline, half_shots_in(path) if path.is_dir() else ())


def shots_in(folder: Path, steps: tuple[Step, ...] | None = None) -> Jobs:
    """The shots of a folder, each a folder by its name with `plate` (or `plate.mov`), and `init.png` or `init.roam`.

    A folder `mattes` in place of an init is imported. Without `steps` a shot with a mask is tracked and rendered, one
    with a project is filled between its keys, and one with mattes has them imported and rendered.
    """
    jobs = tuple(job for shot in _folders(folder) if (job := _shot(shot, steps)) is not None)
    if not jobs:
        raise RoamError(
            f"{folder} holds no shots: folders with a plate each ({', '.join(PLATES[:2])}), and with an init.png, an "
            "init.roam or a folder mattes."
        )
    for job in jobs:
        require_name(job.name, str(folder / job.name))
        require_possible(job, str(folder / job.name))
    return Jobs(jobs, folder.absolute().with_name(f"{folder.absolute().name}-roam"))


def half_shots_in(folder: Path) -> tuple[str, ...]:
    """Sentences about folders that hold half of what a shot is: a plate alone, or what begins one alone."""
    notes = []
    for shot in _folders(folder):
        plate, init, has_mattes = _parts(shot)
        if plate is not None and init is None and not has_mattes:
            notes.append(f"{shot} is left out: it has no init.png, init.roam or folder mattes.")
        if plate is None and (init is not None or has_mattes):
            notes.append(f"{shot} is left out: it has no plate ({', '.join(PLATES)}).")
    return tuple(notes)


def _folders(folder: Path) -> list[Path]:
    return [each for each in sorted(folder.iterdir()) if each.is_dir() and not each.name.startswith(".")]


def _parts(folder: Path) -> tuple[Path | None, Path | None, bool]:
    """The plate of a shot's folder, its init, and whether it has mattes."""
    plate, init = (
        next((folder / name for name in names if (folder / name).exists()), None) for names in (PLATES, INITS)
    )
    return plate, init, (folder / MATTES).is_dir()


def _shot(folder: Path, steps: tuple[Step, ...] | None) -> Job | None:
    plate, init, has_mattes = _parts(folder)
    if plate is None or (init is None and not has_mattes):
        return None
    chosen = _usual(init) if steps is None else steps
    brought = (Step("import", {"source": str((folder / MATTES).absolute())}),) if init is None else ()
    absolute = None if init is None else init.absolute()
    return Job(folder.name, (*brought, *chosen), str(plate.absolute()), absolute)


def _usual(init: Path | None) -> tuple[Step, ...]:
    """Steps that follow from what a job begins with."""
    if init is None:
        return (Step("render"),)
    return (Step("fill" if init.suffix.lower() == ".roam" else "track"), Step("render"))


def _of_edit(path: Path, steps: tuple[Step, ...] | None, handles: int, inits: Path | None, out: Path | None) -> Found:
    if inits is None:
        raise RoamError(f"{path} says nothing of shapes; name the folder of masks and projects with --inits.")
    timeline = edits.read_edit(path)
    jobs = _into(edits.jobs_of_edit(timeline, path, inits, handles, steps or _usual), out)
    return Found(jobs, lambda target: edits.write_with_mattes(timeline, jobs, target))


def _into(jobs: Jobs, out: Path | None) -> Jobs:
    return jobs if out is None else replace(jobs, out=out.absolute())


def _no_timeline(_: Path) -> None:
    raise RoamError("--timeline is for an edit (.otio).")
