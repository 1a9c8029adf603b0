"""What the engine proposes and the artist answers: which offers stand, taking and refusing them, always, never."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum

from PySide6.QtCore import QObject, Signal

from roam_core.propagate.frame.result import FrameResult
from roam_core.propagate.frame.topology_proposals import Proposal
from roam_core.propagate.shapes.provenance import is_stale
from roam_core.proposal.reshaping.topology import TopologyKind
from roam_core.roto import Keyframe

from ..jobs.propagation import Propagation
from ..model.document import Document
from ..model.view_state import ViewState, selected_shapes
from ..translation import N_, number, tr

Place = tuple[str, int]
"""A shape's id and a frame."""

NONE_LEFT = N_("No proposal waits for an answer.")
OUT_OF_SIGHT = N_("Proposals wait for shapes that are not shown while others are soloed; <shape.solo> shows all.")
NOTHING_SELECTED = N_("Select the shapes first that you want to be asked about again.")


class Answer(StrEnum):
    """What an artist has said of all proposals for a shape."""

    ALWAYS = "always"
    NEVER = "never"


@dataclass(frozen=True)
class Offer:
    """A proposal, the tracked key that it was made for, and the direction of the run."""

    proposal: Proposal
    key: Keyframe
    step: int


class Proposals(QObject):
    """Collects the proposals of runs. An offer stands while the tracked key that it was made for does.

    The artist is asked about what is shown: while shapes are soloed, about these alone.

    An object that stays in parts is offered again on every frame: such a stretch of frames is one question.

    Signals
    -------
    changed() : another proposal may stand on the present frame.
    """

    changed = Signal()

    def __init__(
        self, document: Document, view_state: ViewState, propagation: Propagation, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._propagation = document, view_state, propagation
        self._offers: dict[Place, Offer] = {}
        self._path, self._begun = document.path, document.begun
        self.answers: dict[str, dict[str, str]] = {}
        """What was answered for good, by the project's file (empty: not saved yet) and the shape's id."""
        propagation.solved.connect(self.take)
        document.changed.connect(lambda _ids: self.changed.emit())
        document.replaced.connect(self._begin_anew)
        document.path_changed.connect(self._follow_path)
        view_state.frame_changed.connect(self.changed)
        view_state.solo.changed.connect(self.changed)

    def remembered(self) -> dict[str, dict[str, str]]:
        """What was answered for good for projects that have a file, to be kept."""
        return {path: own for path, own in self.answers.items() if path and own}

    def recall(self, kept: Mapping[str, Mapping[str, str]]) -> None:
        """Take back what `remembered` gave."""
        self.answers.update({path: dict(own) for path, own in kept.items()})

    # ---- what stands

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "proposal.next": self.next,
            "proposal.keep": self.keep,
            "proposal.refuse": self.refuse,
            "proposal.keep_always": self.keep_always,
            "proposal.refuse_always": self.refuse_always,
            "proposal.ask_again": self.ask_again,
        }

    @property
    def current(self) -> Proposal | None:
        """The proposal on the present frame, that of the greatest gain where there are several."""
        offer = self._current()
        return None if offer is None else offer.proposal

    @property
    def frames(self) -> list[int]:
        """The frames on which the artist is asked: where each stretch begins, in the direction of its run."""
        left_out = self._left_out()
        standing = {
            place: offer for place, offer in self._offers.items() if place[0] not in left_out and self._stands(place)
        }
        return sorted(
            {
                frame
                for (shape_id, frame), offer in standing.items()
                if not _is_same(offer, standing.get((shape_id, frame - offer.step)))
            }
        )

    def take(self, result: FrameResult, step: int) -> None:
        """Note what a solved frame brought; what is always wanted is done at once, and the run goes on from there."""
        wanted: list[Offer] = []
        for each in result.results:
            self._offers.pop((each.shape.id, result.frame), None)
            answer = self.answer(each.shape.id)
            if each.key is None or not each.proposals or answer is Answer.NEVER:
                continue
            offer = Offer(each.proposals[0], each.key, step)
            if answer is Answer.ALWAYS:
                wanted.append(offer)
            else:
                self._offers[each.shape.id, result.frame] = offer
        if wanted:
            self._do_at_once(wanted, result.frame)
        self.changed.emit()

    # ---- what the artist says

    def keep(self) -> None:
        """Make the proposed change, as the artist's keys."""
        if (offer := self._current()) is not None:
            project, ids = offer.proposal.accepted(self._document.project, offer.step)
            self._document.apply(_title(offer.proposal), project)
            self._view.select(frozenset(ids))
            key = "<track.forward>" if offer.step > 0 else "<track.backward>"
            self._view.say_here(tr("Kept: it is yours now. {key} tracks on from here.", key=key))

    def refuse(self) -> None:
        """Leave the shape as it is; the frames around, on which the same is proposed, are not asked about either."""
        if (offer := self._current()) is not None:
            shape_id, frame = offer.proposal.before[0].id, offer.proposal.frame
            for way in (1, -1):
                place = shape_id, frame + way
                while _is_same(offer, self._offers.get(place)):
                    del self._offers[place]
                    place = shape_id, place[1] + way
            del self._offers[shape_id, frame]
            self.changed.emit()
            self._view.say(self.told(tr("Left as it is.")))  # how many wait was told before

    def keep_always(self) -> None:
        """Make the change, and from now on every one that is proposed for this shape."""
        self._answer_for_good(Answer.ALWAYS)
        self.keep()

    def refuse_always(self) -> None:
        """Refuse, and be asked no more about this shape."""
        self._answer_for_good(Answer.NEVER)
        self.refuse()

    def ask_again(self) -> None:
        """Forget what was answered for good, for the selected shapes."""
        shapes = selected_shapes(self._document.project, self._view.selection)
        for shape in shapes:
            self._own_answers().pop(shape.id, None)
        names = ", ".join(shape.name for shape in shapes)
        self._view.say(tr("You will be asked about {names} again.", names=names) if shapes else tr(NOTHING_SELECTED))

    def next(self) -> None:
        """Go to the next frame with a question, from the last one to the first."""
        frames = self.frames
        if frames:
            self._view.set_frame(next((frame for frame in frames if frame > self._view.frame), frames[0]))
        else:
            self._view.say(tr(OUT_OF_SIGHT if self._waits_out_of_sight() else NONE_LEFT))

    def answer(self, shape_id: str) -> Answer | None:
        """What was answered for good about a shape."""
        word = self._own_answers().get(shape_id)
        return Answer(word) if word in set(Answer) else None

    def told(self, sentence: str) -> str:
        """The closing sentence of a run, with the questions that wait."""
        count = len(self.frames)
        if count:
            waiting = tr("%n proposal(s) to answer: <proposal.next> goes there.", "", count)
        elif self._waits_out_of_sight():
            waiting = tr(OUT_OF_SIGHT)
        else:
            return sentence
        return f"{sentence} {waiting}".lstrip()

    # ---- the rest is private

    def _current(self) -> Offer | None:
        frame, left_out = self._view.frame, self._left_out()
        standing = [
            offer
            for place, offer in self._offers.items()
            if place[1] == frame and place[0] not in left_out and self._stands(place)
        ]
        return max(standing, key=lambda offer: offer.proposal.gain, default=None)

    def _left_out(self) -> frozenset[str]:
        """The shapes about which nothing is asked now; none are without offers."""
        return self._view.solo.left_out(self._document.project) if self._offers else frozenset()

    def _waits_out_of_sight(self) -> bool:
        left_out = self._left_out()
        return any(place[0] in left_out and self._stands(place) for place in self._offers)

    def _stands(self, place: Place) -> bool:
        """True while the shape is on the frame as it was tracked, from keys that have not changed, and not locked."""
        offer, project = self._offers[place], self._document.project
        if not project.has(place[0]) or project.is_locked(place[0]):
            return False
        shape = project.shape(place[0])
        return shape.key_at(place[1]) is offer.key and not is_stale(shape, offer.key, project.clip, project.shapes)

    def _do_at_once(self, wanted: list[Offer], frame: int) -> None:
        project = self._document.project
        more: list[str] = []
        for offer in wanted:
            project, ids = offer.proposal.accepted(project, offer.step)
            more += ids[1:]
        self._propagation.go_on_from(project, frame, more)

    def _answer_for_good(self, answer: Answer) -> None:
        if (offer := self._current()) is not None:
            self._own_answers()[offer.proposal.before[0].id] = answer.value

    def _own_answers(self) -> dict[str, str]:
        return self.answers.setdefault(_name(self._path), {})

    def _begin_anew(self) -> None:
        """Another project: its file has answers of its own. One with another clip is the same."""
        self._offers.clear()
        is_other, self._begun = self._document.begun != self._begun, self._document.begun
        self._path = self._document.path
        if self._path is None and is_other:
            self.answers.pop("", None)
        self.changed.emit()

    def _follow_path(self) -> None:
        """Saved under another name: the answers go along."""
        if self._document.path != self._path:
            own, self._path = self._own_answers(), self._document.path
            self.answers[_name(self._path)] = dict(own)


def sentence_of(proposal: Proposal) -> str:
    """What is proposed, for the artist's eye."""
    name = proposal.before[0].name
    if proposal.kind is TopologyKind.DROP:
        what = tr("Drop the part that came off {name}?", name=name)
    else:
        what = tr("Split {name} into {count} shapes?", name=name, count=len(proposal.after))
    return tr("{what}  The energy falls by {figures}.", what=what, figures=_figures(proposal.gain))


def _title(proposal: Proposal) -> str:
    return tr("Split shape") if proposal.kind is TopologyKind.SPLIT else tr("Drop part")


def _name(path: object) -> str:
    return "" if path is None else str(path)


def _is_same(offer: Offer, other: Offer | None) -> bool:
    """True for two offers that ask the same question on two frames of one run."""
    return other is not None and (other.proposal.kind, other.step) == (offer.proposal.kind, offer.step)


def _figures(gain: float) -> str:
    """A gain in three figures, written out."""
    return number(gain, ".0f" if abs(gain) >= 100 else ".3g")
