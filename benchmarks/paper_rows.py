"""What the paper reports, to stand beside our own figures (Miksik, Perez-Rua, Torr and Perez, CVPR 2017)."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Row:
    """A configuration on DAVIS from one keyframe: IoU and accuracy on the validation and the training set, seconds."""

    name: str
    validation: str
    training: str
    validation_accuracy: str
    training_accuracy: str
    seconds: str


DAVIS = {
    "baseline": Row("Baseline", ".358", ".385", ".930", ".937", "0.056"),
    "lean": Row("Lean", ".409", ".417", ".935", ".937", "0.356"),
    "medium": Row("Medium", ".532", ".591", ".942", ".952", "0.971"),
    "full": Row("Full", ".583", ".624", ".952", ".956", "5.639"),
}
"""Its own four configurations by our names for them."""

OTHERS = (
    Row("GrabCut and tracker", ".277", ".296", ".896", ".914", "0.461"),
    Row("JumpCut", ".570", ".632", ".952", ".957", "-"),
    Row("After Effects Rotobrush", ".533", ".479", ".951", ".942", "-"),
    Row("Roto++, one keyframe", ".248", ".310", ".910", ".922", "0.118"),
    Row("Roto++, two keyframes", ".335", ".394", ".925", ".933", "0.312"),
)
"""The methods that it compares with."""

WARPING = (("optical flow", ".878", ".312"), ("node projection", ".906", ".480"), ("similarity", ".934", ".581"))
"""Accuracy and IoU by the way in which the curve is carried to the next frame, on a subset of DAVIS."""

TIMING = {
    "DP contour": "0.654",
    "DP landmarks": "0.050",
    "local models edge terms": "0.522",
    "other terms": "0.013",
    "reparametrisation": "4.101",
}
"""Mean seconds a frame of the steps of Full, with a GPU for the potentials."""


def beside(config: str) -> Row:
    """The row to stand beside one of our configurations: its twin, or the paper's best."""
    return DAVIS.get(config, DAVIS["full"])
