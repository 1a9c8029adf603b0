"""A layer of the plate's files on the command line: named, chosen, kept in the project, part of what keys depend on."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses
import pytest

from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Origin, file
from tests.unit.cli.conftest import SHOT, Plate, Roam
from tests.unit.cli.test_bad_input import require_refusal

CONFIG = ("--config", "baseline")


@pytest.fixture
def parts(tmp_path: Path) -> Path:
    """The short plate in the part `beauty` of EXR files, behind a part `depth` in which nothing is to be seen."""
    folder = tmp_path / "parts"
    folder.mkdir()
    for frame in SHOT.frames:
        picture = (SHOT.read(frame).astype(np.float32) / 255.0) ** 2.2
        specs = [oiio.ImageSpec(*picture.shape[1::-1], count, "half") for count in (1, 3)]
        specs[0].channelnames = ("Z",)
        for spec, name in zip(specs, ("depth", "beauty"), strict=True):
            spec.attribute("oiio:subimagename", name)
        path = str(folder / f"plate.{frame}.exr")
        output = oiio.ImageOutput.create(path)
        output.open(path, specs)
        output.write_image(np.full((*picture.shape[:2], 1), 0.5, np.float32))
        output.open(path, specs[1], "AppendSubimage")
        output.write_image(np.ascontiguousarray(picture))
        output.close()
    return folder


def test_info_names_the_layers(roam: Roam, parts: Path) -> None:
    assert "layer    beauty, of depth.Z, beauty" in roam("info", parts).out.splitlines()
    assert "layer    depth.Z, of depth.Z, beauty" in roam("info", parts, "--layer", "depth.Z").out.splitlines()


def test_the_colour_is_tracked_and_the_project_says_which_layer_that_was(
    roam: Roam, parts: Path, plate: Plate, tmp_path: Path
) -> None:
    saved = tmp_path / "p.roam"
    done = roam("track", parts, "--init", plate.mask, "--end", 1003, *CONFIG, "--save", saved)
    assert done.status == 0
    project = file.load(saved)
    clip = project.require_clip()
    assert clip.layer == "beauty"
    assert "layer beauty" in roam("info", saved).out
    key = next(key for key in project.shapes[0].keys if key.origin is Origin.ENGINE)
    assert not Stamps.of(project.shapes, clip).is_stale(project.shapes[0], key)
    assert Stamps.of(project.shapes, replace(clip, layer="depth.Z")).is_stale(project.shapes[0], key)


def test_the_projects_layer_is_tracked_again_unless_another_is_named(
    roam: Roam, parts: Path, plate: Plate, tmp_path: Path
) -> None:
    saved = tmp_path / "p.roam"
    words = ("track", parts, "--end", 1002, *CONFIG, "--save", saved)
    assert roam(*words, "--init", plate.mask, "--layer", "depth.Z").status == 0
    assert file.load(saved).require_clip().layer == "depth.Z"
    assert roam(*words, "--init", saved).status == 0
    assert file.load(saved).require_clip().layer == "depth.Z"
    assert roam(*words, "--init", saved, "--layer", "beauty").status == 0
    assert file.load(saved).require_clip().layer == "beauty"


def test_a_layer_that_is_not_there_is_refused(roam: Roam, parts: Path, plate: Plate) -> None:
    refused = roam("track", parts, "--init", plate.mask, "--layer", "diffuse")
    require_refusal(refused, "has no layer 'diffuse'; it has depth.Z, beauty.")


def test_a_colour_space_is_declared_kept_and_part_of_what_keys_depend_on(
    roam: Roam, parts: Path, plate: Plate, tmp_path: Path
) -> None:
    saved = tmp_path / "p.roam"
    words = ("track", parts, "--end", 1002, *CONFIG, "--save", saved)
    assert roam(*words, "--init", plate.mask, "--colour", "lin_ap1").status == 0
    project = file.load(saved)
    clip = project.require_clip()
    assert clip.colour_space == "ACEScg"
    key = next(key for key in project.shapes[0].keys if key.origin is Origin.ENGINE)
    assert not Stamps.of(project.shapes, clip).is_stale(project.shapes[0], key)
    assert Stamps.of(project.shapes, replace(clip, colour_space="linear")).is_stale(project.shapes[0], key)
    assert roam(*words, "--init", saved).status == 0
    assert file.load(saved).require_clip().colour_space == "ACEScg"


def test_a_colour_space_that_is_not_known_is_refused(roam: Roam, parts: Path, plate: Plate) -> None:
    refused = roam("track", parts, "--init", plate.mask, "--colour", "Kodachrome")
    require_refusal(refused, "'Kodachrome' is not known; choose one of sRGB, linear, log")
