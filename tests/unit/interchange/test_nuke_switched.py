"""What a Nuke script says of a node: that it is disabled, of which there are clones, what lies under it; and visibility
that has keys."""

from __future__ import annotations

from pathlib import Path

import pytest

from roam_core.interchange import Imported, ImportOptions, read_shapes
from roam_core.roto import Animated, Clip, Interpolation, Layer, RotoShape, ValueKey
from tests.unit.interchange.test_nuke_reading import group, node

CLIP = Clip(Path("/plates/shot.%04d.exr"), 1001, 1040, (200, 100))


def read(folder: Path, script: str, offset: int = 0) -> Imported:
    path = folder / "a.nk"
    path.write_text(script, encoding="utf-8")
    return read_shapes(path, CLIP, ImportOptions(frame_offset=offset))


def only(imported: Imported) -> RotoShape:
    (shape,) = imported.layer.shapes()
    return shape


def held(*keys: tuple[int, float]) -> Animated:
    return Animated(tuple(ValueKey(frame, value, Interpolation.HOLD) for frame, value in keys))


@pytest.mark.parametrize(("said", "is_off"), [("true", True), ("1", True), ("false", False)])
def test_what_a_disabled_node_holds_is_hidden(tmp_path: Path, said: str, is_off: bool) -> None:
    imported = read(tmp_path, node(group(), knobs=f" name R\n disable {said}"))
    assert imported.notes == ()
    (item,) = imported.layer.children
    if is_off:
        assert isinstance(item, Layer)
        assert (item.name, item.visible) == ("R", False)
    else:
        assert isinstance(item, RotoShape)


def in_group(script: str, knobs: str, species: str = "Group") -> str:
    return f"{species} {{\n name G\n{knobs}\n}}\n{script}\nend_group\n"


@pytest.mark.parametrize("species", ["Group", "Gizmo", "LiveGroup"])
def test_what_lies_in_a_disabled_group_is_hidden(tmp_path: Path, species: str) -> None:
    """However deep, and up to the end of the group only."""
    inner = in_group(node(group(name="Deep"), knobs=" name D"), " disable false")
    within = inner + node(group(name="In"), knobs=" name I\n disable false")
    script = in_group(within, " disable true", species) + node(group(name="Out"), knobs=" name O")
    layer = read(tmp_path, script).layer
    assert {item.name: item.visible for item in layer.children} == {"D": False, "I": False, "O": True}


def test_a_group_that_is_disabled_by_an_expression_is_read_and_named(tmp_path: Path) -> None:
    imported = read(tmp_path, in_group(node(group(), knobs=" name R"), ' disable {{"frame > 5"}}'))
    assert only(imported).visible
    assert imported.notes == ("Whether the node 'R' is disabled varies: it was read as on.",)


def test_a_node_that_is_disabled_by_an_expression_is_read_and_named(tmp_path: Path) -> None:
    imported = read(tmp_path, node(group(), knobs=' name R\n disable {{"frame > 5"}}'))
    assert only(imported).visible
    assert imported.notes == ("Whether the node 'R' is disabled varies: it was read as on.",)


def test_the_first_of_several_clones_has_the_shapes(tmp_path: Path) -> None:
    script = f"clone node1f0a|Roto|31 {node(group(name='Cloned'))}\nclone $C1f0a {{\n xpos 5\n}}\n"
    assert only(read(tmp_path, script)).name == "Cloned"


@pytest.mark.parametrize("knobs", ["", " inputs 1", " inputs 1+1"])
@pytest.mark.parametrize("where", ["script", "node"])
def test_formats_mean_nothing_to_a_node_over_the_plate(tmp_path: Path, knobs: str, where: str) -> None:
    """Its root turns about the middle of the plate; the script's format is often left at another."""
    wide = ' format "400 300 0 0 400 300 1 2K"'
    script = node(group(), knobs=knobs + ("\n" + wide if where == "node" else ""))
    imported = read(tmp_path, script if where == "node" else f"Root {{\n{wide}\n}}\n{script}")
    assert imported.notes == ()
    assert only(imported).at(1001).anchors[0].tolist() == [10.0, 80.0]


