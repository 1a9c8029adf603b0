"""The actions of the File menu."""

from __future__ import annotations

from ..translation import N_
from .spec import ActionSpec

FILE: tuple[ActionSpec, ...] = (
    ActionSpec("file.new", N_("New")),
    ActionSpec("file.open_clip", N_("Open clip…")),
    ActionSpec("file.open_movie", N_("Open movie…")),
    ActionSpec("file.open_project", N_("Open project…")),
    ActionSpec("file.open_demo", N_("Open the demo"), tip=N_("A short shot to try everything on")),
    ActionSpec("file.relink_clip", N_("Relink clip…"), tip=N_("Another version of the plate below the same shapes")),
    ActionSpec("file.reload_clip", N_("Reload clip"), tip=N_("Read again pictures that were rendered anew")),
    ActionSpec(
        "file.clip_settings", N_("Clip settings…"), tip=N_("Colours, layer, frames per second and pixels of the clip")
    ),
    ActionSpec("file.save", N_("Save")),
    ActionSpec("file.save_as", N_("Save as…")),
    ActionSpec(
        "file.save_version",
        N_("Save new version"),
        tip=N_("Save beside the project's file, under the next version number: v003 is followed by v004"),
    ),
    ActionSpec(
        "file.recover", N_("Recover work…"), tip=N_("What crashes left, and what was thrown away, session by session")
    ),
    ActionSpec(
        "file.import_shapes", N_("Import shapes…"), tip=N_("Shapes of Nuke, Silhouette and others; or drop the file")
    ),
    ActionSpec("file.import_masks", N_("Import masks…"), tip=N_("Fit shapes to a folder of mask pictures")),
    ActionSpec(
        "file.export", N_("Export…"), tip=N_("Shapes for other programs, and mattes: every format, keys and frames")
    ),
    ActionSpec(
        "file.export_selected", N_("Export selected shapes…"), tip=N_("The selected shapes alone, in any format")
    ),
    ActionSpec("file.export_nuke", N_("Export to Nuke…")),
    ActionSpec("file.export_mattes", N_("Export mattes…")),
    ActionSpec("file.quit", N_("Quit")),
)
