"""The formats by name."""

from __future__ import annotations

import pytest

from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, exporter_for


def test_every_format_is_known_by_its_own_name() -> None:
    assert {"nuke", "silhouette", "mattes"} <= set(EXPORTERS)
    assert all(exporter.name == name for name, exporter in EXPORTERS.items())
    assert all(exporter.suffix.startswith(".") and exporter.title for exporter in EXPORTERS.values())


def test_an_unknown_format_is_answered_with_the_known_ones() -> None:
    with pytest.raises(RoamError, match=r"no export format 'flame'; there are: .*mattes.*nuke.*silhouette"):
        exporter_for("flame")
    assert "flame" not in EXPORTERS
