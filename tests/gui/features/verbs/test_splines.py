"""Making shapes B-splines, and Beziers again."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from app.features.verbs.splines import SplineVerbs
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry import bezier, bspline, primitives
from roam_core.roto import Project, RotoShape, Spline, edit


@pytest.fixture
def ellipse(document: Document, view_state: ViewState) -> str:
    """The id of a selected ellipse, one of its points selected too."""
    project, shape = edit.new_shape(Project(), primitives.ellipse((20.0, 20.0), (120.0, 80.0)), 1)
    document.open(project, None)
    view_state.select(frozenset({shape.id}), frozenset({(shape.id, 1)}))
    return shape.id


@pytest.fixture
def verbs(document: Document, view_state: ViewState) -> SplineVerbs:
    return SplineVerbs(document, view_state)


def only(document: Document) -> RotoShape:
    (shape,) = document.project.shapes
    return shape


def test_there_and_back(verbs: SplineVerbs, document: Document, view_state: ViewState, ellipse: str) -> None:
    verbs.handlers()["shape.to_bspline"]()
    assert only(document).spline is Spline.BSPLINE
    assert bspline.is_bspline(only(document).at(1).points)
    assert "moved by up to" in view_state.message
    assert view_state.selection.shapes == {ellipse}
    assert not view_state.selection.points
    outline = only(document).at(1).flatten()
    verbs.handlers()["shape.to_bezier"]()
    assert only(document).spline is Spline.BEZIER
    np.testing.assert_array_equal(only(document).at(1).flatten(), outline)
    assert document.undo_stack.count() == 2


def test_what_is_of_that_kind_already_is_told(
    verbs: SplineVerbs, document: Document, view_state: ViewState, ellipse: str
) -> None:
    verbs.to_bezier()
    assert view_state.message == "The selected shapes are Bezier already."
    assert document.undo_stack.count() == 0


def test_locked_shapes_stay(verbs: SplineVerbs, document: Document, view_state: ViewState, ellipse: str) -> None:
    document.open(edit.set_properties(document.project, ellipse, locked=True), None)
    verbs.to_bspline()
    assert only(document).spline is Spline.BEZIER
    assert "is locked" in view_state.message


def test_keys_of_many_frames_become_splines_in_one_go(
    verbs: SplineVerbs, document: Document, ellipse: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    shape = only(document)
    keys = [replace(shape.keys[0], frame=frame, points=shape.keys[0].points + frame) for frame in range(2, 40)]
    document.open(document.project.with_shape(shape.with_keys(keys)), None)
    calls: list[int] = []
    monkeypatch.setattr(bezier, "bernstein", lambda t, own=bezier.bernstein: calls.append(len(t)) or own(t))
    verbs.to_bspline()
    assert only(document).spline is Spline.BSPLINE
    assert len(calls) < len(keys) / 4  # not once for every key
