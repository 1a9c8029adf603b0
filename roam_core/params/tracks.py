"""Parameters of the trackers of planes and points."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class RegistrationParams:
    """Parameters of matching a picture to a reference's texture (`motion.registration`).

    Attributes
    ----------
    side : most pixels of a side of the texture; a greater region is reduced.
    levels, coarsest : most halvings of the texture, and the least pixels of its shorter side after them.
    window : pixels of the side of the square about a place within which brightness and contrast are made alike, and
        the likeness of both pictures is measured.
    flat : grey levels of contrast below which a place counts as flat: what grain makes.
    unlike, alike : local correlation at which a place counts as hidden, and from which on it counts fully.
    rounds : most steps on each level. enough : pixels of the texture's corners below which a step ends them.
    jump : pixels of the texture by which one step may move a corner.
    grown : by how many times `window` the texture reaches beyond the mask, so that gradients at its rim are known.
    resized : times by which a motion may make what lies at a corner larger or smaller than on the reference.
    faint : likeness that is taken from where both are nearly flat: what grain correlates by chance.
    grain : pixels of the texture, as an area, that err together: neighbours share blur and grain.
    least_area : pixels of the texture's finest level that a match needs at least.
    """

    side: int = 240
    levels: int = 3
    coarsest: int = 14
    window: int = 9
    flat: float = 5.0
    unlike: float = 0.3
    alike: float = 0.75
    rounds: int = 20
    enough: float = 0.01
    jump: float = 4.0
    grown: float = 1.0
    resized: float = 8.0
    faint: float = 0.05
    grain: float = 24.0
    least_area: int = 60


@dataclass(frozen=True)
class TrackConfidenceParams:
    """What makes a track's confidence, in [0, 1]: the product of three shares (`motion.registration.Fit.confidence`).

    Attributes
    ----------
    error : pixels of a 480-line image of expected error, at the corners of what is tracked, that halve it.
    seen : share of the texture that must be seen for full confidence; less counts in proportion.
    fit : mean correlation of what is seen from which on the fit counts fully; it counts nothing at `no_fit`.
    aged : factor on confidence for each reference between the picture and the key.
    """

    error: float = 2.0
    seen: float = 0.3
    fit: float = 0.85
    no_fit: float = 0.4
    aged: float = 0.85


@dataclass(frozen=True)
class PlaneTrackParams:
    """Parameters of the planar tracker (`motion.plane_track`).

    Attributes
    ----------
    least_seen : share of the texture that must be seen, and correlate, for a match to be believed.
    least_fit : mean correlation of what is seen that a match needs.
    surely : share that must be seen for no other guess to be tried.
    least_confidence : confidence below which the last picture that was believed becomes the next reference.
    within : pixels of a 480-line image by which the plane may depart, from one frame to the next, from an even motion:
        it decides what the texture that is seen leaves open.
    waits : pictures in a row on which the plane may be hidden before it is lost.
    far : sizes of the picture beyond which no corner is carried: a homography can throw points over the horizon.
    registration, confidence : of matching, and of what it is worth.
    """

    least_seen: float = 0.12
    least_fit: float = 0.6
    surely: float = 0.9
    least_confidence: float = 0.25
    within: float = 3.0
    waits: int = 12
    far: float = 3.0
    registration: RegistrationParams = RegistrationParams()
    confidence: TrackConfidenceParams = TrackConfidenceParams()


PLANE_TRACK = PlaneTrackParams()


@dataclass(frozen=True)
class PointTrackParams:
    """Parameters of the point tracker (`motion.point_track`).

    Attributes
    ----------
    motion : what a pattern may do, by the name of a `PlaneMotion`.
    pattern, search : half the sides of a new point's areas, pixels of a 480-line image.
    least_likeness : correlation with the key's pattern that a place of the search area needs to be looked at closely.
    plane : of following the pattern as a plane.
    """

    motion: str = "affine"
    pattern: float = 12.0
    search: float = 28.0
    least_likeness: float = 0.5
    plane: PlaneTrackParams = PlaneTrackParams(
        least_seen=0.45,
        least_fit=0.7,
        registration=RegistrationParams(side=36, levels=2, coarsest=10),
        confidence=TrackConfidenceParams(error=1.5, seen=0.7),
    )


POINT_TRACK = PointTrackParams()
