"""Lua as a judge of what Fusion is given: constructors of Fusion's are functions that return their table."""

from __future__ import annotations

import re
from typing import Any

import lupa
import numpy as np

from roam_core.arrays import Array
from tests.unit.interchange.judged import JudgedMask

CONSTRUCTORS = ("Input", "Polyline", "FuID", "PolylineMask", "BezierSpline", "OperatorInfo")
TOOLS = ("BitmapMask", "Background")
BAD_WORDS = ("os", "io", "debug", "package", "require", "load", "dofile", "loadstring", "loadfile", "python")


def evaluated(text: str) -> dict[str, Any]:
    """The tools of a setting: only constructors can be called, and nothing else is there to be reached."""
    lua = lupa.LuaRuntime(register_eval=False, register_builtins=False, unpack_returned_tuples=True)
    chunk = lua.eval("function(text, environment) return load('return ' .. text, 'setting', 't', environment) end")
    environment = lua.table()
    for name in (*CONSTRUCTORS, *TOOLS):
        environment[name] = lua.eval(f"function(values) values.kind = {name!r}; return values end")
    environment["ordered"] = lua.eval("function() return function(values) return values end end")
    made = chunk(text, environment)
    assert not isinstance(made, tuple), made[1]
    return _plain(made()["Tools"])


def _plain(value: Any) -> Any:
    """Lua tables as dictionaries."""
    return {key: _plain(inner) for key, inner in value.items()} if lupa.lua_type(value) == "table" else value


def judge(text: str) -> list[JudgedMask]:
    """The polygon masks of a setting, in the order of the file."""
    tools = evaluated(text)
    names = re.findall(r"^  (\w+) = PolylineMask \{", text, flags=re.MULTILINE)
    assert len(set(names)) == len(names) == sum(tool["kind"] == "PolylineMask" for tool in tools.values())
    return [mask_of(name, tools[name], tools) for name in names]


def mask_of(name: str, tool: dict[str, Any], tools: dict[str, Any]) -> JudgedMask:
    inputs = tool["Inputs"]
    values = {key: made.get("Value") for key, made in inputs.items()}
    size = (values["MaskWidth"], values["MaskHeight"])
    assert inputs["Polyline"]["Source"] == "Value"
    spline = tools[inputs["Polyline"]["SourceOp"]]
    frames = sorted(spline["KeyFrames"])
    for index, frame in enumerate(frames):
        key = spline["KeyFrames"][frame]
        assert key[1] == index
        assert key["Flags"] == {"Linear": True, "LockedY": True}
    closed = {spline["KeyFrames"][frame]["Value"].get("Closed", False) for frame in frames}
    assert len(closed) == 1
    keys = {frame: _points(spline["KeyFrames"][frame]["Value"]["Points"], size) for frame in frames}
    extra = {"tool": name, "level": keys_of("Level", tool, tools), "hidden": "PassThrough" in tool}
    extra["below"] = inputs.get("EffectMask", {}).get("SourceOp")
    return JudgedMask(values["Comments"], closed.pop(), keys, values | extra)


def keys_of(name: str, tool: dict[str, Any], tools: dict[str, Any]) -> dict[float, float]:
    """Frames and numbers of an input that a spline drives; nothing where none does."""
    made = tool["Inputs"].get(name, {})
    if "SourceOp" not in made:
        return {}
    assert made["Source"] == "Value"
    keys = tools[made["SourceOp"]]["KeyFrames"]
    assert all(key["Flags"] == {"Linear": True} for key in keys.values())
    return {frame: key[1] for frame, key in keys.items()}


def _points(rows: dict[int, dict[str, float]], size: tuple[int, int]) -> Array:
    width, height = size
    points = []
    for index in range(1, len(rows) + 1):
        row = rows[index]
        x, y = (row["X"] + 0.5) * width, (0.5 - row["Y"]) * height
        handles = [(x + row[f"{side}X"] * width, y - row[f"{side}Y"] * height) for side in "LR"]
        points.append([(x, y), *handles])
    return np.array(points)
