"""An edit of OpenTimelineIO: its clips become jobs, handles included, and their mattes go back above them."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from roam_core.atomic_write import write_atomically
from roam_core.bounded import bounded_bytes
from roam_core.errors import RoamError
from roam_core.installation import studio_module
from roam_core.media import PlateSource, open_clip
from roam_core.media.numbering import NamePattern
from roam_core.studio.jobs import Job, Jobs, Step, require_possible

SUFFIX = ".otio"
LIBRARY = "opentimelineio"
MOST_BYTES = 256 << 20
INIT_SUFFIXES = (".roam", ".png", ".exr", ".tif", ".tiff", ".jpg")
DIGITS = 6
"""Decimals of a frame: what seconds counted in another rate leave behind them."""
_ESCAPED = re.compile(r"(?:%(?!0[1-9]d)[0-9a-fA-F]{2})+")
_DRIVE = "[a-zA-Z](?::|%3[aA])"
"""How a drive of Windows begins in a URL, where some programs write the colon by its number."""
Steps = tuple[Step, ...] | Callable[[Path | None], tuple[Step, ...]]
"""The steps of every job, or what gives them by what a job begins with."""


def read_edit(path: Path) -> Any:
    """The timeline of an `.otio` file. Raises `RoamError` where there is none that can be read."""
    otio = studio_module(LIBRARY)
    content = bounded_bytes(path, MOST_BYTES)
    try:
        text = content.decode("utf-8")
        json.loads(text)  # what is nested too deeply, or is no JSON, is told here
        timeline = otio.core.deserialize_json_from_string(text)
    except RecursionError:
        raise RoamError(f"{path} is nested too deeply to be an edit.") from None
    except (ValueError, otio.exceptions.OTIOError) as error:
        raise RoamError(f"{path} is no edit of OpenTimelineIO: {error}.") from None
    if not isinstance(timeline, otio.schema.Timeline):
        raise RoamError(f"{path} holds no timeline of OpenTimelineIO.")
    return timeline


def jobs_of_edit(timeline: Any, path: Path, inits: Path, handles: int, steps: Steps) -> Jobs:
    """A job for every clip of the edit's video tracks that has a mask or project of its name in `inits`.

    A job's frames are those of the clip that the edit shows, with what transitions take, and `handles` more at either
    end as far as the plate has them. A mask is of the first of these frames.

    Raises `RoamError` where no clip has an init, or the plate of one that has cannot be opened.
    """
    jobs, count = [], 0
    for name, clip in _named_clips(timeline):
        count += 1
        init = next(
            (inits / f"{name}{suffix}" for suffix in INIT_SUFFIXES if (inits / f"{name}{suffix}").exists()), None
        )
        if init is None:
            if clip.source_range is None:  # how long it lasts is asked for where mattes are laid above it
                with suppress(RoamError):
                    _require_range(clip, open_clip(_media_path(clip, path.absolute().parent, name)), name)
            continue
        plate = open_clip(_media_path(clip, path.absolute().parent, name))
        _require_range(clip, plate, name)
        first, last = _frames(clip, plate, name, handles)
        chosen = steps(init) if callable(steps) else steps
        is_mask = init.suffix.lower() != ".roam"
        job = Job(name, tuple(_within(step, first, last, is_mask) for step in chosen), str(plate.path), init.absolute())
        require_possible(job, name)
        jobs.append(job)
    if not jobs:
        raise RoamError(f"None of the {count} clip(s) of {path} has a mask or project of its name in {inits}.")
    return Jobs(tuple(jobs), path.absolute().with_suffix(""))


def write_with_mattes(timeline: Any, jobs: Jobs, path: Path) -> None:
    """Write the edit with a track of mattes above each of its video tracks that has any; gaps where a clip has none.

    Raises `RoamError` where it cannot be written.
    """
    otio = studio_module(LIBRARY)
    require_edit(path)
    made = timeline.deepcopy()
    by_name = {job.name: job for job in jobs.jobs}
    named = list(_named_clips(made))
    tracks = made.find_children(otio.schema.Track)  # those in stacks within others, too
    for track in [each for each in tracks if each.kind == otio.schema.TrackKind.Video]:
        mattes = otio.schema.Track(name=f"{track.name} mattes".strip(), kind=track.kind)
        has_any = False
        for item in track:
            if isinstance(item, otio.schema.Transition):
                continue
            job = by_name.get(next((name for name, clip in named if clip is item), ""))
            reference = None if job is None else _matte_reference(job, jobs.out / job.name / "mattes", item)
            has_any = has_any or reference is not None
            mattes.append(_above(item, reference))
        if has_any:
            track.parent().insert(track.parent().index(track) + 1, mattes)
    write_atomically(path, otio.core.serialize_json_to_string(made, indent=1).encode())


def require_edit(path: Path) -> None:
    """Raise `RoamError` where a name is none for an edit that is written."""
    if path.suffix.lower() != SUFFIX:
        raise RoamError(f"An edit is written as OpenTimelineIO; {path.name} does not end in {SUFFIX}.")


def _above(item: Any, reference: Any) -> Any:
    """A copy of a clip with mattes for its media, or a gap as long as the item."""
    otio = studio_module(LIBRARY)
    if reference is None:
        try:
            return otio.schema.Gap(source_range=otio.opentime.TimeRange(duration=item.duration()))
        except otio.exceptions.CannotComputeAvailableRangeError:
            raise RoamError(
                f"How long {item.name or 'a clip'} lasts is not said in the edit; relink it first."
            ) from None
    clip = otio.schema.Clip(
        name=item.name, media_reference=reference, source_range=item.trimmed_range(), metadata=item.metadata
    )
    clip.enabled = item.enabled
    clip.effects.extend(effect.deepcopy() for effect in item.effects)
    return clip


def _matte_reference(job: Job, folder: Path, clip: Any) -> Any:
    """The mattes of a job as a sequence of images in the clip's own time; None where there are none."""
    otio = studio_module(LIBRARY)
    plate = open_clip(job.clip or "")
    found = {path.stem: path for path in sorted(folder.iterdir())} if folder.is_dir() else {}
    step = max(getattr(clip.media_reference, "frame_step", 1), 1)
    whole = getattr(clip.media_reference, "start_frame", 0)
    shown = (frame for frame in plate.frames if (frame - whole) % step == 0)
    there = [frame for frame in shown if plate.frame_name(frame) in found]
    numbered = _pattern(plate, there)
    if numbered is None:
        return None
    start, rate = clip.available_range().start_time, _rate(clip)
    shift = otio.opentime.RationalTime(there[0] - _place_at(clip, plate, start), rate).rescaled_to(start.rate)
    length = otio.opentime.RationalTime(there[-1] - there[0] + step, rate).rescaled_to(start.rate)
    return otio.schema.ImageSequenceReference(
        target_url_base=otio.url_utils.url_from_filepath(str(folder)) + "/",
        name_prefix=numbered.prefix,
        name_suffix=numbered.suffix + found[plate.frame_name(there[0])].suffix,
        start_frame=there[0],
        frame_step=step,
        frame_zero_padding=numbered.width,
        rate=rate,
        available_range=otio.opentime.TimeRange(start + shift, length),
        metadata={"roam": {"project": str(folder.parent / f"{job.name}.roam")}},
    )


