"""The entities with which Illustrator abbreviates addresses of namespaces, written out, so that no parser meets one."""

from __future__ import annotations

import re

LONGEST = 200
"""Bytes of an address."""

_DECLARATION = (
    rb"<!ENTITY[ \t\r\n]+([A-Za-z_][\w.-]{0,99})[ \t\r\n]+(?:\"([\w:/.#?~+-]*)\"|'([\w:/.#?~+-]*)')[ \t\r\n]*>"
)
_SUBSET = re.compile(
    rb"\A([^\[]{0,4000}<!DOCTYPE[ \t\r\n]+svg[^\[<>]{0,1000})\[((?:[ \t\r\n]*+"
    + _DECLARATION
    + rb"){1,100}+)[ \t\r\n]*\]"
)
_REFERENCE = re.compile(rb"&([A-Za-z_][\w.-]{0,99});")


def written_out(content: bytes, most: int) -> bytes:
    """A drawing with what its document type abbreviates in full, and without these declarations.

    Only words of an address are taken, which cannot hold markup, nor one another. What declares anything else, or would
    grow beyond `most` bytes, stays as it is: the parser refuses it.
    """
    found = _SUBSET.match(content)
    if found is None:
        return content
    declared = re.findall(_DECLARATION, found.group(2))
    words = {name: double or single for name, double, single in declared}
    if any(len(word) > LONGEST for word in words.values()):
        return content
    rest = content[found.end() :]
    grown = sum(len(words.get(one.group(1), b"")) for one in _REFERENCE.finditer(rest))
    if len(content) + grown > most:
        return content
    return found.group(1) + _REFERENCE.sub(lambda one: words.get(one.group(1), one.group()), rest)
