"""The engine's revision: whoever makes it give other points gives it another number, so that older keys are stale.

The points of small runs are stored beside this file with the revision that they belong to. After a change that is
meant, and with a new `provenance.REVISION`: `python -m tests.unit.propagate.test_revision` writes them anew.
"""

from __future__ import annotations

import hashlib
import json
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core import fill_span, shapes_from_mask, track
from roam_core.arrays import UInt8
from roam_core.params import CONFIGS, params_for
from roam_core.propagate.shapes.provenance import REVISION
from roam_core.roto import Origin, RotoShape
from tests.golden.shots import Shot, blob, pose
from tests.unit.propagate.dimmed import dimmed_body
from tests.unit.propagate.figures import (
    arm_like_its_body,
    arm_that_comes_in,
    ball_hidden_while_the_camera_pulls_out,
    bending_body_on_a_pan,
    body_and_sleeve,
    body_behind_a_post,
    body_with_arms,
    card_that_comes_out,
    disc_that_comes_in,
    flame,
    hazy,
    subtracting,
)

STORED = Path(__file__).with_name("revision.json")
NEAR = 0.01
"""Pixels by which points may differ from those stored: rounding, and other processors."""

Points = dict[str, dict[str, list[Any]]]
"""By shape and frame the control points, rounded."""


def lone() -> Points:
    """A shape on its own that glides, turns and grows."""
    poses = tuple(pose(60.0 + 2.0 * k, 56.0 - 0.6 * k, 3.0 * k, 1.0 + 0.01 * k) for k in range(4))
    shot = Shot(blob([26.0, 22.0, 18.0, 24.0, 28.0, 20.0]), poses, drift=(-0.5, 0.3))
    *_, last = track(shot.read, [shot.shape()], shot.frames, "best")
    return _points([last.results[0].shape])


def parts() -> Points:
    """Three parts over each other."""
    figure = body_with_arms(5)
    *_, last = track(figure.read, figure.shapes(), figure.frames, "best")
    return _points([result.shape for result in last.results])


def along() -> Points:
    """Two parts of what bends as no pose does."""
    figure = flame(5)
    *_, last = track(figure.read, figure.shapes(), figure.frames, "best")
    return _points([result.shape for result in last.results])


def filled() -> Points:
    """Three parts over each other between two keys."""
    figure = body_with_arms(5)
    return _points(fill_span(dict(enumerate(figure.pictures)), figure.shapes(0, 4), 0, 4, "best"))


def along_filled() -> Points:
    """Two parts of what bends as no pose does, between two keys; their passes leave them to their poses."""
    figure, params = flame(), params_for("best")
    assert params.region is not None
    by_poses = replace(params, region=replace(params.region, figure=replace(params.region.figure, unfit=np.inf)))
    return _points(fill_span(dict(enumerate(figure.pictures)), figure.shapes(0, 7), 0, 7, by_poses))


def posed() -> Points:
    """A limb on its own, of the colours of what it lies on."""
    figure = arm_like_its_body(4)
    *_, last = track(figure.read, figure.shapes()[1:], figure.frames, "best")
    return _points([last.results[0].shape])


def held() -> Points:
    """A large body of one cloth with what lies before it."""
    figure = body_and_sleeve(4)
    *_, last = track(figure.read, figure.shapes()[:1], figure.frames, "best")
    return _points([last.results[0].shape])


def hidden() -> Points:
    """A whole object behind an occluder, tracked."""
    figure = body_behind_a_post(4)
    body, post = figure.shapes()
    *_, last = track(figure.read, [body, subtracting(post)], figure.frames, "best")
    return _points([result.shape for result in last.results])


def cut_out() -> Points:
    """A hole that is cut out of what looks the same all around it."""
    figure = arm_like_its_body(4)
    body, arm = figure.shapes()
    *_, last = track(figure.read, [body, subtracting(arm)], figure.frames, "best")
    return _points([result.shape for result in last.results])


def hidden_filled() -> Points:
    """The same between two keys."""
    figure = body_behind_a_post(5)
    body, post = figure.shapes(0, 4)
    return _points(fill_span(dict(enumerate(figure.pictures)), [body, subtracting(post)], 0, 4, "best"))


def panned() -> Points:
    """A body that bends, while a camera goes along what was not in the picture on its key."""
    pictures, mask = bending_body_on_a_pan(8)
    return _tracked(pictures, mask)


def dimmed() -> Points:
    """A body that bends, while the light falls."""
    pictures, masks = dimmed_body(6, 0.4)
    return _tracked(pictures, masks[0])


