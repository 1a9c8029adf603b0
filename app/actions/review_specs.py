"""The actions of reviewing: notes, lists, and what is written for others to look at."""

from __future__ import annotations

from ..translation import N_
from .spec import ActionSpec

REVIEW: tuple[ActionSpec, ...] = (
    ActionSpec("mark.toggle", N_("Mark frame"), icon="mark", tip=N_("Mark this frame, or take its mark away")),
    ActionSpec("mark.name", N_("Write note…"), tip=N_("Put a note on this frame's mark")),
    ActionSpec("time.previous_mark", N_("Previous note"), tip=N_("Go to the mark or note before this frame")),
    ActionSpec("time.next_mark", N_("Next note"), tip=N_("Go to the mark or note after this frame")),
    ActionSpec(
        "review.panel", N_("Notes and doubts"), tip=N_("Notes, doubtful frames and boil as a list"), checkable=True
    ),
    ActionSpec(
        "review.measure_boil",
        N_("Measure boil by the picture"),
        tip=N_("How much the shapes in hand jitter beyond the motion of the plate: for shapes that bend as they move"),
    ),
    ActionSpec("review.movie", N_("Movie…"), tip=N_("A movie or pictures of the outlines or the cut-out, to show")),
    ActionSpec("review.sheet", N_("Contact sheet…"), tip=N_("Pages of small pictures with frame numbers and notes")),
)
