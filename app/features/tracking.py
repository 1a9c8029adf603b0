"""What the track buttons and keys mean: which shapes, from which frame to which, and where the doubtful frames are."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from enum import StrEnum
from functools import partial

from roam_core.dials import name_of
from roam_core.params import DEFAULT_CONFIG, departed, is_doubtful
from roam_core.propagate.shapes.gaps import Gap, gaps_of
from roam_core.propagate.shapes.provenance import MIN_POINTS, known_params
from roam_core.propagate.shapes.taking_part import has_begun
from roam_core.review.findings import Finding, boiling_frames, worst_of_stretches
from roam_core.roto import Layer, Project, RotoShape

from ..jobs.propagation import Propagation
from ..model.document import Document
from ..model.reasons import does_not_exist
from ..model.view_state import ViewState, shapes_in_hand
from ..translation import N_, tr
from .boil import boil_of_document
from .navigation import clip_frames

NO_CLIP = N_("Open a clip first: drop a folder of images or a movie on the window.")
NO_GAP = N_("There is no gap to fill here: set a key (<key.set>) on two frames, with others between them.")
NO_GAP_WITHIN = N_("No gap lies wholly between in and out; <time.clear_range> clears them.")
CLIP_ENDS = N_("The clip ends here: there is no frame to track to.")
CLIP_BEGINS = N_("The clip begins here: there is no frame to track to.")
OUT_IS_HERE = N_("The out point is here: move it, or clear in and out (<time.clear_range>), to track on.")
IN_IS_HERE = N_("The in point is here: move it, or clear in and out (<time.clear_range>), to track on.")
FIRST_KEY, LAST_KEY = (
    N_("{name} is not tracked: its first key lies on frame {key}. Track from there, or set a key here (<key.set>)."),
    N_("{name} is not tracked: its last key lies on frame {key}. Track from there, or set a key here (<key.set>)."),
)
NO_PICTURE = N_(
    "{name} is not tracked: the plate has no picture of frame {key}, where its key lies. "
    "Set one where it has (<key.set>)."
)
NO_SHAPE = N_("Draw a shape first: press <tool.bezier> in the viewer.")


class Scope(StrEnum):
    """Which shapes a run takes."""

    SELECTED = "selected"
    ALONE = "alone"
    ALL = "all"


def last_to_track(view_state: ViewState, clip: range, step: int) -> int:
    """The last frame of a run from the playhead: the end of the play range, beyond that of the clip."""
    first, stop = view_state.play_range
    (within, whole) = (stop - 1, clip[-1]) if step > 0 else (first, clip[0])
    return within if (within - view_state.frame) * step >= 0 else whole


def why_not_on(clip: range, frames: range) -> str:
    """Why a run over `frames`, which has nothing to do, does not go on: the clip, or in or out, ends here."""
    ends = frames.start == (clip[-1] if frames.step > 0 else clip[0])
    if frames.step > 0:
        return tr(CLIP_ENDS if ends else OUT_IS_HERE)
    return tr(CLIP_BEGINS if ends else IN_IS_HERE)


class Tracking:
    """Starts runs of the propagation from the playhead.

    `config` names the engine's configuration, `factors` how far its dials are turned, by configuration and dial;
    `scope` tells which shapes are meant: the selected ones (all where none is), or all in any case. The others of their
    objects are solved with them, but where each is to be solved alone. `without_picture()` gives the frames that the
    plate lacks.
    """

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        propagation: Propagation,
        without_picture: Callable[[], Collection[int]] = tuple,
    ) -> None:
        self._document, self._view, self._propagation = document, view_state, propagation
        self._without_picture = without_picture
        self._boil = boil_of_document(document)
        self.config = DEFAULT_CONFIG
        self.factors: dict[str, dict[str, float]] = {}
        self.scope = Scope.SELECTED

    @property
    def configuration(self) -> str:
        """The full name of the configuration, with its turned dials: `best+reach=1.5`."""
        return name_of(self.config, self.factors.get(self.config, {}))

    def turn(self, dial: str, factor: float) -> None:
        """Turn a dial of the present configuration; 1 is what the configuration says."""
        self.factors.setdefault(self.config, {})[dial] = factor

    def reset(self) -> None:
        """Turn all dials of the present configuration back."""
        self.factors.pop(self.config, None)

    def remembered(self) -> dict[str, dict[str, str]]:
        """The turned dials, as words that can be kept."""
        return {
            config: {dial: f"{factor:g}" for dial, factor in own.items() if factor != 1.0}
            for config, own in self.factors.items()
        }

    def recall(self, kept: Mapping[str, Mapping[str, str]]) -> None:
        """Turn the dials as `remembered` told; what makes no sense any more is left out.

        So is a dial that is offered no more: nothing would show that it is turned. Both are said, in one sentence.
        """
        gone: list[str] = []
        for config, own in kept.items():
            for dial, word in own.items():
                name = f"{config}+{dial}={word}"
                if known_params(name) is None or departed(name):
                    gone.append(name)
                else:
                    self.factors.setdefault(config, {})[dial] = float(word)
        if gone:
            self._view.say(
                tr(
                    "Dials that were turned and are not offered (any more) stay at 100 %: {names}.",
                    names=", ".join(gone),
                )
            )

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "track.forward": self.forward,
            "track.backward": self.backward,
            "track.forward_one": self.forward_one,
            "track.backward_one": self.backward_one,
            "track.to_next_key": self.to_next_key,
            "track.fill": self.fill,
            "track.next_doubtful": self.next_doubtful,
            "track.previous_doubtful": self.previous_doubtful,
            "track.most_doubtful": self.most_doubtful,
        }

    def forward(self) -> None:
        """Track to the end of the play range, or of the clip when the playhead lies beyond it."""
        self._run(1, last_to_track(self._view, self._clip(), 1) + 1)

    def backward(self) -> None:
        """Track back to the beginning of the play range, or of the clip when the playhead lies before it."""
        self._run(-1, last_to_track(self._view, self._clip(), -1) - 1)

    def forward_one(self) -> None:
        self._run(1, min(self._view.frame + 2, self._clip().stop))

    def backward_one(self) -> None:
        self._run(-1, max(self._view.frame - 2, self._clip().start - 1))

    def to_next_key(self) -> None:
        """Track up to the next artist key, on the clip, of the shapes that are tracked; to the end if there is none."""
        frame, clip = self._view.frame, self._clip()
        begun = [shape for shape in self.able() if has_begun(shape, frame, forward=True)] or self.able()
        later = [key for shape in begun for key in shape.artist_frames if key > frame and key in clip]
        if not later:
            self.forward()
        elif min(later) == frame + 1:
            self._view.say_here(tr("The next frame is a key already: there is nothing to track before it."))
        else:
            self._run(1, min(later))

    def fill(self) -> None:
        """Fill the frames between artist keys: of the gaps inside in and out, or of the one at the playhead."""
        if self._document.project.clip is None:
            self._view.say(tr(NO_CLIP))
        elif shapes := self._trackable():
            if gaps := self._gaps_meant(gaps_of(shapes)):
                self._propagation.fill(
                    [shape.id for shape in shapes], gaps, self.configuration, alone=self.scope is Scope.ALONE
                )
            elif not any(shape.exists_at(self._view.frame) for shape in shapes):
                self._view.say_here(does_not_exist(shapes[0], self._view.frame))
            elif self._is_within_range and gaps_of(shapes):
                self._view.say_here(tr(NO_GAP_WITHIN))
            else:
                self._view.say_here(tr(NO_GAP))

    def next_doubtful(self) -> None:
        self._go_to_doubtful(1)

    def previous_doubtful(self) -> None:
        self._go_to_doubtful(-1)

    def most_doubtful(self) -> None:
        """Go to the frame that the engine trusts least, the first where several are alike, and tell what it doubts."""
        shapes, clip = self._shapes(), self._clip()
        tracked = [
            (key.confidence, key.frame, partial(doubt_sentence, shape, key.frame))
            for shape in shapes
            for key in shape.living_keys
            if key.confidence is not None and key.frame in clip
        ]
        tracked += [
            (trust, frame, partial(_track_sentence, name, frame, trust))
            for name, frame, trust in tracks_of(self._document.project, shapes)
            if frame in clip
        ]
        if not tracked:
            self._view.say_here(tr("No frame is tracked yet."))
            return
        _, frame, sentence = min(tracked, key=lambda each: each[:2])
        self._view.set_frame(frame)
        self._view.say_here(sentence())

    # ---- the rest is private

    def _clip(self) -> range:
        return clip_frames(self._document.project, self._view.frame)

    def _run(self, step: int, stop: int) -> None:
        frames = range(self._view.frame, stop, step)
        if self._document.project.clip is None:
            self._view.say(tr(NO_CLIP))
        elif len(frames) < 2:
            self._view.say_here(why_not_on(self._clip(), frames))
        elif shapes := self._trackable():
            begin = seen_from(self._view.frame, step, self._clip(), self._without_picture())
            begun = [shape for shape in shapes if has_begun(shape, begin, step > 0)]
            left_out = [shape for shape in shapes if not has_begun(shape, begin, step > 0)]
            if any(shape.exists_at(frame) for frame in frames[1:] for shape in begun):
                lived = _as_long_as_any_exists(range(begin, stop, step), begun)
                ids, alone = [shape.id for shape in begun], self.scope is Scope.ALONE
                self._propagation.start(ids, lived, self.configuration, alone=alone)
                self._tell_of_left_out(left_out, step)  # what a run tells as it begins would take its place
            elif any(shape.exists_at(frame) for frame in frames[1:] for shape in left_out):
                self._tell_of_left_out(left_out, step)
            else:
                self._view.say_here(does_not_exist(shapes[0], frames[1]))

    def _tell_of_left_out(self, left_out: Sequence[RotoShape], step: int) -> None:
        """Say which shapes a run cannot begin with: their outline on its first frame is a mere copy of a key ahead.

        There the shape stands still, wherever the object is.
        """
        is_forward = step > 0
        if len(left_out) > 1:
            count = len(left_out)
            later = tr(
                "%n shape(s) not tracked: their first keys lie ahead. Track from there, or set keys here (<key.set>).",
                "",
                count,
            )
            earlier = tr(
                "%n shape(s) not tracked: their last keys lie ahead. Track from there, or set keys here (<key.set>).",
                "",
                count,
            )
            self._view.say(later if is_forward else earlier)
        elif left_out:
            key = left_out[0].frames[0 if is_forward else -1]
            if key in self._without_picture():
                self._view.say(tr(NO_PICTURE, name=left_out[0].name, key=key))
                return
            self._view.say(tr(FIRST_KEY if is_forward else LAST_KEY, name=left_out[0].name, key=key))

    def _gaps_meant(self, gaps: list[Gap]) -> list[Gap]:
        """In and out mean the gaps between them, where they are set around the playhead; otherwise it lies in a gap.

        On a key that is the gap after it; on the last key the one before.
        """
        frame, (first, stop) = self._view.frame, self._view.play_range
        if self._is_within_range:
            return [gap for gap in gaps if first <= gap[0] and gap[1] < stop]
        around = [gap for gap in gaps if gap[0] <= frame < gap[1]]
        return around or [gap for gap in gaps if gap[1] == frame]

    @property
    def _is_within_range(self) -> bool:
        """Whether in and out are set, and the playhead lies between them."""
        (first, stop), clip = self._view.play_range, self._clip()
        return (first, stop) != (clip.start, clip.stop) and first <= self._view.frame < stop

    def _shapes(self) -> list[RotoShape]:
        """The selected shapes, or all when none is selected."""
        return shapes_in_hand(self._document.project, self._view.selection)

    def in_scope(self) -> list[RotoShape]:
        """The shapes that are meant, whether they can be tracked or not."""
        return list(self._document.project.shapes) if self.scope is Scope.ALL else self._shapes()

    def able(self) -> list[RotoShape]:
        """Those in scope that a run takes: outlines that are not locked."""
        outlines = [shape for shape in self.in_scope() if shape.closed and shape.point_count >= MIN_POINTS]
        return [shape for shape in outlines if not self._document.project.is_locked(shape.id)]

    def _trackable(self) -> list[RotoShape]:
        """Those that can be tracked; says why when there is none."""
        shapes, able, project = self.in_scope(), self.able(), self._document.project
        if not shapes:
            self._view.say(tr(NO_SHAPE))
        elif not able and project.is_locked(shapes[0].id):
            self._view.say_here(tr("{name} is locked; unlock it to track it.", name=shapes[0].name))
        elif not able and shapes[0].closed:
            self._view.say_here(
                tr("{name} is a single point; draw an outline around the object to track it.", name=shapes[0].name)
            )
        elif not able:
            self._view.say_here(
                tr("{name} is open; close it (<points.toggle_closed> in the viewer) to track it.", name=shapes[0].name)
            )
        return able

    def _go_to_doubtful(self, step: int) -> None:
        here = self._view.frame
        shapes = self._shapes()
        doubtful = [
            (abs(key.frame - here), key.confidence, key.frame, doubt_sentence(shape, key.frame))
            for shape in shapes
            for key in shape.living_keys
            if is_doubtful(key.confidence) and (key.frame - here) * step > 0
        ]
        doubtful += [
            (abs(found.frame - here), 1.0, found.frame, boil_sentence(found))
            for shape in shapes
            for found in worst_of_stretches(boiling_frames(shape, self._boil(shape)))
            if (found.frame - here) * step > 0
        ]
        doubtful += [
            (abs(frame - here), trust, frame, _track_sentence(name, frame, trust))
            for name, frame, trust in tracks_of(self._document.project, shapes)
            if is_doubtful(trust) and (frame - here) * step > 0
        ]
        clip = self._clip()
        if inside := [each for each in doubtful if each[2] in clip]:
            _, _, frame, sentence = min(inside, key=lambda each: each[:2])
            self._view.set_frame(frame)
            self._view.say_here(sentence)
        else:
            none = tr("No doubtful frame after frame {frame}.", frame=here)
            self._view.say_here(none if step > 0 else tr("No doubtful frame before frame {frame}.", frame=here))


def _track_sentence(name: str, frame: int, trust: float) -> str:
    """How far the track of a plane, or of points, is trusted on a frame."""
    return tr("Frame {frame}: the confidence of the track {name} is {trust:.2f}.", frame=frame, name=name, trust=trust)


def seen_from(here: int, step: int, clip: range, lacking: Collection[int]) -> int:
    """Where a run in this direction begins: in a gap of the plate on the frame before it, where that has a picture.

    So a run that was stopped in a gap goes on from what it found last.
    """
    behind = next((frame for frame in range(here, here - len(clip) * step, -step) if frame not in lacking), here)
    return behind if behind in clip else here


def _as_long_as_any_exists(frames: range, shapes: Sequence[RotoShape]) -> range:
    """The frames of a run up to the last one on which it makes keys: outside of its lifetime a shape gets none."""
    last = max((k for k, frame in enumerate(frames) if any(shape.exists_at(frame) for shape in shapes)), default=0)
    return frames[: last + 1]


def tracks_of(project: Project, shapes: Sequence[RotoShape]) -> list[tuple[str, int, float]]:
    """The tracks of the layers that these shapes lie in: name of the layer, frame, confidence."""
    ids = {shape.id for shape in shapes}
    return [
        (item.name, frame, trust)
        for item in project.root.items()
        if isinstance(item, Layer) and item.transform is not None and ids & {shape.id for shape in item.shapes()}
        for frame, trust in item.transform.confidence
    ]


def doubt_sentence(shape: RotoShape, frame: int) -> str:
    """How far the engine trusts a shape on a frame, and how many points are ringed; empty where it said nothing."""
    key = shape.key_at(frame)
    if key is None or key.confidence is None:
        return ""
    doubted = len(doubtful_points(shape, frame))
    rings = (
        tr(" %n of its {count} points is/are doubtful and ringed.", "", doubted, count=shape.point_count)
        if doubted
        else ""
    )
    return tr(
        "Frame {frame}: the confidence of {name} is {confidence:.2f}.{rings}",
        frame=frame,
        name=shape.name,
        confidence=key.confidence,
        rings=rings,
    )


def boil_sentence(found: Finding) -> str:
    """How much a shape boils on a frame."""
    return tr("Frame {frame}: {name} boils by {pixels:.1f} px.", frame=found.frame, name=found.name, pixels=found.value)


def doubtful_points(shape: RotoShape, frame: int) -> tuple[int, ...]:
    """The points of a shape that the engine does not trust on a frame."""
    key = shape.key_at(frame)
    if key is None or key.vertex_confidence is None:
        return ()
    return tuple(index for index, trust in enumerate(key.vertex_confidence.tolist()) if is_doubtful(trust))
