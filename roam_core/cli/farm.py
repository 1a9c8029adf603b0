"""`roam farm P.roam`: write a project's work as a job for a render farm."""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path

from roam_core.atomic_write import new_folder, write_atomically
from roam_core.cli.lines import print_json
from roam_core.cli.matte_options import add_matte_arguments, matte_options, matte_style
from roam_core.cli.overwriting import add_overwrite, require_own
from roam_core.cli.paths import path_word
from roam_core.cli.picking import NothingToSolve
from roam_core.cli.plate import loaded
from roam_core.cli.spans import asked_frames, gaps_to_fill
from roam_core.errors import RoamError
from roam_core.roto import Project
from roam_core.studio.jobs import Job, Step, require_name, steps_named
from roam_core.studio.open_job import Shares, checked, template_of, to_be_given, written

OURS = rb'\A\{?\s*"?specificationVersion"?: "?jobtemplate-2023-09"?,?\s+"?name"?: "?ROAM '
"""By which a job that we wrote is known."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=path_word, metavar="P.roam")
    parser.add_argument(
        "--job", type=path_word, metavar="JOB.json", help="the file to write, .json or .yaml (P.openjd.json)"
    )
    parser.add_argument("--out", type=path_word, metavar="DIR", help="folder of the results (P-farm); it is made")
    parser.add_argument(
        "--steps",
        metavar="LIST",
        help="such as fill,render,export:nuke (default: fill where there are gaps, and render)",
    )
    parser.add_argument(
        "--chunk", type=int, default=20, metavar="N", help="frames of a task of rendering (%(default)s)"
    )
    parser.add_argument("--start", type=int, metavar="F", help="first frame to render (default: the clip's first)")
    parser.add_argument("--end", type=int, metavar="F", help="last frame to render (default: the clip's last)")
    parser.add_argument("--roam", default="roam", metavar="COMMAND", help="what runs ROAM on the farm (%(default)s)")
    parser.add_argument("--json", action="store_true", help="print a line of JSON: the file, and its steps")
    add_matte_arguments(parser)
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    path: Path = arguments.project.absolute()
    project = loaded(path)
    clip, name = project.require_clip(), path.stem
    require_name(name, f"The name of {path}")
    frames = asked_frames(clip, arguments.start, arguments.end)
    if arguments.chunk < 1:
        raise RoamError("--chunk has to be 1 or more.")
    gaps = found_gaps(project, path)
    steps = with_mattes(steps_named(arguments.steps or ("fill,render" if gaps else "render")), arguments)
    if not gaps and any(step.verb == "fill" for step in steps):
        gaps_to_fill(project, path)  # says why there is none
    if any(step.verb == "shift" for step in steps):
        raise RoamError(f"The tasks of a farm are by frames; give {path} its new ones first: roam shift {path}.")
    out = (arguments.out or path.with_name(f"{name}-farm")).absolute()
    target = arguments.job or path.with_name(f"{name}.openjd.json")
    job = Job(name, steps, str(clip.path), path, clip.layer)
    shares = Shares(gaps, frames, arguments.chunk)
    template = template_of(job, out, shares, target.absolute().parent, arguments.roam)
    content = written(checked(template), target)
    require_own(target, [path], overwrite=arguments.overwrite, mark=OURS)
    with new_folder(out):
        write_atomically(target, content)
    names = [step["name"] for step in template["steps"]]
    if arguments.json:
        print_json({"files": [str(target)], "steps": names, "parameters": to_be_given(template)})
    else:
        print(f"Wrote {target}: {', '.join(names)}.", file=sys.stderr)
        for label, place in to_be_given(template).items():
            print(f"{label} lies elsewhere; submit the job with {label}={place}.", file=sys.stderr)
    return 0


def with_mattes(steps: tuple[Step, ...], arguments: argparse.Namespace) -> tuple[Step, ...]:
    """The steps, those that render with what was said of mattes. Raises `RoamError` where that fits none of them."""
    given = matte_options(arguments)
    if not given:
        return steps
    if not any(step.verb == "render" for step in steps):
        raise RoamError(f"{', '.join(given)} {'is' if len(given) == 1 else 'are'} for the step render; name it, too.")
    matte_style(arguments)  # refuses what no picture can hold
    said = {name: getattr(arguments, name) for name in (option.removeprefix("--") for option in given)}
    return tuple(replace(step, options=step.options | said) if step.verb == "render" else step for step in steps)


def found_gaps(project: Project, path: Path) -> list[tuple[int, int]]:
    """The gaps between artist keys, none where there are none."""
    try:
        return gaps_to_fill(project, path)
    except NothingToSolve:
        return []
