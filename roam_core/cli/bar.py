"""The bar of commands that work for a while: on the terminal's error line, and only where one looks on."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from tqdm import tqdm

from roam_core.cancel import Progress


def bar(total: float, counts: str = "") -> Any:
    """A bar of tqdm up to `total`; `counts` is what it tells beside the times, in tqdm's format."""
    shape = f"{{l_bar}}{{bar}}| {counts}[{{elapsed}}<{{remaining}}]"
    return tqdm(total=total, bar_format=shape, disable=not sys.stderr.isatty(), leave=False)


@contextmanager
def progress_bar() -> Iterator[Progress]:
    """What tells a bar how far the work is, as a share of it. The bar never goes back."""
    with bar(1.0) as shown:
        yield lambda share, _: shown.update(max(share - shown.n, 0.0))
