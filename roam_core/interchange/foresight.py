"""What an export would lose, found out before it is asked for: a dry run on a project with few keys."""

from __future__ import annotations

import tempfile
from collections.abc import Hashable
from dataclasses import dataclass, replace
from pathlib import Path

from roam_core.interchange.labels.coco import CocoExporter
from roam_core.interchange.labels.cvat import CvatExporter
from roam_core.interchange.mattes.exporter import MatteExporter
from roam_core.interchange.nuke.tracks import NukeTracksExporter
from roam_core.interchange.protocol import STANDARD, Exporter, ExportOptions, KeyChoice, LossyExport
from roam_core.roto import Keyframe, Layer, LayerTransform, Project, RotoShape
from roam_core.translatable import sentence

TRACKS = sentence("Tracks hold how shapes and layers move, not their outlines.")


@dataclass(frozen=True)
class Foreseen:
    """Sentences that an export will tell: `losses` make the mattes differ there, `notes` do not."""

    losses: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def foreseen(exporter: Exporter, project: Project, options: ExportOptions = STANDARD) -> Foreseen:
    """What `exporter` would leave out of `project`; nothing stays written.

    Tried on `trimmed` shapes, so that it is quick: sentences that count keys are not among them, and what only a key in
    between would lose is told by the export itself.
    """
    if isinstance(exporter, MatteExporter):  # pictures hold whatever is rendered
        return Foreseen()
    if isinstance(exporter, NukeTracksExporter):
        return Foreseen(notes=(TRACKS,))
    if isinstance(exporter, CocoExporter | CvatExporter):
        # A server that does not answer must not hold up what waits behind this.
        exporter = replace(exporter, asks_plate=False)
    keys = KeyChoice.EVERY if options.keys is KeyChoice.REDUCED else options.keys
    tried = replace(options, keys=keys, smoothing=0.0, progress=None)
    few = trimmed(project)
    with tempfile.TemporaryDirectory(prefix="roam-") as folder:
        path = Path(folder) / f"shapes{exporter.suffix}"
        try:
            return Foreseen(notes=exporter.export(few, path, replace(tried, lossy=False)))
        except LossyExport as refusal:
            told = exporter.export(few, path, replace(tried, lossy=True))
            return Foreseen(refusal.losses, tuple(note for note in told if note not in refusal.losses))


def trimmed(project: Project) -> Project:
    """The project whose shapes have keys at their ends and the first of each kind, under layers that stand still."""
    return replace(project, root=_trimmed(project.root))


def _trimmed(layer: Layer) -> Layer:
    children = (_trimmed(child) if isinstance(child, Layer) else _with_ends(child) for child in layer.children)
    motion = layer.transform
    if motion is not None:
        motion = LayerTransform(motion.frames[:1], motion.matrices[:1])
    return replace(layer, children=tuple(children), transform=motion)


def _with_ends(shape: RotoShape) -> RotoShape:
    kept = {_kind(key): key for key in reversed(shape.keys)}
    frames = {shape.keys[0].frame, shape.keys[-1].frame, *(key.frame for key in kept.values())}
    return replace(shape, keys=tuple(key for key in shape.keys if key.frame in frames))


def _kind(key: Keyframe) -> Hashable:
    return key.interpolation, key.origin, key.feather is None
