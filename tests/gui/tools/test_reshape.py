"""What drags, nudges and point actions change, in projects of many shapes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from app.tools.reshape import Grab
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Layer, Project, edit


def test_a_drag_of_many_shapes_asks_the_project_for_its_shapes_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each project on the way was asked for all of its shapes: of 300 a drag took a second for each step."""
    project = Project()
    for k in range(20):
        project, _ = edit.new_shape(project, polygon_points([(k, 0), (k + 9, 0), (k + 9, 9)]), 1)
    grab = Grab.of(project, 1, {shape.id: np.ones(3) for shape in project.shapes})
    laid_out, plate_space = list[Layer](), Layer.in_plate_space

    def watched(layer: Layer, *given: Any) -> Layer:
        laid_out.append(layer)
        return plate_space(layer, *given)

    monkeypatch.setattr(Layer, "in_plate_space", watched)
    moved = grab.moved(project, (5.0, 0.0))
    assert not laid_out
    assert [shape.at(1).points[0, 0, 0] for shape in moved.shapes] == [k + 5.0 for k in range(20)]
