"""The canvas: the plate, the shapes painted on it, and the events that go to the tools."""
