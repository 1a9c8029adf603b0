"""`python -m tests.fuzz READER --minutes M`: damages small whole files, and reports what a reader makes of them.

A reader may give a value or raise `RoamError`. Any other exception, more than five seconds, or more than a gibibyte is
a finding: its file is kept in the folder that `--keep` names, and belongs in `tests/golden/hostile` once it is mended,
where `tests/property/test_fuzz.py` reads it again. Files are read in a child process, which is replaced when it dies.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import multiprocessing
import os
import random
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Iterator
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path

import cv2
import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses

from roam_core.bounded import bounded_bytes
from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, read_shapes
from roam_core.interchange.registry import SHAPE_SUFFIXES
from roam_core.matte.vectorise import read_mask
from roam_core.media import open_clip
from roam_core.media.colour import to_engine
from roam_core.roto import Clip, Interpolation, Keyframe, Layer, Project, RotoShape, file

CLIP = Clip(Path("plate"), 1001, 1040, (640, 480))
MOST_SECONDS, MOST_MEMORY = 5.0, 1 << 30
SEED = 17
LOOKED_AT = 4
"""Layers of a damaged picture that are read."""
WORDS = (
    b"nan", b"inf", b"-1e308", b"1e12", b"99999999999999999999", b"0", b"-1", b"{", b"}", b"[", b"]", b"<", b">", b'"',
    b"\\", b"\0", b"&x;", b"null", b"true", b"\xff\xff\xff\xff", b"\x7f\xff\xff\xff", b"\0\0\0\0", b"<a>", b"M",
    b"A1 1 1 1 1 1 1",
)  # fmt: skip


# ---- readers, and the whole files that are damaged -------------------------------------------------------------------


def project() -> Project:
    """A small project with two layers and every kind of key."""
    rng = np.random.default_rng(SEED)
    shapes = tuple(
        RotoShape(
            f"s{number}",
            f"S{number}",
            tuple(
                Keyframe(1001 + 5 * k, rng.uniform(0, 400, (4, 3, 2)), interpolation=kind)
                for k, kind in enumerate(Interpolation)
            ),
        )
        for number in range(3)
    )
    return Project(CLIP, Layer("root", "Root", (shapes[0], Layer("l", "Inner", shapes[1:]))))


def written(name: str, folder: Path) -> bytes:
    """A whole file of a format for shapes, or a project."""
    path = folder / f"whole {name}" / "file"
    path.parent.mkdir(exist_ok=True)
    if name == "project":
        file.save(project(), path)
    else:
        EXPORTERS[name].export(project(), path, ExportOptions(lossy=True))
    return min(path.parent.iterdir()).read_bytes()


def picture(suffix: str, folder: Path) -> bytes:
    """A whole picture of 16 x 12 pixels."""
    path = folder / f"whole{suffix}"
    pixels = np.random.default_rng(SEED).integers(0, 255, (12, 16, 3), dtype=np.uint8)
    output = oiio.ImageOutput.create(str(path))
    output.open(str(path), oiio.ImageSpec(16, 12, 3, "half" if suffix == ".exr" else "uint8"))
    output.write_image(pixels)
    output.close()
    return path.read_bytes()


def parts(compression: str, folder: Path) -> bytes:
    """A whole EXR of three parts, one of them with two layers, that says what its colours are."""
    path = folder / "parts.exr"
    specs = []
    for name, channels in (
        ("depth", ("Z",)),
        ("beauty", ("R", "G", "B", "A")),
        ("light", ("a.R", "a.G", "a.B", "b.R")),
    ):
        spec = oiio.ImageSpec(16, 12, len(channels), "half")
        spec.channelnames = channels
        spec.attribute("oiio:subimagename", name)
        spec.attribute("compression", compression)
        spec.attribute(
            "chromaticities", oiio.TypeDesc("float[8]"), (0.713, 0.293, 0.165, 0.83, 0.128, 0.044, 0.32, 0.34)
        )
        specs.append(spec)
    rng = np.random.default_rng(SEED)
    output = oiio.ImageOutput.create(str(path))
    output.open(str(path), specs)
    for index, spec in enumerate(specs):
        if index:
            output.open(str(path), spec, "AppendSubimage")
        output.write_image(rng.random((12, 16, spec.nchannels), dtype=np.float32))
    output.close()
    return path.read_bytes()


def movie(codec: str, folder: Path) -> bytes:
    """A whole movie of six frames of 64 x 48 pixels."""
    path = folder / ("whole.mp4" if codec == "mp4v" else "whole.avi")
    writer = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, cv2.VideoWriter.fourcc(*codec), 24.0, (64, 48))
    rng = np.random.default_rng(SEED)
    for _ in range(6):
        writer.write(rng.integers(0, 255, (48, 64, 3), dtype=np.uint8))
    writer.release()
    return path.read_bytes()


def settings(name: str, _: Path) -> bytes:
    """A whole settings file."""
    documents: dict[str, dict[str, object]] = {
        "preferences": {
            "cache_gigabytes": 2.5,
            "threads": 3,
            "config": "lean",
            "scale": 1.5,
            "asks_about_clips": False,
        },
        "keymap": {"based_on": "nuke", "keys": {"tool.bezier": ["F9", "Ctrl+]"], "time.play": []}},
        "recent": {"recent": [{"path": "/a/b.roam", "when": 1.5e9}, {"path": "/c", "when": 3}]},
    }
    return json.dumps(documents[name], indent=1).encode()


def read_shape_file(path: Path) -> object:
    """As `roam import`: what comes is written too, for what a project cannot hold must not come."""
    imported = read_shapes(path, CLIP)
    return file.dumps(Project(CLIP, imported.layer), path.parent)


def read_picture(path: Path) -> object:
    """As a plate is opened and its first frame read."""
    source = open_clip(path)
    return to_engine(source.read(source.frames[0]), source.colour_space)


def read_every_layer(path: Path) -> object:
    """As an artist looks at some layers of a plate; one that cannot be read keeps none of the others back."""
    read = []
    source = open_clip(path)
    for layer in source.layers[:LOOKED_AT]:
        with suppress(RoamError):
            read.append(open_clip(path, layer).read(source.frames[0]))
    return read


def read_movie(path: Path) -> object:
    """As a movie is opened and gone through."""
    source = open_clip(path)
    read = []
    for frame in source.frames:
        with suppress(RoamError):
            read.append(source.read(frame))
    return read


def read_project(path: Path) -> object:
    """As `roam info` opens it; what was read is written, for that is what a save does next."""
    return file.dumps(file.load(path), path.parent)


def read_settings(name: str) -> Callable[[Path], object]:
    """The loader of a settings file, loaded when it is asked for: it brings Qt along."""

    def read(path: Path) -> object:
        from app.actions import keymaps
        from app.model import preferences, recent

        loaders: dict[str, Callable[[Path], object]] = {
            "preferences": preferences.load_preferences,
            "keymap": keymaps.load_own,
            "recent": recent.load_recent,
        }
        return loaders[name](path)

    return read


READERS: dict[str, tuple[str, Callable[[str, Path], bytes], str, Callable[[Path], object]]] = {
    **{
        name: (EXPORTERS[name].suffix, written, name, read_shape_file)
        for name in EXPORTERS
        if EXPORTERS[name].suffix in SHAPE_SUFFIXES and name != "nuke-tracks"  # of which no shapes come back
    },
    "project": (".roam", written, "project", read_project),
    **{
        suffix[1:]: (suffix, lambda suffix, folder: picture(suffix, folder), suffix, read_picture)
        for suffix in (".png", ".jpg", ".tif", ".exr", ".dpx", ".tga", ".gif")
    },
    "parts": (".exr", parts, "zip", read_every_layer),
    "movie": (".avi", movie, "MJPG", read_movie),
    "mp4": (".mp4", movie, "mp4v", read_movie),
    "mask": (".png", lambda suffix, folder: picture(suffix, folder), ".png", read_mask),
    **{name: (".json", settings, name, read_settings(name)) for name in ("preferences", "keymap", "recent")},
}
"""By name: the suffix, what makes a whole file and of what, and the reader."""


# ---- damage ----------------------------------------------------------------------------------------------------------


def damaged(whole: bytes, rng: random.Random) -> bytes:
    """The file with bytes changed, words put in, parts cut out, moved and repeated, up to eight times."""
    content = bytearray(whole)
    for _ in range(rng.randint(1, 8)):
        start = rng.randrange(len(content) + 1)
        length = rng.choice((1, 1, 2, 4, 8, 64, 1024))
        match rng.randrange(6):
            case 0 if start < len(content):
                content[start] ^= 1 << rng.randrange(8)
            case 1:
                content[start : start + length] = rng.choice(WORDS)
            case 2:
                content[start:start] = rng.choice(WORDS) * rng.choice((1, 1, 1, 300, 20_000))
            case 3:
                del content[start : start + length]
            case 4:
                content[start:start] = content[start : start + length] * rng.choice((1, 2, 100))
            case _:
                content[start : start + length] = rng.randbytes(min(length, 8))
    return bytes(content)


# ---- the child process, and who watches it ---------------------------------------------------------------------------


def read_for_ever(name: str, connection: Connection) -> None:
    """Read every file whose path comes; answer with what went wrong, empty where nothing did."""
    import resource  # Windows has no such module, and collects the tests that damage files

    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stderr.fileno())  # what libraries of pictures say of each file
    resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    read = READERS[name][3]
    with suppress(RoamError):
        read(Path(tempfile.gettempdir()) / "none")  # libraries are loaded before memory is measured
    started = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss << 10
    connection.send("")
    while path := connection.recv():
        trouble = ""
        try:
            read(Path(path))
        except RoamError as error:
            trouble = "its sentence has several lines" if "\n" in str(error) else ""
        except BaseException:
            trouble = traceback.format_exc()
        if (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss << 10) - started > MOST_MEMORY:
            trouble = trouble or "more than 1 GiB"
        connection.send(trouble)


class Child:
    """A process that reads files."""

    def __init__(self, name: str) -> None:
        self._ours, theirs = multiprocessing.Pipe()
        context = multiprocessing.get_context("spawn")
        self._process = context.Process(target=read_for_ever, args=(name, theirs), daemon=True)
        self._process.start()
        theirs.close()
        self._ours.poll(120.0)
        self._ours.recv()

    def trouble_with(self, path: Path) -> str:
        """What goes wrong in reading a file; empty where nothing does. After trouble, a child is of no more use."""
        self._ours.send(str(path))
        if not self._ours.poll(MOST_SECONDS):
            return f"more than {MOST_SECONDS:g} seconds"
        try:
            return str(self._ours.recv())
        except EOFError:
            self._process.join()
            return f"the process died ({self._process.exitcode})"

    def end(self) -> None:
        """Stop the process."""
        self._process.kill()
        self._process.join()


def findings(name: str, seconds: float, seed: int) -> Iterator[tuple[bytes, str]]:
    """Damaged files with which something goes wrong, and what; the last is empty and tells how many were read."""
    rng = random.Random(seed)
    suffix, make, kind, _ = READERS[name]
    end, count, child = time.monotonic() + seconds, 0, Child(name)
    with tempfile.TemporaryDirectory() as folder:
        whole = make(kind, Path(folder))
        path = Path(folder) / "damaged" / f"file{suffix}"
        path.parent.mkdir()
        while time.monotonic() < end:
            path.write_bytes(damaged(whole, rng))
            count += 1
            if trouble := child.trouble_with(path):
                child.end()
                child = Child(name)
                yield bounded_bytes(path, MOST_MEMORY), trouble
    child.end()
    yield b"", f"{count} files"


def main() -> int:
    """Damage files of one kind, or of all, for so many minutes each. Returns 1 where something was found."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("reader", choices=[*READERS, "all"])
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--keep", type=Path, default=Path("fuzz-findings"), help="folder for the files of findings")
    arguments = parser.parse_args()
    found = 0
    for name in READERS if arguments.reader == "all" else [arguments.reader]:
        for content, trouble in findings(name, 60.0 * arguments.minutes, arguments.seed):
            if not content:
                print(f"{name}: {trouble}", flush=True)
                continue
            found += 1
            arguments.keep.mkdir(parents=True, exist_ok=True)
            kept = arguments.keep / f"{name}-{hashlib.sha256(content).hexdigest()[:12]}{READERS[name][0]}"
            kept.write_bytes(content)
            print(f"{name}: {kept}: {trouble.strip().splitlines()[-1]}", flush=True)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
