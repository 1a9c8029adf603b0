"""ObjectVerbs: what menus and keys do to objects: which shapes are solved as one, how they hang together and lie."""

from __future__ import annotations

from collections.abc import Callable, Collection

from roam_core.errors import RoamError
from roam_core.roto import Project, RotoShape, linking
from roam_core.roto.linking import AS_STACKED, BEHIND, IN_FRONT
from roam_core.translatable import sentence

from ...model.document import Document
from ...model.reasons import LOCKED_STAYS
from ...model.view_state import ViewState, selected_shapes
from ...translation import N_, sentence_of, tr
from .shapes import ALL_LOCKED, NOTHING_SELECTED

LEVELS = {IN_FRONT: N_("In front"), AS_STACKED: N_("As stacked"), BEHIND: N_("Behind")}
"""The levels of depth, the nearest first, as the window calls them."""
PLACES = {
    IN_FRONT: N_("in front of the others"),
    BEHIND: N_("behind the others"),
    AS_STACKED: N_("as stacked again"),
}
"""Where a shape lies, in a sentence."""
LIES_THERE = {
    IN_FRONT: N_("Nothing lies over what is selected from this frame on; it is in front already."),
    BEHIND: N_("Nothing lies under what is selected from this frame on; it is behind already."),
}
"""What is said of a level that would bring a shape past no other."""

Verb = Callable[[Project, Collection[str]], Project]


class ObjectVerbs:
    """The verbs on the selected shapes, those of selected layers among them; locked ones are left alone.

    Each is one undo step. What cannot be done is said in the status bar.
    """

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self._document, self._view = document, view_state

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "object.one": self.link,
            "object.parts": self.unlink,
            "object.apart": self.set_apart,
            "object.attach": lambda: self.attach(True),
            "object.detach": lambda: self.attach(False),
            "object.in_front": lambda: self.set_depth(IN_FRONT),
            "object.behind": lambda: self.set_depth(BEHIND),
            "object.as_stacked": lambda: self.set_depth(AS_STACKED),
        }

    def link(self, link: str = "") -> None:
        """Solve the selected shapes as one whole object: a new one, or the one of a link that is there."""
        self._edit(tr("Solve as one object"), lambda project, ids: linking.linked(project, ids, link))

    def unlink(self) -> None:
        """Leave it to the outlines again what the selected shapes belong to."""
        self._edit(tr("Solve as parts"), linking.unlinked)

    def set_apart(self) -> None:
        """Solve each of the selected shapes by itself."""
        self._edit(tr("Solve by itself"), linking.apart)

    def attach(self, on: bool) -> None:
        """Let the selected shapes hang on the parts that they overlap, or free them."""
        self._edit(
            tr("Attach to neighbours") if on else tr("Detach"), lambda project, ids: linking.attached(project, ids, on)
        )

    def set_depth(self, level: int) -> None:
        """Let the selected shapes lie in front, behind or as stacked, from this frame on.

        What would bring them past no other shape is left: the engine would have to solve anew for nothing.
        """
        frame = self._view.frame

        def lay(project: Project, ids: Collection[str]) -> Project:
            laid = linking.set_depth(project, ids, frame, level)
            if level in LIES_THERE and laid != project and linking.lie_alike(project, laid):
                raise RoamError(sentence(LIES_THERE[level]))
            return laid

        if names := self._edit(tr(LEVELS[level]), lay):
            where = tr(PLACES[level])
            one = tr("{name} lies {where} from frame {frame} on.", name=names[0], where=where, frame=frame)
            all_ = tr("{count} shapes lie {where} from frame {frame} on.", count=len(names), where=where, frame=frame)
            stays = f" {tr(LOCKED_STAYS)}" if len(names) < len(self._selected()) else ""
            self._view.say((one if len(names) == 1 else all_) + stays)

    def _edit(self, text: str, verb: Verb) -> list[str]:
        """Do it with the selected shapes that are not locked, and say so where some are.

        Gives the names of those that are not; none where nothing was done.
        """
        project, shapes = self._document.project, self._selected()
        free = [shape for shape in shapes if not project.is_locked(shape.id)]
        if not free:
            self._view.say_here(tr(ALL_LOCKED) if shapes else tr(NOTHING_SELECTED))
            return []
        try:
            edited = verb(project, [shape.id for shape in free])
        except RoamError as error:
            self._view.say(sentence_of(error))
            return []
        self._document.apply(text, edited)
        if len(free) < len(shapes):
            self._view.say(tr(LOCKED_STAYS))
        return [shape.name for shape in free]

    def _selected(self) -> list[RotoShape]:
        return selected_shapes(self._document.project, self._view.selection)
