"""What comes back of the motion between frames: the same matte, or a note that it is another."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.interchange import EXPORTERS, Imported, read_shapes
from roam_core.matte import render_matte
from roam_core.roto import Animated, Interpolation, Layer, MotionBlur, Project, RotoShape, ValueKey
from tests.judges.scenes import SCENES, blob

CLIP = SCENES["smooth"].project.require_clip()
LEVEL = 0.5 / 255.0
SMOOTH = "The smooth spans of {!r} become linear keys on every frame, straight between frames."


def project(*items: Layer | RotoShape) -> Project:
    return Project(CLIP, Layer("root", "Root", items))


def back(name: str, what: Project, folder: Path) -> tuple[tuple[str, ...], Imported]:
    """The notes of an export, and what is read of it."""
    path = folder / f"shapes{EXPORTERS[name].suffix}"
    return EXPORTERS[name].export(what, path), read_shapes(path, CLIP)


def strays(what: Project, made: Imported, moment: float) -> bool:
    size = CLIP.size[1], CLIP.size[0]
    theirs = render_matte(replace(what, root=made.layer), moment, size)
    return bool(np.abs(render_matte(what, moment, size) - theirs).max() > LEVEL)


def blurred(shutter: float, phase: float) -> RotoShape:
    return blob("Fast", 150.0, 120.0, motion_blur=MotionBlur(shutter, phase, 8))


def smooth_one(shape: RotoShape) -> RotoShape:
    return replace(shape, keys=tuple(replace(key, interpolation=Interpolation.SMOOTH) for key in shape.keys))


@pytest.mark.parametrize("name", ["silhouette", "fusion", "nuke", "json"])
@pytest.mark.parametrize("what", ["outline", "opacity", "layer"])
def test_smooth_motion_is_the_same_between_frames_or_told(name: str, what: str, tmp_path: Path) -> None:
    fade = Animated((ValueKey(1001, 0.2, Interpolation.SMOOTH), ValueKey(1006, 0.9)))
    shape = blob("Smooth", 150.0, 120.0)
    if what == "outline":
        made = project(smooth_one(shape))
    elif what == "opacity":
        made = project(replace(shape, opacity=fade))
    else:
        made = project(Layer("l", "Smooth", (shape, replace(shape, id="other")), opacity=fade))
    notes, imported = back(name, made, tmp_path)
    assert not strays(made, imported, 1003)
    layer = "Nuke has linear keys on every frame for the opacity of 'Smooth', straight between frames."
    told = SMOOTH.format("Smooth") in notes or layer in notes
    assert told is any(strays(made, imported, 1001.0 + part) for part in (0.25, 0.5, 4.75))


@pytest.mark.parametrize("name", ["blender", "natron", "silhouette", "fusion"])
def test_what_stays_between_smooth_keys_is_not_told(name: str, tmp_path: Path) -> None:
    moving = smooth_one(blob("Moves", 150.0, 120.0))
    still = replace(
        moving, id="still", name="Stays", keys=tuple(moving.with_key(key).keys[0] for key in moving.keys[:1])
    )
    value = Animated((ValueKey(1001, 0.5, Interpolation.SMOOTH), ValueKey(1006, 0.5)))
    notes = EXPORTERS[name].export(project(moving, replace(still, opacity=value)), tmp_path / "shapes")
    assert [note for note in notes if "smooth spans" in note] == [SMOOTH.format("Moves")]


@pytest.mark.parametrize("name", ["json", "fusion", "nuke"])
@pytest.mark.parametrize(("shutter", "phase"), [(-0.5, -0.25), (-1.0, 0.5), (0.5, -0.25)])
def test_a_shutter_that_runs_backwards_blurs_as_much(name: str, shutter: float, phase: float, tmp_path: Path) -> None:
    """Nuke's files may hold one; our JSON of it was refused when read, and Fusion's had no blur, without a note."""
    made = project(blurred(shutter, phase))
    assert strays(made, Imported(project(blob("Fast", 150.0, 120.0)).root, ()), 1004)
    _, imported = back(name, made, tmp_path)
    assert not strays(made, imported, 1004)


def test_a_shutter_that_runs_backwards_is_turned_for_natron(tmp_path: Path) -> None:
    texts = []
    for blur in (blurred(-0.5, 0.25), blurred(0.5, -0.25)):
        EXPORTERS["natron"].export(project(blur), tmp_path / "shapes.py")
        texts.append((tmp_path / "shapes.py").read_text())
    assert texts[0] == texts[1]
