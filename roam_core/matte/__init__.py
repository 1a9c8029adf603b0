"""Mattes: shapes to antialiased pixels, and pixels back to shapes."""

from roam_core.arrays import Matte
from roam_core.matte.compose import render_matte
from roam_core.matte.rasterise import Patch, shape_matte, shape_patch
from roam_core.matte.vectorise import read_mask, shapes_from_mask

__all__ = ["Matte", "Patch", "read_mask", "render_matte", "shape_matte", "shape_patch", "shapes_from_mask"]
