"""`roam render P.roam --out DIR`: write a project's mattes, one picture a frame, named as the frames."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from shlex import quote
from typing import Never

from tqdm import tqdm

from roam_core.cli.lines import print_json
from roam_core.cli.matte_files import left_out
from roam_core.cli.matte_options import add_matte_arguments, matte_style, require_no_picture
from roam_core.cli.overwriting import add_overwrite
from roam_core.cli.paths import path_word
from roam_core.cli.picking import add_shapes, with_only
from roam_core.cli.plate import loaded, other_frames, tell
from roam_core.cli.spans import asked_frames
from roam_core.cli.stopping import cancelling
from roam_core.cli.targets import require_writable
from roam_core.errors import RoamError
from roam_core.interchange.authorship import Kind
from roam_core.interchange.flatten import TAKING
from roam_core.interchange.matte_style import OTHER_SUFFIXES, SUFFIXES, Gathering, MatteStyle, Parts
from roam_core.interchange.mattes.exporter import NAME, planned, require_places, style_for, write_mattes
from roam_core.interchange.naming import numbering
from roam_core.interchange.targets import Sources, require_free
from roam_core.media import open_clip
from roam_core.roto import Project
from roam_core.roto.relinking import numbers_now, other_content_now


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=path_word, metavar="P.roam")
    parser.add_argument("--out", type=path_word, required=True, metavar="DIR")
    parser.add_argument("--start", type=int, metavar="F", help="first frame (default: the clip's first)")
    parser.add_argument("--end", type=int, metavar="F", help="last frame (default: the clip's last)")
    parser.add_argument(
        "--name", metavar="PATTERN", help="of the files, such as 'hero.####.exr' (default: as the plate's frames)"
    )
    parser.add_argument("--json", action="store_true", help="print a line of JSON: the files, written or there already")
    add_shapes(parser, "write only this shape, or these")
    add_matte_arguments(parser)
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    place, called = quote(str(arguments.out.parent)), quote(arguments.out.name)
    require_no_picture(arguments.out, f"How they are called there is --name: --out {place} --name {called}.")
    project = with_only(loaded(arguments.project), arguments.shape)
    clip, style = project.require_clip(), matte_style(arguments, arguments.name or "")
    asked = asked_frames(clip, arguments.start, arguments.end)
    pattern = arguments.name
    if pattern:
        pattern, style = named(pattern, style)
        require_places(pattern, style)
    if NAME in arguments.out.name and not arguments.out.is_dir():
        raise RoamError(f"{arguments.out} is the folder of all mattes; {NAME} stands for a layer or shape in --name.")
    tell(other_content_now(clip))
    tell(black_because(project, arguments.project, style))
    names = frame_names(project)
    width, height = clip.size
    frames = [frame for frame in asked if frame in names]
    if told := other_frames(clip, sorted(names)):
        raise RoamError(told)
    tell(numbers_now(clip))
    tell(left_out([frame for frame in asked if frame not in names]))
    as_plate = {frame: f"{names[frame]}{style.suffix}" for frame in frames}
    name_for = numbering(pattern) if pattern else as_plate.__getitem__
    require_free(
        [(path, Kind.PICTURE) for path in planned(project, frames, arguments.out, name_for, style)],
        Sources.of_clip(clip, arguments.project),
        overwrite=arguments.overwrite,
    )
    require_writable(arguments.out, create=True)
    with (
        cancelling() as token,
        tqdm(total=len(frames), unit="frame", disable=not sys.stderr.isatty(), leave=False) as bar,
    ):
        written = write_mattes(
            project,
            frames,
            arguments.out,
            name_for,
            (height, width),
            style=style,
            pixel_aspect=clip.pixel_aspect,
            fps=clip.fps,
            progress=lambda share, _: show(bar, share),
            token=token,
        )
    if frames and not (written.made or written.kept):
        raise RoamError(f"Nothing is visible in {arguments.project} that could have a matte of its own.")
    for note in written.notes:
        tell(note)
    if arguments.json:
        made, there = ([str(path) for path in paths] for paths in (written.made, written.kept))
        print_json({"files": made, "kept": there})
    else:
        print(written.report(f" to {arguments.out}"), file=sys.stderr)
    return 0


def named(pattern: str, style: MatteStyle) -> tuple[str, MatteStyle]:
    """The pattern of `--name` with its suffix, and the style with the file type that the pattern asks for."""
    suffix = Path(pattern).suffix.lower()
    if suffix in SUFFIXES:
        return pattern, style_for(Path(pattern), style)
    if suffix in OTHER_SUFFIXES:
        raise RoamError(f"Mattes are written as PNG, EXR or TIFF; {pattern} would be none of these.")
    return pattern + style.suffix, style


def black_because(project: Project, path: Path, style: MatteStyle) -> str:
    """Why mattes are black whatever the frame, in a sentence; "" where they need not be."""
    if not project.shapes:
        return f"{path} holds no shape: its mattes are black."
    turns = any(item.invert for item in (project.root, *project.root.items()))
    shows_each = style.parts is Parts.SHAPE and style.gathering is not Gathering.CRYPTOMATTE
    if turns or shows_each or not all(shape.blend in TAKING for shape in project.shapes):
        return ""
    return (
        "Shapes that subtract or intersect show nothing by themselves: the mattes are black. As files or channels "
        "--per shape shows each."
    )


def show(bar: tqdm[Never], share: float) -> None:
    """Move a progress bar to a share of its whole."""
    bar.update(round(share * float(bar.total or 0)) - bar.n)


def frame_names(project: Project) -> dict[int, str]:
    """Names for mattes by frame: those of the plate's files, or padded numbers where the plate is not at hand."""
    clip = project.require_clip()
    try:
        source = open_clip(clip.path, content=clip.content)
    except RoamError:
        return {frame: f"{frame:04d}" for frame in clip.frame_range}
    return {frame: source.frame_name(frame) for frame in source.frames}
