"""Run inside Blender by `blender_judge`: runs an exported script, then renders its mask through the compositor."""

import json
import math
import os
from pathlib import Path

import bpy

wanted = json.loads(os.environ["ROAM_WANTED"])
script = Path(wanted["script"])
exec(compile(script.read_text(encoding="ascii"), str(script), "exec"), {"__name__": "__main__"})  # noqa: S102 - our own script

scene, group = bpy.context.scene, bpy.data.node_groups.get("ROAM")
render = scene.render
render.resolution_x, render.resolution_y = wanted["size"]
render.resolution_percentage = 100
render.pixel_aspect_x, render.pixel_aspect_y = max(wanted["aspect"], 1.0), max(1.0 / wanted["aspect"], 1.0)
render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
scene.use_nodes = True
tree = scene.node_tree
tree.nodes.clear()
if group is None:
    source = tree.nodes.new("CompositorNodeMask")
    source.mask, source.size_source, source.use_feather = bpy.data.masks["ROAM"], "SCENE", True
else:
    source = tree.nodes.new("CompositorNodeGroup")
    source.node_tree = group
target = tree.nodes.new("CompositorNodeComposite")
tree.links.new(source.outputs[0], target.inputs[0])
for frame in wanted["frames"]:
    scene.frame_set(math.floor(frame), subframe=frame % 1.0)
    render.filepath = str(Path(wanted["out"]) / f"{frame}.exr")
    bpy.ops.render.render(write_still=True)

layers = [
    {"name": layer.name, "blend": layer.blend, "invert": layer.invert, "locked": layer.hide_select}
    | {"hidden": layer.hide_render, "closed": layer.splines[0].use_cyclic}
    for mask in bpy.data.masks
    for layer in mask.layers
]
(Path(wanted["out"]) / "layers.json").write_text(json.dumps(layers), encoding="utf-8")
