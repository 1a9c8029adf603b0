"""The `.fxs` reader: keys, units, layers and their transforms, B-splines, and what it refuses."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
import pytest
from defusedxml import ElementTree
from scipy.interpolate import BSpline

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.interchange import Imported, ImportOptions, read_shapes
from roam_core.interchange.reading import MAX_DEPTH
from roam_core.interchange.silhouette.values import LayerTransform, Track, track
from roam_core.roto import Animated, BlendMode, Clip, Interpolation, Layer, Origin, RotoShape, Spline, ValueKey

CLIP = Clip(Path("plate"), 1001, 1040, (200, 100))
HEAD = '<Silhouette width="200" height="100" pixelAspect="1" sessionStartFrame="1001">'
POINTS = (
    "<Point>(0,0),(0,0),(0,0)</Point><Point>(0.5,0),(0.4,-0.1),(0.6,0.1)</Point>"
    "<Point>(0.5,0.25),(0.5,0.25),(0.5,0.25)</Point>"
)
"""(100, 50), (150, 50) with handles, (150, 75)."""

Read = Callable[..., Imported]


@pytest.fixture
def read(tmp_path: Path) -> Read:
    """`read(xml)` reads what stands inside the session's element."""

    def run(body: str, options: ImportOptions | None = None, *, head: str = HEAD, clip: Clip = CLIP) -> Imported:
        path = tmp_path / "a.fxs"
        path.write_text(f"<!-- Silhouette Shape File -->\n{head}{body}</Silhouette>", encoding="utf-8")
        return read_shapes(path, clip, options) if options else read_shapes(path, clip)

    return run


def path_key(
    frame: float, points: str = POINTS, *, interp: str = "linear", closed: str = "True", kind: str = "Bezier"
) -> str:
    return f'<Key frame="{frame}" interp="{interp}"><Path closed="{closed}" type="{kind}">{points}</Path></Key>'


def shape_xml(*keys: str, label: str = "A", properties: str = "", attributes: str = "") -> str:
    path = f'<Property id="path">{"".join(keys or (path_key(0),))}</Property>'
    return (
        f'<Shape type="Shape" label="{label}" shape_type="Bezier" {attributes}>'
        f"<Properties>{properties}{path}</Properties></Shape>"
    )


CONTROLS = np.array([[0, 0], [0.4, -0.2], [0.6, 0.3], [0.1, 0.4], [-0.3, 0.1]])


def spline_key(frame: int, controls: np.ndarray, *, closed: bool = True) -> str:
    points = "".join(f"<Point>({x},{y})</Point>" for x, y in controls)
    return path_key(frame, points, closed=str(closed), kind="Bspline")


def layer_xml(body: str, properties: str = "", attributes: str = "", label: str = "L") -> str:
    objects = f'<Property id="objects" constant="True">{body}</Property>'
    return f'<Layer type="Layer" label="{label}" {attributes}><Properties>{properties}{objects}</Properties></Layer>'


def constant(name: str, value: str) -> str:
    return f'<Property id="{name}" constant="True"><Value>{value}</Value></Property>'


def keyed(name: str, *keys: tuple[int, str], interp: str = "linear") -> str:
    entries = "".join(f'<Key frame="{frame}" interp="{interp}">{value}</Key>' for frame, value in keys)
    return f'<Property id="{name}">{entries}</Property>'


def only(imported: Imported) -> RotoShape:
    (shape,) = imported.layer.shapes()
    return shape


ANCHORS = np.array([[0.0, 0.0], [0.5, 0.0], [0.5, 0.25]])
"""Of the points."""
LINEARLY = np.array(["linear"])


def parsed_property(text: str) -> Element:
    element: Element = ElementTree.fromstring(text)
    return element


def bezier_anchors(controls: Array) -> Array:
    """Where a closed uniform cubic B-spline of these control points has its knots."""
    return np.asarray((np.roll(controls, 1, axis=0) + 4.0 * controls + np.roll(controls, -1, axis=0)) / 6.0)


def shifted(x: float) -> str:
    """The points, `x` image heights to the right."""
    return POINTS.replace("(0,0),(0,0),(0,0)", ",".join([f"({x},0)"] * 3))


