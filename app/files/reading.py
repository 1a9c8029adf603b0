"""What is read on the worker when something is opened: a clip, a project and its plate, the demo shot."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from roam_core.errors import RoamError
from roam_core.propagate.shapes.departed import departed_settings
from roam_core.roto import BlendMode, Clip, Origin, Project, edit, file
from roam_core.roto.backups import is_named_as_backup
from roam_core.roto.fingerprint import Fingerprint
from roam_core.roto.migrate import UNION_SINCE
from roam_core.roto.project_lock import Holder
from roam_core.roto.relinking import is_renumbered, open_plate, other_content, other_size, relinked
from roam_core.system_errors import reason_of

from ..jobs.runner import Report, Work
from ..model.document import PROJECT_SUFFIX
from ..model.reasons import keys_beside
from ..translation import N_, sentence_of, tr, translated

if TYPE_CHECKING:
    from roam_core.media import PlateSource

SUMMED = N_(
    "It joins soft edges as older versions did (Plus), so that its mattes stay as they were; "
    "choose Add in the Shape panel where they are to join as in other programs."
)

DEMO = N_(
    "The demo shot: press <track.forward> to track the shape, <track.stop> to stop; drag its points to correct it."
)


@dataclass(frozen=True)
class Found:
    """What was opened: the project, its plate or None, and the sentence about it.

    `path` is the file that saving writes to, `fingerprint` that of the file that was read; `follows` is the journal
    that the project was recovered from. It is unsaved work where no file holds it. `before` is the clip as the file has
    it, where the plate's pictures bear other numbers now.
    """

    project: Project
    source: Any
    sentence: str
    path: Path | None = None
    fingerprint: Fingerprint | None = None
    is_unsaved: bool = False
    follows: Path | None = None
    before: Clip | None = None


def clip_project(
    path: Path, declare: Callable[[PlateSource], PlateSource] | None = None, layer: str = ""
) -> tuple[Project, PlateSource]:
    """A new project on a clip, and the clip's source. Raises `RoamError` when there is no clip at `path`."""
    from roam_core.media import open_clip
    from roam_core.media.colour_spaces import definition_of

    source = open_clip(path, layer)
    if declare is not None:
        source = declare(source)
    definition_of(source.colour_space)  # kept from now on: stamps ask for it in the window's thread
    return Project(Clip.of(source)), source


def version_of(clip: Clip, before: PlateSource | None, path: Path) -> PlateSource:
    """The plate at `path`, read as the project's `clip` is; what was declared of the plate `before` holds.

    Of several sequences in a folder it is the one that the project was made on.
    """
    from roam_core.media import declared, open_clip
    from roam_core.media.declared import DeclaredPlate

    source = open_clip(path, content=clip.content)
    if clip.layer in source.layers:
        source = open_clip(path, clip.layer, clip.content)
    if isinstance(before, DeclaredPlate):
        source = declared(source, clip.colour_space, clip.fps, clip.pixel_aspect)
    return source


def read_version(project: Project, before: PlateSource | None, path: Path) -> Found:
    """The project with the plate that lies at `path`, read as its own one, `before`, is."""
    source = version_of(project.require_clip(), before, path)
    sentence = differences(project, source) or tr("The plate is {name} now; save to keep that.", name=source.path.name)
    return _with_plate(project, source, sentence)


def reloaded(project: Project) -> Found:
    """The project with its plate read anew; unsaved where that has other frames now, or another size."""
    held = project.require_clip()
    source = _plate(held)
    if Clip.of(source) == replace(held, extra={}):
        return Found(project, source, tr("The plate was read anew. Track again what it shows otherwise now."))
    changed = tr("The plate was read anew: it has changed; save to keep that.")
    return _with_plate(project, source, differences(project, source) or changed)


def _with_plate(project: Project, source: PlateSource, sentence: str) -> Found:
    held = project.require_clip()
    clip = replace(Clip.of(source), extra=held.extra)
    sentence = " ".join(filter(None, (sentence, keys_beside(project.shapes, clip, held))))
    return Found(replace(project, clip=clip), source, sentence, is_unsaved=True)


def read_as(project: Project, layer: str, declare: Callable[[PlateSource], PlateSource]) -> Found:
    """The project with the same plate, of which another layer is taken or something else is declared."""
    from roam_core.media.colour_spaces import definition_of

    held = project.require_clip()
    source = declare(open_plate(replace(held, layer=layer)))
    definition_of(source.colour_space)
    now = Clip.of(source)
    clip = replace(
        held, size=now.size, layer=now.layer, colour_space=now.colour_space, fps=now.fps, pixel_aspect=now.pixel_aspect
    )
    sentence = tr("The clip is read so from now on; save to keep that.")
    is_tracked = any(key.origin is Origin.ENGINE for shape in project.shapes for key in shape.keys)
    if is_tracked and (clip.layer, clip.colour_space) != (held.layer, held.colour_space):
        sentence += tr(" Tracked frames are out of date: they were found in other colours.")
    return Found(replace(project, clip=clip), source, sentence if clip != held else "", is_unsaved=True)