def _pattern(plate: PlateSource, frames: list[int]) -> NamePattern | None:
    """How the names of a plate's frames count them; of several groups of digits the one that does. None for none."""
    name = plate.frame_name(frames[0]) if frames else ""
    for digits in reversed([*re.finditer(r"[0-9]+", name)]):
        before = name[: digits.start()].removesuffix("-") if frames[0] < 0 else name[: digits.start()]
        pattern = NamePattern(before, len(digits[0]), name[digits.end() :])
        if all(pattern.name(frame) == plate.frame_name(frame) for frame in (frames[0], frames[-1])):
            return pattern
    return None


def _named_clips(timeline: Any) -> Iterator[tuple[str, Any]]:
    """Every clip of the video tracks, with a name that can be a folder's and that no other has."""
    otio = studio_module(LIBRARY)
    taken: set[str] = set()
    for track in timeline.video_tracks():
        for clip in track.find_children(otio.schema.Clip):
            plain = re.sub(r"[^\w.+-]+", "_", clip.name or "").strip("._") or "clip"
            name, number = plain[:100], 2
            while name.casefold() in taken:
                name, number = f"{plain[:100]}-{number}", number + 1
            taken.add(name.casefold())
            yield name, clip


def _media_path(clip: Any, folder: Path, name: str) -> str:
    """Where a clip's media lie: a path, or a pattern of a sequence."""
    otio = studio_module(LIBRARY)
    reference = clip.media_reference
    if isinstance(reference, otio.schema.ImageSequenceReference):
        base = _path_of(reference.target_url_base or ".", folder, name)
        number = f"%0{reference.frame_zero_padding}d" if reference.frame_zero_padding else "%d"
        return str(base / f"{reference.name_prefix}{number}{reference.name_suffix}")
    if isinstance(reference, otio.schema.ExternalReference):
        return str(_path_of(reference.target_url, folder, name))
    raise RoamError(f"The clip {name} of the edit has no media; relink it first.")


def _path_of(url: str, folder: Path, name: str) -> Path:
    """The path that a URL of a file, or a plain path, names; those that begin nowhere begin in the folder.

    Some programs write URLs by the standard (`%20` is a blank), others a path as it is behind `file://`, and relative
    paths in either way: of the two readings the one that is there is meant.
    """
    scheme = re.match(r"([a-zA-Z][\w+.-]+):", url)
    if scheme is not None and scheme[1].lower() != "file":
        raise RoamError(f"The clip {name} of the edit lies at {url}; only files are opened.")
    plain = url if scheme is None else _without_scheme(url)
    readings = [folder / each for each in ((plain, _decoded(plain)) if scheme is None else (_decoded(plain), plain))]
    there = [place for place in readings if place.exists()] or [place for place in readings if place.parent.is_dir()]
    return (there or readings)[0]


