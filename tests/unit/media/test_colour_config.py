"""Plates in the spaces of an OpenColorIO configuration: found, converted as OpenColorIO does, seen through views."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses
import PyOpenColorIO as ocio  # noqa: N813 - the name its own manual uses
import pytest

from roam_core.arrays import Float32
from roam_core.errors import RoamError
from roam_core.media import declared, open_clip
from roam_core.media.colour import to_display, to_engine
from roam_core.media.colour_config import BUILT_IN, View, displayed, to_linear, views
from roam_core.media.colour_spaces import known_space, offered_spaces
from roam_core.media.curves import COLOUR_SPACES, LINEAR, LOG, SRGB, linear_from_log, linear_from_srgb
from tests.unit.media.conftest import picture, write_image

REC709 = "Linear Rec.709 (sRGB)"
CAMERAS = ["ACEScg", "ACES2065-1", "ARRI LogC4", "S-Log3 S-Gamut3.Cine", "ADX10", "Linear Rec.2020"]
ACES = View("sRGB - Display", "ACES 2.0 - SDR 100 nits (Rec.709)")
ACES_P3 = View("Display P3 - Display", "ACES 2.0 - SDR 100 nits (P3 D65)")
PLAIN = View("sRGB - Display", "Un-tone-mapped")


@pytest.fixture(autouse=True)
def _no_studio(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("OCIO", raising=False)


def config() -> ocio.Config:
    return ocio.Config.CreateFromBuiltinConfig(BUILT_IN)


def by_ocio(values: Float32, space: str, wanted: str | View) -> Float32:
    """The values as OpenColorIO alone converts them to a space or a view."""
    if isinstance(wanted, View):
        transform = ocio.DisplayViewTransform(space, wanted.display, wanted.view)
    else:
        transform = ocio.ColorSpaceTransform(space, wanted)
    converted = np.ascontiguousarray(values, dtype=np.float32).copy()
    config().getProcessor(transform).getDefaultCPUProcessor().applyRGB(converted)
    return converted


def scene(stops: float = 14.0) -> Float32:
    """Colours as a camera sees them: of every brightness, none wholly saturated."""
    rng = np.random.default_rng(2)
    light = np.exp2(rng.random((60, 70, 1)) * stops - 9.0)
    return np.asarray(light * (1.0 + 0.35 * (2.0 * rng.random((60, 70, 3)) - 1.0)), dtype=np.float32)


# ---- the working picture ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("space", CAMERAS)
@pytest.mark.parametrize("kind", [np.uint8, np.float32])
def test_the_working_picture_is_what_ocio_makes_of_the_plate(space: str, kind: type) -> None:
    values = picture(1) if kind is np.float32 else (picture(1) * 255).astype(np.uint8)
    light = np.clip(by_ocio(values / 255.0 if kind is np.uint8 else values, space, REC709), 0.0, 1.0)
    expected = by_ocio(light, REC709, "sRGB Encoded Rec.709 (sRGB)")
    working = to_engine(values, space)
    assert working.dtype == np.float32
    np.testing.assert_allclose(working, expected, atol=2e-4)
    np.testing.assert_allclose(to_display(values, space), expected * 255.0, atol=0.6)


@pytest.mark.parametrize("space", ["ACEScg", "ARRI LogC4"])
def test_strips_are_converted_as_the_whole_is(space: str) -> None:
    tall = np.random.default_rng(5).random((101, 7, 3), dtype=np.float32)
    rows = [to_engine(tall[row : row + 1], space) for row in range(len(tall))]
    np.testing.assert_array_equal(to_engine(tall, space), np.concatenate(rows))


def test_what_no_colour_is_is_black() -> None:
    values = np.array([[[np.nan, np.nan, np.nan], [-1.0, -1.0, -1.0], [9.0, 9.0, 9.0]]], np.float32)
    np.testing.assert_array_equal(to_engine(values, "ACEScg")[0], [[0.0] * 3, [0.0] * 3, [1.0] * 3])


@pytest.mark.parametrize("space", COLOUR_SPACES)
def test_our_own_spaces_are_the_same_light_by_ocio(space: str) -> None:
    values = picture(6)
    light = {SRGB: linear_from_srgb, LINEAR: lambda given: given, LOG: linear_from_log}[space](values.astype(float))
    to_linear(values, space)
    np.testing.assert_allclose(values, light, atol=5e-5)


def test_8_bit_srgb_plates_stay_as_they_are_and_ask_for_no_configuration(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OCIO", "/nowhere/config.ocio")
    values = (picture(1) * 255).astype(np.uint8)
    assert to_engine(values, SRGB) is values
    assert to_display(values, SRGB) is values


def test_a_space_that_is_not_known_is_told() -> None:
    with pytest.raises(RoamError, match="'Kodachrome' is not known to the OpenColorIO configuration studio-config"):
        to_engine(picture(1), "Kodachrome")
    with pytest.raises(RoamError, match=r"'Kodachrome' is not known; choose one of sRGB, linear, log, or .*ACEScg"):
        known_space("Kodachrome")


@pytest.mark.parametrize(
    ("name", "space"),
    [("acescg", "ACEScg"), ("lin_ap0", "ACES2065-1"), ("lin_rec709_scene", "linear"), ("sRGB - Texture", "sRGB"),
     ("log", "log"), ("arri_logc4", "ARRI LogC4"), ("srgb", "sRGB"), ("LINEAR", "linear"), ("Log", "log")],
)  # fmt: skip
def test_spaces_are_known_by_their_aliases(name: str, space: str) -> None:
    assert known_space(name) == space


def test_what_is_offered_is_known_and_no_data() -> None:
    offered = offered_spaces()
    assert offered[:3] == COLOUR_SPACES
    assert {"ACEScg", "ARRI LogC4", "Camera Rec.709"} <= set(offered)
    assert "Raw" not in offered
    for space in offered:
        to_engine(picture(1), space)


# ---- which space a plate has -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("chromaticities", "space"),
    [
        ((0.713, 0.293, 0.165, 0.83, 0.128, 0.044, 0.32168, 0.33767), "ACEScg"),
        ((0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.077, 0.32168, 0.33767), "ACES2065-1"),
        ((0.708, 0.292, 0.17, 0.797, 0.131, 0.046, 0.3127, 0.329), "Linear Rec.2020"),
        ((0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329), "linear"),
        ((0.5, 0.3, 0.3, 0.5, 0.2, 0.1, 0.3127, 0.329), "linear"),
    ],
)
def test_primaries_tell_the_space_of_an_exr(tmp_path: Path, chromaticities: tuple[float, ...], space: str) -> None:
    spec = oiio.ImageSpec(4, 4, 3, "half")
    spec.attribute("chromaticities", oiio.TypeDesc("float[8]"), chromaticities)
    output = oiio.ImageOutput.create(str(tmp_path / "p.exr"))
    assert output.open(str(tmp_path / "p.exr"), spec)
    output.write_image(np.zeros((4, 4, 3), np.float32))
    output.close()
    assert open_clip(tmp_path / "p.exr").colour_space == space


def test_primaries_of_another_type_say_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A damaged header made an array of them, which is neither true nor false."""
    path = write_image(tmp_path / "p.exr", picture(1), "half")
    asked = oiio.ImageSpec.getattribute
    monkeypatch.setattr(
        oiio.ImageSpec,
        "getattribute",
        lambda spec, name, *more: np.zeros(32) if name == "chromaticities" else asked(spec, name, *more),
    )
    assert open_clip(path).colour_space == "linear"


