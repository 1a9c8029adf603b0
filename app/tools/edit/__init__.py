"""The tools that change shapes, and the verbs on points that go with them."""
