"""All export formats by name. A new one is a file of this package and a line here."""

from __future__ import annotations

from collections.abc import Iterable

from roam_core.errors import RoamError
from roam_core.interchange.mattes import MatteExporter
from roam_core.interchange.nuke import NukeExporter
from roam_core.interchange.protocol import Exporter
from roam_core.interchange.silhouette import SilhouetteExporter


class Exporters(dict[str, Exporter]):
    """Formats by name; asking for one that is not there is answered with those that are."""

    def __init__(self, exporters: Iterable[Exporter]) -> None:
        super().__init__((exporter.name, exporter) for exporter in exporters)

    def __missing__(self, name: str) -> Exporter:
        raise RoamError(f"There is no export format {name!r}; there are: {', '.join(sorted(self))}.")


def exporter_for(name: str) -> Exporter:
    """The format of that name, or a `RoamError` that lists those that are there."""
    return EXPORTERS[name]


EXPORTERS = Exporters([NukeExporter(), SilhouetteExporter(), MatteExporter()])
