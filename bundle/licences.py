"""The licences of all parts of a bundle, in one text. A part under the GPL alone or of no known licence ends the build.

Run by the interpreter of the build environment, with what the specification told of every file (`parts.json`):

    python -m bundle.licences parts.json LICENCES.txt
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import sysconfig
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from importlib.metadata import Distribution, distributions
from pathlib import Path

TEXTS = Path(__file__).parent / "texts"
REPLACED = "The libraries under the LGPL are files of their own in the bundle; another build of one may take its place."

SYSTEM = {
    "libbrotli1": "MIT",
    "libbsd0": "BSD-3-Clause",
    "libbz2-1.0": "bzip2-1.0.6",
    "libcom-err2": "MIT",
    "libexpat1": "MIT",
    "libffi8": "MIT",
    "libfontconfig1": "MIT",
    "libfreetype6": "FTL",
    "libgcc-s1": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "libglib2.0-0": "LGPL-2.1-or-later",
    "libglib2.0-0t64": "LGPL-2.1-or-later",
    "liblz4-1": "BSD-2-Clause",
    "liblzma5": "0BSD",
    "libmd0": "BSD-3-Clause",
    "libpcre2-8-0": "BSD-3-Clause",
    "libpng16-16": "libpng-2.0",
    "libpng16-16t64": "libpng-2.0",
    "libsqlite3-0": "blessing",
    "libssl3": "Apache-2.0",
    "libssl3t64": "Apache-2.0",
    "libstdc++6": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "libuuid1": "BSD-3-Clause",
    "libzstd1": "BSD-3-Clause",
    "zlib1g": "Zlib",
}
"""Packages of Debian and Ubuntu whose libraries a bundle may hold, with their licence; and those of `X`."""
X = re.compile(r"libx(11|au|cb|dmcp|ext|render|kbcommon)[a-z0-9-]*|libwayland-[a-z]+0")
"""Packages of X and Wayland: all of them MIT."""

WITHOUT_TEXT = {
    "pyside6_essentials": ("LGPL-3.0.txt", "GPL-3.0.txt"),
    "shiboken6": ("LGPL-3.0.txt", "GPL-3.0.txt"),
}
"""Distributions that hold no text of their licence, and where it lies here."""


NAMED = {"opencolorio": "BSD-3-Clause", "openexr": "BSD-3-Clause"}
"""Distributions that give the text of their licence where others give its name, or its text alone."""


class Refused(Exception):
    """A part may not be in a bundle, or nothing is known of it."""


@dataclass(frozen=True)
class Part:
    """A part of the bundle: its name, version and licence, and the texts of it."""

    name: str
    version: str
    licence: str
    texts: tuple[str, ...]


def may_be_shipped(licence: str) -> bool:
    """Whether one of the alternatives of a licence is free of the GPL, or of its reach by an exception."""
    choices = re.split(r"\s+OR\s+", licence)
    return any(all(_is_free(each) for each in re.split(r"\s+AND\s+|;", choice)) for choice in choices)


def _is_free(licence: str) -> bool:
    is_gpl = re.search(r"(?<!L)(?<!Lesser )(\bA?GPL|GNU (Affero )?General Public)", licence, re.IGNORECASE) is not None
    return not is_gpl or re.search(r"\bWITH\b|exception", licence, re.IGNORECASE) is not None


def parts(files: Iterable[tuple[str, str]]) -> list[Part]:
    """All parts of a bundle by the (place, source) of its files, sorted by name."""
    sources = {Path(source).resolve() for _, source in files}
    found: list[Part] = []
    owned: set[Path] = set()
    for distribution in distributions():
        own = {Path(str(distribution.locate_file(path))).resolve() for path in distribution.files or ()}
        if own & sources and distribution.name.casefold() != "pyinstaller":
            found.append(_of_distribution(distribution))
            owned |= own
    others = {path for path in sources - owned if ".so" in path.name and not is_of_python(path)}
    found += _of_system(others)
    found += [_python(), _loader()]
    for part in found:
        if not may_be_shipped(part.licence):
            raise Refused(f"{part.name} {part.version} is under {part.licence}: it may not be in the bundle.")
    return sorted(found, key=lambda part: part.name.casefold())


def is_of_python(path: Path) -> bool:
    """Whether a file is the interpreter's, or lies in its environment; not the system's, though it may lie beside."""
    homes = [sys.prefix, sysconfig.get_paths()["stdlib"]]
    if sys.base_prefix != "/usr":
        homes.append(sys.base_prefix)
    return path.name.startswith("libpython") or any(path.is_relative_to(Path(home).resolve()) for home in homes)


def _python() -> Part:
    version = "{}.{}.{}".format(*sys.version_info)
    base = Path(sys.base_prefix)
    places = [*base.glob("lib/python3*/LICENSE.txt"), *base.glob("LICENSE.txt"), *base.glob("LICENSE")]
    places += Path("/usr/share/doc").glob(f"python3.{sys.version_info[1]}/copyright")
    if not places:
        raise Refused(f"The licence of Python {version} was not found under {base}.")
    return Part("Python", version, "PSF-2.0", (_text(places[0]),))


def _loader() -> Part:
    """The program that starts the interpreter; PyInstaller's licence lets everybody ship it under any terms."""
    (found,) = (each for each in distributions() if each.name.casefold() == "pyinstaller")
    return Part("PyInstaller's loader", found.version, "GPL-2.0-or-later WITH Bootloader-exception", _texts(found))


