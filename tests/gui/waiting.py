"""How long a test of the window waits for what must come; it comes at once, or on a busy machine after a while."""

from __future__ import annotations

WAIT = 120_000
"""Milliseconds after which a test gives up. No test waits for so long, unless it fails."""
