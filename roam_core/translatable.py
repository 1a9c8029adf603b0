"""The mark of texts that the window translates; the engine itself says everything in English and knows no Qt."""

from __future__ import annotations


def N_(text: str) -> str:  # noqa: N802 - gettext's name for it
    """The text itself: `make translations` finds it by this mark, and whoever shows it translates it."""
    return text
