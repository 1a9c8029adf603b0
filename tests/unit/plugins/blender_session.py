"""Run inside Blender by `test_blender`: the add-on brings shapes from ROAM, and sends them back with the clip."""

import importlib
import json
import os
import sys
from pathlib import Path

import bpy

wanted = json.loads(os.environ["ROAM_WANTED"])
folder = Path(wanted["folder"])
sys.path.insert(0, str(folder / "addons"))
addon = importlib.import_module("roam")
addon.register()
opened = []
addon.roam_bridge.open_window = lambda path, chosen="": opened.append(str(path))

scene = bpy.context.scene
clip = bpy.data.movieclips.load(wanted["first"])
clip.frame_start = wanted["starts"]
scene.active_clip = clip
scene.frame_start, scene.frame_end = wanted["starts"], wanted["starts"] + 4

back = bpy.ops.roam.bring(filepath=wanted["project"])
masks = [mask.name for mask in bpy.data.masks]
for mask in bpy.data.masks:
    mask.frame_start, mask.frame_end = 1, 100  # as Blender makes masks
sent = bpy.ops.roam.send(filepath=str(folder / "sent"))
told = ""
try:
    bpy.ops.roam.bring(filepath=str(folder / "missing.roam"))
except RuntimeError as error:
    told = str(error)
result = {"back": list(back), "sent": list(sent), "masks": masks, "opened": opened, "told": told}
(folder / "result.json").write_text(json.dumps(result), encoding="utf-8")
addon.unregister()