# ---- paths -----------------------------------------------------------------------------------------------------------


def test_points_and_handles_in_pixels(read: Read) -> None:
    imported = read(shape_xml())
    shape = only(imported)
    assert imported.notes == ()
    assert (shape.name, shape.closed, shape.frames) == ("A", True, (1001,))
    np.testing.assert_allclose(shape.at(1001).anchors, [[100, 50], [150, 50], [150, 75]])
    np.testing.assert_allclose(shape.keys[0].points[1], [[150, 50], [140, 40], [160, 60]])


def test_keys_are_numbered_from_the_session_and_may_hold(read: Read) -> None:
    body = shape_xml(path_key(10, shifted(0.5)), path_key(0, interp="hold"), path_key(30, shifted(1.0), closed="False"))
    shape = only(read(body, ImportOptions(frame_offset=1)))
    assert shape.frames == (1000, 1010, 1030)
    assert [key.interpolation for key in shape.keys[:2]] == [Interpolation.HOLD, Interpolation.LINEAR]
    np.testing.assert_allclose(shape.at(1020).anchors[0], [175, 50])


def test_keys_between_frames_move_to_those_around_them(read: Read) -> None:
    """As after a change of speed: two of them may round to one frame, and no shape is lost over that."""
    keys = [path_key(at, shifted(at / 10.0)) for at in (0, 1.2, 1.4, 2.5, 4.0000001)]
    shape = only(imported := read(shape_xml(*keys)))
    assert imported.notes == ()
    assert shape.frames == (1001, 1002, 1003, 1004, 1005)
    np.testing.assert_allclose([shape.at(frame).anchors[0][0] for frame in shape.frames], [100, 110, 120, 130, 140])


def test_keys_of_an_opacity_may_stand_in_any_order(read: Read) -> None:
    imported = read(shape_xml(properties=keyed("opacity", (5, "50"), (0, "100"))))
    assert only(imported).opacity == Animated((ValueKey(1001, 1.0), ValueKey(1006, 0.5)))
    assert imported.notes == ()
    twice = read(shape_xml(properties=keyed("opacity", (5, "50"), (5, "100"))))
    assert twice.notes == ("The opacity of the shape 'A' was left out: it has two keys on one frame.",)


def test_what_holds_stays_until_the_next_key_and_changes_there() -> None:
    track = Track(np.array([0.0, 10.0, 20.0]), np.array([[1.0], [3.0], [5.0]]), np.array(["hold", "linear", "hold"]))
    np.testing.assert_allclose(track.at(np.array([-5.0, 0.0, 9.5, 10.0, 15.0, 30.0]))[:, 0], [1, 1, 1, 3, 4, 5])


def test_wide_pixels_are_narrowed(read: Read) -> None:
    head = HEAD.replace('pixelAspect="1"', 'pixelAspect="2"')
    np.testing.assert_allclose(only(read(shape_xml(), head=head)).at(1001).anchors[1], [125, 50])


def test_a_session_of_another_size_is_scaled(read: Read) -> None:
    head = HEAD.replace('width="200" height="100"', 'width="400" height="200"')
    imported = read(shape_xml(), head=head)
    np.testing.assert_allclose(only(imported).at(1001).anchors[1], [150, 50])
    assert "scaled" in imported.notes[0]


@pytest.mark.parametrize("closed", [True, False])
def test_a_b_spline_stays_one_and_is_the_same_curve(read: Read, closed: bool) -> None:
    shape = only(read(shape_xml(spline_key(0, CONTROLS, closed=closed))))
    assert (shape.spline, shape.closed) == (Spline.BSPLINE, closed)
    pixels = CONTROLS * 100 + [100, 50]
    np.testing.assert_allclose(shape.at(1001).control_points[:, 0], pixels, atol=1e-9)
    if closed:
        pixels = np.vstack([pixels[-1:], pixels, pixels[:2]])
    else:
        pixels = np.vstack([2 * pixels[0] - pixels[1], pixels, 2 * pixels[-1] - pixels[-2]])
    spline = BSpline(np.arange(len(pixels) + 4), pixels, 3)
    segments = 5 if closed else 4
    u = np.linspace(0, segments, 60, endpoint=False)
    curve = bezier.evaluate(shape.keys[0].points, u.astype(int), u % 1, closed)
    np.testing.assert_allclose(curve, spline(3 + u), atol=1e-9)


