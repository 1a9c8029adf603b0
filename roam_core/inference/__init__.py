"""Minimising the energy: exact block-wise steps."""
