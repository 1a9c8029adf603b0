"""The guard against references that the Qt bindings lose."""

from __future__ import annotations

import subprocess
import sys

MANY_CALLS = """
import app.canvas
from PySide6.QtCore import QObject, QRectF, Signal
class Sender(QObject):
    sent = Signal(int)
box, sender = QRectF(), Sender()
for _ in range(200_000):
    box.translate(0.0, 0.0)
    sender.sent.emit(1)
print("alive")
"""


def test_many_qt_calls_do_not_end_the_interpreter() -> None:
    # In a process of its own: without the guard it is aborted.
    done = subprocess.run([sys.executable, "-c", MANY_CALLS], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.strip(), done.stderr) == (0, "alive", "")
