"""Where compiled kernels are kept between starts, and that a damaged one is compiled again.

numba keeps them beside their source, or in the user's cache folder. `keep` adds what is missing there: a private
temporary folder where neither can be written to (numba would refuse to compile), and a digest of every file, because
numba takes a file cut short or overwritten for an error, and would run machine code that is not what it compiled.
"""

# mypy: disable-error-code="no-untyped-call, misc"

from __future__ import annotations

import hashlib
import logging
import os
import pickle
from pathlib import Path
from typing import Any

from numba.core import caching

from roam_core.temporary import private_folder

DIGEST = 32
"""Bytes of a SHA-256."""

FOLDER = "roam-kernels"

log = logging.getLogger(__name__)


class CheckedFile(caching.IndexDataCacheFile):
    """numba's two files of a kernel, each of which ends with the digest of what is pickled in it.

    Where one is damaged, or cannot be written, the kernel is compiled as if it had never been kept.
    """

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


def keep() -> None:
    """Have numba keep kernels so, in this process."""
    caching.IndexDataCacheFile = CheckedFile
    if TemporaryLocator not in caching.CacheImpl._locator_classes:
        caching.CacheImpl._locator_classes.append(TemporaryLocator)


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
