"""How Sphinx makes the reference of `roam_core` from its docstrings: `make docs`.

Our docstrings have NumPy's sections and one departure from its style: after the colon of a parameter stand its shape,
its unit and its meaning, not its type, which stands in the signature. `described` turns them into Sphinx's own fields.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from enum import Enum
from itertools import pairwise
from typing import Any

from sphinx.application import Sphinx

import roam_core

project = "ROAM"
author = "the ROAM developers"
version = release = roam_core.__version__

extensions = ["sphinx.ext.autodoc"]
smartquotes_action = "D"  # dashes, and no quotes: "" in a docstring is an empty text
default_role = "py:obj"  # a name between backquotes is a link where the reference has it, else code
autodoc_default_options = {"members": True, "member-order": "bysource", "no-value": True}
python_maximum_signature_line_length = 100

html_theme = "furo"
html_title = f"ROAM {version}: the library"
html_show_copyright = False
html_show_sourcelink = False
html_copy_source = False

SECTIONS = ("Parameters", "Attributes", "Returns", "Yields", "Raises", "Examples")
ENTRY = re.compile(r"(\*{0,2}\w[\w, ]*) : (.*)")
"""`name : description`; several names that share one description stand with commas."""
NAME = re.compile(r"[A-Za-z_][\w.]*")


def described(lines: list[str]) -> list[str]:
    """The lines of a docstring as Sphinx reads them."""
    result: list[str] = []
    for title, body in _sections([_code(line) for line in lines]):
        match title:
            case "":
                result += body
            case "Parameters":
                result += _fields("param", [ENTRY.fullmatch(entry) for entry in _entries(body)])
            case "Attributes":
                result += [":Attributes:", *(ENTRY.sub(r"    * **\1** -- \2", entry) for entry in _entries(body))]
            case "Raises":
                result += _fields("raises", [re.fullmatch(r"([\w, ]+?)\s+(.*)", entry) for entry in _entries(body)])
            case "Returns" | "Yields":
                result += [f":{title.lower()}:", *(f"    {line}" for line in body)]
            case _:
                result += [f".. rubric:: {title}", "", *body]
        result.append("")
    return result


def _sections(lines: list[str]) -> Iterator[tuple[str, list[str]]]:
    """What stands above the first section, under no title, and then the sections."""
    starts = [n for n, line in enumerate(lines[:-1]) if line in SECTIONS and lines[n + 1].startswith("---")]
    yield "", lines[: starts[0]] if starts else lines
    for start, stop in pairwise([*starts, len(lines)]):
        yield lines[start], lines[start + 2 : stop]


def _entries(body: list[str]) -> list[str]:
    """The entries of a section, each on one line: those that begin at the margin, or behind another's full stop."""
    text = "\n".join(line for line in body if line.strip())
    text = re.sub(r"(?<=[.;]) (?=\w[\w, ]* : )", "\n", re.sub(r"\n +", " ", text))
    return text.splitlines()


def _fields(field: str, entries: list[re.Match[str] | None]) -> list[str]:
    return [f":{field} {entry[1]}: {entry[2]}" for entry in entries if entry is not None]


def _code(line: str) -> str:
    """The line with double backquotes around all code that is no name, and so can be no link."""
    return re.sub(r"(?<!`)`([^`]+)`(?!`)", lambda code: code[0] if NAME.fullmatch(code[1]) else f"`{code[0]}`", line)


class Bare(str):
    """Text that stands in a signature without quotes."""

    __slots__ = ()
    __repr__ = str.__str__


def signature(_app: Sphinx, what: str, _name: str, thing: Any, *_: object) -> tuple[str, str | None] | None:
    """The parameters and the result of a function or class, with the types as the source writes them."""
    # Sphinx asks of what a module imports, too, before it leaves that out: some of Python's own has no signature.
    if what not in ("class", "function", "method") or not thing.__module__.startswith("roam_core"):
        return None
    if isinstance(thing, type) and (issubclass(thing, Enum) or getattr(thing, "_is_protocol", False)):
        return "", None  # nobody makes one by calling it
    found = inspect.signature(thing)
    plain = [_plain(each) for each in found.parameters.values() if (what, each.name) != ("method", "self")]
    result = None if what == "class" or found.return_annotation is found.empty else str(found.return_annotation)
    return str(found.replace(parameters=plain, return_annotation=found.empty)), result


def _plain(parameter: inspect.Parameter) -> inspect.Parameter:
    """The parameter without what Python says of types and of values that are no literals."""
    annotation, default = parameter.annotation, parameter.default
    if annotation is not parameter.empty:
        parameter = parameter.replace(annotation=Bare(annotation))
    if default is parameter.empty:
        return parameter
    if isinstance(default, Enum):
        return parameter.replace(default=Bare(f"{type(default).__name__}.{default.name}"))
    literal = default is None or isinstance(default, bool | int | float | str | tuple)
    return parameter.replace(default=default if literal else Bare("..."))


def docstring(_app: Sphinx, _what: str, _name: str, _thing: object, _options: object, lines: list[str]) -> None:
    """Put our own docstrings into Sphinx's form; those of enumerations without one are Python's, and say nothing."""
    lines[:] = described(lines)


def setup(app: Sphinx) -> None:
    """Called by Sphinx."""
    app.connect("autodoc-process-docstring", docstring)
    app.connect("autodoc-process-signature", signature)
