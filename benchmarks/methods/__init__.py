"""What is measured side by side: the engine and its peers, each with two doors, `carry` and `fill`."""

from benchmarks.methods.engine import Engine
from benchmarks.methods.flow import ContourFlow
from benchmarks.methods.grabcut import GrabCut
from benchmarks.methods.method import Method
from benchmarks.methods.planar import Planar
from benchmarks.methods.still import Hold, Linear

PEERS: tuple[Method, ...] = (
    Hold(),
    Linear(),
    Planar("similarity"),
    Planar("affine"),
    Planar("homography"),
    ContourFlow(),
    GrabCut(),
)
"""Simpler tools, as an artist would use them."""

__all__ = ["PEERS", "ContourFlow", "Engine", "GrabCut", "Hold", "Linear", "Method", "Planar"]
