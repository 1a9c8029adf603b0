"""Nuke's Tracker4 and CornerPin2D: how points and shapes move, as nodes that stabilise, match-move or pin.

`.nk` holds no motion of a shape but its points; a compositor's artist also wants the motion itself. Each shape gives a
corner pin, the similarity that carries its outline from its first artist's key, and a tracker with one track for each
corner of the box around it. Each layer that moves gives the same for the box around what lies in it, by its own motion:
the pin is a planar track, perspective and all.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from roam_core.arrays import Array
from roam_core.atomic_write import write_atomically
from roam_core.errors import RoamError
from roam_core.geometry import projective, similarity
from roam_core.interchange.bake_layers import bake_layers
from roam_core.interchange.nuke.keys import LAST_EXACT_FRAME
from roam_core.interchange.nuke.text import HEAD, tcl_word
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, artists_alone, exported_keys
from roam_core.interchange.telling import gathered
from roam_core.roto import Clip, Layer, Project, RotoShape
from roam_core.roto.bounds import is_near
from roam_core.roto.placement import matrix_at
from roam_core.roto.sight import is_out_of_sight
from roam_core.translatable import N_, sentence

BOTTOM_LEFT, BOTTOM_RIGHT, TOP_RIGHT, TOP_LEFT = range(4)
"""Order of a corner pin's corners."""

COLUMNS = (
    ("5 1 20", "enable", "e"),
    ("3 1 75", "name", "name"),
    *(("2 1 58", name, name) for name in ("track_x", "track_y")),
    *(("2 1 63", name, name) for name in ("offset_x", "offset_y")),
    *(("4 1 27", name, name) for name in "TRS"),
    ("2 0 45", "error", "error"),
    *(("1 1 0", name, name) for name in ("error_min", "error_max")),
    *(("1 1 0", f"{box}_{side}", f"{box}_{side}") for box in ("pattern", "search") for side in "xyrt"),
    ("2 1 0", "key_track", "key_track"),
    *(("2 1 0", f"key_{box}_{side}", f"key_{box}_{side}") for box in ("search", "track") for side in "xyrt"),
    *(("2 1 0", f"key_centre_offset_{axis}", f"key_centre_offset_{axis}") for axis in "xy"),
)
"""The 31 columns of a tracker's table: type, whether saved and width; name; heading."""


@dataclass(frozen=True)
class Track:
    """A point through time: `frames`, strictly rising, and `positions (F, 2)` in our pixels; it may have gaps."""

    name: str
    frames: Sequence[int]
    positions: Array

    def __post_init__(self) -> None:
        if len(self.frames) == 0 or np.shape(self.positions) != (len(self.frames), 2):
            raise ValueError(f"track {self.name!r} has {len(self.frames)} frames, positions {np.shape(self.positions)}")
        if (np.diff(self.frames) <= 0).any():
            raise ValueError(f"the frames of track {self.name!r} do not rise")
        if max(abs(frame) for frame in self.frames) > LAST_EXACT_FRAME or not is_near(self.positions):
            raise RoamError(
                sentence("The track {name!r} goes where no image is; it cannot be exported.", name=self.name)
            )


