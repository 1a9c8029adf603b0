"""Kernels are tested twice: compiled, and line by line (NUMBA_DISABLE_JIT=1), as coverage and mutants need them."""

from __future__ import annotations

import pytest
from numba import config

COMPILED = not config.DISABLE_JIT
"""Whether kernels run as machine code."""
EXACT = 1e-9 if COMPILED else 1e-6
"""Relative difference up to which sums agree with a twin's. NumPy adds float32 scalars in float32, compiled code does
not."""

needs_compiler = pytest.mark.skipif(not COMPILED, reason="of compiled code, or takes seconds line by line")
