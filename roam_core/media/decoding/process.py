"""One process that decodes: started, asked, watched, ended."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
from contextlib import suppress
from pathlib import Path
from typing import Any

from roam_core.errors import RoamError
from roam_core.media.decoding.answers import MOST_LINE, Answer, Garbled, NoRoom, SharedFile, taken, unpacked
from roam_core.media.source import DamagedFrame, MissingFrame
from roam_core.system_errors import reason_of
from roam_core.translatable import said_by, sentence

WORKER = "roam_core.media.decoding.worker"
"""The module that a process runs; the program of a bundle runs it as Python does."""
PATIENCE = 60.0
"""Seconds of the clock beyond those of the processor, for disks and servers that are slow, until a process is ended."""
START_SECONDS = 60.0
LEAVE_SECONDS = 2.0
OF_THE_HEAP, KEPT = 8 << 20, 32 << 20
"""Bytes up to which glibc takes memory from its heap, and of the heap that it keeps though they are free: the pages of
what is decoded of a frame are those of the frame before. Whole pictures of 4K are larger and go back to the system."""
_REFUSALS = {kind.__name__: kind for kind in (RoamError, MissingFrame, DamagedFrame, NoRoom)}


class Died(Exception):
    """The process ended before it answered, or was ended; the message says why, as the end of a sentence."""

    def __init__(self, why: str, *, is_final: bool) -> None:
        super().__init__(why)
        self.is_final = is_final
        """True where it would go no better a second time."""


class NotStarted(RoamError):
    """No process can be started here."""


class DecoderProcess:
    """A process that decodes for this one. It ends with it, and by `close`. One thread asks at a time.

    Raises
    ------
    NotStarted, NoRoom
        where there can be none.
    """

    def __init__(self) -> None:
        self._shared = SharedFile()
        command = [sys.executable, "-m", WORKER, self._shared.name]
        try:
            self._process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env=_environment(),
                pass_fds=() if self._shared.handle < 0 else (self._shared.handle,),
                # A key press that stops the program must not reach it: what is finished is still kept then.
                start_new_session=os.name != "nt",
                creationflags=_windows_flags(),
            )
        except OSError as error:
            self._shared.close()
            raise _not_started(reason_of(error)) from None
        self._is_ready = self._is_late = False

    def ask(self, task: str, words: dict[str, Any], seconds: float) -> Answer:
        """Have the process do a task of `roam_core.media.decoding.worker`.

        Parameters
        ----------
        words : the task's arguments, values of JSON. seconds : of the processor that it may take; a movie's may take
            as many for each picture that it passes.

        Raises
        ------
        RoamError, MissingFrame, DamagedFrame
            what the task raises; and where no process can be started.
        NoRoom
            where the picture does not fit into the file that both share.
        Died
            when the process did not answer; it is of no more use.
        """
        if not self._is_ready:
            self._greet()
        request = {"task": task, "seconds": seconds, "as here": as_here(), **words}
        try:
            assert self._process.stdin is not None
            self._process.stdin.write(json.dumps(request).encode() + b"\n")
            self._process.stdin.flush()
        except OSError:
            raise self._death(seconds) from None
        while line := self._line(seconds + PATIENCE):
            try:
                answer = taken(line, self._shared)
                if "alive" not in answer.fields:
                    return _told(answer)
            except Garbled as garbled:
                self.close()
                raise Died(sentence("it answered with {what}", what=said_by(garbled)), is_final=True) from None
        raise self._death(seconds)

    def close(self) -> None:
        """End the process."""
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                with suppress(OSError):
                    pipe.close()
        try:
            self._process.wait(LEAVE_SECONDS)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._shared.close()

    @property
    def process_id(self) -> int:
        """The number of the process."""
        return self._process.pid

    def _greet(self) -> None:
        """Wait until the process is there."""
        if not self._line(START_SECONDS):
            died = self._death(START_SECONDS)
            raise _not_started(said_by(died))
        self._shared.let_go_of_name()
        self._is_ready = True

    def _line(self, seconds: float) -> bytes:
        """The next line of the process; empty where it ended first, or was ended after so many seconds."""
        assert self._process.stdout is not None
        watch = threading.Timer(seconds, self._end_late)
        watch.daemon = True
        watch.start()
        try:
            line = self._process.stdout.readline(MOST_LINE)
        finally:
            watch.cancel()
        return line if line.endswith(b"\n") else b""

    def _end_late(self) -> None:
        self._is_late = True
        self._process.kill()

    def _death(self, seconds: float) -> Died:
        """Why the process did not answer."""
        with suppress(subprocess.TimeoutExpired):
            self._process.wait(LEAVE_SECONDS)
        code = self._process.poll()
        self.close()
        if self._is_late or code == -getattr(signal, "SIGPROF", 0):
            return Died(sentence("it takes longer than {seconds:.0f} seconds", seconds=seconds), is_final=True)
        how = sentence("what decodes it ended unexpectedly ({how})", how=_name_of(code))
        return Died(how, is_final=False)


def _told(answer: Answer) -> Answer:
    """The answer, where it is no refusal; else that is raised here. Raises `Garbled` where it is no sentence."""
    if (refusal := answer.fields.get("refused")) is not None:
        raise _REFUSALS.get(str(answer.fields.get("kind")), RoamError)(unpacked(refusal))
    if (defect := answer.fields.get("defect")) is not None:
        raise RuntimeError(f"in the process that decodes:\n{defect}")
    return answer


def _not_started(reason: str) -> NotStarted:
    return NotStarted(
        sentence(
            "The process that decodes pictures cannot be started ({reason}); install ROAM again, "
            "or set ROAM_DECODER=inside to do without one.",
            reason=reason,
        )
    )


def _name_of(code: int | None) -> str:
    """How a process ended, in a word."""
    if code is None:
        return sentence("it does not end")
    with suppress(ValueError):
        if code < 0:
            return signal.Signals(-code).name
    return sentence("exit code {code}", code=code)


def _environment() -> dict[str, str]:
    """What the process finds: no folder of the user's on the path of its modules, few threads that it needs not, memory
    that is used again.
    """
    return {
        **os.environ,
        "PYTHONSAFEPATH": "1",
        "OPENBLAS_NUM_THREADS": "1",
        "MALLOC_ARENA_MAX": "4",
        "MALLOC_MMAP_THRESHOLD_": str(OF_THE_HEAP),
        "MALLOC_TRIM_THRESHOLD_": str(KEPT),
    }


def _windows_flags() -> int:
    """No console window, and none of its Ctrl-C."""
    names = ("CREATE_NO_WINDOW", "CREATE_NEW_PROCESS_GROUP")
    return sum(int(getattr(subprocess, name, 0)) for name in names)


def as_here() -> dict[str, Any]:
    """What holds in this process and has to hold in the other: the configuration of colours, the number of threads."""
    import OpenImageIO as oiio  # noqa: N813 - a large library, for programs that decode

    return {"OCIO": os.environ.get("OCIO", ""), "threads": oiio.get_int_attribute("threads")}


def path_text(path: Path) -> str:
    """A path in a request: absolute, for the process may stand in another folder."""
    return str(path.absolute())
