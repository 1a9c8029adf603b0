"""The tools of the canvas, one a file, looked up by name."""

from collections.abc import Mapping

from app.tools.bezier import BezierTool
from app.tools.point_actions import PointActions
from app.tools.polygon import PolygonTool
from app.tools.select import SelectTool
from app.tools.tool import Pointer, Tool

TOOLS: Mapping[str, type[Tool]] = {tool.name: tool for tool in (SelectTool, BezierTool, PolygonTool)}
"""Every tool by the name that `ViewState.tool` holds. A new tool is a file and a line here."""

__all__ = ["TOOLS", "PointActions", "Pointer", "Tool"]
