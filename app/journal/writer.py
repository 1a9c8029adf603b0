"""The journal's writer: a thread of its own that appends every state of the project as a delta, and flushes it."""

from __future__ import annotations

import errno
import logging
import os
import queue
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import IO

from roam_core.atomic_write import flush_file, write_atomically
from roam_core.errors import RoamError
from roam_core.roto import Project, file
from roam_core.roto.fingerprint import Fingerprint
from roam_core.system_errors import reason_of

from ..model.beginning import Beginning
from ..translation import tr, translated
from .delta import between
from .record import Entry, append
from .session import RECOVERED, Session

VERSION = 2
ROOT = Path("/")
"""The folder from which the texts in a journal name the plate."""
MOST_DELTAS = 8 << 20
"""Bytes of deltas after which the whole project is written beside them, so that a replay stays short."""
DELTAS_PER_BASE = 2
"""The same as a multiple of the last whole project: large ones are not written all the time."""
COPIED = 1 << 20
"""Bytes of the artist's file that are copied at a time."""
BASES = 2
"""Whole projects that are kept of a journal: the last one may be damaged."""
AGAIN = 1.0
"""Seconds until a write that failed is tried again."""

log = logging.getLogger(__name__)


@dataclass(frozen=True)
class _State:
    project: Project
    is_modified: bool
    when: float
    edits: int = 1


@dataclass(frozen=True)
class _End:
    why: str


@dataclass(frozen=True)
class _Change:
    """From here on edits build on something else; `state` is what that does not hold, if anything."""

    why: str
    beginning: Beginning
    state: _State | None


@dataclass(frozen=True)
class _Saving:
    """The work is being written to a file that is not the one that it builds on."""

    path: Path


@dataclass(frozen=True)
class _BaseIsWritten:
    """The thread that writes whole projects has finished one."""


@dataclass(frozen=True)
class _Reached:
    event: threading.Event


