"""Layers of image files: what there is to choose from, and that the colour is found by itself."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses
import pytest

from roam_core.errors import RoamError
from roam_core.media import DamagedFrame, open_clip
from roam_core.media.image_file import read_channels, read_image
from roam_core.media.layers import Part, colour_layer, layers_of
from roam_core.roto import Clip
from tests.unit.media.conftest import HEIGHT, WIDTH, write_image, write_parts

RGB, RGBA, XYZ = ("R", "G", "B"), ("R", "G", "B", "A"), ("X", "Y", "Z")


def of(layer: str, channels: tuple[str, ...]) -> tuple[str, ...]:
    """The channels' names in a layer."""
    return tuple(f"{layer}.{channel}" for channel in channels)


@pytest.mark.parametrize(
    ("parts", "names", "colour"),
    [
        ([Part("", "", RGBA)], ["rgb", "alpha"], "rgb"),
        ([Part("Layer 0", "", RGB)], ["rgb"], "rgb"),
        ([Part("", "", ("Y",))], ["rgb"], "rgb"),
        ([Part("", "", ("A",))], ["alpha"], "alpha"),
        ([Part("", "", ("A", "B", "G", "R", "Z"))], ["rgb", "alpha", "Z"], "rgb"),
        ([Part("", "", (*of("N", XYZ), *of("beauty", RGB)))], ["N", "beauty"], "beauty"),
        ([Part("", "", (*of("CryptoObject00", RGBA), *of("diffuse", RGB)))], ["CryptoObject00", "diffuse"], "diffuse"),
        ([Part("", "", (*of("diffuse", RGB), *RGB))], ["diffuse", "rgb"], "rgb"),
        ([Part("", "", (*of("View.Depth", ("Z",)), *of("View.Combined", RGBA)))], ["View.Depth", "View.Combined"],
            "View.Combined"),
        ([Part("depth", "", ("Z",)), Part("beauty", "", RGBA)], ["depth.Z", "beauty", "beauty.alpha"], "beauty"),
        ([Part("normals", "", RGB), Part("rgba", "", RGBA)], ["normals", "rgba", "rgba.alpha"], "rgba"),
        ([Part("diffuse", "", of("diffuse", RGB)), Part("beauty", "", RGB)], ["diffuse", "beauty"], "beauty"),
        ([Part("left", "left", RGB), Part("right", "right", RGB)], ["left", "right"], "left"),
        ([Part("", "left", RGB), Part("", "right", RGB)], ["rgb", "right.rgb"], "rgb"),
        ([Part("a", "left", RGB), Part("a", "right", RGB)], ["a", "right.a"], "a"),
        ([Part("", "", RGB), Part("", "", RGB)], ["rgb", "rgb (part 2)"], "rgb"),
        ([Part("deep", "", ()), Part("flat", "", RGB)], ["flat"], "flat"),
        ([Part("", "", of("motion", ("u", "v")))], ["motion"], "motion"),
    ],
)  # fmt: skip
def test_layers_and_the_one_that_is_colour(parts: list[Part], names: list[str], colour: str) -> None:
    layers = layers_of(parts)
    assert [layer.name for layer in layers] == names
    assert colour_layer(layers).name == colour


def test_no_channel_is_out_of_its_part() -> None:
    rng = np.random.default_rng(3)
    words = ["R", "G", "B", "A", "Y", "Z", "x.R", "x.G", "x.B", "x.Y", "N.X", "N.Y", "N.Z", "", ".", "a.b.R", "ry", "R"]
    for _ in range(500):
        parts = [
            Part(str(rng.choice(["", "one", "x"])), str(rng.choice(["", "left"])), tuple(rng.choice(words, count)))
            for count in rng.integers(1, 7, rng.integers(1, 4))
        ]
        layers = layers_of(parts)
        assert len({layer.name for layer in layers}) == len(layers) > 0
        assert colour_layer(layers) in layers
        for layer in layers:
            assert all(0 <= channel < len(parts[layer.part].channels) for channel in layer.channels)


SHOT = [("depth", "", ("Z",)), ("beauty", "", RGBA), ("diffuse", "", of("diffuse", RGB))]


def test_a_file_whose_first_part_is_depth_shows_its_colour(tmp_path: Path) -> None:
    plate = open_clip(write_parts(tmp_path / "p.1001.exr", SHOT))
    assert (plate.layer, plate.layers) == ("beauty", ("depth.Z", "beauty", "beauty.alpha", "diffuse"))
    assert np.all(plate.read(1001) == (1.0, 1.125, 1.25))
    assert Clip.of(plate).layer == "beauty"


@pytest.mark.parametrize(
    ("layer", "values"),
    [("depth.Z", (0.0, 0.0, 0.0)), ("beauty.alpha", (1.375, 1.375, 1.375)), ("diffuse", (2.0, 2.125, 2.25))],
)
def test_a_layer_is_read_that_was_asked_for(tmp_path: Path, layer: str, values: tuple[float, float, float]) -> None:
    plate = open_clip(write_parts(tmp_path / "p.1001.exr", SHOT), layer)
    assert plate.layer == layer
    assert np.all(plate.read(1001) == values)
    assert plate.read(1001).shape == (HEIGHT, WIDTH, 3)


