"""The toolbox: every tool of the canvas by its name."""

from collections.abc import Mapping

from app.tools.draw.bezier import BezierTool
from app.tools.draw.box import EllipseTool, RectangleTool
from app.tools.draw.bspline import BSplineTool
from app.tools.draw.freehand import FreehandTool
from app.tools.draw.magnetic import MagneticTool
from app.tools.draw.object import ObjectTool
from app.tools.draw.polygon import PolygonTool
from app.tools.edit.brush import ReshapeTool
from app.tools.edit.feather import FeatherTool
from app.tools.edit.select import SelectTool
from app.tools.edit.transform import TransformTool
from app.tools.tool import Tool

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
