"""Where compiled kernels are kept between starts, and that a damaged one is compiled again.

numba keeps them beside their source, or in the user's cache folder. `keep` adds what is missing there: a private
temporary folder where neither can be written to (numba would refuse to compile), and a digest of every file, because
numba takes a file cut short or overwritten for an error, and would run machine code that is not what it compiled.

A stand-alone bundle is shipped with kernels in its folder `kernels`. They are compiled for processors of the last ten
years (`COMMON`), and a processor that has all of that uses them; on any other they are compiled once, for it. What is
compiled on a machine of the artist's goes to the user's cache folder: a bundle may lie where nobody can write.
"""

# mypy: disable-error-code="no-untyped-call, misc, attr-defined"

from __future__ import annotations

import hashlib
import logging
import os
import pickle
import platform
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm
import platformdirs
from numba.core import caching, config

from roam_core.installation import BUNDLE
from roam_core.temporary import private_folder

DIGEST = 32
"""Bytes of a SHA-256."""

FOLDER = "roam-kernels"

SHIPPED = "kernels"
"""The folder of a bundle with compiled kernels."""

COMMON: dict[str, tuple[str, frozenset[str]]] = {
    "x86_64": ("x86-64-v3", frozenset({"avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe"})),
    "arm64": ("apple-m1", frozenset()),  # the first of Apple's processors of this kind; the later ones have all of it
}
"""By machine: the processor, as LLVM calls it, that the kernels of a bundle are compiled for, and what it needs."""

log = logging.getLogger(__name__)


class CheckedFile(caching.IndexDataCacheFile):
    """numba's two files of a kernel, each of which ends with the digest of what is pickled in it.

    Where one is damaged, or cannot be written, the kernel is compiled as if it had never been kept. What is not kept is
    looked for in the bundle.
    """

    def __init__(self, cache_path: str, filename_base: str, source_stamp: Any) -> None:
        super().__init__(cache_path, filename_base, source_stamp)
        self._shipped: CheckedFile | None = None
        if BUNDLE is not None and Path(cache_path) != BUNDLE / SHIPPED:
            self._shipped = CheckedFile(str(BUNDLE / SHIPPED), filename_base, source_stamp)

    def load(self, key: Any) -> Any:
        kept = super().load(key)
        return kept if kept is not None or self._shipped is None else self._shipped.load(key)

    def _dump(self, obj: Any) -> bytes:
        content: bytes = super()._dump(obj)
        return content + hashlib.sha256(content).digest()  # unpickling stops before it

    def _load_index(self) -> dict[Any, str]:
        if not _is_whole(Path(self._index_path), pickle.dumps(self._version, protocol=-1)):
            return {}
        overloads: dict[Any, str] = super()._load_index()
        return overloads

    def _load_data(self, name: str) -> Any:
        path = Path(self._data_path(name))
        return super()._load_data(name) if _is_whole(path) else None

    def save(self, key: Any, data: Any) -> None:
        try:
            super().save(key, data)
        except OSError as error:  # a full disk: the kernel is there, and is compiled again at the next start
            log.warning("a compiled kernel cannot be kept: %s", error)


class TemporaryLocator(caching.UserWideCacheLocator):
    """Keeps kernels in a private temporary folder."""

    def __init__(self, py_func: Any, py_file: str) -> None:
        self._py_file = py_file
        self._lineno = py_func.__code__.co_firstlineno
        self._cache_path = str(private_folder(FOLDER) / self.get_suitable_cache_subpath(py_file))


class BundleLocator(caching.UserWideCacheLocator):
    """Keeps kernels of a bundle, whose modules are no files, where `NUMBA_CACHE_DIR` says, or in the user's cache."""

    def __init__(self, py_func: Any, py_file: str) -> None:
        self._py_file = py_file
        self._lineno = py_func.__code__.co_firstlineno
        self._cache_path = config.CACHE_DIR or str(platformdirs.user_cache_path("roam", appauthor=False) / SHIPPED)


def keep() -> None:
    """Have numba keep kernels so, in this process."""
    caching.IndexDataCacheFile = CheckedFile
    if BUNDLE is not None and BundleLocator not in caching.CacheImpl._locator_classes:
        caching.CacheImpl._locator_classes.insert(0, BundleLocator)
        compile_for_common_processors()
    if TemporaryLocator not in caching.CacheImpl._locator_classes:
        caching.CacheImpl._locator_classes.append(TemporaryLocator)


def compile_for_common_processors() -> bool:
    """Have numba compile for the processor of `COMMON`, where this one has all of it. Returns whether it does so.

    A processor that the user chose stays (`NUMBA_CPU_NAME`).
    """
    name, needed = COMMON.get(platform.machine().replace("AMD64", "x86_64"), ("", frozenset()))
    has = {feature for feature, is_there in llvm.get_host_cpu_features().items() if is_there}
    if not name or config.CPU_NAME is not None or not needed <= has:
        return False
    config.CPU_NAME, config.CPU_FEATURES = name, ""
    return True


def _is_whole(path: Path, head: bytes = b"") -> bool:
    """True for a file that begins with `head` and ends with the digest of what lies between."""
    try:
        content = path.read_bytes()
    except OSError:
        return False
    body = content[len(head) : -DIGEST]
    is_whole = content.startswith(head) and hashlib.sha256(body).digest() == content[-DIGEST:]
    if not is_whole:
        log.info("%s is damaged, or of another version; its kernel is compiled again", os.fspath(path))
    return is_whole
