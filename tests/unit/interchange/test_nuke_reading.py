"""The `.nk` reader: every form that real files hold, hand-decoded, and what it refuses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.interchange import Imported, ImportOptions, read_shapes
from roam_core.interchange.reading import MAX_DEPTH, MAX_POINTS
from roam_core.roto import Animated, BlendMode, Clip, Interpolation, Layer, MotionBlur, RotoShape, ValueKey

CLIP = Clip(Path("/plates/shot.%04d.exr"), 1001, 1040, (200, 100))
SQUARE = "{0 0} {10 20} {0 0} {0 0} {30 20} {0 0} {-4 1} {30 40} {5 -2}"
"""Three points, the last one with handles."""

Read = Callable[..., Imported]


@pytest.fixture
def read(tmp_path: Path) -> Read:
    """`read(script)` reads a text as `a.nk`."""

    def run(script: str, options: ImportOptions | None = None, clip: Clip = CLIP) -> Imported:
        path = tmp_path / "a.nk"
        path.write_text(script, encoding="utf-8", errors="surrogatepass")
        return read_shapes(path, clip, options) if options else read_shapes(path, clip)

    return run


def node(*items: str, root: str = "{f 512} {t 100 50} {a}", knobs: str = "", species: str = "Roto") -> str:
    """A script with one node that holds the items."""
    curves = f"{{{{v x3f99999a}} {{f 0}} {{n {{layer Root {root} {' '.join(items)}}}}}}}"
    return f"{species} {{\n curves {{{curves}}}\n{knobs}\n}}\n"


def group(
    points: str = f"{{px 1001 {SQUARE}}}",
    *,
    name: str = "A",
    flags: int = 512,
    cc: int = 8192,
    feather: str = "idem",
    form: str = "{t 20 30}",
    attributes: str = "",
) -> str:
    """A `curvegroup`."""
    curves = f"{{{{cc {{f {cc}}} {points}}} {feather}}}"
    return f"{{curvegroup {name} {flags} bezier {curves} {form} {{a {attributes}}}}}"


def only(imported: Imported) -> RotoShape:
    (shape,) = imported.layer.shapes()
    return shape


def anchors(shape: RotoShape, frame: float = 1001) -> list[list[float]]:
    """Rounded anchors."""
    return np.round(shape.at(frame).anchors, 4).tolist()


# ---- points ----------------------------------------------------------------------------------------------------------


def test_a_single_key_with_handles_in_the_order_in_point_out(read: Read) -> None:
    imported = read(node(group()))
    shape = only(imported)
    assert imported.notes == ()
    assert (shape.name, shape.frames, shape.closed) == ("A", (1001,), True)
    assert anchors(shape) == [[10, 80], [30, 80], [30, 60]]
    np.testing.assert_allclose(shape.keys[0].points[2], [[30, 60], [26, 59], [35, 62]])


def test_points_without_keys_stand_on_the_clips_first_frame(read: Read) -> None:
    shape = only(read(node(group(f"{{p {SQUARE}}}"))))
    assert (shape.frames, anchors(shape)) == ((1001,), [[10, 80], [30, 80], [30, 60]])


def test_hexadecimal_numbers_are_single_precision(read: Read) -> None:
    shape = only(read(node(group("{px x42280000 {} {x3f99999a x41200000} {} {} {1e1 4} {} {} {2 9} {}}"))))
    assert shape.frames == (42,)
    np.testing.assert_allclose(shape.keys[0].points[0, 0], [np.float32(1.2), 90.0])


def test_several_keys_share_their_times_and_one_key_is_a_constant(read: Read) -> None:
    still = "{} {5 6} {} {} {7 8} {}"
    moving = "{} {{{0 0 1 2 1} {20 2 1 0 1}} {{3 -}}} {}"
    shape = only(read(node(group(f"{{px {{1 11}} {moving} {still}}}"))))
    assert shape.frames == (1, 11)
    assert shape.keys[0].interpolation is Interpolation.LINEAR
    assert anchors(shape, 6) == [[10, 97], [5, 94], [7, 92]]


def test_keys_read_at_once_and_one_by_one_are_the_same(read: Read) -> None:
    at_once = "{{0 0 1 x40000000 1} {x41a00000 x40000000 1 0 1}}"
    one_by_one = "{{0.0 0 1 2 1} {20 2 1 0 1}}"
    shapes = [
        only(read(node(group(f"{{px {{1 11}} {{}} {{{keys} 3}} {{}} {{}} {{8 9}} {{}}}}"))))
        for keys in (at_once, one_by_one)
    ]
    assert shapes[0].keys == shapes[1].keys
    assert anchors(shapes[0], 6)[0] == [10, 97]


def test_run_lengths_stand_for_copies_of_a_key(read: Read) -> None:
    curve = "{{x 3 {4 -}} {9 -}}"
    shape = only(read(node(group(f"{{px {{1 2 3 4}} {{}} {{{curve} 0}} {{}} {{}} {{8 9}} {{}}}}"))))
    assert [anchors(shape, frame)[0][0] for frame in (1, 2, 3, 4)] == [4, 4, 4, 9]


def test_coordinates_with_times_of_their_own(read: Read) -> None:
    point = "{ {{1 0 -} {11 10 -}} {{6 50 -}} }"
    shape = only(read(node(group(f"{{p {{}} {point} {{}} {{}} {{8 9}} {{}}}}"))))
    assert shape.frames == (1, 11)
    assert shape.keys[0].interpolation is Interpolation.SMOOTH
    assert [anchors(shape, frame)[0] for frame in (1, 6, 11)] == [[0, 50], [5, 50], [10, 50]]


def test_a_cubic_that_is_not_ours_gets_a_key_on_every_frame(read: Read) -> None:
    moving = "{{{0 0 1 9 1} {30 0 1 0 1}} {{3 -}}}"
    shape = only(read(node(group(f"{{px {{1 11}} {{}} {moving} {{}} {{}} {{8 9}} {{}}}}"))))
    assert shape.frames == tuple(range(1, 12))
    u = np.arange(11) / 10
    expected = 30 * u**2 * (3 - 2 * u) + 90 * u * (1 - u) ** 2
    np.testing.assert_allclose([anchors(shape, frame)[0][0] for frame in shape.frames], expected, atol=1e-3)


@pytest.mark.parametrize(("kind", "between"), [(256, 0.0), (257, 2.5), (258, 1.5625)])
def test_interpolation_numbers_of_keys(read: Read, kind: int, between: float) -> None:
    moving = f"{{ {{{{1 0 {kind}}} {{5 10 {kind}}}}} {{{{6 50 -}}}} }}"
    shape = only(read(node(group(f"{{p {{}} {moving} {{}} {{}} {{8 9}} {{}}}}"))))
    assert anchors(shape, 2)[0][0] == pytest.approx(between, abs=1e-3)
    assert anchors(shape, 5)[0][0] == 10


def test_long_handles_in_time_bend_it(read: Read) -> None:
    moving = "{ {{1 0 0 1 0 3} {11 10 0 3 0 1}} {{6 50 -}} }"
    shape = only(read(node(group(f"{{p {{}} {moving} {{}} {{}} {{8 9}} {{}}}}"))))
    # x(u) = 3u(1-u)^2 * 1 + 0 + u^3: the time handles reach to the other key
    u = np.linspace(0, 1, 2001)
    time, value = 3 * u * (1 - u) ** 2 + u**3, 3 * u * u * (1 - u) + u**3
    for frame in (3, 5, 8):
        expected = 10 * np.interp((frame - 1) / 10, time, value)
        assert anchors(shape, frame)[0][0] == pytest.approx(expected, abs=0.01)


def test_a_held_key_is_found_again(read: Read) -> None:
    curve = "{{4 -} {4 -} {9 -}}"
    shape = only(read(node(group(f"{{px {{1 9 10}} {{}} {{{curve} 0}} {{}} {{}} {{8 9}} {{}}}}"))))
    assert shape.frames == (1, 10)
    assert shape.keys[0].interpolation is Interpolation.HOLD


def test_a_feather_curve_is_relative_to_the_outline(read: Read) -> None:
    feather = "{cc {f 8192} {px 1001 {0 0} {2 3} {0 0} {0 0} {0 0} {0 0} {-4 1} {0 -1} {5 -2}}}"
    key = only(read(node(group(feather=feather)))).keys[0]
    assert key.feather is not None
    np.testing.assert_allclose(key.feather[:, 0], [[2, -3], [0, 0], [0, 1]])
    np.testing.assert_allclose(key.feather[2], [[0, 1]] * 3)


def test_a_feather_curve_on_the_outline_is_none(read: Read) -> None:
    feather = "{cc {f 8192} {px 1001 {} {} {} {} {} {} {-4 1} {} {5 -2}}}"
    assert only(read(node(group(feather=feather)))).keys[0].feather is None


def test_open_shapes_and_attributes_of_points(read: Read) -> None:
    points = "{px 1001 {} {{a osw 1 osf 2} 10 20} {} {} {30 20 1} {}}"
    imported = read(node(group(points, cc=8192 + 32)))
    assert (only(imported).closed, anchors(only(imported))) == (False, [[10, 80], [30, 80]])
    assert ["single points" in note for note in imported.notes] == [True]


# ---- transforms ------------------------------------------------------------------------------------------------------


def test_a_transform_scales_turns_and_moves_about_its_pivot(read: Read) -> None:
    shape = only(read(node(group(form="{t 10 20 0 100 7 0 0 0 90 2 3}"))))
    # y up, about (10, 20): (30, 40) is (20, 20) away, scaled (40, 60), a quarter turn to the left (-60, 40)
    assert anchors(shape)[2] == [10 - 60 + 100, 100 - (20 + 40 + 7)]


def test_layers_are_applied_after_the_shape_and_outer_ones_last(read: Read) -> None:
    inner = "{layer L {f 512} {t 0 0 0 0 0 0 0 0 90} {a} " + group(form="{t 0 0 0 1 2}") + "}"
    shape = only(read(node(inner, root="{f 512} {t 0 0 0 0 0 0 0 0 0 2 2} {a}")))
    # (30, 40) + (1, 2) -> a quarter turn (-42, 31) -> doubled
    assert anchors(shape)[2] == [-84, 100 - 62]


def test_an_animated_transform_makes_keys_of_its_own(read: Read) -> None:
    turning = "{t 0 0 0 0 0 0 0 0 {{1 0 0 1 9 1} {11 90 9 1 0 1}}}"
    shape = only(read(node(group(form=turning))))
    assert set(range(1, 12)) < set(shape.frames)
    angle = np.radians(45)
    x, y = 30 * np.cos(angle) - 40 * np.sin(angle), 30 * np.sin(angle) + 40 * np.cos(angle)
    np.testing.assert_allclose(anchors(shape, 6)[2], [x, 100 - y], atol=1e-3)


def test_keys_of_a_transform_with_times_in_front(read: Read) -> None:
    shape = only(read(node(group(form="{tx {1 11} 0 0 0 {{0 0 1 1 1} {10 1 1 0 1}} {{5 -}}}"))))
    assert shape.frames == (1, 11, 1001)
    assert anchors(shape, 6)[0] == [15, 75]


def test_parts_of_a_transform_that_are_unknown_are_named(read: Read) -> None:
    imported = read(node(group(form="{t 0 0 0 0 0 0 0 0 0 1 1 1 0 4}")))
    assert imported.notes == ("The shape 'A': the skew of its transform was left out.",)


# ---- attributes and flags --------------------------------------------------------------------------------------------


def test_attributes_of_a_shape(read: Read) -> None:
    words = (
        "opc 0.25 bm 12 inv 1 vis 0 ro 1 go 0.5 bo 0 ao 1 fx 4 fy 4 mbo 1 mb 2 mbs 0.5 mbsot 1 ltt 4 ltn 1003 ltm 1009"
    )
    shape = only(read(node(group(attributes=words, flags=512 + 1024))))
    assert (shape.opacity, shape.blend, shape.invert, shape.visible) == (0.25, BlendMode.SUBTRACT, True, False)
    assert (shape.colour, shape.feather, shape.locked) == ((1.0, 0.5, 0.0), 4.0, True)
    assert (shape.motion_blur, shape.lifetime) == (MotionBlur(0.5, 0.0, 32), (1003, 1010))


@pytest.mark.parametrize(
    ("words", "lifetime"),
    [
        ("ltn 1003 ltm 1009", None),
        ("ltt 0 ltn 1003", None),
        ("ltt 1 ltn 1003", (1001, 1004)),
        ("ltt 2 ltn 1003", (1003, 1004)),
        ("ltt 3 ltn 1003", (1003, 1041)),
        ("ltt 4 ltn 1003 ltm 1005", (1003, 1006)),
    ],
)
def test_types_of_lifetime(read: Read, words: str, lifetime: tuple[int, int] | None) -> None:
    assert only(read(node(group(attributes=words)))).lifetime == lifetime


def test_animated_opacity_and_feather_keep_their_keys(read: Read) -> None:
    words = "opc {{1001 0 -} {1011 1 -}} fx {{1001 2 0 1 1 1} {1005 6 1 1 0 1}} fy {{1001 2 0 1 1 1} {1005 6 1 1 0 1}}"
    imported = read(node(group(attributes=words)))
    shape = only(imported)
    assert shape.opacity == Animated((ValueKey(1001, 0.0, Interpolation.SMOOTH), ValueKey(1011, 1.0)))
    assert shape.feather == Animated((ValueKey(1001, 2.0), ValueKey(1005, 6.0)))
    assert imported.notes == ()


@pytest.mark.parametrize(
    ("words", "has_tangents"),
    [("{1001 0 0 1 0.15 1} {1021 1 0 1 0 1}", True), ("{1001 0 0 1 0.15 1} {1020.5 1 0 1 0 1}", False)],
)
def test_an_opacity_that_moves_otherwise_keeps_its_tangents_or_has_few_keys_between(
    read: Read, words: str, has_tangents: bool
) -> None:
    """Tangents are Nuke's own where its keys lie on whole frames."""
    shape = only(read(node(group(attributes=f"opc {{{words}}}"))))
    assert isinstance(shape.opacity, Animated)
    assert (len(shape.opacity.keys) == 2) == has_tangents
    assert {1001, 1021} <= set(shape.opacity.frames)
    span = 20.0 if has_tangents else 19.5
    u = np.minimum(np.linspace(0.0, 20.0, 21) / span, 1.0)
    first = 0.15 * span / 3.0
    truth = 3 * (1 - u) ** 2 * u * first + 3 * (1 - u) * u * u + u**3
    np.testing.assert_allclose([shape.opacity_at(1001 + frame) for frame in range(21)], truth, atol=2e-3)


