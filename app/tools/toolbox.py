"""The toolbox: every tool of the canvas by its name."""

from collections.abc import Mapping

from .draw.bezier import BezierTool
from .draw.box import EllipseTool, RectangleTool
from .draw.bspline import BSplineTool
from .draw.freehand import FreehandTool
from .draw.magnetic import MagneticTool
from .draw.object import ObjectTool
from .draw.polygon import PolygonTool
from .edit.adjust import AdjustTool
from .edit.brush import ReshapeTool
from .edit.feather import FeatherTool
from .edit.points import PointsTool
from .edit.select import SelectTool
from .edit.transform import TransformTool
from .tool import Tool

_ORDER: tuple[type[Tool], ...] = (
    SelectTool,
    TransformTool,
    ReshapeTool,
    BezierTool,
    BSplineTool,
    PolygonTool,
    FreehandTool,
    MagneticTool,
    EllipseTool,
    RectangleTool,
    ObjectTool,
    FeatherTool,
    AdjustTool,
    PointsTool,
)
TOOLS: Mapping[str, type[Tool]] = {tool.name: tool for tool in _ORDER}
"""Every tool by the name that `ViewState.tool` holds. A new tool is a file and a line here."""
