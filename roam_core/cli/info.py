"""`roam info P.roam`: say what is in a project, or what a clip is."""

from __future__ import annotations

import argparse
from collections.abc import Set
from itertools import pairwise
from pathlib import Path

from roam_core.cli.lines import print_json
from roam_core.cli.paths import path_word
from roam_core.cli.plate import add_layer, opened, tell
from roam_core.errors import RoamError
from roam_core.interchange.authorship import is_project
from roam_core.media import open_clip
from roam_core.media.colour_spaces import config_trouble
from roam_core.media.finding import is_there
from roam_core.media.unseen import unseen
from roam_core.propagate.between.frames_shown import frames_shown
from roam_core.propagate.shapes.departed import departed_settings
from roam_core.propagate.shapes.gaps import Gap
from roam_core.propagate.shapes.provenance import Stamp, Stamps, known_params
from roam_core.propagate.shapes.suggest_keyframe import suggest_keyframe
from roam_core.roto import Clip, Layer, Origin, RotoShape, file
from roam_core.roto.imported import is_import
from roam_core.roto.relinking import missing_now, numbers_now, other_content_now, relinked


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    add_layer(parser)
    parser.add_argument(
        "--json", action="store_true", help="print a line of JSON: of a clip, or of a project and its shapes"
    )
    parser.add_argument("project", type=path_word, metavar="P.roam", help="a project, or a clip")


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    if arguments.project.suffix.lower() == ".roam" or is_project(arguments.project):
        if arguments.json:
            print_json(_project_values(arguments.project))
            return 0
        for line in _project_lines(arguments.project):
            print(line)
        return 0
    source = open_clip(arguments.project, arguments.layer)
    tell(unseen(source))
    tell(config_trouble())
    if arguments.json:
        print_json(
            {"clip": _clip_values(Clip.of(source)) | {"missing": list(source.missing), "layers": list(source.layers)}}
        )
        return 0
    width, height = source.size
    print(f"clip     {source.path}")
    print(
        f"frames   {source.frames[0]}-{source.frames[-1]}, {len(source.frames)} present, {len(source.missing)} missing"
    )
    print(
        f"picture  {width}x{height}, {source.depth}, {source.fps:g} fps, {source.colour_space}, "
        f"pixel aspect {source.pixel_aspect:g}"
    )
    if len(source.layers) > 1:
        print(f"layer    {source.layer}, of {', '.join(source.layers)}")
    return 0


def _clip_values(clip: Clip) -> dict[str, object]:
    return {
        "path": str(clip.path),
        "first": clip.first,
        "last": clip.last,
        "size": list(clip.size),
        "fps": clip.fps,
        "colour_space": clip.colour_space,
        "pixel_aspect": clip.pixel_aspect,
        "layer": clip.layer,
    }


def _project_values(path: Path) -> dict[str, object]:
    project = file.load(path)
    clip, stamps = project.clip, Stamps.of(project.shapes, project.clip)
    there = (
        None
        if clip is None
        else _clip_values(clip)
        | {"is_there": is_there(clip.path), "note": other_content_now(clip) or numbers_now(clip)}
    )
    missing = frozenset[int]() if clip is None else missing_now(clip)
    shapes = [_shape_values(shape, stamps, missing, clip) for shape in project.shapes]
    layers = [_layer_values(item) for item in project.root.items() if isinstance(item, Layer)]
    return {"project": str(path), "digest": file.digest(project), "clip": there, "layers": layers, "shapes": shapes}


def _layer_values(layer: Layer) -> dict[str, object]:
    motion = layer.transform
    return {
        "id": layer.id,
        "name": layer.name,
        "visible": layer.visible,
        "locked": layer.locked,
        "blend": layer.blend.value,
        "holds": [child.id for child in layer.children],
        "motion": None
        if motion is None
        else {
            "frames": list(motion.frames),
            "adjust_keys": list(motion.adjusted),
            "confidence": {str(frame): confidence for frame, confidence in motion.confidence},
        },
    }


def _shape_values(shape: RotoShape, stamps: Stamps, missing: Set[int], clip: Clip | None) -> dict[str, object]:
    engine = [key for key in shape.keys if key.origin is Origin.ENGINE]
    return {
        "id": shape.id,
        "name": shape.name,
        "points": shape.point_count,
        "closed": shape.closed,
        "blend": shape.blend.value,
        "artist_keys": list(shape.artist_frames),
        "engine_keys": [key.frame for key in engine],
        "stale": [key.frame for key in engine if stamps.is_stale(shape, key)],
        "not_filled": _interpolated(shape, missing, stamps, clip),
        "confidence": {str(key.frame): key.confidence for key in engine if key.confidence is not None},
        "worth_fixing": suggest_keyframe(shape),
    }


