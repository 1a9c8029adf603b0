"""The table of formats in docs/FORMATS.md: no cell below what is asked, and today's writers give its figures."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from tests.judges.__main__ import PAGE
from tests.judges.programs import JUDGES
from tests.judges.scenes import NAMES, SCENES
from tests.judges.table import Judge, judged, names_kept

IN_WORDS = {("blender", "holds, between frames")}
"""Cells that the page explains below the table: Blender's masks have keys on whole frames only."""


def published() -> dict[tuple[str, str], str]:
    """The cells of the page by format and scene."""
    found = re.search(r"<!-- judges -->\n(.*?)\n<!-- end of judges -->", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert found is not None
    head, _, *lines = ([cell.strip() for cell in line.strip("|").split("|")] for line in found.group(1).split("\n"))
    return {(name, line[0]): cell for line in lines for name, cell in zip(head[1:], line[1:], strict=True)}


def test_every_published_cell_holds_what_is_asked_or_is_refused() -> None:
    cells = published()
    assert {name for name, _ in cells} == {judge.exporter for judge in JUDGES}
    assert set(SCENES) <= {scene for _, scene in cells}
    for judge in JUDGES:
        for scene in SCENES:
            cell = cells[judge.exporter, scene]
            if (judge.exporter, scene) not in IN_WORDS and not cell.startswith("refused"):
                assert float(cell) >= judge.least, (judge.exporter, scene)


@pytest.mark.parametrize("name", ["modes", "layers"])
@pytest.mark.parametrize("judge", JUDGES, ids=lambda judge: judge.exporter)
def test_the_writers_give_the_figures_of_the_page(judge: Judge, name: str, tmp_path: Path) -> None:
    if judge.missing:
        pytest.skip(judge.missing)
    scene = SCENES[name]
    cell = judged(judge, replace(scene, moments=scene.moments[1:2]), tmp_path)
    assert cell.overlap >= judge.least or published()[judge.exporter, name].startswith("refused")


@pytest.mark.parametrize("judge", [judge for judge in JUDGES if judge.names], ids=lambda judge: judge.exporter)
def test_no_two_names_become_one(judge: Judge, tmp_path: Path) -> None:
    if judge.missing:
        pytest.skip(judge.missing)
    kept, apart = names_kept(judge, tmp_path)
    assert apart == len(NAMES)
    assert kept >= sum(name.isascii() for name in NAMES) - 2, "an empty name, and brackets that Tcl would run"