def _of_distribution(found: Distribution) -> Part:
    data = found.metadata
    named = [text.rpartition(" :: ")[2] for text in data.get_all("Classifier") or () if text.startswith("License ::")]
    short = (data.get("License") or "").strip().splitlines()
    named_here = NAMED.get(found.name.casefold())
    licence = named_here or data.get("License-Expression") or (short[0] if len(short) == 1 else " OR ".join(named))
    licence = licence or (short[0] if short else "")
    texts = _texts(found)
    if not licence or not texts:
        raise Refused(f"{found.name} {found.version} does not say what licence it is under.")
    return Part(found.name, found.version, licence, texts)


def _texts(found: Distribution) -> tuple[str, ...]:
    names = [
        path
        for path in found.files or ()
        if re.search(r"LICEN[CS]E|COPYING|NOTICE|THIRD.?PARTY", path.name, re.IGNORECASE)
        and path.suffix.casefold() in ("", ".txt", ".md", ".rst", ".thirdparty", ".third-party", ".apache", ".bsd")
    ]
    texts = [_text(Path(str(found.locate_file(path)))) for path in names]
    texts += [_text(TEXTS / name) for name in WITHOUT_TEXT.get(found.name.casefold().replace("-", "_"), ())]
    return tuple(dict.fromkeys(texts))  # some are there twice


def _of_system(paths: Iterable[Path]) -> Iterator[Part]:
    packages: dict[str, str] = {}
    for path in paths:
        package = package_of(path)
        licence = "MIT" if X.fullmatch(package) else SYSTEM.get(package)
        if licence is None:
            raise Refused(
                f"{path} is of {package or 'no package'}, whose licence is not known; see bundle/licences.py."
            )
        packages[package] = licence
    for package, licence in packages.items():
        text = _text(Path("/usr/share/doc") / package / "copyright")
        more = (_text(TEXTS / "LGPL-2.1.txt"),) if licence.startswith("LGPL-2.1") else ()
        yield Part(package, _version(package), licence, (text, *more))


def package_of(path: Path) -> str:
    """The package of Debian or Ubuntu that a library came with; "" where there is none."""
    for name in (str(path), str(path).removeprefix("/usr")):  # some packages list /lib, which is a link to /usr/lib
        try:
            done = subprocess.run(["dpkg-query", "-S", name], capture_output=True, text=True, check=False)
        except FileNotFoundError:
            return ""
        if done.returncode == 0:
            return done.stdout.split(":")[0]
    return ""


def _version(package: str) -> str:
    command = ["dpkg-query", "-W", "-f=${Version}", package]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[0]


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="replace").strip()


def document(found: Iterable[Part]) -> str:
    """The text: a list of all parts, and then each licence in full, once."""
    found = list(found)
    width = max(len(part.name) + len(part.version) for part in found) + 1
    lines = ["What this bundle of ROAM is made of.", "", REPLACED, ""]
    lines += [f"{f'{part.name} {part.version}':<{width}}  {part.licence}" for part in found]
    by_text: dict[str, list[str]] = {}
    for part in found:
        for text in part.texts:
            by_text.setdefault(text, []).append(part.name)
    for text, names in by_text.items():
        lines += ["", "=" * 100, ", ".join(names), "=" * 100, "", text]
    return "\n".join(lines) + "\n"


def main() -> int:
    """Write the text; 1 where a part may not be shipped."""
    listed, target = map(Path, sys.argv[1:])
    try:
        text = document(parts([(place, source) for place, source in json.loads(listed.read_text(encoding="utf-8"))]))
    except Refused as refused:
        print(refused, file=sys.stderr)
        return 1
    target.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