def _project_lines(path: Path) -> list[str]:
    project = file.load(path)
    lines = [f"project  {path}", f"digest   {file.digest(project)[:16]}"]
    if project.clip is None:
        lines.append("clip     none")
    else:
        width, height = project.clip.size
        lines.append(
            f"clip     {project.clip.path}, frames {project.clip.first}-{project.clip.last}, {width}x{height}, "
            f"{project.clip.fps:g} fps, {project.clip.colour_space}"
            f"{f', layer {project.clip.layer}' if project.clip.layer else ''}"
        )
        if not is_there(project.clip.path):
            found = relinked(project, path.parent).require_clip().path
            lines.append(f"         is not there{'' if found == project.clip.path else f'; found again at {found}'}")
        elif warning := other_content_now(project.clip):
            lines.append(f"note     {warning}")
    lines.extend(f"note     {mark.frame}: {' '.join(mark.text.split())}" for mark in project.marks if mark.text)
    stamps = Stamps.of(project.shapes, project.clip)
    missing = frozenset[int]() if project.clip is None else missing_now(project.clip)
    if project.clip is not None and len(missing) == len(project.clip.frame_range):
        lines.append("note     The plate has none of these frames; where it was numbered anew, roam shift follows it.")
    elif project.clip is not None and (numbers := numbers_now(project.clip)):
        lines.append(f"note     {numbers}")
    lines.extend(_layer_line(item) for item in project.root.items() if isinstance(item, Layer))
    lines.extend(_shape_line(shape, stamps, missing, project.clip) for shape in project.shapes)
    if sentence := departed_settings(project.shapes):
        lines.append(f"note     {sentence}")
    return lines


def _layer_line(layer: Layer) -> str:
    count = sum(1 for _ in layer.shapes())
    states = [word for word, holds in (("hidden", not layer.visible), ("locked", layer.locked)) if holds]
    line = f"layer    {layer.name!r}: " + ", ".join([f"{count} shape(s)", layer.blend.value, *states])
    motion = layer.transform
    if motion is not None:
        line += f"; moves on {motion.frames[0]}-{motion.frames[-1]}"
        if len(motion.adjusted) > 1:
            line += f", {len(motion.adjusted)} adjust keys"
        if motion.confidence:
            frame, confidence = min(motion.confidence, key=lambda pair: pair[1])
            line += f"; least sure on {frame} ({confidence:.2f})"
    return line


def _shape_line(shape: RotoShape, stamps: Stamps, missing: Set[int], clip: Clip | None) -> str:
    engine = [key for key in shape.keys if key.origin is Origin.ENGINE]
    stale = sum(stamps.is_stale(shape, key) for key in engine)
    rated = [(key.confidence, key.frame) for key in engine if key.confidence is not None]
    line = (
        f"shape    {shape.name!r}: {shape.point_count} points, {'closed' if shape.closed else 'open'}, "
        f"{shape.blend.value}, keys on {shape.frames[0]}-{shape.frames[-1]}: "
        f"{len(shape.artist_frames)} artist, {len(engine)} engine"
    )
    if stale:
        line += f" ({stale} stale)"
    if interpolated := _interpolated(shape, missing, stamps, clip):
        line += f"; {len(interpolated)} frame(s) between its artist keys are not filled, the first is {interpolated[0]}"
    if rated:
        confidence, frame = min(rated)
        line += f"; least sure on {frame} ({confidence:.2f})"
    if (worst := suggest_keyframe(shape)) is not None:
        line += f"; most worth fixing is {worst}"
    return line


def _interpolated(shape: RotoShape, missing: Set[int], stamps: Stamps, clip: Clip | None) -> list[int]:
    """The frames between a closed shape's artist keys on which it exists without a key: `roam fill` makes them.

    Not those that `roam fill` passes over: which the plate lacks, or which show nothing; and not where an import put
    keys between two of the file's, as few as show its motion.
    """
    if not shape.closed:
        return []
    imported = {key.frame for key in shape.keys if is_import(key)}
    keyed = set(shape.frames)
    found: list[int] = []
    for gap in pairwise(shape.artist_frames):
        between = range(gap[0] + 1, gap[1])
        if imported.isdisjoint(between):
            lacking = [each for each in between if each not in keyed and each not in missing and shape.exists_at(each)]
            found.extend(_shown(shape, gap, lacking, stamps, clip) if lacking else ())
    return found


def _shown(shape: RotoShape, gap: Gap, lacking: list[int], stamps: Stamps, clip: Clip | None) -> list[int]:
    """Those frames of a gap `lacking` a key that filling would make; pictures are looked at only where it is filled."""
    made = [key for key in shape.keys if gap[0] < key.frame < gap[1]]
    is_filled = all(Stamp.read(key.inputs).gap == gap and not stamps.is_stale(shape, key) for key in made)
    params = known_params(Stamp.read(made[0].inputs).config) if made and is_filled else None
    if params is None or clip is None:
        return lacking
    try:
        with opened(str(clip.path), clip) as plate:
            return list(frames_shown(plate.parts, shape, gap, lacking, params))
    except RoamError:
        return lacking
