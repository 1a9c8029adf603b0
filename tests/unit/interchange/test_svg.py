"""SVG out and in: what we write is painted by Qt's renderer, what we read is compared with what it paints."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, Imported, KeyChoice, read_shapes
from roam_core.interchange.keys.reduction import Reduction, reduced
from roam_core.interchange.svg.abbreviations import written_out
from roam_core.interchange.svg.format import svg_document
from roam_core.matte import render_matte
from roam_core.roto import BlendMode, Clip, Keyframe, Layer, Origin, Project, RotoShape, Spline, control_points
from tests.judges import svg as svg_judge
from tests.unit.interchange import qt_judge
from tests.unit.interchange.conftest import animated, points
from tests.unit.interchange.test_other_programs import NAMES, bent_leaf

SIZE = (320, 200)
CLIP = Clip(Path("plate"), 1, 21, SIZE)


def read(text: str, folder: Path, clip: Clip = CLIP) -> Imported:
    path = folder / "drawing.svg"
    path.write_text(text, encoding="utf-8", newline="")
    return read_shapes(path, clip)


def drawing(body: str, head: str = 'width="320" height="200"') -> str:
    return f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" {head}>{body}</svg>'


# ---- writing ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "options",
    [
        ExportOptions(keys=KeyChoice.REDUCED),
        ExportOptions(keys=KeyChoice.ARTIST),
        ExportOptions(smoothing=2.0, frame_offset=7),
    ],
    ids=["reduced", "artist", "smooth"],
)
def test_pictures_of_all_frames_are_those_of_each(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, options: ExportOptions
) -> None:
    """Keys are chosen once for all of them."""
    chosen: list[str] = []

    def counted(shape: RotoShape, *rest: Any) -> Reduction:
        chosen.append(shape.name)
        return reduced(shape, *rest)

    keys = [replace(key, origin=Origin.ENGINE if k % 2 else Origin.ARTIST) for k, key in enumerate(tracked("A").keys)]
    shape = replace(tracked("A"), keys=tuple(keys), feather=4.0)
    spline = control_points.with_spline(replace(animated("B"), id="b"), Spline.BSPLINE)
    project = Project(CLIP, Layer("root", "Root", (shape, spline)))
    alone = [svg_document(project, frame, options)[0] for frame in (1, 6, 14)]
    monkeypatch.setattr("roam_core.interchange.protocol.reduced", counted)
    notes = EXPORTERS["svg"].export(project, tmp_path / "p.####.svg", options)
    for frame, text in zip((1, 6, 14), alone, strict=True):
        name = f"p.{frame + options.frame_offset:04d}.svg"
        assert (tmp_path / name).read_text(encoding="utf-8") == text
    assert chosen == (["A", "B"] if options.keys is KeyChoice.REDUCED else [])
    assert len(notes) == len(set(notes))


def tracked(name: str) -> RotoShape:
    """The animated shape with a key on every frame."""
    shape = animated(name)
    keys = (Keyframe(frame, shape.at(frame).points) for frame in CLIP.frame_range)
    return replace(shape, keys=tuple(keys))


@pytest.mark.parametrize("frame", [1, 6, 11, 14])
def test_qt_paints_the_pixels_of_our_matte(frame: int) -> None:
    project = Project(CLIP, Layer("root", "Root", (bent_leaf(SIZE),)))
    theirs = qt_judge.painted(svg_document(project, frame)[0], SIZE)
    error = np.abs(theirs - render_matte(project, frame, SIZE[::-1]))
    assert error.max() < 0.2  # Qt's polygons are coarser than ours
    assert error.mean() < 0.001


def test_one_frame_is_written_or_every_frame_where_the_name_says_so(tmp_path: Path) -> None:
    project = Project(CLIP, Layer("root", "Root", (bent_leaf(SIZE),)))
    EXPORTERS["svg"].export(project, tmp_path / "one.svg", ExportOptions(frame=11))
    assert (tmp_path / "one.svg").read_text() == svg_document(project, 11)[0]
    told: list[float] = []
    options = ExportOptions(frame_offset=1000, progress=lambda share, _: told.append(share))
    EXPORTERS["svg"].export(project, tmp_path / "s.%05d.svg", options)
    names = sorted(path.name for path in tmp_path.glob("s.*"))
    assert names == [f"s.{frame:05d}.svg" for frame in range(1001, 1022)]
    assert told == sorted(told)


def test_layers_values_and_names_come_back(project: Project, tmp_path: Path) -> None:
    """What SVG has words for, in its words; the rest in attributes that other programs pass over."""
    back = read(svg_document(project, 1010)[0], tmp_path, project.require_clip()).layer
    for item, mine in zip(back.items(), project.root.items(), strict=True):
        assert (item.name, item.visible, item.locked, item.invert) == (
            mine.name,
            mine.visible,
            mine.locked,
            mine.invert,
        )
        assert item.opacity == pytest.approx(mine.opacity)
        if isinstance(mine, RotoShape):
            assert isinstance(item, RotoShape)
            assert (item.blend, item.closed) == (mine.blend, mine.closed)
            assert item.feather == pytest.approx(mine.feather)
            np.testing.assert_allclose(item.colour, mine.colour, atol=0.5 / 255)
            np.testing.assert_allclose(item.keys[0].points, mine.at(1010).points, atol=1e-5)


def test_names_come_back_but_for_what_xml_cannot_hold(tmp_path: Path) -> None:
    shapes = tuple(replace(animated("x"), id=f"shape-{k}", name=name) for k, name in enumerate(NAMES))
    text = svg_document(Project(CLIP, Layer("root", "Root", shapes)), 1001)[0]
    names = [shape.name for shape in read(text, tmp_path).layer.shapes()]
    assert names == [name.replace("\x00", "\ufffd").replace("\x1b", "\ufffd") for name in NAMES]


def test_what_is_lost_is_told(project: Project) -> None:
    notes = " ".join(svg_document(project, 1010)[1])
    for words in ("The feather curve of 'Soft' is written as outlines", "no shutter: that of 'Soft'"):
        assert words in notes
    assert svg_document(project, 1020)[1] == ("'Soft' does not exist on frame 1020: it is left out.",)


# ---- reading ---------------------------------------------------------------------------------------------------------

DRAWINGS = {
    "absolute": '<path d="M20 20 L 100,30 H150 V90 C 140 140 80 160 60,120 S 20 100 20 60 Z"/>',
    "relative": '<path d="m20 20 80 10h50v60c-10 50-70 70-90 30s-40-20-40-60z"/>',
    "quadratic": '<path d="M30,100 Q 60,20 100,100 T 170,100 t 60,10 L 200 170 q-60 20-100-10z"/>',
    "arcs": '<path d="M60 60 A 50 30 20 1 1 150 100 a30 60-15 0140 20 A 10 10 0 0 0 60 150 z"/>',
    "an arc too small to reach": '<path d="M40 100 A 5 9 30 0 1 200 120 L 100 180 Z"/>',
    "shapes": '<rect x="10" y="10" width="90" height="60"/><circle cx="200" cy="60" r="40"/>'
    '<ellipse cx="80" cy="140" rx="60" ry="30"/><polygon points="200,120 300,130 250,190"/>',
    "rounded": '<rect x="20" y="20" width="200" height="120" rx="40" ry="25"/>'
    '<rect x="240" y="20" width="60" height="120" rx="90"/>',
    "transforms": '<g transform="translate(40 10) rotate(12) scale(.8 1.1)"><g transform="skewX(10) skewY(-5)">'
    '<rect x="30" y="20" width="120" height="80" transform="rotate(30 90 60) matrix(1 .1 -.2 1 5 3)"/></g></g>',
    "a hole": '<path d="M20 20 H200 V180 H20 Z M60 60 V140 H160 V60 Z"/>',
    "islands that run against each other": '<path d="M20 20 H100 V180 H20 Z M120 60 V140 H220 V60 Z"/>',
    "an island in a hole": '<path d="M20 20 H300 V180 H20 Z M60 60 V140 H260 V60 Z M80 80 H200 V120 H80 Z"/>',
    "a hole between two cubics": '<path d="M20 20 H300 V180 H20 Z '
    'M60 100 C60 40 200 40 200 100 C200 160 60 160 60 100 Z"/>',
    "painted, not closed": '<path d="M20 20 H200 V180"/><polyline points="220 20 300 40 260 180"/>',
    "a switch": '<switch><g requiredExtensions="x"><rect width="300" height="180"/></g>'
    '<rect x="50" y="50" width="90" height="70"/><rect x="200" y="50" width="90" height="70"/></switch>',
    "even and odd": '<path fill-rule="evenodd" d="M20 20 H200 V180 H20 Z M60 60 H240 V140 H60 Z"/>',
    "two outlines": '<path d="M20 20 H100 V100 H20 Z m150 20 h80 v80 h-80 z"/>',
    "hidden": '<g style="display:none"><rect width="99" height="99"/></g><rect x="150" y="50" width="40" height="30"/>',
    "nested groups": '<a><switch><g><path d="M10,10h100v100h-100z"/></g></switch></a>',
}


@pytest.mark.parametrize("name", DRAWINGS)
def test_what_is_read_is_what_qt_paints(tmp_path: Path, name: str) -> None:
    text = drawing(DRAWINGS[name])
    read_back = read(text, tmp_path)
    theirs, ours = qt_judge.painted(text, SIZE), render_matte(read_back.layer, 1, SIZE[::-1])
    assert theirs.sum() > 500
    assert np.abs(theirs - ours).max() < 0.2
    assert np.abs(theirs - ours).mean() < 0.002
    assert read_back.notes == ()


TIED = {
    "a star": '<path fill-rule="evenodd" d="M160 10 L220 190 L60 80 H260 L100 190 Z"/>',
    "curves": '<path fill-rule="evenodd" '
    'd="M40 100 C60 -60 300 -40 200 120 S40 180 120 60 S300 60 280 150 S60 230 40 100 Z"/>',
    "a cubic that crosses itself": '<path fill-rule="evenodd" d="M60 180 C400 -60 -80 -60 260 180 Z"/>',
    "in small units": '<g transform="scale(300 180)"><polygon fill-rule="evenodd" '
    'points=".5,.05 .7,.95 .1,.4 .9,.4 .3,.95"/></g>',
    "two that cross each other, too": '<path style="fill-rule:evenodd" d="M160 10 L220 190 L60 80 H260 L100 190 Z '
    'M20 20 C300 20 20 180 300 180 C300 100 20 100 20 20"/>',
    "a clip path": '<clipPath id="c"><path clip-rule="evenodd" d="M160 10 L220 190 L60 80 H260 L100 190 Z"/></clipPath>'
    '<rect width="320" height="200" clip-path="url(#c)"/>',
    "two that run against each other": '<path d="M10 10H190V150H10Z M100 80V190H300V80Z"/>',
    "a hole that reaches out": '<path d="M10 10H190V150H10Z M100 40V90H300V40Z"/>',
    "holes that overlap": '<path d="M10 10H310V190H10Z M40 40C40 220 200 140 200 40Z M140 90V170H280V90Z"/>',
    "two that run alike": '<path d="M10 10H190V150H10Z M100 80H300V190H100Z"/>',
    "one that is filled wherever it winds": '<path d="M160 10 L220 190 L60 80 H260 L100 190 Z"/>',
}


@pytest.mark.parametrize("name", TIED)
def test_outlines_that_cross_are_filled_by_the_rule_of_their_path(tmp_path: Path, name: str) -> None:
    """Where edges cross, a difference of coverages is not exact."""
    pytest.importorskip("resvg_py", reason="resvg is the judge of SVG: install the extra dev")
    text = drawing(TIED[name])
    read_back = read(text, tmp_path)
    theirs, ours = svg_judge.matte(text, SIZE), render_matte(read_back.layer, 1, SIZE[::-1])
    assert theirs.sum() > 500
    assert (np.abs(theirs - ours) > 0.2).sum() < 12
    assert np.abs(theirs - ours).mean() < 0.002
    assert read_back.notes == ()


def test_outlines_that_run_alike_stay_as_they_were_drawn(tmp_path: Path) -> None:
    read_back = read(drawing(TIED["two that run alike"]), tmp_path)
    assert [shape.point_count for shape in read_back.layer.shapes()] == [4, 4]


def test_crossings_of_a_hostile_outline_are_counted(tmp_path: Path) -> None:
    """A thousand points anywhere cross each other some hundred thousand times."""
    places = " ".join(f"{x:.1f} {y:.1f}" for x, y in np.random.default_rng(3).uniform(0.0, 200.0, (1000, 2)))
    with pytest.raises(RoamError, match="parts"):
        read(drawing(f'<polygon fill-rule="evenodd" points="{places}"/>'), tmp_path)


def test_an_outline_that_does_not_cross_itself_stays_one_shape(tmp_path: Path) -> None:
    read_back = read(drawing('<path fill-rule="evenodd" d="M20 20 C60 -10 90 50 200 20 V180 H20 Z"/>'), tmp_path)
    (shape,) = read_back.layer.children
    assert isinstance(shape, RotoShape)
    assert shape.blend is BlendMode.ADD


@pytest.mark.parametrize("origin", ["140 110", "140px,110", "43.75% 55%"])
def test_transforms_act_about_their_origin(tmp_path: Path, origin: str) -> None:
    """Which Qt does not know."""
    rect = '<rect x="100" y="80" width="80" height="60" transform="{}"/>'
    theirs = read(drawing(rect.format("rotate(30 140 110)")), tmp_path).layer.shapes()
    text = drawing(rect.format(f'rotate(30)" transform-origin="{origin}'))
    for ours, their in zip(read(text, tmp_path).layer.shapes(), theirs, strict=True):
        np.testing.assert_allclose(ours.keys[0].points, their.keys[0].points)


@pytest.mark.parametrize(
    ("head", "corner", "scale"),
    [
        ('viewBox="0 0 160 100"', (0, 0), (2, 2)),
        ('viewBox="-10 -20 320 200"', (10, 20), (1, 1)),
        ('viewBox="0 0 100 100" preserveAspectRatio="none"', (0, 0), (3.2, 2)),
        ('viewBox="0 0 200 200"', (60, 0), (1, 1)),
        ('viewBox="0 0 200 200" preserveAspectRatio="xMinYMid meet"', (0, 0), (1, 1)),
        ('viewBox="0 0 320 100" preserveAspectRatio="xMidYMax"', (0, 100), (1, 1)),
        ('viewBox="0 0 200 200" preserveAspectRatio="xMaxYMid slice"', (0, -60), (1.6, 1.6)),
    ],
)
def test_the_view_box_is_fitted_into_the_picture(
    tmp_path: Path, head: str, corner: tuple[float, float], scale: tuple[float, float]
) -> None:
    text = drawing('<rect width="10" height="20"/>', f'width="320" height="200" {head}')
    (shape,) = read(text, tmp_path).layer.shapes()
    np.testing.assert_allclose(shape.keys[0].points[0, 0], corner)
    np.testing.assert_allclose(shape.keys[0].points[2, 0], np.array(corner) + np.array(scale) * (10, 20))


def test_drawings_of_another_size_are_scaled_to_the_clip(tmp_path: Path) -> None:
    made = read(drawing('<rect x="10" y="10" width="20" height="30"/>', 'width="160" height="100"'), tmp_path)
    (shape,) = made.layer.shapes()
    np.testing.assert_allclose(shape.keys[0].points[:, 0], [(20, 20), (60, 20), (60, 80), (20, 80)])
    assert "were scaled" in made.notes[0]


def test_a_drawing_that_differs_in_one_measure_is_scaled_too(tmp_path: Path) -> None:
    made = read(drawing('<rect x="10" y="10" width="20" height="30"/>', 'width="320" height="100"'), tmp_path)
    assert "were scaled" in made.notes[0]


@pytest.mark.parametrize(("width", "pixels"), [("1in", 96), ("2.54cm", 96), ("25.4mm", 96), ("72pt", 96), ("6pc", 96)])
def test_units_are_those_of_css(tmp_path: Path, width: str, pixels: float) -> None:
    (shape,) = read(drawing(f'<rect width="{width}" height="10%"/>'), tmp_path).layer.shapes()
    np.testing.assert_allclose(shape.keys[0].points[2, 0], (pixels, 20.0))


def test_names_colours_and_modes_are_found(tmp_path: Path) -> None:
    body = (
        '<g id="layer1"><title>Body</title><path id="p1" d="M0 0H9V9Z" style="fill:#336699;opacity:.5"/>'
        '<path id="p2" d="M0 0H9V9Z" fill="rgb(100%,0%,50%)" data-roam-blend="subtract" data-roam-invert="true"/></g>'
    )
    (layer,) = read(drawing(body), tmp_path).layer.children
    assert isinstance(layer, Layer)
    first, second = layer.shapes()
    assert (layer.name, first.name, second.name) == ("Body", "p1", "p2")
    np.testing.assert_allclose(first.colour, (0.2, 0.4, 0.6))
    np.testing.assert_allclose(second.colour, (1.0, 0.0, 0.5))
    assert (first.opacity, second.blend, second.invert) == (0.5, BlendMode.SUBTRACT, True)


def test_what_is_no_outline_is_named_and_the_rest_is_kept(tmp_path: Path) -> None:
    body = (
        '<use xlink:href="other.svg#x"/><text>Hello</text><image href="http://example.invalid/x.png"/>'
        '<defs><path d="M0 0H9V9Z"/></defs><path id="bad" d="M1 1 L 5 5 9 1 Z oops"/><path id="empty" d=""/>'
        '<path id="turned" transform="spin(3)" d="M0 0H9V9Z"/><path id="good" d="M0 0H9V9Z"/>'
    )
    made = read(drawing(body), tmp_path)
    assert [shape.name for shape in made.layer.shapes()] == ["bad", "good"]
    notes = " ".join(made.notes)
    for words in ("'Use' refers to lies in another", "'text'", "'image'", "'bad' is damaged", "'turned' was left out"):
        assert words in notes


def test_a_document_type_is_not_followed_and_entities_are_refused(tmp_path: Path) -> None:
    doctype = '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "file:///etc/passwd">'
    made = read(doctype + drawing('<rect width="9" height="9"/>'), tmp_path)
    assert len(list(made.layer.shapes())) == 1
    bomb = '<!DOCTYPE svg [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]>'
    with pytest.raises(RoamError, match="declares a document type or an entity"):
        read(bomb + drawing("<title>&b;</title>"), tmp_path)


ILLUSTRATOR = """<?xml version="1.0" encoding="utf-8"?>
<!-- Generator: Adobe Illustrator 19.0.0, SVG Export Plug-In . SVG Version: 6.00 Build 0)  -->
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd" [
\t<!ENTITY ns_extend "http://ns.adobe.com/Extensibility/1.0/">
\t<!ENTITY ns_svg 'http://www.w3.org/2000/svg'>
]>
<svg xmlns:x="&ns_extend;" xmlns="&ns_svg;" viewBox="0 0 100 100"><path id="Arm" d="M10,10h20v20h-20z"/></svg>
"""


def test_illustrators_abbreviated_addresses_are_written_out(tmp_path: Path) -> None:
    """It declares its namespaces by entities where a drawing is saved to be edited again."""
    for text in (ILLUSTRATOR, ILLUSTRATOR.replace("\n", "\r\n")):
        (shape,) = read(text, tmp_path).layer.shapes()
        assert shape.name == "Arm"


@pytest.mark.parametrize(
    "declared",
    [
        '<!ENTITY a "&b;">', '<!ENTITY a SYSTEM "file:///etc/hostname">', '<!ENTITY a "x&#34;y">', '<!ENTITY % a "b">',
        "<!ENTITY a '\"'>", '<!ENTITY a "<g/>">', f'<!ENTITY a "{"x" * 201}">', '<!ENTITY a "b"> <!ELEMENT svg ANY>',
    ],
)  # fmt: skip
def test_other_entities_stay_refused(declared: str, tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="declares a document type or an entity"):
        read(f"<!DOCTYPE svg [{declared}]>" + drawing("<title>&a;</title>"), tmp_path)


def test_addresses_that_would_make_a_drawing_too_large_stay_refused() -> None:
    text = f'<!DOCTYPE svg [<!ENTITY a "{"x" * 200}">]><svg>'.encode() + b"&a;" * 1000
    assert written_out(text, len(text) + 199_999) == text
    assert written_out(text, len(text) + 200_000) == b"<!DOCTYPE svg ><svg>" + b"x" * 200_000


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "no valid XML"),
        ("<svg", "no valid XML"),
        ("<html/>", r"no SVG picture \(its root element is 'html'\)"),
        (drawing("<g>" * 300 + "</g>" * 300), "more than 200 deep"),
    ],
)
def test_what_is_no_drawing_is_refused_in_a_sentence(tmp_path: Path, text: str, sentence: str) -> None:
    with pytest.raises(RoamError, match=sentence):
        read(text, tmp_path)


def test_absurd_numbers_leave_a_shape_out(tmp_path: Path) -> None:
    made = read(drawing('<path id="far" d="M0 0 H1e300 V1e308 Z"/><rect width="1e9999" height="9"/>'), tmp_path)
    assert list(made.layer.shapes()) == []
    assert "'far' was left out" in made.notes[0]


def test_open_shapes_keep_the_handles_of_their_ends(tmp_path: Path) -> None:
    shape = RotoShape("shape-1", "Open", (replace(animated("x").keys[0], points=points(7, 4)),), closed=False)
    text = svg_document(Project(CLIP, Layer("root", "Root", (shape,))), 1001)[0]
    (back,) = read(text, tmp_path).layer.shapes()
    np.testing.assert_allclose(back.keys[0].points, shape.keys[0].points, atol=1e-5)


def test_the_outlines_of_one_path_are_of_one_compound(tmp_path: Path) -> None:
    two = '<path d="M20 20 H100 V100 H20 Z m150 20 h80 v80 h-80 z"/>'
    body = f'{two}<rect width="9" height="9"/>{two}'
    shapes = read(drawing(body), tmp_path).layer.shapes()
    assert [shape.compound for shape in shapes] == ["compound-1", "compound-1", "", "compound-2", "compound-2"]