def demo_project(report: Report) -> tuple[Project, Any]:
    from roam_core.installation import demo

    from ..folders import cache_folder

    folder = cache_folder() / demo.cache_name()
    try:

        def tell(fraction: float, text: str) -> None:
            frame = text.rpartition(" ")[2]  # what is rendered says it in English, the number last
            done = tr("The demo shot is rendered …")
            report.progress(
                fraction, tr("Rendering the demo shot, frame {frame} …", frame=frame) if fraction < 1.0 else done
            )

        demo.write_frames(folder, tell)
    except OSError as error:
        raise RoamError(
            tr(
                "The demo shot cannot be written to {folder}: {reason}.",
                folder=folder,
                reason=translated(reason_of(error)),
            )
        ) from None
    project, source = clip_project(folder)
    project, _ = edit.new_shape(project, demo.true_points(demo.FIRST), demo.FIRST, name="Manta")
    return project, source


def read_project(path: Path) -> Found:
    # Before it is read: what is written meanwhile is a change.
    fingerprint = Fingerprint.of(path)
    stored, version = file.load_versioned(path)
    project = relinked(stored, path.parent)
    source, problem = plate_of(project)
    moved = (
        ""
        if project is stored
        else tr(" Its plate was found at {path}; save to keep that.", path=project.require_clip().path)
    )
    told = problem or tr("Opened {name}.{moved}", name=path.name, moved=moved)
    more = [_older(project, version), translated(departed_settings(project.shapes))]
    numbered, before, numbers = with_numbers(project, source)
    beyond = "" if before else _beyond(project, source)
    sentence = " ".join(filter(None, (told, numbers, beyond, *more)))
    return Found(numbered, source, sentence, path, fingerprint, is_unsaved=before is not None, before=before)


def with_numbers(project: Project, source: PlateSource | None) -> tuple[Project, Clip | None, str]:
    """The project with the numbers that its plate's pictures bear now, its clip before that, and a sentence.

    Where they bear those of the project's clip nothing is changed: None and "".
    """
    if (before := project.clip) is None or source is None or not is_renumbered(before, now := Clip.of(source)):
        return project, None, ""
    numbers = tr("Its plate is numbered from {first} now, not from {before}.", first=now.first, before=before.first)
    return replace(project, clip=replace(now, extra=before.extra)), before, numbers


def _beyond(project: Project, source: PlateSource | None) -> str:
    """Where the plate has frames that the project's clip has not, as one that was still being written when it came."""
    if project.clip is None or source is None:
        return ""
    found, frames = Clip.of(source), project.clip.frame_range
    if found.first in frames and found.last in frames:
        return ""
    return tr(
        "The plate has frames {first} to {last} now, the project {before} to {after}; File > Relink clip takes them.",
        first=found.first,
        last=found.last,
        before=project.clip.first,
        after=project.clip.last,
    )


def _older(project: Project, version: int) -> str:
    """What an artist must know of a project whose file is of an older version; mostly nothing."""
    is_summed = version < UNION_SINCE and any(item.blend is BlendMode.PLUS for item in project.root.items())
    return tr(SUMMED) if is_summed else ""


def plate_of(project: Project) -> tuple[Any, str]:
    """The plate of a project, or None and why it could not be opened; or the plate and what differs from before."""
    if (clip := project.clip) is None:
        return None, ""
    try:
        source = _plate(clip)
    except RoamError as error:
        return None, tr(
            "The plate could not be opened; choose it again in the File menu. {error}", error=sentence_of(error)
        )
    return source, differences(project, source)


def _plate(clip: Clip) -> PlateSource:
    """The plate of a clip, read as the clip says."""
    from roam_core.media import declared
    from roam_core.media.colour_spaces import definition_of

    definition_of(clip.colour_space)
    return declared(open_plate(clip), clip.colour_space, clip.fps, clip.pixel_aspect)


def differences(project: Project, source: PlateSource) -> str:
    """What tells a plate from the one that the project was made on, as a sentence; "" where nothing does."""
    if project.clip is None:
        return ""
    found = Clip.of(source)
    return translated(other_size(project.clip, found) or other_content(project.clip, found))


def gaps_of(source: Any) -> str:
    missing = len(source.missing)
    return tr("%n frame(s) is/are missing.", "", missing) if missing else ""


def reading_work(text: str, read: Callable[[], Found | Holder]) -> Work:
    """The work of reading something; its sentence is that of what was found."""

    def work(report: Report) -> str:
        report.progress(0.0, text)
        found = read()
        report.token.check()
        report.partial(found)
        return found.sentence if isinstance(found, Found) else ""

    return work


def holds_project(path: Path) -> bool:
    """By its name: a project file, or an earlier version of one."""
    return path.suffix.lower() == PROJECT_SUFFIX or is_named_as_backup(path)
