"""How keys of `.fxs` files go on to the next: a hold in any letters, and what is taken for linear is told."""

from __future__ import annotations

from pathlib import Path

import pytest

from roam_core.interchange import Imported, read_shapes
from roam_core.roto import Clip, Interpolation

CLIP = Clip(Path("plate"), 1001, 1040, (200, 100))


def made_of(folder: Path, *names: str, path: str = "linear", opacity: str = "linear", count: int = 2) -> Imported:
    """Shapes with `count` keys of their outlines and opacities, which go on as these words say."""
    outlines = (
        f"""<Key frame="{10 * k}" interp="{path}"><Path closed="True" type="Bezier">"""
        + "".join(f"<Point>{','.join([f'({x + 0.1 * k},{y})'] * 3)}</Point>" for x, y in ((0, 0), (0.3, 0), (0.3, 0.2)))
        + "</Path></Key>"
        for k in range(count)
    )
    values = (f"""<Key frame="{10 * k}" interp="{opacity}">{20 + 60 * k}</Key>""" for k in range(count))
    inside = (
        f"""<Property id="path">{"".join(outlines)}</Property><Property id="opacity">{"".join(values)}</Property>"""
    )
    shapes = (
        f"""<Shape type="Shape" label="{name}" shape_type="Bezier"><Properties>{inside}</Properties></Shape>"""
        for name in names
    )
    file = folder / "a.fxs"
    head = """<Silhouette width="200" height="100" pixelAspect="1" sessionStartFrame="1001">"""
    file.write_text(f"{head}{''.join(shapes)}</Silhouette>")
    return read_shapes(file, CLIP)


@pytest.mark.parametrize("word", ["HOLD", "Hold", " hold "])
def test_a_hold_is_one_in_any_letters(word: str, tmp_path: Path) -> None:
    imported = made_of(tmp_path, "A", path=word, opacity=word)
    (shape,) = imported.layer.shapes()
    assert shape.keys[0].interpolation is Interpolation.HOLD
    assert shape.opacity_at(1009) == pytest.approx(0.2)
    assert imported.notes == ()


def test_keys_that_are_taken_for_linear_are_told_once(tmp_path: Path) -> None:
    imported = made_of(tmp_path, "A", "B", path="Ease", opacity="bezier")
    shape, _ = imported.layer.shapes()
    assert shape.keys[0].interpolation is Interpolation.LINEAR
    (note,) = imported.notes
    assert note.startswith("The shape 'A': keys of the kind 'bezier', 'ease' were read as linear.")
    assert "'B'" in note


@pytest.mark.parametrize(("word", "count"), [("linear", 2), ("catmullrom", 2), ("ease", 1)])
def test_what_is_known_or_goes_on_to_no_key_is_not(word: str, count: int, tmp_path: Path) -> None:
    assert made_of(tmp_path, "A", path=word, opacity=word, count=count).notes == ()