@pytest.mark.parametrize(
    ("words", "note"),
    [
        ("inv {{1 0 -} {9 1 -}}", "'inv' is animated"),
        ("bm 99", "blend mode 99"),
        ("fx 1 fy 3", "differs in x and y"),
        ("r 0.5", "colour of its paint"),
        ("ff 2", "fall-off"),
        ("opc {=t 1}", "expression, which is not run"),
        ("opc nonsense", "'opc' cannot be read"),
    ],
)
def test_attributes_that_are_lost_are_named(read: Read, words: str, note: str) -> None:
    imported = read(node(group(attributes=words)))
    assert len(imported.notes) == 1
    assert note in imported.notes[0]
    assert "'A'" in imported.notes[0]
    assert len(list(imported.layer.shapes())) == 1


def test_shapes_of_some_views_alone_are_named(read: Read) -> None:
    """As Nuke writes them: a shape of three views has `nv 3 view2 2 view3 3`, one of the second alone `view1 2`."""
    every = "nv x40400000 view2 x40000000 view3 x40400000"
    script = node(
        group(name="both", attributes=every),
        group(name="right", attributes="view1 x40000000"),
        group(name="left"),
    )
    (note,) = read(script).notes
    assert note == "ROAM has one view, and shows what Nuke shows in some of the script's alone: 'right', 'left'."
    assert len([*read(script).layer.shapes()]) == 3


