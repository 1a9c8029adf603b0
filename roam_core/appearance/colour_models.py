"""ColourModels: all colour models of one curve, learned and adapted together."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.appearance.edge_models import EdgeModels
from roam_core.appearance.global_histogram import GlobalHistogram
from roam_core.appearance.global_mixture import GlobalMixture
from roam_core.arrays import Array
from roam_core.features import PreparedFrame
from roam_core.params import RoamParams


@dataclass(frozen=True, eq=False)
class ColourModels:
    """The local models p_n of the edges, and the global model p_0 where it has a weight."""

    edges: EdgeModels
    whole: GlobalMixture | GlobalHistogram | None

    @classmethod
    def learned(cls, frame: PreparedFrame, nodes: Array, params: RoamParams, scale: float) -> ColourModels | None:
        """From a frame whose outline `nodes (N, 2)` is given; None where the configuration knows no colour."""
        if params.appearance is None:
            return None
        whole: GlobalMixture | GlobalHistogram | None = None
        if params.lambda_global > 0.0:
            kind = GlobalMixture if params.appearance.global_kind == "mixture" else GlobalHistogram
            whole = kind.learned(frame, nodes, params.appearance, scale)
        return cls(EdgeModels.learned(frame, nodes, params.appearance, scale), whole)

    def adapted(
        self, frame: PreparedFrame, nodes: Array, params: RoamParams, scale: float, confidence: float
    ) -> ColourModels:
        """After a frame with the outline `nodes (N, 2)`; the same where the confidence is too low to teach anything."""
        if params.appearance is None or confidence < params.appearance.trusted:
            return self
        whole = self.whole and self.whole.adapted(frame, nodes, params.appearance, scale, confidence)
        return ColourModels(self.edges.adapted(frame, nodes, params.appearance, scale, confidence), whole)
