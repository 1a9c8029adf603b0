"""No room of the engine holds a tuned number of its own: what tunes what comes out stands in `roam_core.params`."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import ROOT

ROOMS = (
    "appearance", "energy", "features", "geometry", "inference", "kernels", "landmarks", "motion",
    "proposal", "propagate",
)  # fmt: skip

NO_CHOICE = {
    # Numerical: what a rounding error is.
    "geometry/projective.py": {"HORIZON", "LEAST_DETERMINANT"},
    "inference/alternate.py": {"ENOUGH"},
    # Columns, labels and steps of a lattice.
    "geometry/bezier.py": {"ANCHOR", "IN", "OUT"},
    "proposal/segment/graph_cut.py": {"OFFSETS", "OUTSIDE", "INSIDE", "UNDECIDED", "PER_NAT", "MOST", "SWEEPS"},
    # Flows are integers of 32 bits (PER_NAT, MOST); rounds that decide cells beforehand (SWEEPS) change the time alone.
    # A law: a circle by cubics, half a pixel between two conventions, a mean, no colour in a picture of all colours.
    "geometry/primitives.py": {"QUARTER"},
    "features/grid.py": {"FROM_CENTRES", "TO_CENTRES"},
    "proposal/cues/label_propagation.py": {"MEAN"},
    "appearance/gmm.py": {"FLOOR"},
    # Made of parameters.
    "geometry/merging.py": {"STRAIGHT"},
    "proposal/mask_keys/anchors.py": {"CHOICES"},
    # A unit: what a field calls sure; all that reads one clips it there.
    "proposal/cues/evidence.py": {"SURE"},
    # Columns, labels, units and sizes of tables: of a histogram, of whole parts of a difference, of a digest.
    "kernels/posing.py": {"PIVOT_X", "PIVOT_Y", "PARENT", "ANGLE", "RIM"},
    "kernels/local_match.py": {"OUTSIDE", "INSIDE", "UNKNOWN", "PARTS", "FAR", "LANES"},
    "kernels/nearest_edges.py": {"FAR"},
    "kernels/colour_bins.py": {"BINS"},
    "kernels/keeping.py": {"DIGEST"},
    # Rounding, and bounds that change the time or keep a loop from going on for ever.
    "geometry/bspline.py": {"MOST_DENSE", "AT_ONCE", "FEW"},
    "kernels/alignment.py": {"BEAM", "ROUNDING"},
    "kernels/hypotheses.py": {"BLOCK"},
    "kernels/oblivious_trees.py": {"BLOCK"},
    "features/frame.py": {"BRIGHTEST", "DECODED_TOGETHER", "AS_THEY_ARE"},
    "motion/planar.py": {"BESIDE"},
    "kernels/flattening.py": {"MOST"},
    # How closely an error is measured, which is then compared with a tolerance that somebody chose.
    "kernels/coverage.py": {"SWEEP_STEP", "MOST_STEPS", "DUST"},
    "kernels/key_spans.py": {"RIDGE", "PARTS", "REACH"},
    "kernels/mask_fit.py": {"AROUND", "FINE"},
    # Another library's defect, that it dies of.
    "motion/flow.py": {"LEAST_SIDE"},
    # Bookkeeping: a revision, a length without meaning, what an explanation shows, how many results are kept.
    "propagate/shapes/provenance.py": {"REVISION", "MIN_POINTS"},
    "propagate/shapes/departed.py": {"NAMED"},
    "propagate/shapes/known_stamps.py": {"AT_ONE_TIME"},
    "propagate/engines/by_regions.py": {"BESIDE"},
}
"""By module the constants that are no choice, each with its reason above."""


def constants(path: Path) -> Iterator[str]:
    """The names in capitals to which a module gives a value that holds a number."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if not isinstance(node, ast.Assign | ast.AnnAssign) or node.value is None:
            continue
        targets = node.targets if isinstance(node, ast.Assign) else [node.target]
        names = [each.id for target in targets for each in ast.walk(target) if isinstance(each, ast.Name)]
        if any(is_number(each) for each in ast.walk(node.value)) or is_array(node.value):
            yield from (name for name in names if name.isupper())


def is_number(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and type(node.value) in (int, float)


def is_array(value: ast.expr) -> bool:
    """What NumPy makes of something: it is asked about, though no digit stands in it."""
    return isinstance(value, ast.Call) and ast.unparse(value.func).startswith("np.")


def modules(room: str) -> list[Path]:
    return sorted((ROOT / "roam_core" / room).rglob("*.py"))


@pytest.mark.parametrize("room", ROOMS)
def test_no_room_holds_a_tuned_number(room: str) -> None:
    for path in modules(room):
        name = path.relative_to(ROOT / "roam_core").as_posix()
        own = set(constants(path)) - EMPTY.get(name, set())
        assert own <= NO_CHOICE.get(name, set()), f"{name}: what tunes what comes out belongs into roam_core.params"


def test_the_list_names_nothing_that_is_gone() -> None:
    held = {
        path.relative_to(ROOT / "roam_core").as_posix(): set(constants(path))
        for room in ROOMS
        for path in modules(room)
    }
    assert {name: own - held.get(name, set()) for name, own in NO_CHOICE.items() if own - held.get(name, set())} == {}


EMPTY = {
    "motion/pose.py": {"NOTHING"},
    "landmarks/warp.py": {"NO_POINTS"},
    "energy/total.py": {"NO_MOVE"},
    "geometry/projective.py": {"IDENTITY"},
    "geometry/similarity.py": {"IDENTITY"},
}
"""Arrays that stand for nothing: no sight, no place, no move, no motion."""
