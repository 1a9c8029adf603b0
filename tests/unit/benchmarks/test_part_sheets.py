"""The arithmetic of parts drawn by hand, and a sheet of a tiny shot."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from benchmarks import contact_sheet, part_sheets, report, shots
from benchmarks.shots import Shot
from roam_core.arrays import Bools


def box(left: int, right: int) -> Bools:
    mask = np.zeros((10, 40), dtype=bool)
    mask[:, left:right] = True
    return mask


def test_the_union_and_the_share_of_each_part_are_scored() -> None:
    overlap, inside = part_sheets.score([box(0, 10), box(5, 25)], box(30, 40), box(0, 20))
    assert overlap == pytest.approx(20 / 25)
    assert inside == pytest.approx((1.0 + 15 / 20) / 2)


def test_what_the_post_covers_does_not_count() -> None:
    overlap, inside = part_sheets.score([box(0, 10), box(5, 25)], box(20, 40), box(0, 20))
    assert (overlap, inside) == pytest.approx((1.0, 1.0))


def test_a_part_that_is_nowhere_has_no_share() -> None:
    assert part_sheets.score([box(0, 10), box(0, 0)], box(0, 0), box(0, 10)) == pytest.approx((1.0, 0.5))


def test_overlaps_are_relative_to_the_first_frame() -> None:
    overlaps = [0.8, *[0.8] * 10, *[0.4] * 10, *[0.0] * 20]
    found = part_sheets.summary(overlaps, [0.0, *[0.5] * 20, *[1.0] * 20])
    assert found == pytest.approx({"first": 0.8, "1-10": 1.0, "1-20": 0.75, "1-40": 0.375, "share": 0.75})


def test_every_part_is_an_outline_and_has_a_colour() -> None:
    for parts in part_sheets.outlines().values():
        assert len(parts) <= len(part_sheets.COLOURS)
        assert all(line.ndim == 2 and len(line) >= 3 and line.shape[1] == 2 for line in parts.values())


def test_a_sheet_of_a_shot_is_written(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, gliding: Shot) -> None:
    x, y, width, height = cv2.boundingRect(gliding.mask(gliding.first).astype(np.uint8))
    middle = x + width / 2
    drawn = {
        part: np.array([(left, y), (right, y), (right, y + height), (left, y + height)], dtype=float)
        for part, left, right in (("left", x, middle), ("right", middle, x + width))
    }
    monkeypatch.setattr(shots, "load", {gliding.name: gliding}.__getitem__)
    monkeypatch.setattr(part_sheets, "outlines", lambda: {gliding.name: drawn})
    monkeypatch.setattr(part_sheets, "SPANS", (3, 7))
    monkeypatch.setattr(part_sheets, "SHOWN", (0, 3, 7))
    monkeypatch.setattr(report, "OUT", tmp_path)
    found = part_sheets.measured((gliding.name, "best"))
    assert len(found["overlaps"]) == len(found["inside"]) == 8
    assert found["1-7"] > 0.8
    sheet = cv2.imread(str(tmp_path / "part-sheets" / "gliding.png"))
    assert sheet is not None
    assert sheet.shape == (2 * contact_sheet.WIDTH, 3 * contact_sheet.WIDTH, 3)
