"""Compiled kernels: numba functions on plain arrays, each behind a public wrapper that checks and allocates."""

from roam_core.kernels.keeping import keep

keep()
