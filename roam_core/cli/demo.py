"""`roam demo --headless`: render the built-in shot, track it from its true outline, and say how well that went."""

from __future__ import annotations

import argparse
import sys
from contextlib import nullcontext
from pathlib import Path

import numpy as np
from platformdirs import user_cache_path
from tqdm import tqdm

from roam_core.cli.configuring import configured
from roam_core.cli.keeping import Write
from roam_core.cli.overwriting import add_overwrite, claimed, project_writer
from roam_core.cli.paths import path_word
from roam_core.cli.plate import Plate, opened
from roam_core.cli.targets import require_target, require_writable
from roam_core.cli.track import Report, frame_range, print_line, track_project
from roam_core.errors import RoamError
from roam_core.installation import demo
from roam_core.interchange.authorship import Kind
from roam_core.interchange.targets import Sources, require_free
from roam_core.matte import render_matte
from roam_core.params import DEFAULT_CONFIG
from roam_core.propagate import FrameResult
from roam_core.roto import Clip, Project, RotoShape, edit
from roam_core.system_errors import reason_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("--headless", action="store_true", help="track without opening a window")
    parser.add_argument("--config", default=DEFAULT_CONFIG)
    parser.add_argument(
        "--frames", type=path_word, metavar="DIR", help="folder for the shot (default: the user's cache)"
    )
    parser.add_argument("--save", type=path_word, metavar="P.roam", help="write the tracked project")
    parser.add_argument("--json", action="store_true", help="print one line of JSON a frame")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    configured(arguments.config)
    if arguments.save is not None:
        require_target(arguments.save)
    require_free_places(arguments.frames, arguments.save, overwrite=arguments.overwrite)
    folder = demo_frames(arguments.frames)
    truth: list[float] = []

    def scored(solved: FrameResult) -> None:
        truth.append(overlap(solved.results[0].shape, solved.frame))
        if arguments.json:
            print_line(solved)

    with opened(str(folder)) as plate, nullcontext() if arguments.save is None else claimed(arguments.save):
        track_demo(plate, arguments.config, scored, None if arguments.save is None else project_writer(arguments.save))
    solved = np.array(truth[1:])
    worst = int(np.argmin(solved))
    print(
        f"Tracked the demo shot, frames {demo.FIRST}-{demo.LAST}, without a window: IoU with the true outline "
        f"{solved.mean():.3f} on average, {solved[worst]:.3f} at worst (frame {demo.FIRST + 1 + worst}).",
        file=sys.stderr if arguments.json else sys.stdout,
    )
    return 0


def require_free_places(folder: Path | None, save: Path | None, *, overwrite: bool) -> None:
    """Refuse what may not be written over: frames that are not ours in a folder of the user's, what is no project.

    The shot in the user's cache is ours, whatever has become of it.
    """
    rendered = [] if folder is None else demo.missing_frames(folder)
    made = [(path, Kind.PICTURE) for path in rendered]
    if save is not None:
        made.append((save, Kind.PROJECT))
    read = set((folder or demo_folder()).glob("demo.*.png")) - set(rendered)
    require_free(made, Sources(tuple(read)), overwrite=overwrite)


def demo_folder() -> Path:
    """Where the demo shot is kept."""
    return user_cache_path("roam", appauthor=False) / demo.cache_name()


def demo_frames(folder: Path | None = None) -> Path:
    """The folder with the rendered shot; what is not there yet is rendered first."""
    place = folder or demo_folder()
    require_writable(place, create=True)
    with tqdm(total=1.0, desc="Rendering the demo shot", disable=not sys.stderr.isatty(), leave=False) as bar:
        try:
            demo.write_frames(place, lambda fraction, _: bar.update(fraction - bar.n))
        except OSError as error:
            raise RoamError(f"The demo shot cannot be written to {place}: {reason_of(error)}.") from None
    return place


def demo_project(plate: Plate) -> Project:
    """The demo as it is handed to the artist: the clip, and the true outline as the key of the first frame."""
    project, _ = edit.new_shape(Project(Clip.of(plate.source)), demo.true_points(demo.FIRST), demo.FIRST, name="Demo")
    return project


def track_demo(plate: Plate, config: str, report: Report, keep: Write | None = None) -> Project:
    """Track the demo forward from its first frame; `report` and `keep` as for `track_project`."""
    frames = frame_range(plate.source.frames, None, None)
    return track_project(plate, demo_project(plate), frames, config, report=report, keep=keep)


def overlap(shape: RotoShape, frame: int) -> float:
    """IoU of a tracked shape with the true outline."""
    width, height = demo.SIZE
    ours = render_matte([shape], frame, (height, width)) > 0.5
    true = demo.true_mask(frame) > 127
    return int(np.count_nonzero(ours & true)) / max(int(np.count_nonzero(ours | true)), 1)
