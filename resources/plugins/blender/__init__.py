"""The add-on ROAM for Blender 4.2 and newer: a movie clip and its masks to ROAM, and shapes from there as masks."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import bpy

from . import roam_bridge, roam_masks

bl_info = {
    "name": "ROAM",
    "author": "ROAM",
    "version": (1, 0, 0),
    "blender": (4, 2, 0),
    "location": "Movie Clip Editor and Image Editor > Mask > ROAM",
    "description": "Sends a clip and its masks to ROAM, and brings shapes back as masks",
    "category": "Compositing",
}


class Preferences(bpy.types.AddonPreferences):
    """Where ROAM's program is."""

    bl_idname = __package__

    program: bpy.props.StringProperty(  # type: ignore[valid-type]
        name="ROAM's program", subtype="FILE_PATH", description="Empty: roam on the PATH, or the variable ROAM_PROGRAM"
    )

    def draw(self, context: Any) -> None:
        self.layout.prop(self, "program")


class Send(bpy.types.Operator):
    """Make a ROAM project of the clip and its masks, and open it in ROAM"""

    bl_idname = "roam.send"
    bl_label = "Send Clip and Masks to ROAM"
    filepath: bpy.props.StringProperty(subtype="FILE_PATH")  # type: ignore[valid-type]
    filter_glob: bpy.props.StringProperty(default="*.roam", options={"HIDDEN"})  # type: ignore[valid-type]

    def invoke(self, context: Any, event: Any) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Any) -> set[str]:
        try:
            self._send(context)
        except roam_bridge.Trouble as trouble:
            self.report({"ERROR"}, str(trouble))
            return {"CANCELLED"}
        return {"FINISHED"}

    def _send(self, context: Any) -> None:
        clip = roam_masks.clip_of(context)
        chosen, path = _program(context), bpy.path.abspath(clip.filepath)
        masks = [mask for mask in bpy.data.masks if any(layer.splines for layer in mask.layers)]
        if not masks:
            roam_bridge.send(Path(), path, None, chosen=chosen)
            return
        size = (clip.size[0], clip.size[1])
        project, offset = roam_bridge.project_of(self.filepath), roam_masks.offset_of(clip, path, chosen)
        frames = roam_masks.frames_of(clip)
        shapes = [shape for mask in masks for shape in roam_masks.shapes_of(context.scene, mask, size, frames)]
        with tempfile.TemporaryDirectory() as folder:
            written = Path(folder) / "shapes.json"
            written.write_text(roam_bridge.document(shapes, size), encoding="utf-8")
            roam_bridge.send(project, path, written, offset, chosen)


class Bring(bpy.types.Operator):
    """Make masks of the shapes of a ROAM project"""

    bl_idname = "roam.bring"
    bl_label = "Bring Shapes Back from ROAM"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012 - Blender asks for a set here
    filepath: bpy.props.StringProperty(subtype="FILE_PATH")  # type: ignore[valid-type]
    filter_glob: bpy.props.StringProperty(default="*.roam", options={"HIDDEN"})  # type: ignore[valid-type]

    def invoke(self, context: Any, event: Any) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Any) -> set[str]:
        try:
            clip = roam_masks.clip_of(context)
            chosen = _program(context)
            offset = roam_masks.offset_of(clip, bpy.path.abspath(clip.filepath), chosen)
            with tempfile.TemporaryDirectory() as folder:
                script = Path(folder) / "masks.py"
                said = roam_bridge.bring(Path(self.filepath), script, "blender", offset, chosen)
                text = script.read_text(encoding="ascii")
        except roam_bridge.Trouble as trouble:
            self.report({"ERROR"}, str(trouble))
            return {"CANCELLED"}
        # ROAM wrote this script a moment ago, in a folder that nobody else can write to.
        exec(compile(text, "masks.py", "exec"), {"__name__": "__main__"})  # noqa: S102
        self.report({"INFO"}, said)
        return {"FINISHED"}


class Menu(bpy.types.Menu):
    """The two ways"""

    bl_idname = "MASK_MT_roam"
    bl_label = "ROAM"

    def draw(self, context: Any) -> None:
        self.layout.operator(Send.bl_idname)
        self.layout.operator(Bring.bl_idname)


def _program(context: Any) -> str:
    addon = context.preferences.addons.get(__package__)
    return addon.preferences.program if addon is not None and addon.preferences is not None else ""


def _draw_menu(menu: Any, context: Any) -> None:
    menu.layout.menu(Menu.bl_idname)


CLASSES = (Preferences, Send, Bring, Menu)


def register() -> None:
    """Called by Blender when the add-on is enabled."""
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.MASK_MT_mask.append(_draw_menu)


def unregister() -> None:
    """Called by Blender when the add-on is disabled."""
    bpy.types.MASK_MT_mask.remove(_draw_menu)
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
