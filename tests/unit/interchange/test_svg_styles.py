"""SVG in: style sheets, clip paths, masks, repetitions, sizes; what is read is compared with what resvg paints."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.interchange import Imported, read_shapes
from roam_core.matte import render_matte
from roam_core.roto import Clip
from tests.judges import svg as judge

SIZE = (640, 400)
CLIP = Clip(Path("plate"), 1, 21, SIZE)
DISC = '<circle id="k" cx="250" cy="200" r="120"/>'
BAR = '<rect x="200" y="100" width="300" height="180" transform="rotate(10)"/>'
SHEET = ".a,.b{clip-path:url(#c)} .b>rect{display:none} g .z{opacity:.6} /* { */ @media print{g{opacity:0}}"

DRAWINGS = {
    "clip path": f'<clipPath id="c">{DISC}</clipPath><g clip-path="url(#c)">{BAR}<path d="M0 150H99V160H0"/></g>',
    "clip path of several outlines": f'<clipPath id="c">{DISC}<path clip-rule="evenodd" d="M300 50H600V350H300Z'
    'M350 100H550V300H350Z"/></clipPath><path clip-path="url(#c)" d="M100 90H620V210H100Z"/>',
    "clip path in clip path": f'<clipPath id="c">{DISC}</clipPath><clipPath id="e">{BAR}</clipPath>'
    '<g clip-path="url(#c)"><g clip-path="url(#e)"><rect width="640" height="400"/></g></g>',
    "sheet": f'<style>{SHEET}</style><defs>{DISC}</defs><clipPath id="c" transform="translate(30,0)">'
    f'<use xlink:href="#k"/></clipPath><g class="a">{BAR}</g><g class="b"><rect width="640" height="400"/>'
    '<g><rect class="z" x="10" y="150" width="200" height="60"/></g></g>',
    "luminance mask": f'<mask id="m"><g fill="white">{DISC}</g><circle cx="250" cy="200" r="50"/></mask>'
    f'<g mask="url(#m)">{BAR}</g>',
    "knock-out": '<mask id="m" maskUnits="userSpaceOnUse" x="0" y="0" width="640" height="400">'
    f'<rect width="640" height="400" fill="#fff"/>{DISC}</mask><g mask="url(#m)">{BAR}</g>',
    "alpha mask": f'<mask id="m" style="mask-type:alpha">{DISC}</mask><g mask="url(#m)">{BAR}</g>',
    "use": f'<defs><g id="g">{DISC}<rect x="10" width="50" height="60"/></g><symbol id="s" viewBox="0 0 100 100">'
    '<circle cx="50" cy="50" r="50"/></symbol></defs><use href="#g" x="100" y="20"/>'
    '<use href="#s" x="400" y="200" width="200" height="150" opacity=".9"/>'
    '<use xlink:href="#g" transform="scale(.3)"/>',
    "picture in picture": '<svg x="100" y="50" width="300" height="200" viewBox="0 0 100 100"><circle cx="50" cy="50" '
    'r="50"/></svg>',
    "important rules": "<style>.a{display:inline!important} .b{display:none !important}</style>"
    '<rect class="a" style="display:none" x="20" y="30" width="200" height="150"/>'
    '<rect class="b" style="display:inline" x="320" y="30" width="200" height="150"/>',
    "turned arcs": '<path d="M100 150A120 50 30 1 1 300 160Z"/><path d="M400 300a60 90-40 0 0 120-80L520 350z"/>'
    '<path d="M350 60A10 4 70 0 1 420 90Z"/>',
    "visibility": f'<g visibility="hidden">{DISC}<rect visibility="visible" x="300" y="200" '
    'width="90" height="90"/></g>',
    "a frame that nothing is seen of": f'<path d="M0 0h640v400H0z" fill="none"/>{DISC}<g fill="none">'
    '<rect fill="inherit" width="640" height="400"/></g><rect fill="transparent" width="640" height="400"/>',
    "paint that is transparent": '<rect x="20" y="30" width="200" height="150" fill="rgba(255, 0, 0, .8)"/>'
    '<rect x="20" y="200" width="200" height="150" fill="#f00c"/>'
    '<rect x="320" y="200" width="200" height="150" fill="#00ff00f0" fill-opacity=".8"/>',
    "traced": '<g transform="translate(0,400) scale(0.1,-0.1)" fill="#000000" stroke="none"><path d="M1000 3000 c500 0 '
    "800 -200 800 -700 0 -600 -400 -900 -900 -900 -400 0 -700 300 -700 800 0 500 300 800 800 800z M1000 2600 c-300 0 "
    '-400 -200 -400 -400 0 -300 200 -400 400 -400 200 0 400 200 400 400 0 200 -100 400 -400 400z"/></g>',
}


def drawing(body: str, head: str = 'width="640" height="400"') -> str:
    return f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" {head}>{body}</svg>'


def read(text: str, folder: Path) -> Imported:
    path = folder / "drawing.svg"
    path.write_text(text, encoding="utf-8")
    return read_shapes(path, CLIP)


@pytest.mark.parametrize("name", DRAWINGS)
def test_what_is_read_is_what_resvg_paints(tmp_path: Path, name: str) -> None:
    pytest.importorskip("resvg_py", reason="resvg is the judge of SVG: install the extra dev")
    made = read(drawing(DRAWINGS[name]), tmp_path)
    ours, theirs = render_matte(made.layer, 1, SIZE[::-1]), judge.matte(drawing(DRAWINGS[name]), SIZE, 3)
    assert theirs.sum() > 500
    assert np.abs(ours - theirs).mean() < 0.0005
    inside, painted = ours > 0.5, theirs > 0.5
    assert (inside & painted).sum() / (inside | painted).sum() > 0.998
    assert made.notes == (("Style rules with '@media' were left out.",) if name == "sheet" else ())


def test_a_clip_path_round_the_whole_picture_is_none(tmp_path: Path) -> None:
    body = (
        '<g clip-path="url(#c)"><rect width="9" height="9"/></g><defs><clipPath id="c"><rect width="640" height="400"/>'
    )
    made = read(drawing(body + "</clipPath></defs>"), tmp_path)
    assert [shape.name for shape in made.layer.shapes()] == ["Rect"]


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ('<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>', "refers to itself"),
        ('<use id="q" href="#nobody"/>', "'q' refers to ('nobody') is not in the drawing"),
        ('<rect id="q" width="9" height="9" filter="url(#f)"/>', "The filter of 'q' was left out"),
        ('<rect id="q" width="9" height="9" clip-path="circle(40%)"/>', "The clip path of 'q' is no outline"),
        ("<style>a:hover{fill:red}</style>", "The style rule for 'a:hover' was not understood"),
        ('<path d="M0 0H9V9" fill="none" stroke="red"/>', "1 of the outlines are drawn as lines only"),
        (
            '<svg id="q" x="9" y="9" width="90" height="90" viewBox="0 0 10 10"><rect width="20" height="5"/></svg>',
            "The frame of 'q' was left out",
        ),
        (
            '<mask id="m" maskUnits="userSpaceOnUse" width="60" height="60"><rect width="90" height="9" fill="white"/>'
            '</mask><rect id="q" width="99" height="99" mask="url(#m)"/>',
            "The frame of the mask of 'q' was left out",
        ),
        (
            '<clipPath id="c" clipPathUnits="objectBoundingBox"><rect width="1" height="1"/></clipPath>'
            '<rect id="q" width="9" height="9" clip-path="url(#c)"/>',
            "The clip path of 'q' is given in shares of its box",
        ),
    ],
)
def test_what_is_not_read_is_named(tmp_path: Path, body: str, words: str) -> None:
    assert words in " ".join(read(drawing(body), tmp_path).notes)


@pytest.mark.parametrize(
    ("head", "notes"),
    [
        ('width="192mm" height="120mm" viewBox="0 0 640 400"', ()),
        ('width="169.3333333mm" height="105.8333333mm"', ()),
        ('width="100%" height="100%" viewBox="0 0 640 400"', ()),
        (
            'width="210mm" height="131.25mm" viewBox="0 0 210 131.25"',
            ("The drawing measures 210mm x 131.25mm: it was fitted to the clip's 640 x 400 pixels.",),
        ),
        (
            'width="320" height="100"',
            (
                "The file speaks of pictures of 320 x 100 pixels, the clip has 640 x 400: the shapes were scaled, each "
                "axis by its own ratio.",
            ),
        ),
    ],
)
def test_sizes_are_told_truly(tmp_path: Path, head: str, notes: tuple[str, ...]) -> None:
    assert read(drawing('<rect width="9" height="9"/>', head), tmp_path).notes == notes


@pytest.mark.parametrize(
    ("element", "name"),
    [
        ('<rect id="Body_x20_left" width="9" height="9"/>', "Body left"),
        ('<rect id="a" data-name="Ärmel" width="9" height="9"/>', "Ärmel"),
    ],
)
def test_names_are_read_as_drawing_programs_write_them(tmp_path: Path, element: str, name: str) -> None:
    assert [shape.name for shape in read(drawing(element), tmp_path).layer.shapes()] == [name]


def test_the_stronger_rule_counts(tmp_path: Path) -> None:
    sheet = "<style>rect{opacity:.1} g rect.x{opacity:.2} #q{opacity:.3} .x{opacity:.4} *{opacity:.5}</style>"
    body = f'{sheet}<g><rect id="q" class="x" width="9" height="9"/><rect class="x" width="9" height="9"/></g>'
    body += '<rect width="9" height="9"/><rect id="s" width="9" height="9" style="opacity:.6;fill:red"/>'
    shapes = list(read(drawing(body), tmp_path).layer.shapes())
    assert [shape.opacity for shape in shapes] == [0.3, 0.2, 0.1, 0.6]
    assert shapes[3].colour == (1.0, 0.0, 0.0)


def bomb(leaf: str) -> str:
    """Groups that repeat the one before ten times, eleven deep."""
    steps = "".join(f'<g id="u{k}">' + f'<use href="#u{k - 1}"/>' * 10 + "</g>" for k in range(1, 12))
    return drawing(f'<defs>{leaf}{steps}</defs><use href="#u11"/>')


@pytest.mark.parametrize(
    "text",
    [
        bomb('<rect id="u0" width="9" height="9"/>'),
        bomb('<g id="u0"/>'),
        drawing(f"<style>{'*{fill:red}' * 100_000}</style>" + '<rect width="9" height="9"/>' * 2000),
        drawing(f"<style>{'a,' * 3_000_000}{{fill:red}}</style>"),
        drawing(f'<rect style="{"fill:red;" * 1_500_000}"/>'),
        drawing(f'<style>.q{{fill:red}}</style><rect class="{"q " * 5_000_000}"/>'),
    ],
    ids=["use", "use of nothing", "rules", "selectors", "style", "classes"],
)
def test_what_grows_without_end_is_refused(tmp_path: Path, text: str) -> None:
    with pytest.raises(RoamError, match="holds more than"):
        read(text, tmp_path)
