"""The window's texts for translators: `make translations` takes them out of the code, and compiles what is translated.

`pyside6-lupdate` finds what is written as `tr("...")`, `N_("...")` and `sentence("...")`, and puts it into
`resources/translations`; texts that are new there wait for Qt Linguist. `pyside6-lrelease`
makes of each the file that the window loads.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from app.translation import LANGUAGES, SOURCE

ROOT = Path(__file__).resolve().parents[1]
TRANSLATIONS = ROOT / "resources" / "translations"
ROOMS = ("app", "roam_core")
MARKS = "QT_TR_NOOP+=N_,QT_TR_NOOP+=sentence"
"""What this house writes where Qt looks for its own marks."""


def main() -> int:
    """Renew all languages. Returns the exit code: 1 where texts wait for their translation."""
    waiting = 0
    for language in LANGUAGES:
        if language != SOURCE:
            ts = TRANSLATIONS / f"roam_{language}.ts"
            extract(ts, language)
            release(ts, ts.with_suffix(".qm"))
            waiting += ts.read_text(encoding="utf-8").count('type="unfinished"')
    if waiting:
        print(f"translations: {waiting} texts wait for their translation; open resources/translations in Qt Linguist.")
    return int(waiting > 0)


def extract(ts: Path, language: str) -> None:
    """Bring the texts of the code into `ts`; translations that are there stay, texts that are gone go."""
    sources = [str(path.relative_to(ROOT)) for room in ROOMS for path in sorted((ROOT / room).rglob("*.py"))]
    options = ["-silent", "-no-obsolete", "-locations", "none", "-sort-messages", "-tr-function-alias", MARKS]
    languages = ["-source-language", SOURCE, "-target-language", language]
    _run("pyside6-lupdate", *options, *languages, *sources, "-ts", str(ts))


def release(ts: Path, qm: Path) -> None:
    """Compile what is translated in `ts` to `qm`."""
    _run("pyside6-lrelease", "-silent", str(ts), "-qm", str(qm))


def _run(tool: str, *arguments: str) -> None:
    subprocess.run([str(Path(sys.executable).with_name(tool)), *arguments], cwd=ROOT, check=True)


if __name__ == "__main__":
    sys.exit(main())
