"""What a format is: the protocol of its writer, the options, and the checks that all writers share."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from itertools import pairwise
from pathlib import Path
from typing import Any, ClassVar, Protocol, runtime_checkable

from roam_core.arguments import shown
from roam_core.cancel import CancelToken, Progress, Reporting
from roam_core.errors import RoamError
from roam_core.interchange.bake_layers import BY_LAYER, bake_layers
from roam_core.interchange.keys.reduction import Motion, Slopes, reduced
from roam_core.interchange.keys.smoothing import smoothed
from roam_core.interchange.matte_style import MatteStyle
from roam_core.interchange.out_of_sight import without_points
from roam_core.interchange.telling import gathered
from roam_core.interchange.timing import value_within
from roam_core.roto import Clip, Interpolation, Keyframe, Layer, Origin, Project, RotoShape, Spline
from roam_core.roto.animated import Animatable, ValueKey, value_at
from roam_core.roto.bounds import is_near
from roam_core.roto.control_points import is_of_its_kind
from roam_core.roto.value_curves import opacity_as_seen
from roam_core.translatable import sentence

MAX_FRAMES = 1 << 24
"""No frame number beyond this, either way: single precision, which Nuke counts in, would round it."""


class KeyChoice(StrEnum):
    """Which keys leave the program."""

    EVERY = "every"
    ARTIST = "artist"
    REDUCED = "reduced"


@dataclass(frozen=True)
class ExportOptions(Reporting):
    """What an artist may choose, and the channels to whoever waits.

    Attributes
    ----------
    frame_offset : added to the plate's own frame numbers wherever a frame is written.
    keys : every key; the artist's only (a shape without any of the artist's gives every one); or as few as keep the
        outline within `tolerance` pixels, the artist's among them, in the format's own interpolation.
    tolerance : pixels, for reduced keys.
    smoothing : pixels by which the engine's keys may move so that the shape moves evenly; 0 leaves them where they are.
    frames : the plate's frames that are written, or None for all: pictures of no others, keys on no others, with the
        motion on these frames as it is.
    frame : the plate's frame for formats of still pictures; None is the first that is written.
    mattes : how pictures are written.
    lossy : write although the mattes will differ in the other program.
    progress : called with the finished fraction and a few words.
    token : cancels the export at its next safe point; no half-written file is left behind.
    """

    frame_offset: int = 0
    keys: KeyChoice = KeyChoice.EVERY
    tolerance: float = 0.5
    smoothing: float = 0.0
    frames: range | None = None
    frame: int | None = None
    mattes: MatteStyle = field(default_factory=MatteStyle)
    lossy: bool = False
    progress: Progress | None = None
    token: CancelToken | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "keys", KeyChoice(self.keys))
        if not isinstance(self.frames, range | None):
            raise ValueError(f"the frames to export are a range, such as range(1001, 1011), not {shown(self.frames)}")

    def frames_of(self, clip: Clip) -> range:
        """The frames that are written; a `RoamError` where they are none of the clip's, or numbered absurdly."""
        if max(abs(frame + self.frame_offset) for frame in (clip.first, clip.last)) > MAX_FRAMES:
            raise RoamError(
                sentence(
                    "An offset of {offset} would number frames beyond {most}; choose a smaller one.",
                    offset=self.frame_offset,
                    most=MAX_FRAMES,
                )
            )
        if self.frames is None:
            return clip.frame_range
        if not self.frames:
            raise RoamError(sentence("The last frame to export lies before the first; name the earlier one first."))
        if self.frames[0] < clip.first or self.frames[-1] > clip.last:
            raise RoamError(
                sentence(
                    "The frames to export must lie between {first} and {last}, the clip's own.",
                    first=clip.first,
                    last=clip.last,
                )
            )
        return self.frames

    def frame_of(self, clip: Clip) -> int:
        """The frame of a still picture; a `RoamError` where the clip does not have it."""
        frames = self.frames_of(clip)
        if self.frame is not None and self.frame not in clip.frame_range:
            raise RoamError(
                sentence(
                    "Frame {frame} lies outside of the clip's, which are {first} to {last}.",
                    frame=self.frame,
                    first=clip.first,
                    last=clip.last,
                )
            )
        return frames[0] if self.frame is None else self.frame


STANDARD = ExportOptions()


class LossyExport(RoamError):
    """A format cannot hold what makes the matte; nothing was written.

    `losses` has a sentence for each thing that would look different, with the shapes and layers.
    """

    def __init__(self, losses: Iterable[str]) -> None:
        self.losses = tuple(losses)
        super().__init__(" ".join(("Nothing was written, for the mattes would differ.", *self.losses)))


def settled(notes: Iterable[str], losses: Iterable[str], options: ExportOptions) -> tuple[str, ...]:
    """What an exporter tells: its losses and then its notes; a `LossyExport` for losses that nobody agreed to."""
    losses = gathered(losses)
    if losses and not options.lossy:
        raise LossyExport(losses)
    return (*losses, *gathered(notes))


