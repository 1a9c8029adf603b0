"""Every number of the engine that tunes what comes out, a module for each room, and the named configurations.

`RoamParams` holds what a run reads; its rooms are dataclasses in it. What tools read that belong to no run (keys from
masks, drawing by the picture, fitting curves) stands here too, in dataclasses of their own. Numbers that are no choice
stay where they are used; `docs/ARCHITECTURE.md` says which those are.
"""

from __future__ import annotations

from roam_core.params.appearance import AppearanceParams
from roam_core.params.between import EndpointConsistencyParams, SpanParams
from roam_core.params.confidence import CONFIDENCE, ConfidenceParams
from roam_core.params.configurations import (
    CONFIGS,
    DEFAULT_CONFIG,
    DOUBTFUL,
    departed,
    is_doubtful,
    numbers_in,
    params_for,
)
from roam_core.params.contour import (
    INVARIANTS,
    UNTYING,
    ContourFitParams,
    InvariantsParams,
    RefineParams,
    UntyingParams,
)
from roam_core.params.curves import (
    CONTROL_POLYGON,
    CURVE_FIT,
    MERGING,
    ControlPolygonParams,
    CurveFitParams,
    MergingParams,
)
from roam_core.params.drawing import CUT_OUT, GROWING, LIVE_WIRE, CutOutParams, GrowingParams, LiveWireParams
from roam_core.params.evidence import ComponentsParams, KeyColoursParams, LabelPropagationParams, TextureParams
from roam_core.params.fast_motion import FastMotionParams
from roam_core.params.figure import EDGES, EdgesParams, FigureParams, FreeEdgesParams
from roam_core.params.keys import (
    ANCHORS,
    KEY_FIT,
    OUTLINE_MATCH,
    PAIRING,
    AnchorParams,
    KeyFitParams,
    OutlineMatchParams,
    PairingParams,
)
from roam_core.params.klt import KLT, KltParams
from roam_core.params.landmarks import FILTERS, FilterParams, LandmarkParams
from roam_core.params.objects import OBJECTS, ObjectParams
from roam_core.params.pose import BONES, JOINTS, BonesParams, JointParams, PoseParams, PyramidParams
from roam_core.params.proposals import ProposalParams
from roam_core.params.redetection import RedetectionParams
from roam_core.params.region import RegionParams
from roam_core.params.rigid import PLANAR, PlanarParams, RigidityParams
from roam_core.params.roam import RoamParams, enlargement_for, scale_for
from roam_core.params.softness import SOFTNESS, SoftnessParams

__all__ = [
    "ANCHORS",
    "BONES",
    "CONFIDENCE",
    "CONFIGS",
    "CONTROL_POLYGON",
    "CURVE_FIT",
    "CUT_OUT",
    "DEFAULT_CONFIG",
    "DOUBTFUL",
    "EDGES",
    "FILTERS",
    "GROWING",
    "INVARIANTS",
    "JOINTS",
    "KEY_FIT",
    "KLT",
    "LIVE_WIRE",
    "MERGING",
    "OBJECTS",
    "OUTLINE_MATCH",
    "PAIRING",
    "PLANAR",
    "SOFTNESS",
    "UNTYING",
    "AnchorParams",
    "AppearanceParams",
    "BonesParams",
    "ComponentsParams",
    "ConfidenceParams",
    "ContourFitParams",
    "ControlPolygonParams",
    "CurveFitParams",
    "CutOutParams",
    "EdgesParams",
    "EndpointConsistencyParams",
    "FastMotionParams",
    "FigureParams",
    "FilterParams",
    "FreeEdgesParams",
    "GrowingParams",
    "InvariantsParams",
    "JointParams",
    "KeyColoursParams",
    "KeyFitParams",
    "KltParams",
    "LabelPropagationParams",
    "LandmarkParams",
    "LiveWireParams",
    "MergingParams",
    "ObjectParams",
    "OutlineMatchParams",
    "PairingParams",
    "PlanarParams",
    "PoseParams",
    "ProposalParams",
    "PyramidParams",
    "RedetectionParams",
    "RefineParams",
    "RegionParams",
    "RigidityParams",
    "RoamParams",
    "SoftnessParams",
    "SpanParams",
    "TextureParams",
    "UntyingParams",
    "departed",
    "enlargement_for",
    "is_doubtful",
    "numbers_in",
    "params_for",
    "scale_for",
]
