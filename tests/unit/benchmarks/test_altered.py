"""The benchmark of altered shots: where the copy lies, what the camera sees, and that it runs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from benchmarks import altered, shots
from benchmarks.altered import ALTERATIONS, Run, measured, with_copy
from benchmarks.shots import Shot


@pytest.mark.parametrize("dtype", [np.uint8, np.float32])
def test_a_copy_lies_behind_its_object(dtype: type) -> None:
    mask = np.zeros((60, 120), dtype=bool)
    mask[20:40, 30:60] = True
    picture = np.where(mask[..., None], 200, 40).repeat(3, axis=2).astype(dtype)
    picture[20:40, 30:60, 0] = 10 + np.arange(30)
    mixed = with_copy(picture, mask, 20)
    assert mixed.dtype == dtype
    np.testing.assert_array_equal(mixed[mask], picture[mask])
    np.testing.assert_allclose(mixed[24:36, 64:76], picture[24:36, 44:56], atol=1)
    np.testing.assert_allclose(mixed[:, 90:], picture[:, 90:], atol=1)
    np.testing.assert_allclose(with_copy(picture, mask, -40)[24:36, 4:16], picture[24:36, 44:56], atol=1)


@pytest.mark.parametrize(("left", "side"), [(10, 1), (80, -1)])
def test_a_copy_lies_where_there_is_more_room(left: int, side: int) -> None:
    mask = np.zeros((60, 120), dtype=bool)
    mask[20:40, left : left + 30] = True
    assert altered._offset(mask, 1.5) == side * 45


@pytest.mark.parametrize("alteration", ALTERATIONS)
def test_every_alteration_keeps_the_number_and_the_size_of_frames(alteration: str, gliding: Shot) -> None:
    pictures, masks = ALTERATIONS[alteration](gliding.pictures, gliding.masks)
    assert len(pictures) == len(masks) == len(gliding.pictures)
    for picture, mask, true in zip(pictures, masks, gliding.masks, strict=True):
        assert picture.shape == (*true.shape, 3)
        assert mask.shape == true.shape
        assert mask.dtype == np.bool_


def test_a_camera_that_pulls_out_ends_on_the_shot_and_one_that_pushes_in_begins_on_it(gliding: Shot) -> None:
    (out, out_masks), (into, into_masks) = (
        ALTERATIONS[each](gliding.pictures, gliding.masks) for each in ("pulled out", "pushed in")
    )
    np.testing.assert_array_equal(out[-1], gliding.pictures[-1])
    np.testing.assert_array_equal(into[0], gliding.pictures[0])
    for masks, near in ((out_masks, 0), (into_masks, -1)):
        assert masks[near].sum() == pytest.approx(altered.ZOOM**2 * gliding.masks[near].sum(), rel=0.05)


@pytest.mark.parametrize("dtype", [np.uint8, np.float32])
def test_a_trunk_passes_before_the_object_and_hides_it(dtype: type, gliding: Shot) -> None:
    pictures = [picture.astype(dtype) for picture in gliding.pictures]
    altered_pictures, masks = ALTERATIONS["behind a trunk"](pictures, gliding.masks)
    np.testing.assert_array_equal(masks[0], gliding.masks[0])
    np.testing.assert_array_equal(masks[-1], gliding.masks[-1])
    middle = len(masks) // 2
    assert masks[middle].sum() < 0.5 * gliding.masks[middle].sum()
    for ours, picture, mask, true in zip(altered_pictures, pictures, masks, gliding.masks, strict=True):
        assert ours.dtype == dtype
        np.testing.assert_array_equal(ours[mask], picture[mask])
        hidden = true & ~mask
        assert np.count_nonzero((ours != picture).any(axis=-1) & hidden) >= 0.9 * np.count_nonzero(hidden)


@pytest.mark.parametrize("alteration", ALTERATIONS)
def test_an_altered_shot_is_scored(alteration: str, monkeypatch: pytest.MonkeyPatch, gliding: Shot) -> None:
    monkeypatch.setattr(shots, "load", {gliding.name: gliding}.__getitem__)
    monkeypatch.setattr(altered, "LENGTH", 3)
    found = measured((Run(gliding.name, 0, alteration), "best"))
    assert found is not None
    assert 0.4 < found <= 1.0


def test_a_key_that_shows_nothing_of_the_object_is_no_run(monkeypatch: pytest.MonkeyPatch, gliding: Shot) -> None:
    nothing = replace(gliding, masks=[np.zeros_like(mask) for mask in gliding.masks])
    monkeypatch.setattr(shots, "load", {gliding.name: nothing}.__getitem__)
    monkeypatch.setattr(altered, "LENGTH", 3)
    assert measured((Run(gliding.name, 0, "as it is"), "best")) is None
