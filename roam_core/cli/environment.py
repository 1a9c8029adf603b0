"""What the environment says of the share of the machine that a command may take."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

from roam_core.errors import RoamError

THREADS = "ROAM_THREADS"
"""Threads of the engine: 1, or 2 (default: as many as OpenCV takes, of which the engine uses two)."""
CACHE = "ROAM_CACHE_MB"
"""Megabytes of decoded pictures that a command keeps."""
USUAL_CACHE = 512
MOST, LONGEST = 1 << 20, 20
"""The largest number that makes sense, and characters that are looked at."""
DECODER = "ROAM_DECODER"
"""`inside`: pictures are decoded in ROAM's own process. By default others do that, which a damaged file may end."""


def cache_bytes() -> int:
    """Bytes of decoded pictures that a command keeps. Raises `RoamError` where the environment says nonsense."""
    return _whole(CACHE, USUAL_CACHE) << 20


def take_decoder() -> None:
    """Decode in other processes from now on, unless the environment says otherwise."""
    from roam_core.media import decoding  # large: `roam --version` does not wait for it

    if os.environ.get(DECODER) != "inside":
        decoding.isolate()


@contextmanager
def decoding_apart() -> Iterator[None]:
    """`take_decoder` for the length of a `with` block: around all that a program does."""
    from roam_core.media import decoding

    was_isolated = decoding.is_isolated()
    take_decoder()
    try:
        yield
    finally:
        if not was_isolated:
            decoding.trust()


def take_threads() -> None:
    """Keep the engine to as many threads as the environment says. Raises `RoamError` where that is nonsense."""
    if os.environ.get(THREADS):
        import cv2  # only where it is asked for: `roam info` does not wait for it

        cv2.setNumThreads(_whole(THREADS, 0))


def _whole(name: str, usual: int) -> int:
    text = os.environ.get(name, "")
    if not text:
        return usual
    if not text.isdecimal() or len(text) > LONGEST or not 1 <= int(text) <= MOST:
        raise RoamError(f"The environment variable {name} is {text[:20]!r}; it has to be a whole number, 1 to {MOST}.")
    return int(text)
