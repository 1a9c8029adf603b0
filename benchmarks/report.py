"""Where results go: a table on the terminal, JSON into `out/`, and on demand the table into `docs/BENCHMARKS.md`."""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Mapping, Sequence
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
OUT = ROOT / "out" / "benchmarks"
PAGE = ROOT / "docs" / "BENCHMARKS.md"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table, its columns padded so that it also reads well on a terminal."""
    cells = [list(head), *[list(row) for row in rows]]
    widths = [max(len(row[k]) for row in cells) for k in range(len(head))]

    def line(row: Sequence[str]) -> str:
        padded = [
            cell.rjust(width) if k else cell.ljust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        return "| " + " | ".join(padded) + " |"

    rule = "|" + "|".join("-" * (w + 2) if k == 0 else "-" * (w + 1) + ":" for k, w in enumerate(widths)) + "|"
    return "\n".join([line(cells[0]), rule, *(line(row) for row in cells[1:])])


def circumstances() -> str:
    """When and on what this was measured, in one line."""
    load = f", load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else ""
    machine = f"{_processor()}, {os.cpu_count()} cores{load}"
    return f"{date.today().isoformat()} · {machine} · Python {platform.python_version()}, NumPy {np.__version__}"


def write(name: str, text: str, result: Mapping[str, Any], *, publish: bool) -> None:
    """Print the table, keep the numbers in `out/benchmarks/NAME.json`, and with `publish` renew the page's block."""
    print(f"\n{text}")
    OUT.mkdir(parents=True, exist_ok=True)
    path = OUT / f"{name.replace(' ', '-')}.json"
    path.write_text(json.dumps({"measured": circumstances(), **result}, indent=1) + "\n", encoding="utf-8")
    print(f"\nWrote {path.relative_to(ROOT)}.")
    if publish:
        PAGE.write_text(with_block(PAGE.read_text(encoding="utf-8"), name, text), encoding="utf-8")
        print(f"Renewed the table {name!r} in {PAGE.relative_to(ROOT)}.")


def with_block(page: str, name: str, text: str) -> str:
    """The page with `text` between the marks of `name`; a block that is not there yet is put at the end."""
    begin, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
    block = f"{begin}\n{text}\n{end}"
    head, found, rest = page.partition(begin)
    if not found:
        return f"{page.rstrip()}\n\n{block}\n"
    return head + block + rest.partition(end)[2]


def _processor() -> str:
    """The processor's name, without the ornaments of its maker."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = [line.partition(":")[2] for line in lines if line.startswith("model name")]
    return " ".join((names or [platform.machine()])[0].replace("(R)", "").replace("(TM)", "").split())