@pytest.mark.parametrize(("knobs", "root"), [(" inputs 0", "{t 100 50}"), ("", "{t 200 150}"), ("", "{t {=x 100} 50}")])
def test_formats_hold_for_a_node_without_an_input_or_of_another_plate(tmp_path: Path, knobs: str, root: str) -> None:
    script = node(group(), knobs=knobs, root=f"{{f 512}} {root} {{a}}")
    imported = read(tmp_path, f'Root {{\n format "400 300 0 0 400 300 1 2K"\n}}\n{script}')
    assert only(imported).at(1001).anchors[0] == pytest.approx([5.0, 280.0 / 3.0])


def test_curves_of_a_warp_are_hidden_and_named(tmp_path: Path) -> None:
    script = node(group(name="Pulled"), knobs=" name SplineWarp1", species="SplineWarp3") + node(group(name="Drawn"))
    imported = read(tmp_path, script)
    drawn, warp = imported.layer.children
    assert (warp.name, warp.visible, drawn.visible) == ("SplineWarp1", False, True)
    assert imported.notes == (
        "SplineWarp3 'SplineWarp1' warps by its curves, which make no matte: they came in hidden.",
    )


def test_visibility_with_keys_becomes_opacity(tmp_path: Path) -> None:
    """From a key on it is as the key says, wherever the next one lies."""
    imported = read(tmp_path, node(group(attributes="vis {{1011 0} {1015 1} {1018.5 0}} opc 0.5")), offset=10)
    shape = only(imported)
    assert shape.visible
    assert shape.opacity == held((1001, 0.0), (1005, 0.5), (1009, 0.0))
    assert imported.notes == ("The shape 'A': its visibility is switched by keys; its opacity has them.",)


def test_visibility_and_opacity_that_both_have_keys_are_multiplied(tmp_path: Path) -> None:
    words = "vis {{1001 1} {1005 0}} opc {{1001 0 0 1 x3dcccccd 1} {1011 1 x3dcccccd 1 0 1}}"
    opacity = only(read(tmp_path, node(group(attributes=words)))).opacity
    assert isinstance(opacity, Animated)
    assert [opacity.at(frame) for frame in (1001, 1004, 1005, 1011)] == pytest.approx([0.0, 0.3, 0.0, 0.0], abs=1e-6)


def test_a_layer_comes_and_goes_by_keys_of_its_visibility(tmp_path: Path) -> None:
    layer = f"{{layer Inner {{f 512}} {{t 0 0}} {{a vis {{{{1001 1}} {{1005 0}}}}}} {group()}}}"
    (item,) = read(tmp_path, node(layer)).layer.children
    assert isinstance(item, Layer)
    assert (item.visible, item.opacity) == (True, held((1001, 1.0), (1005, 0.0)))


@pytest.mark.parametrize(("words", "visible"), [("{{1001 0} {1005 0}}", False), ("{{1001 1} {1005 1}}", True)])
def test_visibility_whose_keys_say_the_same_is_plain(tmp_path: Path, words: str, visible: bool) -> None:
    imported = read(tmp_path, node(group(attributes=f"vis {words}")))
    assert (only(imported).visible, only(imported).opacity, imported.notes) == (visible, 1.0, ())


@pytest.mark.parametrize(("kind", "opacity"), [(256, 0.0), (257, 0.5)])
def test_a_key_without_slopes_may_say_how_it_goes_on(tmp_path: Path, kind: int, opacity: float) -> None:
    read_as = only(read(tmp_path, node(group(attributes=f"opc {{{{1001 0 - {kind}}} {{1005 1 - {kind}}}}}")))).opacity
    assert isinstance(read_as, Animated)
    assert read_as.at(1003) == opacity
