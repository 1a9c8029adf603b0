"""The tools of the canvas, one a file, looked up by name."""

from collections.abc import Mapping

from app.tools.bezier import BezierTool
from app.tools.box import EllipseTool, RectangleTool
from app.tools.brush import ReshapeTool
from app.tools.bspline import BSplineTool
from app.tools.feather import FeatherTool
from app.tools.freehand import FreehandTool
from app.tools.magnetic import MagneticTool
from app.tools.object import ObjectTool
from app.tools.point_actions import PointActions
from app.tools.polygon import PolygonTool
from app.tools.select import SelectTool
from app.tools.tool import Pointer, Tool
from app.tools.transform import TransformTool

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
)
TOOLS: Mapping[str, type[Tool]] = {tool.name: tool for tool in _ORDER}
"""Every tool by the name that `ViewState.tool` holds. A new tool is a file and a line here."""

__all__ = ["TOOLS", "PointActions", "Pointer", "Tool"]
