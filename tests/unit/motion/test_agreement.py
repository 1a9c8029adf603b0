"""What two keys say of a part's look together: what hid it on one of them is left out."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.features import PreparedFrame
from roam_core.features.pyramid import Pyramid
from roam_core.geometry.bezier import polygon_points
from roam_core.motion.agreement import Drawn, agreed, looking_as_on
from roam_core.motion.template import Template
from roam_core.params import PyramidParams
from tests.golden.shots import texture
from tests.unit.motion.test_pose import BACKGROUND, BODY, PARAMS, WHOLE, box, centres, polyline_mask

CORNERS = np.array([(40.0, 40.0), (110.0, 40.0), (110.0, 70.0), (40.0, 70.0)])
LINE = box(40, 40, 70, 30)
MOVED = np.array([12.0, 9.0])
OCCLUDER = texture(9, 0.0, 1.0, 12)


def picture(moved: Array, cover: Array | None) -> PreparedFrame:
    """The part where it has `moved` to, with something before it that was not drawn."""
    places = centres()
    image = np.where(polyline_mask(places - moved, LINE)[..., None], BODY.at(places - moved), BACKGROUND.at(places))
    if cover is not None:
        image = np.where(polyline_mask(places, cover)[..., None], OCCLUDER.at(places), image)
    return PreparedFrame(np.round(255.0 * image).astype(np.uint8))


def outline(moved: Array) -> Array:
    return polygon_points(CORNERS + moved)


def key(moved: Array, cover: Array | None) -> Drawn:
    pyramid = Pyramid.of(picture(moved, cover), WHOLE, 1.0, PyramidParams())
    template = Template.of(pyramid, LINE + moved, PARAMS, 1.0)
    assert template is not None
    return Drawn(template, outline(moved))


def own(template: Template) -> Array:
    return template.levels[0].places[template.levels[0].weights > 0]


def test_what_hides_the_part_on_one_key_is_left_out_of_both_looks() -> None:
    hidden = box(30, 30, 40, 50)  # of the 70 pixels of its length 30
    first, last = key(np.zeros(2), hidden), key(MOVED, None)
    ours, theirs = agreed(first, last)
    for template, moved in ((ours, np.zeros(2)), (theirs, MOVED)):
        left = polyline_mask(own(template) - moved, hidden)
        assert np.count_nonzero(left) < 0.1 * len(left)
        assert np.count_nonzero(~left) > 0.9 * 600 * 4 / 7
        weights = template.levels[0].weights
        np.testing.assert_allclose(weights[weights > 0].sum(), 1.0)


def test_a_part_that_is_seen_on_both_keys_keeps_its_look() -> None:
    first, last = key(np.zeros(2), None), key(MOVED, None)
    for ours, before in zip(agreed(first, last), (first, last), strict=True):
        assert len(own(ours)) > 0.9 * len(own(before.template))


def test_where_little_is_alike_it_may_be_by_chance_and_nothing_is_left_out() -> None:
    first, last = key(np.zeros(2), box(20, 20, 72, 70)), key(MOVED, None)
    assert agreed(first, last) == (first.template, last.template)


def test_the_look_of_a_key_on_another_is_that_of_the_part_though_it_is_hidden_there() -> None:
    seen, hidden = key(np.zeros(2), None), key(MOVED, box(20, 20, 130, 90))
    borrowed = looking_as_on(hidden, seen)
    places, colours = own(borrowed), borrowed.levels[0].colours[borrowed.levels[0].weights > 0]
    np.testing.assert_allclose(places, own(seen.template) + MOVED, atol=0.01)
    np.testing.assert_array_equal(colours, seen.template.levels[0].colours[seen.template.levels[0].weights > 0])
    assert borrowed.chain is hidden.template.chain
    fast = borrowed.chain.rest + 30.0
    assert borrowed.blurred(borrowed.chain.rest, fast) is borrowed
    assert seen.template.blurred(seen.template.chain.rest, fast) is not seen.template
