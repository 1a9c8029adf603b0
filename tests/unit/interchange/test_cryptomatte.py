"""Cryptomatte: numbers of names, manifests, ranks, and mattes taken out of a file as a compositor takes them."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest

from roam_core.arrays import Float32
from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, write_mattes
from roam_core.interchange.matte_style import DataWindow, Depth, Gathering, MatteFile, MatteStyle, Parts
from roam_core.interchange.mattes.exporter import Written, planned
from roam_core.interchange.mattes.manifest import id_bits, manifests_of
from roam_core.interchange.mattes.murmur import murmur3
from roam_core.matte import render_matte, shape_matte
from roam_core.roto import BlendMode, Clip, Layer, MotionBlur, Project, RotoShape
from tests.judges.exr_header import header
from tests.unit.matte.conftest import rectangle

SIZE = (40, 48)
STYLE = MatteStyle(MatteFile.EXR, gathering=Gathering.CRYPTOMATTE)


def named(name: str, number: int, left: float, right: float, **values: Any) -> RotoShape:
    return replace(rectangle(left, 5.0, right, 35.0), id=f"shape-{number}", name=name, **values)


def root(*children: Layer | RotoShape) -> Layer:
    return Layer("root", "Root", children)


def written(shapes: Project | Layer, folder: Path, style: MatteStyle = STYLE, size: tuple[int, int] = SIZE) -> Written:
    return write_mattes(shapes, [1], folder, lambda frame: f"m.{frame}.exr", size, style=style)


class Decoded:
    """A file as the specification says that it is read: by OpenImageIO, and nothing of ours."""

    def __init__(self, path: Path) -> None:
        picture = oiio.ImageBuf(str(path))
        assert not picture.has_error, picture.geterror()
        self.spec = picture.spec()
        window = oiio.ROI(0, self.spec.full_width, 0, self.spec.full_height, 0, 1, 0, self.spec.nchannels)
        pixels = picture.get_pixels(oiio.FLOAT, window)
        self.channels = {name: pixels[..., k].copy() for k, name in enumerate(self.spec.channelnames)}
        self.told = {each.name: each.value for each in self.spec.extra_attribs if each.name.startswith("cryptomatte/")}
        self.keys = {value: name.split("/")[1] for name, value in self.told.items() if name.endswith("/name")}

    def manifest(self, cryptomatte: str) -> dict[str, str]:
        found = json.loads(self.told[f"cryptomatte/{self.keys[cryptomatte]}/manifest"])
        assert isinstance(found, dict)
        return found

    def ranks(self, cryptomatte: str) -> list[tuple[Float32, Float32]]:
        layers = [f"{cryptomatte}{layer:02d}" for layer in range(3)]
        return [
            (self.channels[f"{layer}.{pair[0]}"], self.channels[f"{layer}.{pair[1]}"])
            for layer in layers
            for pair in ("RG", "BA")
        ]

    def matte(self, cryptomatte: str, name: str) -> Float32:
        wanted = int(self.manifest(cryptomatte)[name], 16)
        total = np.zeros(self.channels["A"].shape, dtype=np.float32)
        for numbers, coverages in self.ranks(cryptomatte):
            total += np.where(numbers.view(np.uint32) == wanted, coverages, np.float32(0.0))
        return total


@pytest.mark.parametrize(
    ("content", "seed", "number"),
    [
        (b"", 0, 0),
        (b"", 1, 0x514E28B7),
        (b"test", 0, 0xBA6BD213),
        (b"Hello, world!", 0, 0xC0363E43),
        (b"The quick brown fox jumps over the lazy dog", 0x9747B28C, 0x2FA826CD),
    ],
)
def test_the_hash_is_that_of_the_published_vectors(content: bytes, seed: int, number: int) -> None:
    assert murmur3(content, seed) == number


@pytest.mark.parametrize(
    ("name", "number"),
    [
        ("hello", 6.0705627102400005616e-17),
        ("равнина", -1.3192631212399999468e-25),
        ("mädchen", 6.2361298211599995797e25),
    ],
)
def test_names_have_the_numbers_of_the_reference_decoder(name: str, number: float) -> None:
    """Those of its own tests, which name them as floating point numbers."""
    assert np.uint32(id_bits(name)).view(np.float32) == np.float32(number)


def test_names_have_the_digits_of_the_specification() -> None:
    assert (f"{id_bits('bunny'):08x}", f"{id_bits('default'):08x}") == ("13851a76", "42c9679f")


def test_no_number_is_broken() -> None:
    """`a33` hashes to a denormal number, and the empty name to 0, which stands for nothing."""
    assert murmur3(b"a33") == 0x006E11DA
    assert id_bits("a33") == 0x00EE11DA
    assert id_bits("") == 0x00800000
    for number in range(5000):
        value = np.uint32(id_bits(f"a{number}")).view(np.float32)
        assert np.isfinite(value)
        assert abs(value) >= np.finfo(np.float32).tiny


def test_a_file_holds_what_the_specification_asks_for(tmp_path: Path) -> None:
    shapes = root(named("Mädchen", 1, 5.0, 20.0), Layer("layer-1", 'Arme "links"', (named("Hand", 2, 10.0, 30.0),)))
    (path,) = written(shapes, tmp_path).made
    found = Decoded(path)
    layers = [f"{name}{layer:02d}.{c}" for name in ("roam_shape", "roam_layer") for layer in range(3) for c in "RGBA"]
    assert set(found.channels) == {*"RGBA", *layers}
    assert (str(found.spec.format), found.spec.get_string_attribute("compression")) == ("float", "zip")
    assert found.keys == {"roam_shape": "986a535", "roam_layer": "05dd645"}
    for key in found.keys.values():
        assert found.told[f"cryptomatte/{key}/hash"] == "MurmurHash3_32"
        assert found.told[f"cryptomatte/{key}/conversion"] == "uint32_to_float32"
    assert list(found.manifest("roam_shape")) == ["Mädchen", "Hand"]
    assert list(found.manifest("roam_layer")) == ["Root", 'Arme "links"']
    attributes = header(path)
    assert attributes["cryptomatte/986a535/manifest"].kind == "string"
    assert '"Mädchen":' in attributes["cryptomatte/986a535/manifest"].content.decode()
    assert all(len(name) <= 31 for name in attributes), "longer names need the format's flag for them"


def test_the_nearer_of_two_shapes_comes_out_whole_and_the_other_where_it_is_seen(tmp_path: Path) -> None:
    lower = named("lower", 1, 5.25, 25.0)
    upper = named("upper", 2, 15.5, 40.0, opacity=0.75, feather=3.0, motion_blur=MotionBlur())
    found = Decoded(written(root(lower, upper), tmp_path).made[0])
    np.testing.assert_allclose(found.matte("roam_shape", "upper"), shape_matte(upper, 1, SIZE), atol=1e-6)
    behind = shape_matte(lower, 1, SIZE) * (1.0 - shape_matte(upper, 1, SIZE))
    np.testing.assert_allclose(found.matte("roam_shape", "lower"), behind, atol=1e-6)
    joint = render_matte([lower, upper], 1, SIZE)
    np.testing.assert_array_equal(found.channels["A"], joint)
    total = sum(coverages for _, coverages in found.ranks("roam_shape"))
    np.testing.assert_allclose(total, joint, atol=1e-6)
    assert np.max(total) <= 1.0 + 1e-6


def test_ranks_fall_and_nothing_is_told_by_zeros(tmp_path: Path) -> None:
    shapes = [named(f"s{k}", k, 5.0, 40.0 - 3 * k, opacity=0.3) for k in range(6)]
    done = written(root(*shapes), tmp_path)
    assert done.notes == []
    ranks = Decoded(done.made[0]).ranks("roam_shape")
    for (_, coverages), (_, less) in pairwise(ranks):
        assert (coverages >= less).all()
    for numbers, coverages in ranks:
        np.testing.assert_array_equal(numbers.view(np.uint32) == 0, coverages == 0.0)
    assert (ranks[5][1] > 0.0).any()


def test_more_than_six_in_a_pixel_keep_those_that_cover_most_and_it_is_told(tmp_path: Path) -> None:
    shapes = [named(f"s{k}", k, 5.0, 40.0, opacity=0.3) for k in range(8)]
    done = written(root(*shapes), tmp_path)
    told = "Pixels of 1 frame(s), the first is 1, show more than 6 shapes: the Cryptomatte has those that cover most."
    assert done.notes == [told]
    found = Decoded(done.made[0])
    assert [name for name in found.manifest("roam_shape") if found.matte("roam_shape", name).any()] == [
        f"s{k}" for k in range(2, 8)
    ]
    project = Project(Clip(Path("/plates/gone"), 1, 1, (SIZE[1], SIZE[0])), root(*shapes))
    assert told in EXPORTERS["mattes"].export(project, tmp_path / "out", ExportOptions(mattes=STYLE))


def test_what_takes_away_cuts_and_is_not_named(tmp_path: Path) -> None:
    hole = named("hole", 2, 10.0, 15.0, blend=BlendMode.SUBTRACT)
    shapes = root(named("body", 1, 5.0, 20.0), hole, named("off", 3, 1.0, 3.0, visible=False))
    found = Decoded(written(shapes, tmp_path).made[0])
    assert list(found.manifest("roam_shape")) == ["body"]
    np.testing.assert_array_equal(found.matte("roam_shape", "body"), render_matte(shapes, 1, SIZE))


def test_a_layer_is_the_sum_of_its_own_shapes(tmp_path: Path) -> None:
    inner = Layer("layer-2", "Inner", (named("c", 3, 20.0, 30.0),), opacity=0.5)
    outer = Layer("layer-1", "Outer", (named("a", 1, 5.0, 15.0), named("b", 2, 10.0, 35.0), inner))
    found = Decoded(written(root(outer), tmp_path).made[0])
    shown = {name: found.matte("roam_shape", name) for name in "abc"}
    np.testing.assert_allclose(found.matte("roam_layer", "Outer"), shown["a"] + shown["b"], atol=1e-6)
    np.testing.assert_allclose(found.matte("roam_layer", "Inner"), shown["c"], atol=1e-6)
    assert set(Decoded(written(root(outer), tmp_path, replace(STYLE, parts=Parts.SHAPE)).made[0]).keys) == {
        "roam_shape"
    }
    assert set(Decoded(written(root(outer), tmp_path, replace(STYLE, parts=Parts.LAYER)).made[0]).keys) == {
        "roam_layer"
    }


def test_shapes_without_layers_have_no_cryptomatte_of_layers(tmp_path: Path) -> None:
    assert set(Decoded(written(root(named("a", 1, 5.0, 15.0)), tmp_path).made[0]).keys) == {"roam_shape"}


def test_an_inverted_layer_stands_for_what_it_holds(tmp_path: Path) -> None:
    layer = Layer("layer-1", "hand", (named("hand", 1, 5.0, 15.0),), invert=True)
    found = Decoded(written(root(layer), tmp_path).made[0])
    assert list(found.manifest("roam_shape")) == ["hand 2"]
    np.testing.assert_array_equal(found.matte("roam_shape", "hand 2"), render_matte(layer, 1, SIZE))


def names(shapes: Sequence[RotoShape]) -> list[str]:
    return list(manifests_of(root(*shapes), Parts.SHAPE)[0].words.values())


def test_equal_names_get_numbers_and_hiding_one_renames_none() -> None:
    first, second, third = (named("hand", k, 5.0, 15.0) for k in range(3))
    assert names([first, second, third]) == ["hand", "hand 2", "hand 3"]
    assert names([replace(first, visible=False), second, third]) == ["hand 2", "hand 3"]


def test_inverted_layers_keep_their_names_and_the_layers_their_channels_when_one_is_hidden() -> None:
    layers = [Layer(f"layer-{k}", "hole", (named("S", k, 5.0, 15.0),), invert=True) for k in range(2)]
    hidden = [replace(layers[0], visible=False), layers[1]]
    for children, left in ((layers, ["hole", "hole 2"]), (hidden, ["hole 2"])):
        by_shape, by_layer = manifests_of(root(*children), Parts.ALL)
        assert (list(by_shape.words.values()), list(by_layer.words.values())) == (left, left)
    names_by_layer = [manifest.name for manifest in manifests_of(root(hidden[0]), Parts.ALL)]
    assert names_by_layer == ["roam_shape", "roam_layer"]


def test_of_equal_coverages_the_lower_one_comes_first(tmp_path: Path) -> None:
    shares = [named(f"s{k}", k, 5.0, 40.0, opacity=opacity) for k, opacity in enumerate((1.0, 0.5, 0.5))]
    found = Decoded(written(root(*shares), tmp_path).made[0])
    numbers = [int(ranked[0].view(np.uint32)[20, 20]) for ranked in found.ranks("roam_shape")[:3]]
    assert [ranked[1][20, 20] for ranked in found.ranks("roam_shape")[:3]] == [0.5, 0.25, 0.25]
    assert numbers == [int(found.manifest("roam_shape")[name], 16) for name in ("s2", "s0", "s1")]


def test_a_name_that_is_no_text_is_written_all_the_same(tmp_path: Path) -> None:
    odd = named("half \ud83d of a sign, \n\t\\ and ✂", 1, 5.0, 15.0)
    found = Decoded(written(root(odd), tmp_path).made[0])
    assert list(found.manifest("roam_shape")) == ["half ? of a sign, \n\t\\ and ✂"]


def test_two_names_of_one_number_are_refused_before_anything_is_written(tmp_path: Path) -> None:
    shapes = root(named("shape 53524", 1, 5.0, 15.0), named("shape 108807", 2, 15.0, 25.0))
    told = "Cryptomatte cannot tell 'shape 53524' from 'shape 108807': it knows both by c0a73ad9. Give one"
    with pytest.raises(RoamError, match=told):
        planned(shapes, [1], tmp_path, lambda frame: f"m.{frame}.exr", STYLE)
    with pytest.raises(RoamError, match=told):
        written(shapes, tmp_path / "out")
    assert list(tmp_path.iterdir()) == []


def test_a_tight_window_holds_the_same(tmp_path: Path) -> None:
    shapes = root(named("a", 1, 5.0, 15.0), named("b", 2, 10.0, 35.0))
    whole = Decoded(written(shapes, tmp_path).made[0])
    tight = Decoded(written(shapes, tmp_path, replace(STYLE, window=DataWindow.TIGHT)).made[0])
    assert (tight.spec.x, tight.spec.y, tight.spec.width, tight.spec.height) == (5, 5, 30, 30)
    for name, pixels in whole.channels.items():
        np.testing.assert_array_equal(tight.channels[name], pixels)
    away = replace(shapes.children[0], lifetime=(7, 9))  # type: ignore[arg-type]
    empty = Decoded(written(root(away), tmp_path, replace(STYLE, window=DataWindow.TIGHT)).made[0])
    assert (empty.spec.width, empty.channels["A"].max()) == (1, 0.0)


@pytest.mark.parametrize("compression", ["zip", "zips", "piz", "rle", "none"])
def test_a_picture_of_many_rows_keeps_every_number(tmp_path: Path, compression: str) -> None:
    size = (600, 20)
    shapes = [replace(rectangle(2.0, 3.0 + 60 * k, 18.0, 90.0 + 60 * k), id=f"s-{k}", name=f"s{k}") for k in range(9)]
    style = replace(STYLE, compression=compression)
    found = Decoded(written(root(*shapes), tmp_path, style, size).made[0])
    for k, shape in enumerate(shapes):
        above = shape_matte(shapes[k + 1], 1, size) if k + 1 < len(shapes) else 0.0
        expected = shape_matte(shape, 1, size) * (np.float32(1.0) - above)
        np.testing.assert_allclose(found.matte("roam_shape", shape.name), expected, atol=1e-6)


def test_people_see_each_shape_in_a_colour_of_its_own(tmp_path: Path) -> None:
    found = Decoded(written(root(named("a", 1, 5.0, 15.0), named("b", 2, 20.0, 30.0)), tmp_path).made[0])
    colours = np.stack([found.channels[channel] for channel in "RGB"], axis=-1)
    assert not np.allclose(colours[20, 8], colours[20, 25], atol=0.05)
    assert colours[20, 45].tolist() == [0.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("asked", "sentence"),
    [
        ({"file": MatteFile.PNG}, "PNG files hold no Cryptomatte; ask for EXR"),
        ({"file": MatteFile.EXR, "depth": Depth.HALF}, "Cryptomatte is float deep, not half"),
    ],
)
def test_what_no_cryptomatte_can_be_is_refused_in_a_sentence(asked: dict[str, Any], sentence: str) -> None:
    with pytest.raises(RoamError, match=sentence):
        MatteStyle(gathering=Gathering.CRYPTOMATTE, **asked)


def test_three_hundred_shapes_are_all_told(tmp_path: Path) -> None:
    shapes = [
        replace(rectangle(k % 20, k // 20, k % 20 + 1, k // 20 + 1), id=f"s-{k}", name=f"Form {k}") for k in range(300)
    ]
    found = Decoded(written(root(*shapes), tmp_path, STYLE, (15, 20)).made[0])
    assert len(found.manifest("roam_shape")) == 300
    assert all(found.matte("roam_shape", f"Form {k}")[k // 20, k % 20] == 1.0 for k in range(300))
