"""Tcl itself as a judge of what Nuke is given: Python's own interpreter of it, or a `tclsh` behind a pipe."""

from __future__ import annotations

import atexit
import shutil
import subprocess
from functools import cache
from typing import Protocol

import pytest


class Tcl(Protocol):
    """As much of Tcl as a judge needs."""

    def node_bodies(self, script: str) -> list[str]:
        """Run a script that may hold nothing but `version`, Rotos, and what joins them; the bodies of the Rotos."""
        ...

    def node_body(self, script: str) -> str:
        """The body of a script's one Roto."""
        ...

    def split(self, text: str) -> list[str]:
        """The elements of a list."""
        ...


WORDS = """
proc version args {}
proc Roto body {lappend ::bodies $body}
foreach node {Merge2 Invert Multiply Clamp NoOp} {proc $node body {}}
proc unknown args {error "the script runs [lindex $args 0]"}
"""

# One request a line, both ways in hexadecimal UTF-8; an answer is the words of a list, or "!" and the error's text.
SERVER = """
fconfigure stdin -encoding ascii
fconfigure stdout -encoding ascii -buffering line
proc coded text {binary scan [encoding convertto utf-8 $text] H* digits; return .$digits}
proc decoded digits {encoding convertfrom utf-8 [binary format H* $digits]}
interp create judge
interp eval judge {WORDS}
while {[gets stdin line] >= 0} {
    set text [decoded [string range $line 1 end]]
    set failed [catch {
        if {[string index $line 0] eq "s"} {
            set words {}
            foreach word $text {lappend words [coded $word]}
        } else {
            interp eval judge {set ::bodies {}}
            interp eval judge $text
            set words {}
            foreach word [interp eval judge {set ::bodies}] {lappend words [coded $word]}
        }
    } message]
    if {$failed} {puts ![coded $message]} else {puts [join $words]}
}
""".replace("WORDS", WORDS)


class TkinterTcl:
    """The interpreter in Python's standard library."""

    def __init__(self) -> None:
        import tkinter

        self._interpreter = tkinter.Tcl()
        self._interpreter.eval(WORDS)

    def node_bodies(self, script: str) -> list[str]:
        self._interpreter.eval("set ::bodies {}")
        self._interpreter.eval(script)
        return self.split(str(self._interpreter.eval("set ::bodies")))

    def node_body(self, script: str) -> str:
        (body,) = self.node_bodies(script)
        return body

    def split(self, text: str) -> list[str]:
        return [str(word) for word in self._interpreter.splitlist(text)]


class TclshTcl:
    """A `tclsh` that answers requests line by line."""

    def __init__(self, program: str) -> None:
        self._process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert self._process.stdin is not None
        # `source` of a file would do, but a test should leave none behind: eval the server from its own first line.
        self._process.stdin.write("eval [encoding convertfrom utf-8 [binary format H* ")
        self._process.stdin.write(SERVER.encode().hex() + "]]\n")
        self._process.stdin.flush()

    def close(self) -> None:
        """Let the program end: it does at the end of its input."""
        self._process.communicate(timeout=120)

    def node_bodies(self, script: str) -> list[str]:
        return self._ask("e", script)

    def node_body(self, script: str) -> str:
        (body,) = self.node_bodies(script)
        return body

    def split(self, text: str) -> list[str]:
        return self._ask("s", text)

    def _ask(self, kind: str, text: str) -> list[str]:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(f"{kind}{text.encode().hex()}\n")
        self._process.stdin.flush()
        answer = self._process.stdout.readline().rstrip("\n")
        if answer.startswith("!"):
            raise ValueError(bytes.fromhex(answer[2:]).decode())
        return [bytes.fromhex(word[1:]).decode() for word in answer.split(" ") if word]


@cache
def available() -> Tcl:
    """One interpreter for the whole run; the test is skipped where the machine has none."""
    try:
        return TkinterTcl()
    except ImportError:
        pass
    program = shutil.which("tclsh")
    if program is None:
        pytest.skip("no Tcl here to judge the file: neither Python's tkinter nor a tclsh")
    interpreter = TclshTcl(program)
    atexit.register(interpreter.close)
    return interpreter