class Exporter(Protocol):
    """One format to write: one room or file of this package, one line in `registry.py`.

    Attributes
    ----------
    name : how the command line calls it: lower case, one word.
    title : how a menu calls it.
    suffix : of the files that it writes, with the dot.
    """

    @property
    def name(self) -> str: ...

    @property
    def title(self) -> str: ...

    @property
    def suffix(self) -> str: ...

    def export(self, project: Project, path: Path, options: ExportOptions = ...) -> tuple[str, ...]:
        """Write all shapes of a project, the locked and the invisible ones too.

        Returns
        -------
        One sentence for each thing that the format cannot hold and that was therefore left out or changed.

        Raises
        ------
        LossyExport
            when the mattes would differ in the other program, and the options are not `lossy`.
        RoamError
            when the project has no clip, holds a point that is not a sensible number, or the file cannot be written.
        """
        ...


@runtime_checkable
class WritesSeveral(Protocol):
    """An exporter whose results are not the one file that is named."""

    def files(self, project: Project, path: Path, options: ExportOptions = ...) -> tuple[Path, ...]:
        """The files that `export` would write, or `RoamError` as it raises it for what cannot be asked for."""
        ...


@dataclass
class ShapeWriter:
    """What the writers of formats share: the clip, the options, the progress over `total` shapes, and what they tell.

    `losses` has one sentence for each thing that makes the matte differ in the other program; `notes` for what else is
    left out, and for each shape whose keys were smoothed or reduced. `settled` weighs them before anything is written.
    """

    KINDS: ClassVar[frozenset[Spline]] = frozenset({Spline.BEZIER})
    """Of curves that the format holds; others are written as the Bezier ones that they are as well."""

    clip: Clip
    options: ExportOptions
    total: int
    done: int = 0
    notes: list[str] = field(default_factory=list)
    losses: list[str] = field(default_factory=list)
    _b_spline: tuple[int, str] | None = None
    _b_splines: int = 0

    def __post_init__(self) -> None:
        self.options.frames_of(self.clip)

    def begun(self, shape: RotoShape) -> RotoShape:
        """The next shape, reported, with the keys that are to be exported to a format with linear interpolation."""
        return self.begun_for(shape, Motion.LINEAR)[0]

    def begun_for(self, shape: RotoShape, motion: Motion) -> tuple[RotoShape, tuple[Slopes | None, ...]]:
        """As `begun`, for a format that moves points by `motion`; and the slopes of reduced cubic spans, or nothing."""
        self.options.advance(self.done / self.total, sentence("Shape {name}", name=shape.name))
        self.done += 1
        if shape.spline not in self.KINDS or not is_of_its_kind(shape):
            self._tell_of_b_spline(shape.name)
            shape = replace(shape, spline=Spline.BEZIER)
        shape = exported_keys(shape, self.options, self.notes)
        if self.options.keys is not KeyChoice.REDUCED:
            return shape, ()
        reduction = reduced(shape, self.options.tolerance, motion, self.options.token)
        self.notes.append(reduction.report())
        return reduction.shape, reduction.slopes

    def numbered(self, frame: int) -> int:
        """A frame of the plate under its number in the file."""
        return frame + self.options.frame_offset

    def value_rows(self, value: Animatable, keys: Sequence[ValueKey]) -> list[Any]:
        """For scripts: the number on the clip's first frame, and the keys as frame, number and whether it holds."""
        rows = [[self.numbered(key.frame), key.value, key.interpolation is Interpolation.HOLD] for key in keys]
        return [value_at(value, self.clip.first), rows]

    def _tell_of_b_spline(self, name: str) -> None:
        """One note for all of them, where the first one's stands: what is lost is read."""
        first, self._b_spline = self._b_spline, self._b_spline or (len(self.notes), name)
        self._b_splines += 1
        if first is None:
            self.notes.append(
                sentence("The B-spline {name!r} is written as Bezier: the same curve, with other handles.", name=name)
            )
            return
        self.notes[first[0]] = sentence(
            "{count} B-splines, {name!r} among them, are written as Bezier: the same curves, with other handles.",
            count=self._b_splines,
            name=first[1],
        )


def artists_alone(project: Project, options: ExportOptions) -> Project:
    """The project without the engine's keys where the artist's are chosen: before layers carry what moves by these."""
    return replace(project, root=_artists(project.root)) if options.keys is KeyChoice.ARTIST else project


def _artists(layer: Layer) -> Layer:
    def kept(shape: RotoShape) -> RotoShape:
        keys = tuple(key for key in shape.keys if key.origin is Origin.ARTIST)
        return replace(shape, keys=keys or shape.keys)

    children = (_artists(item) if isinstance(item, Layer) else kept(item) for item in layer.children)
    return replace(layer, children=tuple(children))


