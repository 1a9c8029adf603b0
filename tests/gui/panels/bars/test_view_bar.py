"""The view bar: what it calls the plate."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.canvas.view import CanvasView
from app.folders import cache_folder
from app.model.document import Document
from app.model.viewing import PROXIES
from app.panels.bars.view_bar import ViewBar
from resources import demo
from roam_core.roto import Clip, Project

CLIP = Clip(Path("plate_v003"), 1001, 1048, (960, 540))


@pytest.mark.parametrize(
    ("path", "name"),
    [
        (cache_folder() / demo.cache_name(), "demo"),
        (Path("shots") / "demo-11e8108e", "demo-11e8108e"),  # a folder of the artist's keeps its name
        (Path("shots") / "plate_v003", "plate_v003"),
    ],
)
def test_the_plate_is_called_by_a_name_the_artist_knows(
    qtbot: QtBot, document: Document, canvas: CanvasView, path: Path, name: str
) -> None:
    bar = ViewBar(document, canvas, Actions(canvas, canvas, load_keymap()))
    qtbot.addWidget(bar)
    document.open(Project(replace(CLIP, path=path)), None)
    assert bar._plate.text().split("  ·  ") == [name, "1001–1048", "960×540", "sRGB"]
    assert bar._plate.toolTip() == f"{bar._plate.text()}\n{path}"


def test_a_proxy_is_named(qtbot: QtBot, document: Document, canvas: CanvasView) -> None:
    actions = Actions(canvas, canvas, load_keymap())
    actions.connect_all(canvas.handlers())
    bar = ViewBar(document, canvas, actions)
    qtbot.addWidget(bar)
    document.open(Project(CLIP), None)
    assert [actions[name].isChecked() for name in PROXIES] == [True, False, False]
    actions["view.quarter"].trigger()
    assert bar._plate.text().endswith("  ·  Proxy 1/4")
    assert [actions[name].isChecked() for name in PROXIES] == [False, False, True]
    actions["view.full"].trigger()
    assert "Proxy" not in bar._plate.text()