class NukeTracksExporter:
    """Writes how each moving layer and each shape moves, as one Tracker4 and one CornerPin2D node for each."""

    name = "nuke-tracks"
    title = N_("Nuke Tracker and CornerPin nodes")
    suffix = ".nk"

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write `project` to `path`; a shape with one key does not move and is left out, with a note."""
        clip, baked = project.require_clip(), bake_layers(artists_alone(project, options))
        writer = ShapeWriter(clip, options, len(project.shapes))
        nodes = []
        for layer in project.root.items():
            if isinstance(layer, Layer) and layer.transform is not None and len(layer.transform.frames) > 1:
                nodes += _nodes(layer.name, *layer_motion(project, layer, options), writer)
        for shape in baked.shapes:
            options.advance(writer.done / writer.total, sentence("Shape {name}", name=shape.name))
            writer.done += 1
            shape = exported_keys(shape, options, writer.notes)
            if len(shape.keys) < 2:
                writer.notes.append(sentence("{name!r} has one key and no motion; it is left out.", name=shape.name))
                continue
            corners, frames = box_motion(shape)
            reference = reference_frame(shape)
            nodes += _nodes(shape.name, frames, corners, corners[frames.index(reference)], reference, writer)
        options.advance(1.0, sentence("Writing {name}", name=path.name))
        write_atomically(path, (HEAD + "".join(nodes)).encode("utf-8"))
        return gathered(writer.notes)


def _nodes(
    name: str, frames: Sequence[int], corners: Array, pinned: Array, reference: int, writer: ShapeWriter
) -> list[str]:
    """The tracker and the pin of `corners (F, 4, 2)` that go out from `pinned (4, 2)`."""
    sides = ("bottom left", "bottom right", "top right", "top left")
    tracks = [Track(f"{name} {side}", frames, corners[:, index]) for index, side in enumerate(sides)]
    clip, offset = writer.clip, writer.options.frame_offset
    return [
        tracker_node(tracks, clip, reference, offset),
        corner_pin_node(name, frames, corners, pinned, clip, offset),
    ]


def layer_motion(
    project: Project, layer: Layer, options: ExportOptions = STANDARD
) -> tuple[list[int], Array, Array, int]:
    """How a layer and those above it move what lies in it.

    Returns
    -------
    The frames, F of them; the corners `(F, 4, 2)` of the box around what lies in the layer, as a corner pin lists them;
    the box itself `(4, 2)`, in the layer's own space; the frame on which the layer puts it nearest to there.
    """
    placement = project.placement_in(layer.id)
    ends = [frame for transform in placement for frame in transform.frames]
    moving = range(min(ends), max(ends) + 1)
    written = moving if options.frames is None else options.frames_of(project.require_clip())
    frames = [frame for frame in moving if frame in written] or [written[0]]
    box = _box_in(layer, project.require_clip())
    corners = np.stack([projective.apply(matrix_at(placement, frame), box) for frame in frames])
    away = np.abs(corners - box).max(axis=(1, 2))
    return frames, corners, box, frames[int(np.argmin(away))]


def _box_in(layer: Layer, clip: Clip) -> Array:
    """The corners `(4, 2)` of the box around the shapes of a layer, in its own space; of an empty one the picture's."""
    shapes = replace(layer, transform=None).in_plate_space().shapes()
    places = [shape.at(reference_frame(shape)).flatten() for shape in shapes] or [np.array([[0, 0], clip.size])]
    whole = np.concatenate(places)
    (left, top), (right, bottom) = whole.min(axis=0), whole.max(axis=0)
    return np.array([[left, bottom], [right, bottom], [right, top], [left, top]], dtype=np.float64)


def reference_frame(shape: RotoShape) -> int:
    """The frame from which a shape's motion is measured: its first artist's key, or its first one that is in sight."""
    seen = (frame for frame in shape.frames if not is_out_of_sight(shape, frame))
    return next(iter(shape.artist_frames or seen), shape.frames[0])


def box_motion(shape: RotoShape) -> tuple[Array, list[int]]:
    """The corners `(F, 4, 2)` of the box around a shape, carried by the similarity that fits its outline best.

    The box is that of the reference frame; F are all frames from the first key to the last on which the shape is in
    sight: closed to a point it tells no motion. Corners in the order of a corner pin: bottom left, bottom right, top
    right, top left, in our pixels, y down.
    """
    every = range(shape.frames[0], shape.frames[-1] + 1)
    seen = [frame for frame in every if not is_out_of_sight(shape, frame)]
    frames = seen if reference_frame(shape) in seen else list(every)
    origin = shape.at(reference_frame(shape))
    left, top = origin.flatten().min(axis=0)
    right, bottom = origin.flatten().max(axis=0)
    box = np.array([[left, bottom], [right, bottom], [right, top], [left, top]])
    source = origin.points.reshape(-1, 2)
    corners = [similarity.apply(similarity.fit(source, shape.at(f).points.reshape(-1, 2)), box) for f in frames]
    return np.stack(corners), frames