def test_kinds_that_are_unknown_or_mixed_are_named(read: Read) -> None:
    odd = shape_xml(path_key(0, kind="Xspline"), label="Odd")
    mixed = shape_xml(spline_key(0, CONTROLS[:3]), path_key(5), label="Mixed")
    assert read(odd + mixed + shape_xml()).notes == (
        "The shape 'Odd' was left out: it is of the kind 'Xspline'.",
        "The shape 'Mixed' was left out: its keys are of several kinds.",
    )


def test_catmullrom_keys_go_by_the_cubic_through_their_neighbours(read: Read) -> None:
    """Four keys on a parabola, evenly spaced in time: the middle span is the parabola, the others are straight."""
    keys = [path_key(10 * k, shifted(0.01 * k * k), interp="catmullrom") for k in range(4)]
    shape = only(read(shape_xml(*keys)))
    x = [float(shape.at(1001 + frame).anchors[0, 0]) for frame in (5, 10, 13, 15, 20, 25, 30)]
    np.testing.assert_allclose(x, [100.5, 101, 100 + 1.3**2, 102.25, 104, 106.5, 109], atol=0.05)
    assert shape.artist_frames == (1001, 1011, 1021, 1031)
    assert 0 < len(shape.keys) - 4 < 9
    assert all(1011 < key.frame < 1021 for key in shape.keys if key.origin is Origin.ENGINE)


def test_two_or_three_catmullrom_keys_need_no_others(read: Read) -> None:
    keys = [path_key(10 * k, shifted(0.1 * k), interp="catmullrom") for k in range(3)]
    assert only(read(shape_xml(*keys))).frames == (1001, 1011, 1021)


# ---- properties ------------------------------------------------------------------------------------------------------


def test_properties_of_a_shape(read: Read) -> None:
    properties = (
        constant("opacity", "25.0") + constant("mode", "Subtract") + constant("invert", "true")
        + constant("outlineColor", "(1.0,0.5,0.0)") + constant("motionBlur", "true")
    )  # fmt: skip
    imported = read(shape_xml(properties=properties, attributes='hidden="True" locked="True"'))
    shape = only(imported)
    assert (shape.opacity, shape.blend, shape.invert, shape.colour) == (0.25, BlendMode.SUBTRACT, True, (1.0, 0.5, 0.0))
    assert (shape.visible, shape.locked, shape.motion_blur is None) == (False, True, False)
    assert "shutter" in imported.notes[0]


@pytest.mark.parametrize("word", ["subtract", "SUBTRACT", " Subtract "])
def test_a_mode_is_known_in_any_letters(read: Read, word: str) -> None:
    assert only(read(shape_xml(properties=constant("mode", word)))).blend is BlendMode.SUBTRACT


def test_an_opacity_that_rises_from_and_falls_to_zero_is_a_lifetime(read: Read) -> None:
    shape = only(read(shape_xml(properties=keyed("opacity", (3, "0"), (4, "50"), (9, "0"), interp="hold"))))
    assert (shape.opacity, shape.lifetime) == (0.5, (1005, 1010))


def test_an_animated_opacity_keeps_its_keys(read: Read) -> None:
    imported = read(shape_xml(properties=keyed("opacity", (0, "10"), (9, "90"))))
    assert only(imported).opacity == Animated((ValueKey(1001, 0.1), ValueKey(1010, 0.9)))
    assert imported.notes == ()


@pytest.mark.parametrize(
    ("properties", "note"),
    [
        (constant("mode", "Screen"), "'Screen'"),
        (constant("feather", "3"), "feather was left out"),
    ],
)
def test_what_is_lost_is_named(read: Read, properties: str, note: str) -> None:
    imported = read(shape_xml(properties=properties))
    assert len(list(imported.layer.shapes())) == 1
    assert [note in sentence for sentence in imported.notes] == [True]


# ---- layers ----------------------------------------------------------------------------------------------------------


