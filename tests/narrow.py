"""A place for one thread at a time: what a lock has to hold, so that a test fails without it."""

from __future__ import annotations

import threading
from collections.abc import Callable


class Narrow:
    """Something for one thread at a time: it waits a moment for a second one, and counts how many were in it."""

    def __init__(self) -> None:
        self.inside, self.most = 0, 0
        self.changed = threading.Condition()

    def passed(self) -> None:
        with self.changed:
            self.inside += 1
            self.most = max(self.most, self.inside)
            self.changed.notify_all()
            self.changed.wait_for(lambda: self.inside > 1, timeout=0.05)
            self.inside -= 1

    def passed_by_two(self, work: Callable[[], object]) -> int:
        """The most threads that were in it at once, of two that do the same a few times over."""
        threads = [threading.Thread(target=lambda: [work() for _ in range(5)]) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return self.most
