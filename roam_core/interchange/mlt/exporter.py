"""The spline of MLT's rotoscoping filter, which Kdenlive and Shotcut show: one JSON file a shape.

Source: the filter's own description (`filter_rotoscoping.yml`) and how it takes the text apart. A spline is a list of
points `[handle 1, point, handle 2]`, each `[x, y]` in shares of the picture from its top-left corner, handles absolute,
always closed; an object gives splines by frames, counted from the filter's first, between which points move straight.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from roam_core.atomic_write import write_atomically
from roam_core.errors import RoamError
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.flatten import TAKING, Branch, branched, has_feather_curve, hidden_notes, takes_part
from roam_core.interchange.labels.polygons import length_of_number
from roam_core.interchange.labels.presence import below_zero
from roam_core.interchange.naming import file_words
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied, settled, without_smooth_keys
from roam_core.interchange.telling import MODE_WORDS
from roam_core.interchange.timing import without_holds
from roam_core.roto import BlendMode, Project, RotoShape
from roam_core.roto.animated import is_always, values_of
from roam_core.translatable import N_, listed, sentence

OPERATIONS = {
    BlendMode.ADD: "add",
    BlendMode.PLUS: "add",
    BlendMode.MAX: "max",
    BlendMode.SUBTRACT: "sub",
    BlendMode.INTERSECT: "min",
}
"""The filter's `alpha_operation`; of hard shapes the matte is the same."""


CUTTING = (*TAKING, BlendMode.DIFFERENCE)
"""Modes that change what lies under a shape."""


class MltExporter:
    """Writes each closed shape as a spline of its own; a filter for each, in their order, makes the matte."""

    name = "mlt"
    title = N_("MLT rotoscoping (Kdenlive, Shotcut)")
    suffix = ".json"

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write `path` where there is one shape, else a file for each beside it, its name before `.json`."""
        clip = project.require_clip()
        writer = _Writer(clip, options, len(project.shapes), notes=below_zero("MLT", clip, options))
        root = branched(readied(project, options))
        writer.tell_joined(root)
        writer.add(root)
        told = settled([*hidden_notes(project, root), *writer.notes], writer.losses, options)
        for place, text in zip(self.files(project, path, options), writer.texts, strict=True):
            write_atomically(place, text.encode("ascii"))
        return told

    def files(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[Path, ...]:
        """The files that `export` writes: one for each closed shape. Raises `RoamError` where there is none."""
        names = [shape.name for shape in project.shapes if shape.closed]
        if not names:
            raise RoamError(
                sentence("The project holds no closed shape, and MLT's splines are closed; nothing was written.")
            )
        if len(names) == 1:
            return (path,)
        name, suffix = path.name, self.suffix
        if path.suffix.lower() == suffix:
            name, suffix = path.stem, path.suffix
        return tuple(path.with_name(f"{name}.{word}{suffix}") for word in file_words(names))


@dataclass
class _Writer(ShapeWriter):
    texts: list[str] = field(default_factory=list)
    lies_lowest: bool = True
    """Whether no filter yet shows anything."""

    def add(self, branch: Branch) -> None:
        """The shapes of a branch and of those in it, in the order of their filters."""
        for item in branch.items:
            if isinstance(item, RotoShape):
                self._add_shape(item)
                continue
            if not self.tell_joined(item) and any(takes_part(each) and each.blend in CUTTING for each in item.items):
                self.losses.append(
                    sentence(
                        "MLT has no layers of masks: what {name!r} takes away within itself goes from all under it.",
                        name=item.name,
                    )
                )
            self.add(item)

    def tell_joined(self, branch: Branch) -> bool:
        """Tell what is lost of how the joint matte of a branch is shown; false where nothing is."""
        kinds = (
            (sentence("the mode {mode!r}", mode=MODE_WORDS[branch.blend]), branch.blend is not BlendMode.ADD),
            (sentence("the opacity"), not is_always(branch.opacity, 1.0)),
            (sentence("the inversion"), branch.invert),
        )
        lost = [word for word, is_so in kinds if is_so]
        if lost:
            self.losses.append(
                sentence("MLT has no layers of masks: {name!r} loses {lost}.", name=branch.name, lost=listed(lost))
            )
        return bool(lost)

    def _add_shape(self, shape: RotoShape) -> None:
        shape = self.begun(shape)
        if not shape.closed:
            self.notes.append(sentence("MLT's splines are closed: the open {name!r} is left out.", name=shape.name))
            return
        self._tell_shape(shape)
        self.lies_lowest &= not shape.visible
        moving = without_holds(without_smooth_keys(shape))
        size = np.array(self.clip.size, dtype=np.float64)
        start = self.clip.first - self.options.frame_offset
        frames = sorted({max(frame, start) for frame in moving.frames})
        width = length_of_number(frames[-1] - start)
        lines = []
        for frame in frames:
            points = (moving.at(frame).points / size).round(9)[:, [IN, ANCHOR, OUT]].tolist()
            lines.append(f' "{frame - start:0{width}d}": {json.dumps(points, separators=(",", ":"))}')
        self.texts.append("{\n" + ",\n".join(lines) + "\n}\n")

    def _tell_shape(self, shape: RotoShape) -> None:
        name, told = f"{shape.name!r}", list[str]()
        losses = self.losses if shape.visible else list[str]()  # what is hidden has no matte to lose
        operation = OPERATIONS.get(shape.blend)
        if operation is None:
            losses.append(
                sentence("MLT has no mode {mode!r}: that of {name} is lost.", mode=MODE_WORDS[shape.blend], name=name)
            )
        elif not self.lies_lowest:
            told.append(sentence("alpha operation {operation!r}", operation=operation))
        if shape.invert:
            told.append(sentence("inversion"))
        width = max(map(abs, values_of(shape.feather)))
        if width:
            told.append(sentence("a feather of about {width}, which is a blur", width=max(round(width / 2), 1)))
        if told:
            self.notes.append(
                sentence(
                    "A spline is a path alone; give the filter of {name}: {settings}.",
                    name=name,
                    settings=listed(told),
                )
            )
        if not is_always(shape.opacity, 1.0):
            losses.append(sentence("MLT's rotoscoping has no opacity: that of {name} is lost.", name=name))
        if not shape.visible or shape.lifetime is not None:
            self.notes.append(
                sentence("A spline is always there: switch off or cut the filter of {name} where it is not.", name=name)
            )
        if has_feather_curve(shape):
            lost = self.losses if shape.visible else self.notes
            lost.append(sentence("MLT has one feather all around: the feather curve of {name} is lost.", name=name))
        if shape.is_blurred:
            self.notes.append(sentence("MLT has no motion blur: that of {name} is left out.", name=name))


def is_mlt(document: Any) -> bool:
    """True for what looks like a spline of MLT's: a list of points, or such lists by frames."""
    if isinstance(document, dict) and document and all(str(word).strip().lstrip("-").isdigit() for word in document):
        document = next(iter(document.values()))
    return (
        isinstance(document, list)
        and bool(document)
        and isinstance(document[0], list)
        and len(document[0]) == 3
        and all(isinstance(place, list) and len(place) == 2 for place in document[0])
    )
