"""The curve editor: what is keyed as curves over time, with keys and tangents to take hold of."""
