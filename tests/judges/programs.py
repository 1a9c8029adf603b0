"""The judges of all formats, as the table asks them."""

from __future__ import annotations

import importlib.util
import shutil
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

import numpy as np

from roam_core.arrays import Array, Float32
from roam_core.roto import Clip
from tests.judges import after_effects, blender, fusion, natron, nuke_grammar, nuke_render, plain_json, silhouette, svg
from tests.judges.scenes import BETWEEN, WHOLE
from tests.judges.table import Judge
from tests.unit.interchange import lua_judge, natron_judge, node_judge

ZOOM = 4
"""How much larger resvg paints, so that its anti-aliasing hides nothing."""


def _size(clip: Clip) -> tuple[int, int]:
    return clip.size[1], clip.size[0]


def _of_text(matte: Callable[[str, float, tuple[int, int]], Array]) -> Callable[[Path, Clip, float], Array]:
    return lambda path, clip, moment: matte(path.read_text(encoding="utf-8"), moment, _size(clip))


def _nuke_names(path: Path) -> list[str]:
    return [shape.name for shape in nuke_grammar.shapes(path.read_text(encoding="utf-8"))]


def _after_effects(path: Path, clip: Clip, moment: float) -> Array:
    return after_effects.matte(path.read_text(encoding="ascii"), path.parent, clip.fps, moment, _size(clip))


def _after_effects_names(path: Path) -> list[str]:
    return [mask["name"] for mask in node_judge.ran(path.read_text(encoding="ascii"), path.parent)["masks"]]


def _fusion_names(path: Path) -> list[str]:
    return [mask.name for mask in lua_judge.judge(path.read_text(encoding="utf-8"))]


def _natron_names(path: Path) -> list[str]:
    masks, _ = natron_judge.judge(path.read_text(encoding="ascii"), 1)
    return [mask.name for mask in masks]


def _svg(path: Path, clip: Clip, moment: float) -> Array:
    return np.asarray(svg.matte(path.read_text(encoding="utf-8"), clip.size, ZOOM))


def _blender(path: Path, clip: Clip, moment: float) -> Array:
    moments = USUAL if moment in USUAL else (moment,)
    found = _rendered(path.read_text(encoding="ascii"), path.parent, _size(clip), clip.pixel_aspect, moments)
    return np.asarray(found[moment], dtype=np.float64)


USUAL = tuple(sorted({*WHOLE, *BETWEEN}))
"""The moments of a scene that Blender starts once for; for any other it starts anew."""


@lru_cache(maxsize=1)
def _rendered(
    text: str, folder: Path, size: tuple[int, int], aspect: float, moments: tuple[float, ...]
) -> dict[float, Float32]:
    return blender.mattes(text, folder, moments, size, aspect)


def _without(program: str, found: object) -> str:
    return "" if found else f"{program} is not installed"


JUDGES = [
    Judge("nuke", "tokenizer and renderer from the NDK's grammar", _of_text(nuke_render.matte), _nuke_names),
    Judge(
        "silhouette",
        "XML parser and renderer",
        _of_text(silhouette.matte),
        lambda path: silhouette.names(path.read_text(encoding="utf-8")),
    ),
    Judge(
        "after-effects",
        "Node, with stand-ins for After Effects' objects",
        _after_effects,
        _after_effects_names,
        missing=_without("Node", shutil.which("node")),
    ),
    Judge(
        "fusion",
        "Lua",
        _of_text(fusion.matte),
        _fusion_names,
        missing=_without("lupa", importlib.util.find_spec("lupa")),
    ),
    Judge(
        "blender",
        "Blender itself",
        _blender,
        least=0.985,
        missing=_without("Blender", blender.is_there()),
    ),
    Judge("natron", "Python, with stand-ins for Natron's objects", _of_text(natron.matte), _natron_names),
    Judge(
        "svg",
        "resvg",
        _svg,
        still=True,
        step=3.0 / 255.0,
        missing=_without("resvg-py", importlib.util.find_spec("resvg_py")),
    ),
    Judge(
        "json",
        "a reader from its description",
        _of_text(plain_json.matte),
        lambda path: plain_json.names(path.read_text(encoding="ascii")),
    ),
]
"""In the table's order."""
