"""Node as a judge of what After Effects is given: the script itself runs, against objects that remember."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.unit.interchange.judged import JudgedMask

STUB = Path(__file__).with_name("after_effects_stub.js")
EASE = {"speed": 0, "influence": 100 / 3}


def ran(text: str, folder: Path, layer: tuple[int, int] | None = None) -> dict[str, Any]:
    """What the script made; with `layer`, a layer of that size is selected that begins at 2 seconds."""
    node = shutil.which("node")
    if node is None:
        pytest.skip("Node is not installed; it runs the scripts for After Effects")
    script = folder / "masks.jsx"
    script.write_bytes(text.encode("ascii"))
    command = [node, str(STUB), str(script), *(str(length) for length in layer or ())]
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    made: dict[str, Any] = json.loads(done.stdout)
    return made


def masks(made: dict[str, Any], fps: float, first: int, start: float = 0.0) -> list[JudgedMask]:
    """The masks in the order in which After Effects applies them, with frames for seconds."""
    return [mask_of(mask, fps, first, start) for mask in made["masks"]]


def mask_of(mask: dict[str, Any], fps: float, first: int, start: float) -> JudgedMask:
    path = mask["properties"]["ADBE Mask Shape"]["keys"]
    assert [key["time"] for key in path] == sorted(key["time"] for key in path)
    frames = [round((key["time"] - start) * fps + first, 6) for key in path]
    closed = {key["value"]["closed"] for key in path}
    assert len(closed) == 1
    keys, moves = {}, {}
    for frame, key, following in zip(frames, path, [*path[1:], None], strict=True):
        anchors = np.array(key["value"]["vertices"], dtype=np.float64)
        handles = [anchors + np.array(key["value"][side], dtype=np.float64) for side in ("inTangents", "outTangents")]
        keys[frame] = np.stack([anchors, *handles], axis=1)
        moves[frame] = {"linear": "linear", "hold": "hold", "bezier": "smooth"}[key["types"][1]]
        if moves[frame] == "smooth":  # the same ease at both ends of the span, and a Bezier in between
            assert key["ease"][1] == EASE
            if following is not None:
                assert (following["types"][0], following["ease"][0]) == ("bezier", EASE)
    return JudgedMask(mask["name"], closed.pop(), keys, mask, moves)
