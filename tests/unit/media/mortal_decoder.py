"""A process that decodes as ROAM's does, and goes wrong where the name of a file says so."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import numpy as np

from roam_core.media.decoding import worker

ENDLESS = sys.maxsize


class Mortal(worker.Worker):
    """Goes wrong in many ways."""

    def say(self, answer: dict[str, Any]) -> None:
        """Give the answer, or another one."""
        super().say(answer)

    def _image(self, file: str, layer: str, area: list[int] | None) -> worker.Result:
        match Path(file).stem.split(".")[0]:
            case "crash":
                os.abort()
            case "leave":
                os._exit(3)
            case "loop":
                sum(range(ENDLESS))
            case "greedy":
                bytearray(worker.MEMORY + 1)
            case "defect":
                raise KeyError("a defect of ours")
            case "rubbish":
                self._answers.write(b"\xff{rubbish\n")
            case "list":
                self._answers.write(b"[1, 2]\n")
            case "flood":
                self._answers.write(b"x" * (1 << 25))
            case "huge":
                self.say({"picture": {"shape": [1 << 20, 1 << 20, 3], "type": "uint8"}})
            case "short":
                self._shared.truncate(10)
                self.say({"picture": {"shape": [6000, 4000, 3], "type": "uint8"}})
            case "objects":
                self.say({"picture": {"shape": [2, 2, 3], "type": "object"}})
            case "nothing":
                return {}, None
            case "once":
                remembered = Path(file).with_suffix(".died")
                if not remembered.exists():
                    remembered.touch()
                    os.abort()
                return {}, np.zeros((2, 2, 3), np.uint8)
        return super()._image(file, layer, area)

    _tasks = {**worker.Worker._tasks, "image": _image}  # noqa: RUF012


if __name__ == "__main__":
    worker.Worker = Mortal  # type: ignore[misc]
    worker.main(sys.argv[1])