def test_layers_nest_and_the_outermost_plain_one_is_taken_off(read: Read) -> None:
    objects = shape_xml(label="B").replace("Shape type", "Object type").replace("/Shape", "/Object")
    inner = layer_xml(objects, constant("invert", "true"), 'hidden="True"', "Inner")
    bottom, top = read(layer_xml(inner + shape_xml())).layer.children
    assert isinstance(bottom, Layer)
    assert (bottom.name, bottom.invert, bottom.visible) == ("Inner", True, False)
    assert ([shape.name for shape in bottom.shapes()], top.name) == (["B"], "A")


def test_a_transform_scales_turns_clockwise_and_moves(read: Read) -> None:
    transform = (
        constant("transform.anchor", "(0.5,0)") + constant("transform.scale", "(2,2)")
        + constant("transform.rotate", "90") + constant("transform.position", "(0.1,0.2)")
    )  # fmt: skip
    shape = only(read(layer_xml(shape_xml(), transform)))
    # (0.5, 0.25) about (0.5, 0): (0, 0.25) -> (0, 0.5) -> clockwise, y down: (-0.5, 0) -> moved
    np.testing.assert_allclose(shape.at(1001).anchors[2], [100 + 100 * (0.5 - 0.5 + 0.1), 50 + 20])


def test_an_animated_layer_gives_keys_where_it_needs_them(read: Read) -> None:
    moving = keyed("transform.position", (0, "(0,0)"), (10, "(0.5,0)"))
    (layer,) = read(layer_xml(shape_xml(path_key(4)), moving)).layer.children
    assert isinstance(layer, Layer)
    assert layer.transform is not None
    (shape,) = layer.in_plate_space().shapes()
    assert (layer.transform.frames, shape.frames) == ((1001, 1011), (1005,))
    np.testing.assert_allclose(shape.at(1006).anchors[0], [125, 50])
    turning = keyed("transform.rotate", (0, "0"), (10, "90"))
    (layer,) = read(layer_xml(shape_xml(), turning)).layer.children
    assert isinstance(layer, Layer)
    assert layer.transform is not None
    (shape,) = layer.in_plate_space().shapes()
    assert (layer.transform.frames, shape.frames) == (tuple(range(1001, 1012)), (1001,))
    np.testing.assert_allclose(shape.at(1011).anchors[1], [100, 100], atol=1e-9)


@pytest.mark.parametrize("interp", ["linear", "hold", "catmullrom"])
def test_a_layer_that_moves_carries_its_shapes_on_every_frame(read: Read, interp: str) -> None:
    """Whatever lies in it; a layer that moves within one that stands elsewhere goes into the points."""
    scales = keyed("transform.scale", (0, "(1,1)"), (3, "(2,1)"), (8, "(1,2)"), (10, "(1,1)"), interp=interp)
    turns = keyed("transform.rotate", (0, "0"), (7, "60"), (9, "10"), interp=interp)
    within = layer_xml(shape_xml(path_key(0), path_key(9, shifted(0.2))), turns, label="Within")
    body = layer_xml(within, scales + constant("transform.anchor", "(0.1,0.2)"), label="Around")
    still = layer_xml(layer_xml(shape_xml(label="B"), turns), constant("transform.position", "(0.1,0)"), label="Still")
    one, other = read(body + still).layer.in_plate_space().shapes()
    sums = {part: track(parsed_property(words), 2 if part == "scale" else 1) for part, words in
            (("scale", scales), ("rotate", turns))}  # fmt: skip
    around = LayerTransform({"scale": sums["scale"], "anchor": Track(np.zeros(1), np.array([[0.1, 0.2]]), LINEARLY)})
    inner, aside = LayerTransform({"rotate": sums["rotate"]}), np.array([0.1, 0.0])
    for frame in range(12):
        at, share = np.array([float(frame)]), min(frame / 9.0, 1.0)
        drawn = ANCHORS + np.array([[0.2 * share, 0.0], [0.0, 0.0], [0.0, 0.0]])
        expected = around.apply(inner.apply(drawn[None, None], at), at)[0, 0]
        np.testing.assert_allclose(one.at(1001 + frame).anchors, expected * 100 + [100, 50], atol=0.15)
        expected = inner.apply(ANCHORS[None, None], at)[0, 0] + aside
        np.testing.assert_allclose(other.at(1001 + frame).anchors, expected * 100 + [100, 50], atol=0.15)


