"""Fusion and Resolve: settings out and in."""
