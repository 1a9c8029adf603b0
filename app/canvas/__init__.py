"""The canvas: the plate, the shapes painted on it, and the events that go to the tools."""

from app.canvas.bindings import keep_singletons_alive

keep_singletons_alive()