@pytest.mark.parametrize(("said", "space"), [("lin_ap1_scene", "ACEScg"), ("lin_rec709_scene", "linear")])
def test_metadata_tells_the_space_of_an_exr(tmp_path: Path, said: str, space: str) -> None:
    assert open_clip(write_image(tmp_path / "p.exr", picture(1), "half", oiio__ColorSpace=said)).colour_space == space


def test_a_studios_file_rules_go_before_what_files_say(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    studio = config()
    rules = studio.getFileRules()
    rules.insertRule(0, "scans", "ADX10", "*scan*", "*")
    rules.insertRule(1, "textures", "sRGB - Texture", "*tex*", "*")
    studio.setFileRules(rules)
    (tmp_path / "studio.ocio").write_text(studio.serialize())
    scan = write_image(tmp_path / "scan.0001.dpx", picture(1), "uint16")
    texture = write_image(tmp_path / "tex.0001.png", picture(1), "uint16")
    other = write_image(tmp_path / "plate.0001.dpx", picture(1), "uint16")
    assert [open_clip(file).colour_space for file in (scan, texture, other)] == ["log", "sRGB", "log"]
    monkeypatch.setenv("OCIO", str(tmp_path / "studio.ocio"))
    assert [open_clip(file).colour_space for file in (scan, texture, other)] == ["ADX10", "sRGB", "log"]
    np.testing.assert_allclose(to_engine(picture(1), "ACEScg"), working_of(picture(1)), atol=2e-4)


def working_of(values: Float32) -> Float32:
    return by_ocio(np.clip(by_ocio(values, "ACEScg", REC709), 0.0, 1.0), REC709, "sRGB Encoded Rec.709 (sRGB)")


def test_a_configuration_that_cannot_be_read_is_told_where_it_is_needed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "broken.ocio").write_text("ocio_profile_version: 2\nroles: [")
    plate = write_image(tmp_path / "p.exr", picture(1), "half")
    for name in ("broken.ocio", "absent.ocio"):
        monkeypatch.setenv("OCIO", str(tmp_path / name))
        assert open_clip(plate).colour_space == "linear"
        assert offered_spaces() == COLOUR_SPACES
        with pytest.raises(RoamError, match=rf"configuration .*{name} cannot be read: .* Correct \$OCIO, or unset it"):
            to_engine(picture(1), "ACEScg")


