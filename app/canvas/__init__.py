"""The canvas: the plate, the shapes painted on it, and the events that go to the tools."""

from app.canvas.bindings import keep_none_alive

keep_none_alive()