class JournalWriter:
    """Takes states of the project from the window and never lets it wait.

    `refused(sentence)` is called, on the writer's thread, when the journal cannot be written; once for
    each journal, until it can again. Then `restored(sentence)` is.
    """

    def __init__(self, session: Session, refused: Callable[[str], object], restored: Callable[[str], object]) -> None:
        self._session, self._refused, self._restored = session, refused, restored
        self._queue: queue.SimpleQueue[object] = queue.SimpleQueue()
        self._open: _Open | None = None
        self._superseded: list[tuple[_Open, str]] = []
        self._broken: list[Path] = []
        self._beginning = Beginning(Project())
        self._waiting: _State | None = None
        self._is_refused = self._is_told = False
        self._thread = threading.Thread(target=self._run, name="roam-journal", daemon=True)
        self._thread.start()

    def change(self, why: str, beginning: Beginning, unsaved: Project | None = None) -> None:
        """Go on with another project, or from another file; the journal until now ends as `saved` or `discarded`.

        `unsaved` is the project where no file holds it. Only when it lies in the next journal the last one ends, which
        may be the only one to hold it. Without it the next journal is made with the first edit.
        """
        state = None if unsaved is None else _State(unsaved, True, time.time())
        self._queue.put(_Change(why, beginning, state))

    def note(self, project: Project, *, is_modified: bool) -> None:
        """Keep this state."""
        self._queue.put(_State(project, is_modified, time.time()))

    def saving(self, path: Path) -> None:
        """Keep where the work is about to be saved: ended meanwhile, it may lie there though nobody noted it."""
        self._queue.put(_Saving(path))

    def end(self, why: str) -> None:
        """Nothing of the journal needs to be recovered: its work is `saved` or `discarded`."""
        self._queue.put(_End(why))

    def flush(self, wait: float = 10.0) -> bool:
        """Wait until all that was noted is on the disk; False when it takes longer, or cannot be written."""
        reached = _Reached(threading.Event())
        self._queue.put(reached)
        return reached.event.wait(wait) and not self._is_refused

    def close(self, wait: float = 10.0) -> bool:
        """End the thread when all is written; False when it takes longer than `wait` seconds."""
        self._queue.put(None)
        self._thread.join(wait)
        return not self._thread.is_alive()

    # ---- the writer's thread

    def _run(self) -> None:
        while True:
            try:
                wish = self._queue.get(timeout=AGAIN if self._waiting else None)
            except queue.Empty:
                self._keep_waiting()
                continue
            try:
                if isinstance(wish, _State):
                    wish = self._latest(wish)
                if wish is None:
                    break
                self._do(wish)
            except Exception as error:  # the thread lives on: the next edit may be written
                self._refuse(error)
        self._leave()

    def _latest(self, state: _State) -> object:
        """Take states that arrived meanwhile together: the last one holds what those before it hold."""
        while not self._queue.empty():
            following = self._queue.get()
            if not isinstance(following, _State):
                self._do(state)
                return following
            state = replace(following, edits=state.edits + following.edits)
        return state

    def _do(self, wish: object) -> None:
        if isinstance(wish, _State):
            if self._waiting is not None:
                wish = replace(wish, edits=wish.edits + self._waiting.edits)
            self._waiting = wish
            self._keep_waiting()
        elif isinstance(wish, _Reached):
            if self._open is not None:
                self._open.settle()
            wish.event.set()
        elif isinstance(wish, _End):
            self._end(wish.why)
        elif isinstance(wish, _BaseIsWritten) and self._open is not None:
            self._open.note_base()
        elif isinstance(wish, _Change):
            self._change(wish)
        elif isinstance(wish, _Saving) and self._open is not None and not self._open.is_broken:
            self._open.note_saving(wish.path)

    def _change(self, wish: _Change) -> None:
        self._is_told = False  # as after a save, whose own sentence stands now where that of the journal stood
        if wish.state is None:
            self._end(wish.why)
            self._beginning = wish.beginning
            return
        if self._open is not None:
            self._superseded.append((self._open, wish.why))
        self._open, self._beginning, self._waiting = None, wish.beginning, wish.state
        self._keep_waiting()

    def _keep_waiting(self) -> None:
        """Write the state that waits; where that fails it goes on waiting."""
        state = self._waiting
        assert state is not None
        try:
            if self._open is None:
                self._open = _Open.on(self._session.new_path(), self._beginning, self._queue.put)
            self._open.keep(state)
        except Exception as error:
            self._refuse(error)
            if self._open is not None and self._open.is_broken:
                self._open.close()
                self._broken.append(self._open.path)
                self._open = None  # the next try begins another file
        else:
            self._waiting = None
            if self._is_refused:
                self._is_refused = self._is_told = False
                self._restored(tr("The journal is written again; it holds all your edits."))
            self._end_superseded()

    def _end_superseded(self) -> None:
        """End the journals whose work lies elsewhere now; of one that broke nothing more can be written into it."""
        for journal, why in self._superseded:
            self._end_one(journal, why)
        for path in self._broken:
            with suppress(OSError):
                if path.exists():
                    path.with_suffix(RECOVERED).touch()
        self._superseded, self._broken = [], []

    def _refuse(self, error: Exception) -> None:
        self._is_refused = True
        if not self._is_told:
            self._is_told = True
            log.error("the journal cannot be written", exc_info=error)
            reason = translated(reason_of(error))
            self._refused(
                tr("Your edits cannot be written to the journal ({reason}); save the project yourself.", reason=reason)
            )

    def _end(self, why: str) -> None:
        self._waiting = None
        self._end_superseded()
        if self._open is not None:
            self._end_one(self._open, why)
            self._open = None

    def _end_one(self, journal: _Open, why: str) -> None:
        """Write that nothing of a journal needs to be recovered, and close it."""
        try:
            journal.write(Entry({"kind": "end", "why": why}))
        except OSError:
            log.exception("the journal cannot be ended")
            why = ""
        journal.close()
        if why == "saved":
            with suppress(OSError):
                self._session.note_saved(journal.path)

    def _leave(self) -> None:
        for journal in (*(each for each, _ in self._superseded), self._open):
            if journal is not None:
                journal.close()
        self._superseded, self._open = [], None