def test_a_declared_space_is_the_plates(tmp_path: Path) -> None:
    plate = open_clip(write_image(tmp_path / "p.exr", picture(1), "half"))
    said = declared(plate, "ACEScg", plate.fps, plate.pixel_aspect)
    assert said.colour_space == "ACEScg"
    np.testing.assert_array_equal(said.read(1), plate.read(1))


# ---- views -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("view", [ACES, ACES_P3, PLAIN])
@pytest.mark.parametrize("exposure", [0.0, -3.0, 1.5])
def test_a_view_shows_what_ocio_shows(view: View, exposure: float) -> None:
    expected = by_ocio(scene() * np.float32(2.0**exposure), "ACEScg", view)
    shown = displayed(scene(), "ACEScg", view, exposure)
    assert shown.dtype == np.uint8
    wrong = np.abs(shown - np.clip(expected, 0.0, 1.0) * 255.0)
    assert wrong.max() <= (0.6 if view is PLAIN else 3.0)
    assert wrong.mean() < 0.5


def test_every_view_can_be_shown() -> None:
    assert ACES in views()
    for view in {view.view: view for view in views()}.values():
        assert displayed(scene()[:4], "ARRI LogC4", view, 0.0).shape == (4, 70, 3)


def test_the_same_scene_looks_the_same_from_every_space() -> None:
    """A picture as linear EXR and as Cineon log: within what ten bits of log can hold."""
    light = scene(9.0).clip(0.0, 1.0)
    codes = (np.log10(light * (1 - 10 ** (-590 / 300)) + 10 ** (-590 / 300)) * 300 + 685) / 1023
    log = (np.round(codes * 1023) / 1023).astype(np.float32)
    for view in (ACES, PLAIN):
        seen = [displayed(*plate, view, 0.0).astype(int) for plate in ((light, LINEAR), (log, LOG))]
        assert np.abs(seen[0] - seen[1]).max() <= 4
    assert os.environ.get("OCIO") is None


def test_a_view_that_is_not_there_is_told() -> None:
    with pytest.raises(RoamError, match="cannot show the view Sepia on sRGB - Display"):
        displayed(scene(), LINEAR, View("sRGB - Display", "Sepia"), 0.0)
