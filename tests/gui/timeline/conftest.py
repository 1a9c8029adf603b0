"""A timeline with two tracked shapes on a clip of 48 frames."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.features.navigation import Navigation
from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.timeline import Timeline
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import clip_stamp, stamp
from roam_core.roto import Keyframe, Origin, Project, edit
from tests.gui.timeline.places import CLIP, SQUARE
from tests.gui.waiting import WAIT


@pytest.fixture
def timeline(qtbot: QtBot, document: Document, view_state: ViewState) -> Iterator[Timeline]:
    navigation = Navigation(document, view_state)
    window = QWidget()
    qtbot.addWidget(window)
    actions = Actions(window, window, load_keymap())
    timeline = Timeline(document, view_state, lambda: range(1001, 1011), lambda: (1033, 1034), actions)
    actions.connect_all(timeline.taking_over({}))
    qtbot.addWidget(timeline)
    timeline.resize(1100, 220)
    with qtbot.waitExposed(timeline, timeout=WAIT):
        timeline.show()
    project = Project(CLIP)
    for first in (1001, 1010):
        project, shape = edit.new_shape(project, SQUARE + 300 * (first > 1001), first)
        inputs = stamp([shape], 1020, first, CONFIGS[DEFAULT_CONFIG], clip_stamp(CLIP), True)
        keys = [
            Keyframe(f, SQUARE, origin=Origin.ENGINE, confidence=0.2, inputs=inputs) for f in range(first + 1, 1020)
        ]
        project = project.with_shape(edit.set_engine_keys(edit.key_here(shape, 1030), keys))
    document.open(project, None)
    assert navigation.clip_range == (1001, 1049)
    yield timeline
    window.close()  # it holds the actions up to here
