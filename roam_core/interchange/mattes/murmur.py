"""MurmurHash3 of names, the hash that Cryptomatte knows them by (Austin Appleby's, in the public domain)."""

from __future__ import annotations

FULL = 0xFFFFFFFF
"""All 32 bits: sums and products are cut off there."""


def murmur3(content: bytes, seed: int = 0) -> int:
    """MurmurHash3_x86_32 of bytes, as a whole number of 32 bits without sign."""
    state, whole = seed, len(content) // 4 * 4
    for start in range(0, whole, 4):
        state ^= _mixed(int.from_bytes(content[start : start + 4], "little"))
        state = (_turned(state, 13) * 5 + 0xE6546B64) & FULL
    state ^= _mixed(int.from_bytes(content[whole:], "little"))  # of nothing nothing: 0 stays 0
    state ^= len(content)
    for shift, factor in ((16, 0x85EBCA6B), (13, 0xC2B2AE35)):
        state = ((state ^ state >> shift) * factor) & FULL
    return state ^ state >> 16


def _mixed(block: int) -> int:
    return _turned(block * 0xCC9E2D51 & FULL, 15) * 0x1B873593 & FULL


def _turned(word: int, places: int) -> int:
    return (word << places | word >> 32 - places) & FULL
