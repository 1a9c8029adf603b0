"""Plates: image sequences and movies as one kind of source, their colour, and the cache of decoded frames."""

from roam_core.media.cache import FrameCache
from roam_core.media.declared import declared
from roam_core.media.opening import open_clip
from roam_core.media.source import DamagedFrame, MissingFrame, PlateSource

__all__ = ["DamagedFrame", "FrameCache", "MissingFrame", "PlateSource", "declared", "open_clip"]
