"""Mattes: shapes to antialiased pixels, and pixels back to shapes."""

from roam_core.matte.compose import render_matte
from roam_core.matte.rasterise import Matte, shape_matte
from roam_core.matte.vectorise import shapes_from_mask

__all__ = ["Matte", "render_matte", "shape_matte", "shapes_from_mask"]
