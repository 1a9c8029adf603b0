"""Single numbers by their paths: reachable, stamped, refused in a sentence, and none of them standing outside."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass, replace
from types import FunctionType
from typing import Any

import numpy as np
import pytest

from roam_core import fill_span, params, track
from roam_core.cli import main
from roam_core.errors import RoamError
from roam_core.params import CONFIGS, RegionParams, RoamParams, params_for
from roam_core.params.paths import leaves, meaning, meanings
from roam_core.params.stamped import later, values
from roam_core.propagate.shapes.provenance import clip_stamp, is_stale, stamp
from roam_core.roto import Clip, Keyframe, Origin, RotoShape
from tests.golden.shots import Shot, blob, pose
from tests.unit.propagate.figures import body_with_arms

ROOMS = [kind for kind in vars(params).values() if isinstance(kind, type) and is_dataclass(kind)]

OTHERS: dict[str, float] = {"window": 7, "proposals.neighbours": 4, "gradient_top": 99.0}
"""Values for numbers of which not every one like the present one makes sense (`params.limits`)."""


@pytest.mark.parametrize("config", list(CONFIGS))
def test_every_number_is_reached_by_its_path(config: str) -> None:
    base = CONFIGS[config]
    for path, value in leaves(base):
        if isinstance(value, str) or value is None:
            continue
        first = value[0] if isinstance(value, tuple) else value
        other = first + 1 if isinstance(first, int) else 1.5 * first + 0.125 * (first == 0)
        other = OTHERS.get(path, other)
        text = (
            ",".join([f"{other!r}", *(f"{each!r}" for each in value[1:])]) if isinstance(value, tuple) else f"{other!r}"
        )
        name = f"{config}+{path}={text}"
        found = params_for(name)
        there = dict(leaves(found))
        assert there[path] == ((other, *value[1:]) if isinstance(value, tuple) else other)
        assert {each for each, now in leaves(base) if there[each] != now} == {path}
        assert found.config == name
        assert json.dumps(replace(found, config=config).values()) != json.dumps(base.values()), path


@pytest.mark.parametrize("kind", ROOMS, ids=lambda kind: kind.__name__)
def test_every_number_is_described(kind: type) -> None:
    assert {each.name for each in fields(kind)} - set(meanings(kind)) == set()


def test_rooms_nest_and_words_of_a_name_add_up() -> None:
    found = params_for("best+region.band=6+region.redetection.alike=0.5+warp=landmarks+klt+steps=3,1+reach=2").region
    assert found is not None
    assert (found.band, found.redetection.alike) == (12, 0.5)
    assert params_for("best+warp=landmarks+klt").warp == "landmarks+klt"
    assert params_for("best+region.pose=none").region == replace(params_for("best").region or RegionParams(), pose=None)
    assert params_for("full+appearance.cues.redetection.distinct=1").appearance != CONFIGS["full"].appearance
    assert meaning(CONFIGS["best"], "region.redetection.alike").startswith("share of the key's own score")


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("best+regoin.band=3", "the closest are region.band"),
        ("best+region.redetection.alkie=0.5", "the closest are region.redetection.alike"),
        ("best+band=3", "the closest are region.band"),
        ("best+raech=2", "the closest are reach"),
        ("best+qqqqqq=3", "roam configs --params"),
        ("lean+region.band=3", "has no region"),
        ("best+region=4", "a room of numbers"),
        ("best+region.span=none", "a room of numbers"),
        ("best+region.band=x", "a whole number"),
        ("best+region.band=2.5", "a whole number"),
        ("best+region.band=0", "from 1"),
        ("best+region.band=1e9", "a whole number"),
        ("best+region.blur=-1", "from 0"),
        ("medium+window=4", "an odd number"),
        ("baseline+max_nodes=1", "2 or more"),
        ("baseline+gradient_top=150", "100 at most"),
        ("baseline+klt.window=2", "3 or more"),
        ("best+region.rigidity.planar.window_closely=1", "3 or more"),
        ("full+proposals.neighbours=6", "4 or 8"),
        ("lean+appearance.key_share=1.5", "1 at most"),
        ("medium+landmarks.star=0", "from 0.0002"),
        ("best+region.blur=inf", "a number"),
        ("best+steps=1", "give 2 numbers"),
        ("best+warp=foo", "choose from none, klt"),
        ("best+config=lean", "no dial or parameter"),
        ("best+region.band.more=1", "no dial or parameter"),
        ("best+=3", "no dial or parameter"),
        ("best+", "no configuration"),
    ],
)
def test_a_path_that_makes_no_sense_is_refused_in_a_sentence(name: str, told: str) -> None:
    with pytest.raises(RoamError, match=r"\.$") as refused:
        params_for(name)
    assert told in str(refused.value)
    assert "\n" not in str(refused.value)


def test_the_l2_term_may_rest_at_zero_as_in_the_paper() -> None:
    assert params_for("lean+l2_rest=0").l2_rest == 0.0


def test_a_number_that_came_later_is_stamped_only_where_it_is_changed() -> None:
    @dataclass(frozen=True)
    class Before:
        old: float = 1.0

    @dataclass(frozen=True)
    class Now:
        old: float = 1.0
        new: float = later(2.0)

    assert values(Now()) == values(Before())
    assert values(Now(new=3.0)) == {"old": 1.0, "new": 3.0}


def test_what_a_changed_number_made_is_fresh_under_its_name_and_stale_under_another() -> None:
    clip, square = Clip("shot", 1, 9, (64, 48)), blob([20.0] * 4)
    shape = RotoShape("s", "s", (Keyframe(1, square),))
    changed = params_for("best+region.components.speck=9")
    inputs = stamp([shape], 2, 1, changed, clip_stamp(clip), True)
    assert inputs != stamp([shape], 2, 1, replace(changed, config="best"), clip_stamp(clip), True)
    made = Keyframe(2, square, origin=Origin.ENGINE, inputs=inputs)
    tracked = replace(shape, keys=(*shape.keys, made))
    assert not is_stale(tracked, made, clip)
    assert is_stale(tracked, replace(made, inputs=inputs.replace("speck=9", "speck=8")), clip)


SHOT = Shot(
    blob([52.0, 44.0, 36.0, 48.0, 56.0, 40.0]),
    tuple(pose(110.0 + 3.0 * k, 106.0, 3.0 * k, 1.0 + 0.02 * k) for k in range(4)),
    size=(240, 320),
    drift=(-0.5, 0.3),
)


@pytest.mark.parametrize(
    ("config", "word"),
    [
        ("best+region.rigid=1.5", "region.contour_fit.stretch=60"),
        ("best+region.rigid=1.5", "region.label_propagation.like=1"),
        ("best+region.rigid=1.5", "region.unseen=0.002"),
        ("best", "region.rigidity.fewest=2000"),
        ("medium", "landmarks.filters.lobe=1"),
        ("lean", "gradient_floor=14000"),
        ("baseline", "gradient_top=50"),
        ("baseline", "klt.window=7"),
        ("medium", "landmarks.patch=0.2"),
        ("best+region.rigid=1.5", "region.contour_fit.straight=1"),
        ("best+region.rigid=1.5", "region.motion_agreed=1.01"),
    ],
)
def test_a_changed_number_changes_what_comes_out(config: str, word: str) -> None:
    def solved(name: str) -> np.ndarray:
        *_, last = track(SHOT.read, [SHOT.shape()], SHOT.frames, name)
        key = last.results[0].key
        assert key is not None
        return key.points

    assert not np.array_equal(solved(config), solved(f"{config}+{word}"))


class Poison:
    """In place of the numbers that a function goes by where it is told none."""

    def __getattr__(self, name: str) -> Any:
        raise AssertionError(f"a run reads {name!r} of a default, and not of its configuration")


def functions() -> Iterator[Any]:
    """All functions and methods of the engine's rooms."""
    for name, module in list(sys.modules.items()):
        if not name.startswith("roam_core.") or name.startswith("roam_core.params"):
            continue
        for value in vars(module).values():
            held = vars(value).values() if isinstance(value, type) and value not in ROOMS else [value]
            yield from (getattr(each, "__func__", each) for each in held if hasattr(each, "__func__") or callable(each))