@pytest.mark.parametrize("attributes", ["", "nv 2 view2 2", "view1 2"])
def test_shapes_that_are_in_the_same_views_are_not_told_of(read: Read, attributes: str) -> None:
    assert not read(node(*(group(name=name, attributes=attributes) for name in "ab"))).notes


def test_the_offset_is_taken_off_keys_and_lifetimes(read: Read) -> None:
    shape = only(read(node(group(attributes="ltt 4 ltn 1003 ltm 1005")), ImportOptions(frame_offset=1000)))
    assert (shape.frames, shape.lifetime) == ((1,), (3, 6))


def test_the_list_begins_with_what_lies_on_top(read: Read) -> None:
    inner = "{layer {In ner} {f 1536} {t 0 0} {a opc 0.5 inv 1 vis 0} " + group(name="Deep") + "}"
    layer = read(node(group(name="Top"), inner, group(name="Bottom"))).layer
    bottom, middle, top = layer.children
    assert (bottom.name, middle.name, top.name) == ("Bottom", "In ner", "Top")
    assert isinstance(middle, Layer)
    assert (middle.opacity, middle.invert, middle.visible, middle.locked) == (0.5, True, False, True)


# ---- nodes and formats -----------------------------------------------------------------------------------------------


def test_the_format_of_the_node_turns_y_over_and_scales_to_the_clip(read: Read) -> None:
    imported = read(node(group(), knobs=' inputs 0\n format "400 300 0 0 400 300 1 big"'))
    assert anchors(only(imported))[0] == [5, pytest.approx((300 - 20) / 3, abs=1e-3)]
    assert ["scaled" in note for note in imported.notes] == [True]