class _Open:
    """A journal file that is being written."""

    def __init__(self, path: Path, stream: IO[bytes], beginning: Beginning, post: Callable[[object], None]) -> None:
        self.path, self._stream, self._post = path, stream, post
        self._beginning = beginning
        self._last = beginning.project if beginning.is_on_file else Project()
        self._length = self._since_base = 0
        self._after = 0
        self._copying: threading.Thread | None = None
        self._made: Entry | None = None
        self._bases: list[Path] = []
        self.is_broken = False
        """True where something half written could not be taken back."""
        self._needs_base = beginning.is_on_file

    @classmethod
    def on(cls, path: Path, beginning: Beginning, post: Callable[[object], None]) -> _Open:
        """Begin a journal file."""
        stream = path.open("xb", buffering=0)
        journal = cls(path, stream, beginning, post)
        held = beginning.fingerprint
        try:
            header = {"kind": "begin", "version": VERSION, "time": time.time(), "is_on_file": beginning.is_on_file}
            original = None if beginning.original is None else str(beginning.original)
            follows = None if beginning.follows is None else beginning.follows.name
            digest = held.digest if held else None
            journal.write(Entry(header | {"original": original, "digest": digest, "follows": follows}))
        except BaseException:
            stream.close()
            path.unlink(missing_ok=True)
            raise
        return journal

    def keep(self, state: _State) -> None:
        """Append what a state adds to the one before it."""
        delta = between(self._last, state.project)
        clip = state.project.clip
        header = {
            "kind": "edit",
            "time": state.when,
            "is_modified": state.is_modified,
            "edits": state.edits,
            "tracked": delta.tracked,
            "ids": delta.ids,
            "clip": None if clip is None else str(clip.path),
            "tree": delta.tree,
            "dropped": delta.dropped,
            "partly": delta.partly,
        }
        self._since_base += self.write(Entry(header, file.dumps(delta.parts, ROOT)))
        self._last = state.project
        self._after += 1
        if self._after == 1 and self._beginning.follows is not None:
            with suppress(OSError):  # a folder that cannot be written to: it is offered once more
                self._beginning.follows.with_suffix(RECOVERED).touch()
        self._consider_base()

    def write(self, entry: Entry) -> int:
        """Append an entry and flush it to the disk; where that fails, the file ends where it ended before."""
        try:
            written = append(self._stream, entry)
            flush_file(self._stream.fileno())
            self._require_name()
        except OSError:
            self._take_back()
            raise
        self._length += written
        return written

    def _require_name(self) -> None:
        """Raise `OSError` where the file was deleted: what goes into it is gone with the program, without an error."""
        if os.fstat(self._stream.fileno()).st_nlink == 0:
            self.is_broken = True
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))

    def _take_back(self) -> None:
        """Let the file end where it ended before a write that failed."""
        try:
            self._stream.truncate(self._length)
            self._stream.seek(self._length)
        except OSError:
            self.is_broken = True

    def note_base(self) -> None:
        """Tell of a whole project that was written, if there is one that was not told of yet."""
        made, self._made = self._made, None
        if made is not None and not self.is_broken:
            try:
                self.write(made)
            except OSError:
                log.exception("a base of the journal cannot be noted")
                return
            self._bases.append(self.path.with_name(str(made.header["name"])))
            for old in self._bases[:-BASES]:
                with suppress(OSError):
                    old.unlink(missing_ok=True)
            self._bases = self._bases[-BASES:]

    def note_saving(self, path: Path) -> None:
        """Tell to which file the work is about to be saved; without it, that work is offered once more."""
        try:
            self.write(Entry({"kind": "saving", "path": str(path)}))
        except OSError:
            log.exception("where the work is saved cannot be noted")

    def settle(self) -> None:
        """Wait for a base that is being written: without it edits may not be enough, once the artist's file changes."""
        if self._copying is not None:
            self._copying.join()
        self.note_base()

    def close(self) -> None:
        self.settle()
        with suppress(OSError):  # a share may fail now; all of it was flushed
            self._stream.close()

    def _consider_base(self) -> None:
        """Have the whole project written beside the deltas: first a copy of the artist's file, later anew."""
        if self._copying is not None and self._copying.is_alive():
            return
        if self._needs_base:
            self._needs_base = False
            self._write_base(0, self._beginning.project, self._copied_original)
        elif self._since_base > max(MOST_DELTAS, DELTAS_PER_BASE * self._base_bytes()):
            self._since_base = 0
            self._write_base(self._after, self._last, lambda _: False)

    def _base_bytes(self) -> int:
        try:
            return self._bases[-1].stat().st_size if self._bases else 0
        except OSError:
            return 0

    def _write_base(self, after: int, project: Project, copied: Callable[[Path], bool]) -> None:
        """On a thread of its own: a large project takes seconds, and edits go on to be written meanwhile."""
        target = self.path.with_name(f"{self.path.stem}-{after:06d}.roam")
        original = self._beginning.original

        def work() -> None:
            try:
                if original is not None and copied(target):
                    folder = original.parent
                else:
                    write_atomically(target, file.contents(project, ROOT))
                    folder = ROOT
                self._made = Entry({"kind": "base", "name": target.name, "after": after, "folder": str(folder)})
                self._post(_BaseIsWritten())
            except (OSError, ValueError, RoamError):
                log.exception("a base of the journal cannot be written")

        self._copying = threading.Thread(target=work, name="roam-journal-base", daemon=True)
        self._copying.start()

    def _copied_original(self, target: Path) -> bool:
        """Whether the artist's file could be copied as it was when it was read or saved."""
        original, held = self._beginning.original, self._beginning.fingerprint
        assert original is not None
        assert held is not None
        try:
            with original.open("rb") as opened:
                write_atomically(target, iter(partial(opened.read, COPIED), b""))
        except OSError:
            return False
        now = Fingerprint.of(target)
        return now is not None and now.digest == held.digest
