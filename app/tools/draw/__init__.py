"""The tools that make new shapes."""
