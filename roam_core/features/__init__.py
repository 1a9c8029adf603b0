"""What the engine sees of a frame: grey values and gradients, prepared once and shared by all shapes."""

from roam_core.features.frame import PreparedFrame, Region

__all__ = ["PreparedFrame", "Region"]