def test_a_layer_that_shrinks_to_nothing_goes_into_the_points(read: Read) -> None:
    shrinks = keyed("transform.scale", (0, "(1,1)"), (10, "(0,0)"))
    shape = only(read(layer_xml(shape_xml(), shrinks)))
    assert shape.frames == (1001, 1011)
    np.testing.assert_allclose(shape.at(1011).anchors, [[100, 50]] * 3, atol=1e-9)


def test_a_layer_that_moves_is_scaled_with_its_pictures(read: Read) -> None:
    moving = keyed("transform.position", (0, "(0,0)"), (10, "(0.5,0.25)"))
    head = HEAD.replace('width="200" height="100"', 'width="400" height="100"')
    (shape,) = read(layer_xml(shape_xml(), moving), head=head).layer.in_plate_space().shapes()
    np.testing.assert_allclose(shape.at(1011).anchors[0], [100 + 25, 50 + 25])


def test_a_tracked_project_of_many_shapes_is_read(read: Read) -> None:
    """A key for each shape on each frame of its layer was more than a file may hold."""
    moving = keyed("transform.matrix", *((k, f"(1,0,0,0,0,1,0,0,0,0,1,0,0,{k % 7},0,1)") for k in range(2000)))
    shapes = "".join(shape_xml(label=f"S{k}") for k in range(100))
    assert len(list(read(layer_xml(shapes, moving)).layer.shapes())) == 100


def test_a_matrix_acts_last_and_on_row_vectors(read: Read) -> None:
    move = constant("transform.position", "(0.1,0)")
    turn = constant("transform.matrix", "(0,1,0,0,-1,0,0,0,0,0,1,0,0.05,0.25,0,1)")
    imported = read(layer_xml(shape_xml(), move + turn))
    # (0.5, 0.25) -> moved (0.6, 0.25) -> (x, y) becomes (-y, x) + (0.05, 0.25): (-0.2, 0.85)
    np.testing.assert_allclose(only(imported).at(1001).anchors[2], [100 - 20, 50 + 85])
    assert imported.notes == ()


def test_a_tracked_matrix_with_perspective_moves_the_control_points(read: Read) -> None:
    flat = "(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1)"
    tilted = "(1,0,0,0.5,0,1,0,0,0,0,1,0,0.2,0,0,1)"
    properties = keyed("transform.matrix", (0, flat), (5, ""), (10, tilted))
    imported = read(layer_xml(shape_xml(spline_key(0, CONTROLS), spline_key(10, CONTROLS)), properties))
    (note,) = imported.notes
    assert note.startswith("1 B-spline(s) lie in a layer that moves in perspective")
    assert note.endswith("'A' strays by up to 2.6 px.")
    (shape,) = imported.layer.in_plate_space().shapes()
    assert shape.frames == (1001, 1011)
    expected = (CONTROLS + np.array([0.2, 0.0])) / (1.0 + 0.5 * CONTROLS[:, :1])
    np.testing.assert_allclose(shape.at(1011).anchors, bezier_anchors(expected) * 100 + [100, 50], atol=2.6)
    half = (CONTROLS + np.array([0.1, 0.0])) / (1.0 + 0.25 * CONTROLS[:, :1])
    np.testing.assert_allclose(shape.at(1006).anchors, bezier_anchors(half) * 100 + [100, 50], atol=2.6)


@pytest.mark.parametrize(
    ("value", "note"),
    [
        ("(1,0,0,0)", "The matrix of the layer 'L' was left out: 'transform.matrix' has 4 numbers, not 16."),
        ("(" + "0," * 15 + "0)", "The shape 'A' was left out: a matrix sends it to infinity."),
    ],
)
def test_a_matrix_that_is_none_is_named(read: Read, value: str, note: str) -> None:
    assert read(layer_xml(shape_xml(), constant("transform.matrix", value))).notes == (note,)


