"""Fixtures of fills: two squares with gaps between their keys, and stand-ins for what takes long."""

from __future__ import annotations

import pytest

from app.jobs.propagation import Propagation
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.propagate.between import span
from roam_core.roto import Project, edit
from tests.gui.jobs.spans import CLIP, RAMP, SQUARE, Engine, HeldTrack


@pytest.fixture
def engine(monkeypatch: pytest.MonkeyPatch) -> Engine:
    engine = Engine()
    monkeypatch.setattr(span, "fill_span", engine.fill_span)
    return engine


@pytest.fixture
def propagation(document: Document, view_state: ViewState, runner: Runner, engine: Engine) -> Propagation:
    """A square with artist keys on 1, 4 and 7, and one with keys on 1 and 7."""
    project, first = edit.new_shape(Project(CLIP), SQUARE, 1)
    project, second = edit.new_shape(project, SQUARE, 1)
    project = project.with_shape(edit.key_here(edit.key_here(first, 4), 7)).with_shape(edit.key_here(second, 7))
    document.open(project, None)
    return Propagation(document, view_state, runner, lambda frame: RAMP)


@pytest.fixture
def held(document: Document, view_state: ViewState, runner: Runner, propagation: Propagation) -> HeldTrack:
    return HeldTrack(document, view_state, runner, propagation)
