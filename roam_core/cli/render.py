"""`roam render P.roam --out DIR`: write a project's mattes, one PNG a frame, named as the frames."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from tqdm import tqdm

from roam_core.cli.track import require_writable
from roam_core.errors import RoamError
from roam_core.interchange.mattes import write_matte
from roam_core.media import open_clip
from roam_core.roto import Project, file


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=Path, metavar="P.roam")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR")
    parser.add_argument("--start", type=int, metavar="F", help="first frame (default: the clip's first)")
    parser.add_argument("--end", type=int, metavar="F", help="last frame (default: the clip's last)")


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    project = file.load(arguments.project)
    clip = project.require_clip()
    first = clip.first if arguments.start is None else arguments.start
    last = clip.last if arguments.end is None else arguments.end
    if last < first:
        raise RoamError(f"--end {last} comes before --start {first}.")
    require_writable(arguments.out, create=True)
    names = frame_names(project)
    width, height = clip.size
    frames = [frame for frame in range(first, last + 1) if frame in names]
    for frame in tqdm(frames, unit="frame", disable=not sys.stderr.isatty(), leave=False):
        write_matte(project.root, frame, arguments.out / f"{names[frame]}.png", (height, width))
    print(f"Wrote {len(frames)} matte(s) to {arguments.out}.", file=sys.stderr)
    return 0


def frame_names(project: Project) -> dict[int, str]:
    """Names for mattes by frame: those of the plate's files, or padded numbers where the plate is not at hand."""
    clip = project.require_clip()
    try:
        source = open_clip(clip.path)
    except RoamError:
        return {frame: f"{frame:04d}" for frame in clip.frame_range}
    return {frame: source.frame_name(frame) for frame in source.frames}