def test_what_says_nothing_is_not_named(read: Read) -> None:
    """Silhouette writes every property, blank or at its default."""
    layer = constant("transform.matrix", "") + constant("transform.pin_ur", "(1.000000000,0.000000000)")
    layer += constant("opacity", "100") + constant("transform.scale", "(1,1,1)")
    shape = constant("feather", "0") + constant("blur", "0") + constant("strokeWidth", "0")
    imported = read(layer_xml(shape_xml(properties=shape), layer))
    assert imported.notes == ()
    assert only(imported).frames == (1001,)


def test_a_corner_pin_is_named_once(read: Read) -> None:
    pins = constant("transform.pin_ul", "(0.1,0)") + constant("transform.pin_lr", "(0.9,1)")
    assert read(layer_xml(shape_xml(), pins)).notes == ("The layer 'L': its corner pin was left out.",)


def test_the_opacity_of_a_layer(read: Read) -> None:
    (half, _) = read(layer_xml(shape_xml(), constant("opacity", "50")) + shape_xml()).layer.children
    assert isinstance(half, Layer)
    assert half.opacity == 0.5
    broken = read(layer_xml(shape_xml(), constant("opacity", "much")))
    assert ["opacity of the layer 'L' was left out" in note for note in broken.notes] == [True]
    assert len(list(broken.layer.shapes())) == 1


# ---- refusals --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "keys",
    [
        [path_key(0, "<Point>(0,0)</Point><Point>(1,1)</Point>")],
        [path_key(0, "<Point>(0,0),(0,0),(0,0)</Point>")],
        [path_key(0), path_key(1, "<Point>(0,0),(0,0),(0,0)</Point>" * 2)],
        [path_key(0), path_key(0)],
        [path_key(0, POINTS.replace("0.5", "nan"))],
        [path_key(0, POINTS.replace("0.5", "1e9"))],
        [path_key(0, POINTS.replace("0.5", "half"))],
        [path_key(10**12)],
        ["<Key frame='x'/>"],
    ],
)
def test_a_shape_that_cannot_be_read_is_named_and_the_others_are_kept(read: Read, keys: list[str]) -> None:
    imported = read(shape_xml(*keys, label="Bad") + shape_xml(label="Good"))
    assert only(imported).name == "Good"
    assert ["'Bad'" in note for note in imported.notes] == [True]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("<Other/>", "no Silhouette shape file"),
        ('<Silhouette width="x"/>', "what pictures its shapes belong to: 'x' is no number\\."),
        ('<Silhouette width="0"/>', "that cannot be"),
        ("not xml", "no valid XML"),
        ('<!DOCTYPE a [<!ENTITY x "y">]><Silhouette>&x;</Silhouette>', "document type"),
        ("<Silhouette>" + "<Layer>" * MAX_DEPTH, "deep"),
    ],
)
def test_files_of_another_kind_are_one_sentence(tmp_path: Path, content: str, message: str) -> None:
    path = tmp_path / "a.fxs"
    path.write_text(content)
    with pytest.raises(RoamError, match=message):
        read_shapes(path, CLIP)


def keyed_words(name: str, *keys: tuple[float, str]) -> str:
    return f'<Property id="{name}">{"".join(f"""<Key frame="{at}">{word}</Key>""" for at, word in keys)}</Property>'


def test_an_invert_or_mode_that_varies_is_named(read: Read) -> None:
    """They have their earliest key, in whatever order the keys stand."""
    varies = keyed_words("invert", (5, "false"), (0, "true")) + keyed_words("mode", (0, "Subtract"), (5, "Add"))
    imported = read(layer_xml(shape_xml(properties=varies), keyed_words("invert", (0, "true"), (9, "false"))))
    (layer,) = imported.layer.children
    assert isinstance(layer, Layer)
    (shape,) = layer.shapes()
    assert (shape.invert, shape.blend, layer.invert) == (True, BlendMode.SUBTRACT, True)
    assert set(imported.notes) == {
        "The invert of the layer 'L' varies: it was read as 'true', its first key.",
        "The mode of the shape 'A' varies: it was read as 'Subtract', its first key.",
        "The invert of the shape 'A' varies: it was read as 'true', its first key.",
    }


def test_keys_that_say_the_same_vary_nothing(read: Read) -> None:
    same = keyed_words("invert", (0, "true"), (5, "true"))
    assert read(shape_xml(properties=same)).notes == ()