def test_a_layer_of_another_view(tmp_path: Path) -> None:
    path = write_parts(tmp_path / "p.exr", [("l", "left", RGB), ("r", "right", RGB)])
    assert open_clip(path).layers == ("l", "right.r")
    assert read_image(path, "right.r")[0, 0, 0] == 1.0
    one_part = write_parts(tmp_path / "q.exr", [("", "", (*RGB, *of("right", RGB)))])
    assert open_clip(one_part).layers == ("rgb", "right")


def test_every_frame_shows_the_layer_of_one_name_wherever_it_lies(tmp_path: Path) -> None:
    write_parts(tmp_path / "p.1.exr", SHOT)
    write_parts(tmp_path / "p.2.exr", [SHOT[2], SHOT[0], SHOT[1]])
    write_parts(tmp_path / "p.3.exr", [SHOT[0], SHOT[2]])
    plate = open_clip(tmp_path)
    assert [plate.read(frame)[0, 0, 0] for frame in (1, 2)] == [1.0, 2.0]
    with pytest.raises(DamagedFrame, match=r"p\.3\.exr has no layer 'beauty'; it has depth.Z, diffuse\."):
        plate.read(3)


def test_a_data_window_counts_in_every_part(tmp_path: Path) -> None:
    window = {"x": 2, "full_x": 0, "full_y": 0, "full_width": WIDTH, "full_height": HEIGHT}
    image = open_clip(write_parts(tmp_path / "p.1.exr", SHOT, **window)).read(1)
    assert image.shape == (HEIGHT, WIDTH, 3)
    assert np.all(image[:, :2] == 0.0)
    assert np.all(image[:, 2:] == (1.0, 1.125, 1.25))


@pytest.mark.parametrize(
    ("parts", "values"),
    [
        ([("", "", (*RGBA, "Z"))], (0.0, 0.125, 0.25, 0.375)),
        ([("", "", ("Y", "Z"))], (0.0,)),
        ([("", "", ("A", "Z"))], (0.0,)),
        ([("", "", ("A", "Left.A"))], (0.125, 0.0)),
        ([("", "", (*of("diffuse", RGBA), *of("N", ("X", "Y", "Z"))))], (0.0, 0.125, 0.25, 0.375)),
        (SHOT, (1.0, 1.125, 1.25, 1.375)),
        ([SHOT[1], SHOT[0]], (0.0, 0.125, 0.25, 0.375)),
    ],
)
def test_a_mask_is_told_by_the_picture_and_its_alpha_alone(
    tmp_path: Path, parts: list[tuple[str, str, tuple[str, ...]]], values: tuple[float, ...]
) -> None:
    """What lies beside them is no part of a mask; depth was the brightest channel of one, or taken for its alpha."""
    path = write_parts(tmp_path / "m.exr", parts)
    channels = read_channels(path)
    assert channels is not None
    np.testing.assert_array_equal(channels[1, 1], values)


def test_a_layer_that_is_not_there_is_told_with_those_that_are(tmp_path: Path) -> None:
    path = write_parts(tmp_path / "p.1.exr", SHOT)
    with pytest.raises(RoamError, match=r"has no layer 'spec'; it has depth\.Z, beauty, beauty\.alpha, diffuse\."):
        open_clip(path, "spec")


def test_a_file_of_plain_colour_has_no_layer_to_keep(tmp_path: Path) -> None:
    path = write_image(tmp_path / "p.1.png", np.zeros((HEIGHT, WIDTH, 4), np.uint8), "uint8")
    plate = open_clip(path)
    assert (plate.layer, plate.layers, Clip.of(plate).layer) == ("rgb", ("rgb", "alpha"), "")
    assert open_clip(path, "alpha").read(1).shape == (HEIGHT, WIDTH, 3)


def test_names_of_older_programs_are_letters(tmp_path: Path) -> None:
    path = write_parts(tmp_path / "p.1.exr", SHOT)
    path.write_bytes(path.read_bytes().replace(b"beauty", b"beaut\xe9"))
    plate = open_clip(path)
    assert (plate.layer, plate.layers[1]) == ("beauté", "beauté")
    assert open_clip(path, "diffuse").read(1)[0, 0, 0] == 2.0


def test_deep_pixels_alone_are_told(tmp_path: Path) -> None:
    spec = oiio.ImageSpec(4, 4, 5, "float")
    spec.channelnames = (*RGBA, "Z")
    spec.deep = True
    path = tmp_path / "p.1.exr"
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), spec), output.geterror()
    samples = oiio.DeepData()
    samples.init(16, 5, [oiio.TypeDesc("float")] * 5, spec.channelnames)
    assert output.write_deep_image(samples), output.geterror()
    output.close()
    with pytest.raises(RoamError, match="holds deep pixels and no picture; flatten it"):
        open_clip(path)