def test_each_node_is_scaled_from_its_own_format(read: Read) -> None:
    """A node without one is of the clip's; all were scaled as the first that had one, and lay in a wrong place."""
    knobs = (' inputs 0\n format "400 300 0 0 400 300 1 x"', "", ' inputs 0\n format "200 200 0 0 200 200 1 x"')
    imported = read("".join(node(group(), knobs=each) for each in knobs))
    first = [np.round(shape.at(1001).anchors[0], 3).tolist() for shape in reversed(list(imported.layer.shapes()))]
    assert first == [[5.0, 93.333], [10.0, 80.0], [10.0, 90.0]]
    assert ["were scaled" in note for note in imported.notes] == [True, True]


@pytest.mark.parametrize(
    ("pivot", "told"), [("100 50", False), ("100.5 50", False), ("1024 778", True), ("0 50", False)]
)
def test_a_node_without_format_that_turns_about_another_middle_is_doubted(read: Read, pivot: str, told: bool) -> None:
    root = f"{{f 512}} {{t {pivot}}} {{a}}"
    assert ["middle is that of 2048 x 1556" in note for note in read(node(group(), root=root)).notes] == [True] * told
    assert read('Root {\n format "200 100 0 0 200 100 1 x"\n}\n' + node(group(), root=root)).notes == ()