def _without_scheme(url: str) -> str:
    """What follows `file:` and this machine's name in a URL, as it is; another machine's name begins a network path."""
    place = url.partition(":")[2]
    if not place.startswith("//"):
        return place
    host, slash, rest = place[2:].partition("/")
    if host.lower() in ("", "localhost"):
        return rest if re.match(_DRIVE, rest) else f"/{rest}"
    return f"{host}{slash}{rest}" if re.fullmatch(_DRIVE, host) else place


def _decoded(text: str) -> str:
    """A path of a URL with the characters that stand there by their numbers; `%04d`, a frame's place, is none."""
    return _ESCAPED.sub(lambda found: bytes.fromhex(found[0].replace("%", "")).decode(errors="replace"), text)


def _frames(clip: Any, plate: PlateSource, name: str, handles: int) -> tuple[int, int]:
    """The first and the last frame of a plate that a clip of an edit wants."""
    otio = studio_module(LIBRARY)
    shown = clip.trimmed_range()
    speed = max([1.0, *(abs(effect.time_scalar) for effect in clip.effects if _is_warp(effect))])
    begin = _place_at(clip, plate, shown.start_time)
    # Where the edit counts faster than the plate, its last moment may lie within a frame.
    end = round(begin + shown.duration.rescaled_to(_rate(clip)).value * speed, DIGITS)
    first, last = math.floor(begin), math.ceil(end) - 1
    is_in_track = isinstance(clip.parent(), otio.schema.Track)  # else it lies in a stack, alone
    before, after = clip.parent().neighbors_of(clip) if is_in_track else (None, None)
    if isinstance(before, otio.schema.Transition):
        first -= round(before.in_offset.rescaled_to(_rate(clip)).value)
    if isinstance(after, otio.schema.Transition):
        last += round(after.out_offset.rescaled_to(_rate(clip)).value)
    there = plate.frames[0], plate.frames[-1]
    if last < there[0] or first > there[1]:
        raise RoamError(f"The clip {name} shows the frames {first} to {last}; its plate has {there[0]} to {there[1]}.")
    return max(first - handles, there[0]), min(last + handles, there[1])


def _require_range(clip: Any, plate: PlateSource, name: str) -> None:
    """Give the media of a clip, of which an edit need not say it, the range of time that they last.

    They are as long as the plate, and begin at 0 or at the number of its first frame: where only one of these takes in
    what the clip shows, it is meant. Raises `RoamError` where both do, or neither.
    """
    otio = studio_module(LIBRARY)
    media, shown = clip.media_reference, clip.source_range
    if media.available_range is not None:
        return
    rate = plate.fps if shown is None else shown.start_time.rate
    first, length = plate.frames[0], plate.frames[-1] - plate.frames[0] + 1
    rate = _sequence_rate(media) or rate
    starts = {0, first}
    if shown is None:
        starts = {first}
    else:
        times = shown.start_time, shown.end_time_exclusive()
        begin, end = (round(time.rescaled_to(rate).value, DIGITS) for time in times)
        starts = {start for start in starts if start <= begin and end <= start + length}
    if len(starts) != 1:
        raise RoamError(
            f"The clip {name} does not say at which time its media begin (available_range), and by its plate, frames "
            f"{first} to {plate.frames[-1]}, it cannot be told; give it that in the edit."
        )
    media.available_range = otio.opentime.TimeRange(
        otio.opentime.RationalTime(starts.pop(), rate), otio.opentime.RationalTime(length, rate)
    )


def _is_warp(effect: Any) -> bool:
    return isinstance(effect, studio_module(LIBRARY).schema.LinearTimeWarp)


def _rate(clip: Any) -> float:
    """How many numbers of the plate's frames a second takes."""
    return _sequence_rate(clip.media_reference) or float(clip.available_range().start_time.rate)


def _sequence_rate(reference: Any) -> float:
    """That of a sequence of images, whatever the rate that its times are told in; 0 where it has none.

    1 is what the library puts where none was given.
    """
    is_sequence = isinstance(reference, studio_module(LIBRARY).schema.ImageSequenceReference)
    return float(reference.rate) if is_sequence and reference.rate != 1.0 else 0.0


def _place_at(clip: Any, plate: PlateSource, time: Any) -> float:
    """The plate's frame at a time of a clip's media, which begin with its first one, and how much of it is over.

    A sequence's numbers go on by its rate, whatever its `frame_step`: that says which of them are pictures.
    """
    first = getattr(clip.media_reference, "start_frame", None)
    since = (time - clip.available_range().start_time).rescaled_to(_rate(clip)).value
    start: int = plate.frames[0] if first is None else int(first)
    return start + round(float(since), DIGITS)


def _within(step: Step, first: int, last: int, is_mask: bool) -> Step:
    """A step that keeps to a range of frames, where it can and nothing else was said."""
    if step.verb == "track":
        return replace(step, options={**({"start": first} if is_mask else {}), "end": last, **step.options})
    if step.verb == "render":
        return replace(step, options={"start": first, "end": last, **step.options})
    return step