@pytest.mark.parametrize("config", ["best", "full"])
def test_no_run_falls_back_on_numbers_that_its_configuration_does_not_tell(
    config: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    figure = body_with_arms(4)
    given, pictures = figure.shapes(0, 3), dict(enumerate(figure.pictures))
    poisoned = 0
    for function in set(functions()):
        if not isinstance(function, FunctionType) or not function.__defaults__:
            continue
        told = tuple(Poison() if type(each) in ROOMS else each for each in function.__defaults__)
        if told != function.__defaults__:
            monkeypatch.setattr(function, "__defaults__", told)
            poisoned += 1
    assert poisoned > 5
    assert len(list(track(SHOT.read, [SHOT.shape()], SHOT.frames, config))) == 3
    assert len(list(track(figure.read, figure.shapes(), figure.frames, config))) == 3
    assert len(fill_span(pictures, given, 0, 3, config)) == len(given)


def test_the_command_line_lists_what_can_be_changed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["configs"]) == 0
    said = capsys.readouterr().out
    assert all(f"\n{name}" in f"\n{said}" for name in CONFIGS)
    assert main(["configs", "lean", "--params", "--json"]) == 0
    told = {line["path"]: line for line in map(json.loads, capsys.readouterr().out.splitlines())}
    assert set(told) == {path for path, _ in leaves(CONFIGS["lean"])}
    assert all(line["meaning"] for line in told.values())
    assert main(["configs", "leen"]) == 1


def test_parameters_are_one_value_whatever_they_hold() -> None:
    assert hash(params_for("best+region.band=6")) == hash(params_for("best+region.band=6"))
    assert len({*CONFIGS.values(), RoamParams()}) == len(CONFIGS)
    empty: Any = replace(CONFIGS["best"], region=None)
    assert empty != CONFIGS["best"]
