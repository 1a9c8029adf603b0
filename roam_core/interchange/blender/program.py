"""The script for Blender around its values: it builds masks, and a group of compositor nodes where layers join."""

PROGRAM = """\
# Masks from ROAM. In Blender: open this in the text editor and run it; then pick the mask "ROAM" in an image editor in
# mask mode, or in the compositor's Mask node with "Scene Size". Where layers of shapes have modes of their own there is
# a mask for each, and the node group "ROAM" of the compositor joins them.
import json

import bpy

FRAMES = @FRAMES@
PARTS = json.loads(@PARTS@)


def keyed(owner, field, value):
    number, keys = value
    setattr(owner, field, number)
    for frame, number, holds in keys:
        setattr(owner, field, number)
        owner.keyframe_insert(field, frame=frame)


def hold(owner, path, value):
    # Interpolation is a matter of the curve's points: straight, or held to the next key.
    holds = dict((frame, is_held) for frame, _, is_held in value[1])
    for curve in curves(owner):
        if curve.data_path == path:
            for point in curve.keyframe_points:
                point.interpolation = "CONSTANT" if holds.get(round(point.co[0])) else "LINEAR"


def curves(owner):
    action = owner.animation_data and owner.animation_data.action
    if not action:
        return []
    if hasattr(action, "fcurves"):
        return action.fcurves
    return [curve for layer in action.layers for strip in layer.strips for bag in strip.channelbags
            for curve in bag.fcurves]


def new_layer(mask, data):
    layer = mask.layers.new()
    layer.name = data["name"]
    layer.blend = data["blend"]
    layer.invert = data["invert"]
    layer.falloff = "LINEAR"
    layer.use_fill_overlap = True
    layer.hide = data["hidden"]
    layer.hide_render = data["hidden"] or not data["closed"]  # an open spline shows its feather, and inverted all
    spline = layer.splines.new()
    spline.use_cyclic = data["closed"]
    spline.use_fill = data["closed"]
    spline.offset_mode = "EVEN"
    spline.weight_interpolation = "LINEAR"
    spline.points.add(len(data["keys"][0][1]) - 1)
    for point in spline.points:
        point.handle_left_type = point.handle_right_type = "FREE"
        point.select = True
    return layer


def place(layer, rows):
    for point, row in zip(layer.splines[0].points, rows):
        point.co, point.handle_left, point.handle_right = row[0:2], row[2:4], row[4:6]
        point.weight = row[6]


def insert_keys(mask, layers, datas):
    # Shape keys are made by an operator alone, which wants an image editor in mask mode, and which acts on every layer
    # that is not locked.
    area = bpy.context.window_manager.windows[0].screen.areas[0]
    before = area.type
    area.type = "IMAGE_EDITOR"
    space = area.spaces.active
    space.mode, space.mask = "MASK", mask
    region = [region for region in area.regions if region.type == "WINDOW"][0]
    window = bpy.context.window_manager.windows[0]
    try:
        with bpy.context.temp_override(window=window, area=area, region=region, space_data=space):
            for layer, data in zip(layers, datas):
                for other in layers:
                    other.hide_select = other != layer
                    other.hide = other != layer
                for frame, rows in data["keys"]:
                    bpy.context.scene.frame_set(frame)
                    place(layer, rows)
                    bpy.ops.mask.shape_key_insert()
    finally:
        space.mask = None
        area.type = before
    for layer, data in zip(layers, datas):
        layer.hide, layer.hide_select = data["hidden"], data["locked"]


def new_mask(name, datas):
    mask = bpy.data.masks.new(name)
    mask.frame_start, mask.frame_end = FRAMES
    layers = [new_layer(mask, data) for data in datas]
    insert_keys(mask, layers, datas)
    for layer, data in zip(layers, datas):
        keyed(layer, "alpha", data["alpha"])
    for layer, data in zip(layers, datas):
        hold(mask, layer.path_from_id("alpha"), data["alpha"])
    return mask


def new_math(tree, operation, first, second, third=None):
    try:
        node = tree.nodes.new("CompositorNodeMath")
    except RuntimeError:
        node = tree.nodes.new("ShaderNodeMath")
    node.operation = operation
    for socket, value in zip(node.inputs, (first, second, third)):
        if isinstance(value, (int, float)):
            socket.default_value = value
        elif value is not None:
            tree.links.new(value, socket)
    return node


def without(tree, value):
    return new_math(tree, "SUBTRACT", 1.0, value).outputs[0]


def joined(tree, blend, under, above):
    if blend == "subtract":
        return new_math(tree, "MULTIPLY", under, without(tree, above)).outputs[0]
    if blend == "intersect":
        return new_math(tree, "MULTIPLY", under, above).outputs[0]
    if blend == "difference":
        return new_math(tree, "ABSOLUTE", new_math(tree, "SUBTRACT", under, above).outputs[0], None).outputs[0]
    if blend == "max":
        return new_math(tree, "MAXIMUM", under, above).outputs[0]
    if blend == "plus":
        node = new_math(tree, "ADD", under, above)
        node.use_clamp = True
        return node.outputs[0]
    return new_math(tree, "MULTIPLY_ADD", under, without(tree, above), above).outputs[0]


def dimmed(tree, value, opacity):
    if opacity == [1.0, []]:
        return value
    node = new_math(tree, "MULTIPLY", value, 1.0)
    keyed(node.inputs[1], "default_value", opacity)
    hold(tree, node.inputs[1].path_from_id("default_value"), opacity)
    return node.outputs[0]


def matte(tree, part):
    if "parts" in part:
        value = None
        for inner in part["parts"]:
            above = matte(tree, inner)
            value = above if value is None else joined(tree, inner["blend"], value, above)
        if value is None:
            value = new_math(tree, "MULTIPLY", 0.0, 0.0).outputs[0]
    else:
        node = tree.nodes.new("CompositorNodeMask")
        node.mask, node.size_source, node.use_feather = new_mask("ROAM " + part["name"], part["layers"]), "SCENE", True
        value = node.outputs[0]
    if part["invert"]:
        value = without(tree, value)
    return dimmed(tree, value, part["opacity"])


def new_group(parts):
    tree = bpy.data.node_groups.new("ROAM", "CompositorNodeTree")
    tree.interface.new_socket("Matte", in_out="OUTPUT", socket_type="NodeSocketFloat")
    whole = {"parts": parts, "invert": False, "opacity": [1.0, []]}
    tree.links.new(matte(tree, whole), tree.nodes.new("NodeGroupOutput").inputs[0])
    for number, node in enumerate(tree.nodes):
        node.location = (180 * number, 0)


current = bpy.context.scene.frame_current
if len(PARTS) == 1 and "layers" in PARTS[0] and PARTS[0]["opacity"] == [1.0, []]:
    new_mask("ROAM", PARTS[0]["layers"])
else:
    new_group(PARTS)
bpy.context.scene.frame_set(current)
"""
