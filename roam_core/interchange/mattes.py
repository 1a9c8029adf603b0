"""PNG mattes: the antialiased matte of every frame as a grey picture."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from roam_core.cancel import CancelToken, Progress
from roam_core.errors import RoamError
from roam_core.interchange.protocol import STANDARD, ExportOptions, chosen_keys
from roam_core.matte import Matte, render_matte
from roam_core.roto import Layer, Project, RotoShape
from roam_core.roto.file import write_atomically

LEVELS: dict[int, type[np.unsignedinteger[Any]]] = {8: np.uint8, 16: np.uint16}


class MatteExporter:
    """Writes the joint matte of all visible shapes for every frame of the clip."""

    name = "mattes"
    title = "Mattes (PNG)"
    suffix = ".png"

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write one picture a frame.

        A `path` without the suffix is a folder, made when missing, for `matte.1001.png` and so on. With it, the frame's
        number goes in place of `####` or `%04d` in the file name, or before the suffix where there is neither.
        """
        clip = project.require_clip()
        folder, name_for = (path.parent, path.name) if path.suffix.lower() == self.suffix else (path, "matte.####.png")
        shown = replace(project, root=_chosen(project.root, options))
        write_mattes(
            shown,
            clip.frame_range,
            folder,
            _numbering(name_for, options.frame_offset),
            (clip.size[1], clip.size[0]),
            progress=options.progress,
            token=options.token,
        )
        return ()


def write_mattes(
    shapes: Project | Layer | Sequence[RotoShape],
    frames: Iterable[int],
    folder: Path,
    name_for: Callable[[int], str],
    size: tuple[int, int],
    *,
    progress: Progress | None = None,
    token: CancelToken | None = None,
    bits: int = 8,
) -> tuple[Path, ...]:
    """Render and write a PNG for each frame; each appears under its name only when it is whole.

    Parameters
    ----------
    shapes : a project, a layer or shapes in the order of compositing, as for `render_matte`.
    frames : the plate's frame numbers.
    folder : made when it is missing.
    name_for : gives the file name of a frame.
    size : (h, w) of the pictures.
    progress, token : told of, and asked before, every frame; a cancelled run leaves the frames that are finished.
    bits : 8 or 16.

    Returns
    -------
    The files, in the order of the frames.

    Raises
    ------
    RoamError
        when two frames have one name, a name is none, or a file cannot be written.
    Cancelled
        when the token was cancelled.
    """
    paths = _paths(frames, folder, name_for)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise RoamError(f"The folder {folder} cannot be made: {error.strerror}.") from None
    for done, (frame, path) in enumerate(paths.items()):
        if token is not None:
            token.check()
        if progress is not None:
            progress(done / len(paths), f"Matte of frame {frame}")
        write_matte(shapes, frame, path, size, bits=bits)
    if progress is not None:
        progress(1.0, f"{len(paths)} mattes written")
    return tuple(paths.values())


def write_matte(
    shapes: Project | Layer | Sequence[RotoShape], frame: int, path: Path, size: tuple[int, int], *, bits: int = 8
) -> None:
    """Render one frame's matte `(h, w)` = `size` and write it as PNG: to a temporary file beside `path`, then renamed.

    Raises `RoamError` when the file cannot be written.
    """
    write_atomically(path, encode_png(render_matte(shapes, frame, size), bits))


def encode_png(matte: Matte, bits: int = 8) -> bytes:
    """A matte `(h, w)` in [0, 1] as a grey PNG, rounded to the nearest of its 256 or 65536 levels."""
    if bits not in LEVELS:
        raise RoamError(f"Mattes have 8 or 16 bits, not {bits}.")
    white = float((1 << bits) - 1)
    written, buffer = cv2.imencode(".png", np.rint(matte.astype(np.float64) * white).astype(LEVELS[bits]))
    if not written:
        raise RoamError(f"A matte of {matte.shape[1]} x {matte.shape[0]} pixels cannot be encoded as PNG.")
    return buffer.tobytes()


def _paths(frames: Iterable[int], folder: Path, name_for: Callable[[int], str]) -> dict[int, Path]:
    """The file of each frame: plain names, no two of them equal."""
    paths: dict[int, Path] = {}
    taken: dict[str, int] = {}
    for frame in frames:
        name = name_for(frame)
        if name in ("", ".", "..") or name != Path(name).name or "\0" in name:
            raise RoamError(f"{name!r} is no file name for the matte of frame {frame}.")
        if taken.setdefault(name, frame) != frame:
            raise RoamError(f"The mattes of frames {taken[name]} and {frame} would both be named {name!r}.")
        paths[frame] = folder / name
    return paths


def _numbering(pattern: str, offset: int) -> Callable[[int], str]:
    """How a pattern such as `matte.####.png`, `matte.%04d.png` or plain `matte.png` names a frame."""
    marked = re.fullmatch(r"(.*?)(#+|%0(\d)d)(.*)", pattern, flags=re.DOTALL)
    if marked is None:
        stem, suffix = Path(pattern).stem, Path(pattern).suffix
        return lambda frame: f"{stem}.{frame + offset:04d}{suffix}"
    before, marks, digits, after = marked.groups()
    width = int(digits) if digits else len(marks)
    return lambda frame: f"{before}{frame + offset:0{width}d}{after}"


def _chosen(layer: Layer, options: ExportOptions) -> Layer:
    children = (_chosen(c, options) if isinstance(c, Layer) else chosen_keys(c, options) for c in layer.children)
    return replace(layer, children=tuple(children))