def test_handles_may_be_told_as_places(read: Read) -> None:
    by_place = only(read(node(group(cc=0)))).keys[0].points
    by_step = only(read(node(group()))).keys[0].points
    np.testing.assert_allclose(by_place[:, 0], by_step[:, 0])
    np.testing.assert_allclose(by_step[2], [[30.0, 60.0], [26.0, 59.0], [35.0, 62.0]])
    np.testing.assert_allclose(by_place[2], [[30.0, 60.0], [-4.0, 99.0], [5.0, 102.0]])


def test_the_format_of_the_script_is_the_next_best(read: Read) -> None:
    script = 'Root {\n format "200 500 0 0 200 500 1 tall"\n}\n' + node(group(), knobs=" inputs 0")
    assert anchors(only(read(script)))[0] == [10, 480 / 5]


def test_several_nodes_are_layers_of_their_names(read: Read) -> None:
    script = node(group(), knobs=" name Roto1") + "Blur {\n size {{curve x1 0 4}}\n}\n"
    imported = read(script + node(group(), knobs=" name Paint7", species="RotoPaint"))
    assert [child.name for child in imported.layer.children] == ["Paint7", "Roto1"]


def test_a_clipboard_with_comments_and_foreign_lines(read: Read) -> None:
    script = "#! nuke {\nset cut_paste_input [stack 0]\nversion 10.5 v2\npush $cut_paste_input\n" + node(group())
    assert only(read(script)).name == "A"


def test_nothing_of_a_script_is_run(read: Read, tmp_path: Path) -> None:
    target = tmp_path / "made"
    script = f"[exec touch {target}]\n" + node(group(name=f"{{[exec touch {target}]}}"))
    assert only(read(script)).name == f"[exec touch {target}]"
    assert not target.exists()


@pytest.mark.parametrize(
    ("word", "name"),
    [("{a b}", "a b"), ("a\\ b", "a b"), ('"a b"', "a b"), ("\\{x\\n\\u00fc", "{x\nü"), ("a;b", "a;b"), ("{}", "")],
)
def test_names_are_words_of_tcl(read: Read, word: str, name: str) -> None:
    assert only(read(node(group(name=word)))).name == name


# ---- refusals --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("bad", "reason"),
    [
        (group("{p {} {{=origin.x 5} 4} {} {} {1 2} {}}", name="B"), "expression '=origin.x'"),
        (group("{p {} {1 2}}", name="B"), "not three for each point"),
        (group("{q {} {1 2} {}}", name="B"), "none of the known forms"),
        (group("{px {2 1} {} {1 2} {}}", name="B"), "not in order"),
        (group("{px {1 2 3} {} {{{1 -} {2 -}} 0} {}}", name="B"), "2 keys stand for 3 times"),
        (group("{px {1 2} {} {{{x 999999999 {1 -}}} 0} {}}", name="B"), "more than 2 keys"),
        (group("{p {} {inf 2} {}}", name="B"), "sensible number"),
        (group("{p {} {x7f800000 2} {}}", name="B"), "sensible number"),
        (group("{p {} {xyz 2} {}}", name="B"), "left out"),
        (group("{p {} {1e9 2} {}}", name="B"), "nowhere near the image"),
        (group("{px 1e9 {} {1 2} {}}", name="B"), "no frame number"),
        (group(feather="{cc {f 8192} {p {} {} {}}}", name="B"), "not as many points"),
        ("{curvegroup B 512 bspline {{cc {f 0} {p}} idem} {t} {a}}", "bspline shape"),
        ("{cubiccurve B 512 catmullrom {cc {f 32} {p {1 2 1}}} {t} {a}}", "catmullrom stroke"),
        ("{curvegroup B 512}", "left out"),
        ("{curvegroup B}", "left out"),
    ],
)
def test_a_shape_that_cannot_be_read_is_named_and_the_others_are_kept(read: Read, bad: str, reason: str) -> None:
    imported = read(node(bad, group(name="Good")))
    assert only(imported).name == "Good"
    (note,) = imported.notes
    assert "'B'" in note
    assert reason in note


