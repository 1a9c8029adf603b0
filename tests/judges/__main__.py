"""Print the table of formats: `python -m tests.judges [--publish] [--formats a,b]`."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from benchmarks.report import with_block
from tests.judges.programs import JUDGES
from tests.judges.table import table

PAGE = Path(__file__).resolve().parents[2] / "docs" / "FORMATS.md"


def main() -> None:
    """Judge all formats, or those that were named, and print or publish the table."""
    parser = argparse.ArgumentParser(prog="python -m tests.judges", description=__doc__)
    parser.add_argument("--formats", help="only these, with commas between")
    parser.add_argument("--publish", action="store_true", help="renew the table in docs/FORMATS.md")
    given = parser.parse_args()
    wanted = given.formats.split(",") if given.formats else [judge.exporter for judge in JUDGES]
    judges = [judge for judge in JUDGES if judge.exporter in wanted]
    with tempfile.TemporaryDirectory() as folder:
        text = table(judges, Path(folder))
    absent = [f"{judge.exporter} was not judged: {judge.missing}." for judge in judges if judge.missing]
    print("\n".join([text, *absent]))
    if given.publish:
        if absent:
            raise SystemExit("The table was not published: some judges are missing.")
        PAGE.write_text(with_block(PAGE.read_text(encoding="utf-8"), "judges", text), encoding="utf-8")


if __name__ == "__main__":
    main()
