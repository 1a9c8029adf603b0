"""Shapes changed by what the plate shows beside them, as jobs: as soft as its edge, steady with its motion."""