def test_a_bezier_stroke_comes_as_an_open_shape(read: Read) -> None:
    stroke = f"{{cubiccurve S 512 bezier {{cc {{f 8224}} {{p {SQUARE}}}}} {{t}} {{a}}}}"
    imported = read(node(stroke))
    assert not only(imported).closed
    assert "without its brush" in imported.notes[0]


def test_a_file_that_is_cut_off_gives_what_is_whole(read: Read) -> None:
    script = node(group(name="Whole"), group(name="Half"))
    imported = read(script[: script.index("Half") + 60])
    assert only(imported).name == "Whole"
    assert any("'Half'" in note and "cut off" in note for note in imported.notes)


@pytest.mark.parametrize("end", [" curves {", " label {"])
def test_a_file_that_ends_within_a_later_node_says_so(read: Read, end: str) -> None:
    """Also where the lists of its curves are whole, or have not begun."""
    imported = read(f"{node(group(name='Whole'))}Roto {{\n name Second\n{end}")
    assert [shape.name for shape in imported.layer.shapes()] == ["Whole"]
    assert imported.notes == ("The file ends within the node 'Second': what is whole was read.",)


@pytest.mark.parametrize(
    ("script", "message"),
    [
        ("", "no Roto"),
        ("Blur {\n size 4\n}\n", "no Roto"),
        ('Roto {\n curves {AnimTree: "" {\n Version: 1.2}}\n}\n', "Nuke 7"),
        ("Roto {\n curves {{{v 1} {f 0} {n oops}}}\n}\n", "Nuke 7"),
        ("Roto " + "{" * (MAX_DEPTH + 5), "deep"),
        ("\0\1\2\xff", "no Roto"),
    ],
)
def test_files_that_hold_nothing_are_one_sentence(read: Read, script: str, message: str) -> None:
    with pytest.raises(RoamError, match=message):
        read(script)


def test_the_number_of_points_is_bounded_before_they_are_made(read: Read) -> None:
    curve = f"{{ {{{{1 0 0 1 9 1}} {{{MAX_POINTS * 2} 5 3 1 0 1}}}} 0 }}"
    with pytest.raises(RoamError, match="points over all keys"):
        read(node(group(f"{{p {{}} {curve} {{}}}}")))


def test_reading_can_be_cancelled(read: Read) -> None:
    token = CancelToken()
    token.cancel()
    with pytest.raises(Cancelled):
        read(node(group()), ImportOptions(token=token))


def test_a_clip_of_another_pixel_grid_only_scales(read: Read) -> None:
    script = node(group(), knobs=' format "200 100 0 0 200 100 1 small"')
    doubled = only(read(script, clip=replace(CLIP, size=(400, 200))))
    np.testing.assert_allclose(doubled.keys[0].points, 2 * only(read(script)).keys[0].points)


@pytest.mark.parametrize("word", ["hello", "xzz112233", "x123", "1,5"])
def test_a_damaged_number_is_named(read: Read, word: str) -> None:
    points = f"{{p {{}} {{{word} 2}} {{}}}}"
    assert read(node(group(points))).notes == (f"The shape 'A' was left out: {word!r} is no number.",)


def test_lists_that_lack_something_are_told_in_our_words(read: Read) -> None:
    assert read(node("{curvegroup B 512 bezier {{cc}} {a}}")).notes == (
        "The shape 'B' was left out: it has none of the known forms.",
    )
    told = read(node(group("{p {} {1 2} {}}", form="{t éa 2}"))).notes
    assert told == ("The shape 'A': its transform was left out, 'éa' is no number.",)
