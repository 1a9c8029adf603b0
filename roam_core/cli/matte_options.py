"""The options of commands that write mattes, and the style that they ask for."""

from __future__ import annotations

import argparse
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.interchange.matte_style import (
    COMPRESSIONS,
    DEPTHS,
    OTHER_SUFFIXES,
    SUFFIXES,
    DataWindow,
    Depth,
    Gathering,
    MatteFile,
    MatteStyle,
    Parts,
)


def add_matte_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options of pictures."""
    group = parser.add_argument_group("mattes")
    words = sorted({word for compressions in COMPRESSIONS.values() for word in compressions})
    group.add_argument(
        "--file",
        choices=[file.value for file in MatteFile],
        help="kind of the pictures (as the name ends, else the first that holds the rest: png, exr, tiff)",
    )
    group.add_argument(
        "--depth", choices=[depth.value for depth in Depth], help="bits, or floating point (8; half for exr)"
    )
    group.add_argument("--compression", choices=words, help="without loss in any case (zip)")
    group.add_argument(
        "--per",
        choices=[parts.value for parts in Parts],
        default=Parts.ALL,
        help="what has a matte of its own (%(default)s)",
    )
    group.add_argument("--channels", action="store_true", help="exr: layers or shapes as channels of one file")
    group.add_argument("--cryptomatte", action="store_true", help="exr: shapes and layers as Cryptomatte, by name")
    group.add_argument("--tight", action="store_true", help="exr: leave out the black around the shapes")
    group.add_argument("--resume", action="store_true", help="skip frames whose files are there")


def matte_options(arguments: argparse.Namespace) -> list[str]:
    """Those of the options that were given another value than their own."""
    plain: dict[str, object] = dict.fromkeys(("file", "depth", "compression"))
    plain |= {"per": Parts.ALL, "channels": False, "cryptomatte": False, "tight": False, "resume": False}
    return [f"--{option}" for option, value in plain.items() if getattr(arguments, option) != value]


def matte_style(arguments: argparse.Namespace, name: str = "") -> MatteStyle:
    """The style that the options ask for, and the suffix of the pictures' `name` where no kind of file is asked for.

    Raises `RoamError` when the kind of file cannot hold it.
    """
    if arguments.channels and arguments.cryptomatte:
        raise RoamError("--channels and --cryptomatte are two ways to put mattes into one file; choose one of them.")
    parts = Parts.SHAPE if arguments.channels and arguments.per == Parts.ALL else Parts(arguments.per)
    return MatteStyle(
        file=_kind(arguments, name),
        depth=None if arguments.depth is None else Depth(arguments.depth),
        compression=arguments.compression,
        parts=parts,
        gathering=_gathering(arguments),
        window=DataWindow.TIGHT if arguments.tight else DataWindow.FULL,
        resumes=arguments.resume,
    )


def _gathering(arguments: argparse.Namespace) -> Gathering:
    if arguments.cryptomatte:
        return Gathering.CRYPTOMATTE
    return Gathering.CHANNELS if arguments.channels else Gathering.FILES


def _kind(arguments: argparse.Namespace, name: str) -> MatteFile:
    """The kind that is asked for, or that the name has; without either the first that holds what is asked for."""
    if arguments.file:
        return MatteFile(arguments.file)
    if named := SUFFIXES.get(Path(name).suffix.lower()):
        return named
    if arguments.channels or arguments.cryptomatte or arguments.tight:
        return MatteFile.EXR
    depth, compression = arguments.depth, arguments.compression
    fitting = (
        kind
        for kind in MatteFile
        if (depth is None or depth in DEPTHS[kind]) and (compression is None or compression in COMPRESSIONS[kind])
    )
    return next(fitting, MatteFile.EXR if depth == Depth.HALF else MatteFile.PNG)


def require_no_picture(folder: Path, advice: str) -> None:
    """Refuse a name of pictures, such as `m.%04d.png`, where a folder is asked for and nothing is there yet."""
    if folder.suffix.lower() in SUFFIXES.keys() | OTHER_SUFFIXES and not folder.exists():
        raise RoamError(f"{folder} is the name of pictures; name the folder that they go to. {advice}")
