"""The verbs on shapes and layers, each one undo step."""