def readied(project: Project, options: ExportOptions, *, are_labels: bool = False) -> Project:
    """What all writers begin with: layers that stand still, opacities between none and full, and these and feathers on
    the chosen frames only; where there is motion blur, feathers as far beyond them as the shutter reaches.

    The keys of outlines are chosen as each shape is begun. Where the engine's are among them, the opacity tells which
    shapes are out of sight: of hard ones, which close to a point there, for `are_labels` and before smoothing alone.

    Raises `RoamError` for frames that the clip does not have.
    """
    options.frames_of(project.require_clip())
    project = bake_layers(artists_alone(project, options))
    project = replace(project, root=_opacities_as_seen(project.root))
    project = replace(project, root=without_points(project.root, are_labels or options.smoothing > 0.0))
    return project if options.frames is None else replace(project, root=_values_within(project.root, options.frames))


def _opacities_as_seen(layer: Layer) -> Layer:
    """The layer with opacities between none and full everywhere, as mattes take them: programs refuse others."""
    children = (
        _opacities_as_seen(child)
        if isinstance(child, Layer)
        else replace(child, opacity=opacity_as_seen(child.opacity))
        for child in layer.children
    )
    return replace(layer, children=tuple(children), opacity=opacity_as_seen(layer.opacity))


def _values_within(layer: Layer, frames: range) -> Layer:
    children = (
        _values_within(child, frames)
        if isinstance(child, Layer)
        else replace(
            child,
            opacity=value_within(child.opacity, frames),
            feather=value_within(child.feather, _seen_from(child, frames)),
        )
        for child in layer.children
    )
    return replace(layer, children=tuple(children), opacity=value_within(layer.opacity, frames))


def exported_keys(shape: RotoShape, options: ExportOptions, notes: list[str]) -> RotoShape:
    """The shape with the keys that are to be exported: those that were chosen, on the chosen frames.

    Where it has motion blur, as far beyond them as the shutter reaches.
    """
    chosen = chosen_keys(shape, options, notes)
    return chosen if options.frames is None else within(chosen, _seen_from(shape, options.frames))


def _seen_from(shape: RotoShape, frames: range) -> range:
    return frames if shape.motion_blur is None else shape.motion_blur.seen_from(frames)


def with_chosen_keys(layer: Layer, options: ExportOptions, notes: list[str]) -> Layer:
    """The layer with `chosen_keys` of every shape in it."""
    children = (
        with_chosen_keys(child, options, notes) if isinstance(child, Layer) else chosen_keys(child, options, notes)
        for child in layer.children
    )
    return replace(layer, children=tuple(children))


def chosen_keys(shape: RotoShape, options: ExportOptions, notes: list[str]) -> RotoShape:
    """The shape with the artist's keys only, or smoothed, where that is asked for, on the plate's own frames.

    What smoothing does is added to `notes`. Raises `RoamError` for a point that is not finite or lies absurdly far
    away: no program could open it.
    """
    if options.keys is KeyChoice.ARTIST and shape.artist_frames:
        kept = (key for key in shape.keys if key.origin is Origin.ARTIST or key.inputs == BY_LAYER)
        shape = replace(shape, keys=tuple(kept))
    for key in shape.keys:
        for array in (key.points, key.feather):
            if array is not None and not is_near(array):
                raise RoamError(
                    sentence(
                        "The shape {name!r} has a point on frame {frame} that lies nowhere near the image; "
                        "correct or delete it, then export again.",
                        name=shape.name,
                        frame=key.frame,
                    )
                )
    if options.smoothing == 0.0:
        return shape
    smoothing = smoothed(shape, options.smoothing, options.token)
    if smoothing.shape is not shape:
        notes.append(smoothing.report())
    return smoothing.shape


def within(shape: RotoShape, frames: range) -> RotoShape:
    """The shape with keys on these frames only, which moves on them as it did: the ends of a cut span become keys."""
    first, last = frames[0], frames[-1]
    cut = {
        start.frame for start, stop in pairwise(shape.keys) for end in (first, last) if start.frame < end < stop.frame
    }
    shape = replace(shape, keys=tuple(_linear_keys(shape, cut)))
    keys = {key.frame: key for key in shape.keys if first <= key.frame <= last}
    for frame in (first, last):
        if frame not in keys and (shape.frames[0] < frame < shape.frames[-1] or not keys):
            outline = shape.at(frame)
            before = next((key for key in reversed(shape.keys) if key.frame < frame), shape.keys[0])
            keys[frame] = replace(before, frame=frame, points=outline.points, feather=outline.feather)
    return replace(shape, keys=tuple(keys[frame] for frame in sorted(keys)))


def without_smooth_keys(shape: RotoShape) -> RotoShape:
    """The shape with a linear key on every frame of its smooth spans, for formats that know linear and hold only."""
    return replace(shape, keys=tuple(_linear_keys(shape, set(shape.frames))))


def _linear_keys(shape: RotoShape, begun: set[int]) -> Iterator[Keyframe]:
    """The keys, with linear ones on every frame of the smooth spans that are `begun` on these frames."""
    for key, following in zip(shape.keys, (*shape.keys[1:], None), strict=True):
        if key.interpolation is not Interpolation.SMOOTH or key.frame not in begun:
            yield key
            continue
        yield replace(key, interpolation=Interpolation.LINEAR)
        for frame in range(key.frame + 1, key.frame if following is None else following.frame):
            outline = shape.at(frame)
            yield Keyframe(frame, outline.points, outline.feather, origin=key.origin)
