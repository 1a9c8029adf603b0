"""The paper's tables and plots: variants that exist, shares of a fall, round ticks."""

from __future__ import annotations

import itertools
from pathlib import Path

import cv2
import numpy as np
import pytest

from benchmarks import chart, paper_plots, restarts, shots, variants
from benchmarks.shots import Shot
from benchmarks.stopwatch import Stopwatch, replaced
from benchmarks.variants import ABLATION, WARPS, Variant
from roam_core.errors import RoamError
from roam_core.geometry import polyline
from roam_core.params import CONFIGS, params_for


@pytest.mark.parametrize("variant", [*ABLATION, *WARPS], ids=lambda variant: variant.name)
def test_a_variant_differs_from_its_configuration_as_it_says(variant: Variant) -> None:
    params, whole = variant.params, params_for(variant.config)
    assert params.config == variant.name
    for name, value in variant.changes.items():
        assert variants.field_of(params, name) == value
    changed = {name: value for name, value in variant.changes.items() if variants.field_of(whole, name) != value}
    assert bool(changed) == bool(variant.changes) or variant in WARPS


@pytest.mark.parametrize("variant", [*ABLATION, *WARPS], ids=lambda variant: variant.name)
def test_a_variant_can_track(variant: Variant, gliding: Shot) -> None:
    found = [shots.overlap(*pair) for pair in restarts.predicted(gliding, gliding.frames[:3], variant.params)]
    assert len(found) == 2
    assert min(found) > 0.6


def test_every_configuration_is_a_row_of_the_ablation() -> None:
    assert set(CONFIGS) <= {variant.name for variant in ABLATION}


def test_a_field_that_is_not_there_cannot_be_changed() -> None:
    with pytest.raises(RoamError, match="no field 'region"):
        variants.with_field(params_for("best"), "region.size", 1)


def test_what_is_left_of_a_fall_goes_from_all_to_nothing() -> None:
    assert paper_plots.fallen([5.0, 2.0, 1.0]) == [1.0, 0.25, 0.0]
    assert paper_plots.fallen([1.0, 1.0]) == [0.0, 0.0]


def test_ticks_are_round_and_inside() -> None:
    assert chart.ticks(0.0, 1.0).tolist() == pytest.approx([0.0, 0.2, 0.4, 0.6, 0.8, 1.0])
    assert chart.ticks(3.0, 61.0).tolist() == pytest.approx([10.0, 20.0, 30.0, 40.0, 50.0, 60.0])


def test_a_chart_shows_its_lines_in_their_colours(tmp_path: Path) -> None:
    lines = [chart.line("up", [0, 1], [0, 1]), chart.line("down", [0, 1], [1, 0])]
    band = chart.Band("between", np.array([0.0, 1.0]), np.array([0.2, 0.2]), np.array([0.8, 0.8]))
    chart.write(tmp_path / "charts" / "both.png", chart.Axes("A title", "x", "y"), lines, band)
    picture = cv2.imread(str(tmp_path / "charts" / "both.png"))
    assert picture is not None
    assert picture.shape == (chart.HEIGHT, chart.WIDTH, 3)
    for colour in chart.PALETTE[:2]:
        assert (picture == colour).all(axis=2).sum() > 100


def test_a_function_is_replaced_wherever_it_is_known_and_put_back() -> None:
    line = np.array([[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]])
    true = polyline.crossings
    with replaced({true: lambda line, closed=True: np.empty((0, 2), dtype=np.intp)}):
        assert polyline.is_simple(line)
    assert polyline.crossings is true
    assert not polyline.is_simple(line)


def test_the_stopwatch_counts_an_inner_stage_for_itself_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    ticking = itertools.count()
    monkeypatch.setattr("benchmarks.stopwatch.time.thread_time", lambda: float(next(ticking)))
    watch = Stopwatch()
    line = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]])
    with watch.watching({"outer": (polyline.is_simple,), "inner": (polyline.crossings,)}):
        polyline.is_simple(line)
    # Looked at four times: the outer call lasts three ticks, one of which is the inner call's.
    assert watch.lap() == {"outer": 2.0, "inner": 1.0}
    assert watch.lap() == {}
