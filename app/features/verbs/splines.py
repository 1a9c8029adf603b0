"""SplineVerbs: shapes made B-splines, and Beziers again."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from roam_core.roto import RotoShape, Spline, control_points

from ...model.document import Document
from ...model.reasons import why_not
from ...model.shown import editable_shapes
from ...model.view_state import ViewState
from ...translation import tr


class SplineVerbs:
    """The verbs on the selected shapes; locked and hidden ones are left alone. Each is one undo step."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self._document, self._view = document, view_state

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"shape.to_bezier": self.to_bezier, "shape.to_bspline": self.to_bspline}

    def to_bezier(self) -> None:
        """Give the selected B-splines anchors and handles; no outline changes."""
        self._turn(
            Spline.BEZIER, tr("Make Bezier"), lambda *_: tr("handles shape the curve now, and no outline changed")
        )

    def to_bspline(self) -> None:
        """Give the selected shapes control points in place of their points; says by how much outlines moved."""

        def told(before: RotoShape, after: RotoShape) -> str:
            were, are = (np.stack([key.points for key in shape.keys]) for shape in (before, after))
            moved = np.abs(are - were).max()
            return tr(
                "its curve is smooth everywhere now, and its points moved by up to {moved:.1f} pixels", moved=moved
            )

        self._turn(Spline.BSPLINE, tr("Make B-spline"), told)

    def _turn(self, spline: Spline, text: str, told: Callable[[RotoShape, RotoShape], str]) -> None:
        project, chosen = self._document.project, self._view.selection.shapes
        shapes = [
            shape for shape in editable_shapes(self._view.solo.seen(project), self._view.frame) if shape.id in chosen
        ]
        turning = [shape for shape in shapes if shape.spline is not spline]
        if not turning:
            already = tr("The selected shapes are Bezier already.")
            if spline is Spline.BSPLINE:
                already = tr("The selected shapes are B-spline already.")
            self._view.say_here(already if shapes else why_not(project, self._view))
            return
        turned = [control_points.with_spline(shape, spline) for shape in turning]
        self._document.apply(text, project.with_shapes(turned))
        # Points of one kind are not those of the other.
        self._view.select(chosen)
        said = f"{turning[0].name}: {told(turning[0], turned[0])}."
        self._view.say(
            said if len(turned) == 1 else tr("{count} shapes changed. {sentence}", count=len(turned), sentence=said)
        )