def tracker_node(
    tracks: Sequence[Track],
    clip: Clip,
    reference: int,
    frame_offset: int = 0,
    frames: Iterable[int] = (),
    label: str | None = None,
) -> str:
    """The text of a Tracker4 node.

    A track is enabled on the frames that it has and not on others that the node knows; between its places goes a
    straight line, before and after them it rests. T, R and S are ticked for tracks that have all of those frames: one
    that is missing somewhere would move the picture there by what it does not know.

    Parameters
    ----------
    tracks : at least one; names are any text.
    clip : whose height turns y over.
    reference : the plate's frame at which the tracker's transform is none.
    frame_offset : added to all frames.
    frames : that the node knows besides those of its tracks: on which any of them was looked for.
    label : of the node; any text.
    """
    if not tracks:
        raise RoamError(sentence("There is no track to export."))
    columns = "\n".join(f"{{ {kind} {name} {heading} 1 }}" for kind, name, heading in COLUMNS)
    known = sorted({frame for track in tracks for frame in track.frames}.union(frames))
    rows = "\n".join(_row(track, known, clip.size[1], frame_offset) for track in tracks)
    first = np.mean([np.asarray(track.positions)[0] for track in tracks], axis=0)
    knobs = {
        "tracks": f"{{ {{ 1 {len(COLUMNS)} {len(tracks)} }}\n{{ {columns}\n}}\n{{\n{rows}\n}}\n}}",
        "reference_frame": str(reference + frame_offset),
        "center": f"{{{first[0]:.6f} {clip.size[1] - first[1]:.6f}}}",
        "name": "Tracker1",
    }
    if label is not None:
        knobs["label"] = tcl_word(_label(label))
    return _node("Tracker4", knobs)


def corner_pin_node(
    name: str, frames: Sequence[int], corners: Array, pinned: Array, clip: Clip, frame_offset: int = 0
) -> str:
    """The text of a CornerPin2D node.

    Parameters
    ----------
    name : of what is pinned, for the node's label.
    frames : F of them.
    corners : (F, 4, 2) bottom left, bottom right, top right, top left; our pixels, y down.
    pinned : (4, 2) where the corners come from, in the same order.
    clip : whose height turns y over.
    frame_offset : added to all frames.
    """
    height = clip.size[1]
    knobs = {}
    for index in range(4):
        track = Track(name, frames, corners[:, index])
        x, y = (_curve(track.frames, values, frame_offset) for values in _up(track.positions, height).T)
        knobs[f"to{index + 1}"] = f"{{{x} {y}}}"
    for index, (x, y) in enumerate(_up(pinned, height).tolist()):
        knobs[f"from{index + 1}"] = f"{{{x:.6f} {y:.6f}}}"
    knobs |= {"name": "CornerPin2D1", "label": tcl_word(_label(name))}
    return _node("CornerPin2D", knobs)


def _node(species: str, knobs: Mapping[str, str]) -> str:
    lines = "\n".join(f" {name} {value}" for name, value in knobs.items())
    return f"{species} {{\n inputs 0\n{lines}\n}}\n"


def _label(name: str) -> str:
    """A label as it may stand on a node: Nuke runs what stands in brackets there, so that these become round ones."""
    return name.translate({ord("["): "(", ord("]"): ")"})


def _row(track: Track, frames: Sequence[int], height: int, frame_offset: int) -> str:
    """One row of the table of a tracker that knows `frames`, one entry for each of its columns."""
    first = track.frames[0] + frame_offset
    x, y = (_curve(track.frames, values, frame_offset) for values in _up(np.asarray(track.positions), height).T)
    still = f"{{curve K x{first} 0}}"
    boxes = "-15 -15 15 15 -25 -25 25 25"
    empty = " ".join(["{}"] * 11)
    start = f"{_enabled(track, frames, frame_offset)} {tcl_word(track.name)}"
    moves = " ".join(["1" if len(track.frames) == len(frames) else "0"] * 3)
    return f"{{ {start} {x} {y} {still} {still} {moves} {{curve x{first} 0}} 0 0 {boxes} {empty} }}"


def _enabled(track: Track, frames: Sequence[int], frame_offset: int) -> str:
    """The steps of a track's switch: on where it has a place, off on others of `frames`, as before in between."""
    known = set(track.frames)
    keys, last = [], None
    for frame in frames:
        if (frame in known) != last:
            last = frame in known
            keys.append(f"K x{frame + frame_offset} {last:d}")
    return f"{{curve {' '.join(keys)}}}"


def _up(positions: Array, height: int) -> Array:
    return positions * [1.0, -1.0] + [0.0, float(height)]


def _curve(frames: Sequence[int], values: Array, frame_offset: int) -> str:
    """A knob's animation: straight from key to key."""
    keys = (f"x{frame + frame_offset} {value:.6f}" for frame, value in zip(frames, values.tolist(), strict=True))
    return f"{{curve L {' L '.join(keys)}}}"