def coming_in() -> Points:
    """What the edge of the picture cuts off on its key, carried by its region."""
    pictures, masks = disc_that_comes_in(36.0, 14.0)
    return _tracked(pictures, masks[0])


def coming_in_posed() -> Points:
    """The same of a small object, which its pose would hold to what was seen of it on the key."""
    pictures, masks = disc_that_comes_in(14.0, 5.0)
    return _tracked(pictures, masks[0])


def coming_in_limb() -> Points:
    """An arm alone that comes in with its body, of the same cloth: by its pose, and by its region beyond the key."""
    figure = arm_that_comes_in()
    *_, last = track(figure.read, figure.shapes()[1:], figure.frames, "best")
    return _points([last.results[0].shape])


def hidden_while_zoomed() -> Points:
    """A ball that passes behind a post while the camera pulls out."""
    pictures, masks = ball_hidden_while_the_camera_pulls_out()
    return _tracked(pictures, masks[0])


def known_by_keypoints() -> Points:
    """A card that comes out from behind a board, and is half hidden still."""
    pictures, masks = card_that_comes_out(11)
    return _tracked(pictures, masks[0])


def in_haze() -> Points:
    """A figure in parts over which haze comes up."""
    figure = body_with_arms(6)
    pictures = hazy(figure.pictures)
    *_, last = track(lambda frame: pictures[frame], figure.shapes(), figure.frames, "best")
    return _points([result.shape for result in last.results])


def _tracked(pictures: Sequence[UInt8], mask: UInt8) -> Points:
    *_, last = track(lambda frame: pictures[frame], shapes_from_mask(mask), range(len(pictures)), "best")
    return _points([result.shape for result in last.results])


RUNS: dict[str, Callable[[], Points]] = {
    each.__name__: each
    for each in (
        lone,
        parts,
        along,
        filled,
        along_filled,
        posed,
        held,
        hidden,
        cut_out,
        hidden_filled,
        panned,
        dimmed,
        coming_in,
        coming_in_posed,
        coming_in_limb,
        hidden_while_zoomed,
        known_by_keypoints,
        in_haze,
    )
}


def _points(shapes: Sequence[RotoShape]) -> Points:
    return {
        shape.id: {
            str(key.frame): np.round(key.points, 4).tolist() for key in shape.keys if key.origin is Origin.ENGINE
        }
        for shape in shapes
    }


@pytest.mark.parametrize("name", list(RUNS))
def test_other_points_have_another_revision(name: str) -> None:
    stored = json.loads(STORED.read_text(encoding="utf-8"))
    found, known = RUNS[name](), stored["points"][name]
    assert {shape: list(keys) for shape, keys in found.items()} == {shape: list(keys) for shape, keys in known.items()}
    apart = max(
        float(np.abs(np.array(points) - np.array(known[shape][frame])).max())
        for shape, keys in found.items()
        for frame, points in keys.items()
    )
    told = f"the points of {name!r} are up to {apart:.4f} px from those of revision {stored['revision']}"
    assert apart <= NEAR or stored["revision"] != REVISION, f"{told}: give `provenance.REVISION` another number"
    assert stored["revision"] == REVISION, f"{told}: write them anew, see the top of this file"
    assert apart <= NEAR


@pytest.mark.parametrize("config", list(CONFIGS))
def test_what_a_stamp_tells_of_a_configuration_stays_as_long_as_the_revision(config: str) -> None:
    """A number that comes into the parameters and is not marked `later` would make every tracked key stale."""
    stored = json.loads(STORED.read_text(encoding="utf-8"))
    assert stored["revision"] != REVISION or told(config) == stored["stamped"][config]


def told(config: str) -> str:
    """A digest of what a stamp tells of a configuration."""
    return hashlib.sha256(json.dumps(CONFIGS[config].values(), sort_keys=True).encode()).hexdigest()[:16]


def write() -> None:
    """Store the points of the engine as it is, and what stamps tell of its configurations."""
    stamped = {config: told(config) for config in CONFIGS}
    points = {name: run() for name, run in RUNS.items()}
    text = json.dumps({"revision": REVISION, "stamped": stamped, "points": points}, separators=(",", ":"))
    text = text.replace('"points"', '\n"points"').replace('"stamped"', '\n"stamped"').replace('},"', '},\n"')
    STORED.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    write()
    print(f"Wrote {STORED.name} of revision {REVISION}.", file=sys.stderr)
