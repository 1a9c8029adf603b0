"""The bars about the viewer: tools, views, modes, status."""
