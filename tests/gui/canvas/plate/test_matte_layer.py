"""Mattes are rendered off the window's thread, one at a time, the newest request last."""

from __future__ import annotations

import threading
import time

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.canvas.plate.matte_layer import MatteLayer
from roam_core.arrays import Float32
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit
from tests.gui.waiting import WAIT

SIZE = (12, 16)


class SlowRenderer:
    """Renders the frame number as grey, when it is let go."""

    def __init__(self) -> None:
        self.frames: list[int] = []
        self.threads: set[int] = set()
        self.gate = threading.Semaphore(0)

    def __call__(self, project: Project, frame: int, size: tuple[int, int]) -> Float32:
        self.gate.acquire()
        self.frames.append(frame)
        self.threads.add(threading.get_ident())
        return np.full(size, frame / 255.0, dtype=np.float32)


def test_only_the_newest_of_the_waiting_requests_is_rendered(qtbot: QtBot) -> None:
    renderer, project = SlowRenderer(), Project()
    layer = MatteLayer(renderer)
    for frame in (1, 2, 3, 4):
        layer.request(project, frame, SIZE)
    assert layer.pixels is None
    for expected in (1, 4):
        with qtbot.waitSignal(layer.ready, timeout=WAIT):
            renderer.gate.release()
        assert layer.pixels is not None
        assert (layer.pixels == expected).all()
    assert renderer.frames == [1, 4]
    assert threading.get_ident() not in renderer.threads
    layer.close()


def test_no_thread_outlives_the_layer(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    def render(project: Project, frame: int, size: tuple[int, int]) -> Float32:
        if frame == 1:
            raise ValueError("no matte")
        return np.zeros(size, dtype=np.float32)

    monkeypatch.setattr(threading, "excepthook", lambda _: time.sleep(0.2))  # after it has told of its end
    layer = MatteLayer(render)
    layer.request(Project(), 1, SIZE)
    layer.request(Project(), 2, SIZE)
    qtbot.waitUntil(lambda: layer.pixels is not None, timeout=WAIT)
    layer.close()
    assert not [thread for thread in threading.enumerate() if thread.name == "matte"]


def test_the_same_matte_is_rendered_once(qtbot: QtBot) -> None:
    renderer, project = SlowRenderer(), Project()
    layer = MatteLayer(renderer)
    layer.request(project, 1, SIZE)
    layer.request(project, 1, SIZE)
    with qtbot.waitSignal(layer.ready, timeout=WAIT):
        renderer.gate.release()
    layer.request(project, 1, SIZE)
    layer.close()
    assert renderer.frames == [1]


def test_closing_forgets_what_waits(qtbot: QtBot) -> None:
    renderer = SlowRenderer()
    layer = MatteLayer(renderer)
    layer.request(Project(), 1, SIZE)
    layer.request(Project(), 2, SIZE)
    renderer.gate.release()
    layer.close()
    assert renderer.frames == [1]


def test_the_matte_of_a_project(qtbot: QtBot) -> None:
    project, _ = edit.new_shape(Project(), polygon_points([(4.0, 2.0), (12.0, 2.0), (12.0, 10.0), (4.0, 10.0)]), 1)
    layer = MatteLayer()
    with qtbot.waitSignal(layer.ready, timeout=WAIT):
        layer.request(project, 1, SIZE)
    layer.close()
    expected = np.zeros(SIZE, dtype=np.uint8)
    expected[2:10, 4:12] = 255
    np.testing.assert_array_equal(layer.pixels, expected)


def test_after_an_error_the_next_matte_is_rendered_and_the_one_before_is_not_shown_for_it(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[type[BaseException]] = []
    monkeypatch.setattr(threading, "excepthook", lambda args: told.append(args.exc_type))

    def render(_project: Project, frame: int, size: tuple[int, int]) -> Float32:
        if frame == 2:
            raise MemoryError
        return np.full(size, frame / 255.0, dtype=np.float32)

    layer, project, shown = MatteLayer(render), Project(), []
    for frame in (1, 2, 3):
        with qtbot.waitSignal(layer.ready, timeout=WAIT):
            layer.request(project, frame, SIZE)
        layer.request(project, frame, SIZE)  # a repaint: what failed is not tried again for it
        shown.append(None if layer.pixels is None else int(layer.pixels[0, 0]))
    layer.close()
    assert (shown, told) == ([1, None, 3], [MemoryError])
