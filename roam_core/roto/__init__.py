"""The artist's data: immutable projects, layers, shapes and keyframes; the edit verbs; the project file."""

from roam_core.roto.animated import Animated, Interpolation, ValueKey
from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.roto.motion_blur import MotionBlur
from roam_core.roto.placement import LayerTransform
from roam_core.roto.project import Clip, Layer, Mark, Project
from roam_core.roto.shape import BlendMode, Outline, RotoShape, Spline

__all__ = [
    "Animated",
    "BlendMode",
    "Clip",
    "Interpolation",
    "Keyframe",
    "Layer",
    "LayerTransform",
    "Mark",
    "MotionBlur",
    "Origin",
    "Outline",
    "Project",
    "RotoShape",
    "Spline",
    "ValueKey",
]
