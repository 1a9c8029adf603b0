"""The public `Tracker`: start on a frame, step to the next, correct, go on."""

from __future__ import annotations

from copy import copy
from typing import Any, Self

from numpy.typing import NDArray

from roam_core.arguments import frame_number, shown
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.params import DEFAULT_CONFIG, RoamParams
from roam_core.propagate.frame.result import TrackResult
from roam_core.propagate.group import GroupTracker
from roam_core.roto import RotoShape


class Tracker:
    """Carries one closed shape from frame to frame, in either direction.

    A copy (`copy.copy`, `copy.deepcopy`) stands on the same frame and goes on by itself, so that a run may branch; both
    share what none of them changes, such as the picture. One that was started is not pickled (`TypeError`).

    Parameters
    ----------
    config : name of a configuration (`roam_core.params.CONFIGS`) or a `RoamParams`.
    clip : identity of the clip for the stamps of ENGINE keys (`provenance.clip_stamp`).

    Examples
    --------
    >>> tracker = Tracker(config="best")  # doctest: +SKIP
    >>> tracker.start(first_image, shape, frame=1001)  # doctest: +SKIP
    >>> result = tracker.step(second_image, frame=1002)  # doctest: +SKIP
    """

    def __init__(self, config: str | RoamParams = DEFAULT_CONFIG, clip: str = "") -> None:
        self._group = GroupTracker(config, clip)

    def __copy__(self) -> Self:
        branch = type(self).__new__(type(self))
        vars(branch).update(vars(self), _group=copy(self._group))
        return branch

    def __deepcopy__(self, _memo: dict[int, Any]) -> Self:
        return copy(self)

    def __getstate__(self) -> dict[str, Any]:
        if self._group.is_started:
            raise TypeError(
                "a Tracker that was started is not pickled: it holds pictures and what was learned of them; keep its "
                "shape, and go on from the last frame of that with roam_core.track, which takes the run up there"
            )
        return vars(self)

    @property
    def params(self) -> RoamParams:
        """The parameters that the tracker goes by."""
        return self._group.params

    @property
    def frame(self) -> int:
        """The frame that was started on, or stepped to, last."""
        return self._group.standing.frame

    @property
    def shape(self) -> RotoShape:
        """The shape with all its keys so far."""
        return self._group.standing.shapes[0]

    def start(self, image: NDArray[Any] | PreparedFrame, shape: RotoShape, frame: int) -> None:
        """Begin at `frame`, where the shape is as `shape.at(frame)` says.

        Parameters
        ----------
        image : (h, w, 3) RGB, uint8 or float32 in [0, 1].

        Raises
        ------
        ValueError
            when the image is none, the shape no `RotoShape` or the frame no whole number.
        RoamError
            when the shape is open or a single point (only a closed curve has an inside to follow), or has a point that
            lies nowhere near the image.
        """
        self._group.start(image, [_one(shape)], frame_number(frame))

    def given(self) -> TrackResult:
        """The shape on the frame where the tracker stands, as it was given there, with what was learned of it."""
        return self._group.given()[0]

    def step(self, image: NDArray[Any] | PreparedFrame, frame: int, token: CancelToken | None = None) -> TrackResult:
        """Carry the shape to `frame`. A frame that holds an artist's key is taken as the artist made it.

        One that shows nothing, all black or white, is passed over as by `skip`.

        Raises
        ------
        Cancelled
            when `token` was cancelled; the tracker then still stands on the frame before.
        """
        return self._group.step(image, frame_number(frame), token)[0]

    def skip(self, frame: int) -> TrackResult:
        """Pass over a frame whose picture is missing, or blank: no key is made there, the next step bridges the gap."""
        return self._group.skip(frame_number(frame))[0]

    def correct(self, shape: RotoShape) -> None:
        """Take over the artist's edit on the current frame; the next step starts from it.

        Where the shape lies otherwise there than the tracker had it, its key there is an ARTIST key from now on,
        whoever made it before, and no later run replaces it.

        Raises
        ------
        ValueError
            when the shape is no `RotoShape`.
        RoamError
            as by `start`; the tracker then still has the shape that it had.
        """
        self._group.correct([_one(shape)])


def _one(shape: RotoShape) -> RotoShape:
    if not isinstance(shape, RotoShape):
        raise ValueError(f"a tracker carries one RotoShape, not {shown(shape)}; roam_core.track carries several")
    return shape
